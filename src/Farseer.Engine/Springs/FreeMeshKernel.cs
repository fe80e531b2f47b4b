using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Springs;

/// <summary>
/// A free mesh over a substep: ways and kicks in turns. Six kicks are the scheme of Blanes and Moan (2002), where the last of a part and
/// the first of the next are one; four that of Omelyan, Mryglod and Folk (2002). Both are symmetric splittings of fourth order whose errors
/// are a hundredth of those of three leaps of second order that make one of fourth.
/// </summary>
internal static unsafe class FreeMeshKernel
{
    private const double SixKick1 = 0.0829844064174052;
    private const double SixKick2 = 0.396309801498368;
    private const double SixKick3 = -0.0390563049223486;
    private const double SixKick4 = 1 - (2 * (SixKick1 + SixKick2 + SixKick3));
    private const double SixWay1 = 0.245298957184271;
    private const double SixWay2 = 0.604872665711080;
    private const double SixWay3 = 0.5 - (SixWay1 + SixWay2);

    private const double FourWay1 = 0.1786178958448091;
    private const double FourWay2 = -0.06626458266981849;
    private const double FourWay3 = 1 - (2 * (FourWay1 + FourWay2));
    private const double FourKick2 = -0.2123418310626054;
    private const double FourKick1 = 0.5 - FourKick2;

    public static void Advance(in FreeMesh mesh, in FreePace pace, FreeBody* bodies, FreeSpring* springs, double h)
    {
        if (pace.Scheme == FreeScheme.Six)
        {
            ByParts(mesh, pace.Parts, bodies, springs, h);
            return;
        }

        FreeBody* first = bodies + mesh.FirstBody;
        bool leap = pace.Scheme == FreeScheme.Leap;
        Move(first, first + mesh.BodyCount, 0, (leap ? 0.5 : FourWay1) * h);
        Turn(mesh, bodies);
        if (leap)
        {
            Stage(mesh, bodies, springs, h, 0.5 * h);
            return;
        }

        Stage(mesh, bodies, springs, FourKick1 * h, FourWay2 * h);
        Stage(mesh, bodies, springs, FourKick2 * h, FourWay3 * h);
        Stage(mesh, bodies, springs, FourKick2 * h, FourWay2 * h);
        Stage(mesh, bodies, springs, FourKick1 * h, FourWay1 * h);
    }

    private static void ByParts(in FreeMesh mesh, int parts, FreeBody* bodies, FreeSpring* springs, double h)
    {
        double part = h / parts;
        double kick = SixKick1 * part;
        for (int i = 0; i < parts; i++)
        {
            Stage(mesh, bodies, springs, kick, SixWay1 * part);
            Stage(mesh, bodies, springs, SixKick2 * part, SixWay2 * part);
            Stage(mesh, bodies, springs, SixKick3 * part, SixWay3 * part);
            Stage(mesh, bodies, springs, SixKick4 * part, SixWay3 * part);
            Stage(mesh, bodies, springs, SixKick3 * part, SixWay2 * part);
            Stage(mesh, bodies, springs, SixKick2 * part, SixWay1 * part);
            kick = 2 * SixKick1 * part;
        }

        Stage(mesh, bodies, springs, SixKick1 * part, 0);
    }

    /// <summary>Sine and cosine of a body's turn, if a spring pulls beside its centre.</summary>
    public static void Turn(FreeBody* body)
    {
        if (body->Turns != 0)
        {
            StableMath.SinCos(body->Turned, out body->Sin, out body->Cos);
        }
    }

    /// <summary>Energy of motion and of the springs, and what gravity and forces have given of it since the step's start.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static double Energy(in FreeMesh mesh, FreeBody* bodies, FreeSpring* springs, out double given)
    {
        double energy = 0;
        given = 0;
        FreeBody* end = bodies + mesh.FirstBody + mesh.BodyCount;
        for (FreeBody* body = bodies + mesh.FirstBody; body < end; body++)
        {
            if (body->InverseMass > 0)
            {
                energy += ((body->VX * body->VX) + (body->VY * body->VY)) / body->InverseMass;
                given += ((body->LoadX * body->X) + (body->LoadY * body->Y)) / body->InverseMass;
            }

            if (body->InverseInertia > 0)
            {
                energy += body->W * body->W / body->InverseInertia;
                given += body->LoadW * body->Turned / body->InverseInertia;
            }
        }

        FreeSpring* springEnd = springs + mesh.FirstSpring + mesh.SpringCount;
        for (FreeSpring* spring = springs + mesh.FirstSpring; spring < springEnd; spring++)
        {
            double stretch = Math.Abs(Stretch(spring, bodies + spring->A, bodies + spring->B));

            // Beyond its largest torque a spring turns with that.
            double most = spring->Kind == SpringKind.Angular ? spring->MaxTorque : double.PositiveInfinity;
            double pull = spring->Stiffness * stretch;
            energy += pull <= most ? pull * stretch : most * ((2 * stretch) - (most / spring->Stiffness));
        }

        return energy / 2;
    }

    private static double Stretch(FreeSpring* spring, FreeBody* a, FreeBody* b)
    {
        if (spring->Kind == SpringKind.Angular)
        {
            return spring->OffsetX + b->Turned - a->Turned;
        }

        double x = spring->OffsetX + (b->X - a->X);
        double y = spring->OffsetY + (b->Y - a->Y);
        if (spring->HasArms != 0)
        {
            x += (b->Cos * spring->ArmBX) - (b->Sin * spring->ArmBY) - (a->Cos * spring->ArmAX) + (a->Sin * spring->ArmAY);
            y += (b->Sin * spring->ArmBX) + (b->Cos * spring->ArmBY) - (a->Sin * spring->ArmAX) - (a->Cos * spring->ArmAY);
        }

        return Math.Sqrt((x * x) + (y * y)) - spring->Rest;
    }

    private static void Stage(in FreeMesh mesh, FreeBody* bodies, FreeSpring* springs, double kick, double way)
    {
        FreeSpring* spring = springs + mesh.FirstSpring;
        FreeSpring* springEnd = spring + mesh.SpringCount;
        FreeBody* body = bodies + mesh.FirstBody;
        FreeBody* bodyEnd = body + mesh.BodyCount;
        Pull(spring, springEnd, bodies, mesh.Pace.Drag > 0);
        if (mesh.Terms > 1)
        {
            TakeTerm(body, bodyEnd, kick, kick);
            for (int term = 2; term <= mesh.Terms; term++)
            {
                PullAgain(spring, springEnd, bodies);
                TakeTerm(body, bodyEnd, kick / term, 0);
            }

            kick = 0;
        }

        Move(body, bodyEnd, kick, way);
        Turn(mesh, bodies);
    }

    private static void Turn(in FreeMesh mesh, FreeBody* bodies)
    {
        for (int i = mesh.FirstBody; mesh.Turns && i < mesh.FirstBody + mesh.BodyCount; i++)
        {
            Turn(bodies + i);
        }
    }

    /// <summary>The forces of the springs where the bodies are.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    private static void Pull(FreeSpring* spring, FreeSpring* end, FreeBody* bodies, bool damped)
    {
        for (; spring < end; spring++)
        {
            FreeBody* a = bodies + spring->A;
            FreeBody* b = bodies + spring->B;
            if (spring->Kind == SpringKind.Angular)
            {
                Twist(spring, a, b);
                continue;
            }

            double x = spring->OffsetX + (b->X - a->X);
            double y = spring->OffsetY + (b->Y - a->Y);
            if (spring->HasArms != 0)
            {
                PullByArms(spring, a, b, x, y);
                continue;
            }

            // Ends that coincide have no direction between them, and no force.
            double length = Math.Sqrt((x * x) + (y * y));
            double inverse = length > 0 ? 1 / length : 0;
            double pull = spring->Stiffness * (length - spring->Rest) * inverse;
            if (damped)
            {
                spring->NormalX = x * inverse;
                spring->NormalY = y * inverse;
                pull += spring->Damping * inverse * inverse * ((x * (b->VX - a->VX)) + (y * (b->VY - a->VY)));
            }

            a->ForceX += pull * x;
            a->ForceY += pull * y;
            b->ForceX -= pull * x;
            b->ForceY -= pull * y;
        }
    }

    private static void PullByArms(FreeSpring* spring, FreeBody* a, FreeBody* b, double x, double y)
    {
        double ax = (a->Cos * spring->ArmAX) - (a->Sin * spring->ArmAY);
        double ay = (a->Sin * spring->ArmAX) + (a->Cos * spring->ArmAY);
        double bx = (b->Cos * spring->ArmBX) - (b->Sin * spring->ArmBY);
        double by = (b->Sin * spring->ArmBX) + (b->Cos * spring->ArmBY);
        x += bx - ax;
        y += by - ay;
        double length = Math.Sqrt((x * x) + (y * y));
        double inverse = length > 0 ? 1 / length : 0;
        double nx = x * inverse;
        double ny = y * inverse;
        double turnA = (ax * ny) - (ay * nx);
        double turnB = (bx * ny) - (by * nx);
        double speed = (nx * (b->VX - a->VX)) + (ny * (b->VY - a->VY)) + (turnB * b->W) - (turnA * a->W);
        double pull = (spring->Stiffness * (length - spring->Rest)) + (spring->Damping * speed);
        spring->NormalX = nx;
        spring->NormalY = ny;
        spring->TurnA = turnA;
        spring->TurnB = turnB;
        a->ForceX += pull * nx;
        a->ForceY += pull * ny;
        a->Torque += pull * turnA;
        b->ForceX -= pull * nx;
        b->ForceY -= pull * ny;
        b->Torque -= pull * turnB;
    }

    private static void Twist(FreeSpring* spring, FreeBody* a, FreeBody* b)
    {
        double torque = spring->Stiffness * (spring->OffsetX + b->Turned - a->Turned);
        double onA = torque - (spring->Damping * a->W);
        double onB = -torque - (spring->Damping * b->W);
        double most = spring->MaxTorque;
        spring->TurnA = Math.Abs(onA) <= most ? 1 : 0;
        spring->TurnB = Math.Abs(onB) <= most ? 1 : 0;
        a->Torque += Math.Max(-most, Math.Min(most, onA));
        b->Torque += Math.Max(-most, Math.Min(most, onB));
    }

    /// <summary>What the damping makes of the last term.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    private static void PullAgain(FreeSpring* spring, FreeSpring* end, FreeBody* bodies)
    {
        for (; spring < end; spring++)
        {
            FreeBody* a = bodies + spring->A;
            FreeBody* b = bodies + spring->B;
            if (spring->Kind == SpringKind.Angular)
            {
                a->Torque -= spring->Damping * spring->TurnA * a->TermW;
                b->Torque -= spring->Damping * spring->TurnB * b->TermW;
                continue;
            }

            double speed = (spring->NormalX * (b->TermX - a->TermX)) + (spring->NormalY * (b->TermY - a->TermY))
                + (spring->TurnB * b->TermW) - (spring->TurnA * a->TermW);
            double pull = spring->Damping * speed;
            a->ForceX += pull * spring->NormalX;
            a->ForceY += pull * spring->NormalY;
            a->Torque += pull * spring->TurnA;
            b->ForceX -= pull * spring->NormalX;
            b->ForceY -= pull * spring->NormalY;
            b->Torque -= pull * spring->TurnB;
        }
    }

    [MethodImpl(KernelMethod.Optimized)]
    private static void TakeTerm(FreeBody* body, FreeBody* end, double share, double load)
    {
        for (; body < end; body++)
        {
            body->TermX = (share * body->InverseMass * body->ForceX) + (load * body->LoadX);
            body->TermY = (share * body->InverseMass * body->ForceY) + (load * body->LoadY);
            body->TermW = (share * body->InverseInertia * body->Torque) + (load * body->LoadW);
            body->VX += body->TermX;
            body->VY += body->TermY;
            body->W += body->TermW;
            body->ForceX = 0;
            body->ForceY = 0;
            body->Torque = 0;
        }
    }

    /// <summary>Takes the forces for a while, unless it is 0, and moves on.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    private static void Move(FreeBody* body, FreeBody* end, double kick, double way)
    {
        for (; body < end; body++)
        {
            if (kick != 0)
            {
                body->VX += kick * ((body->InverseMass * body->ForceX) + body->LoadX);
                body->VY += kick * ((body->InverseMass * body->ForceY) + body->LoadY);
                body->W += kick * ((body->InverseInertia * body->Torque) + body->LoadW);
                body->ForceX = 0;
                body->ForceY = 0;
                body->Torque = 0;
            }

            body->X += way * body->VX;
            body->Y += way * body->VY;
            body->Turned += way * body->W;
        }
    }
}
