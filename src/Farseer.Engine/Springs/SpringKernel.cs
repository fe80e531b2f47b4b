using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Springs;

/// <summary>
/// One spring in one substep, in double precision. C is the length minus the rest length (or the difference of the angles minus the
/// rest), J its Jacobian: C' = n·(vB − vA) + (rB×n)·ωB − (rA×n)·ωA.
/// </summary>
internal static unsafe class SpringKernel
{
    public static double InverseMassA(in SpringRow row) =>
        (row.InverseMassA * Linear(row)) + (row.InverseInertiaA * row.TurnA * row.TurnA);

    public static double InverseMassB(in SpringRow row) =>
        (row.InverseMassB * Linear(row)) + (row.InverseInertiaB * row.TurnB * row.TurnB);

    /// <summary>A body that is switched off is a place of the world and nothing else.</summary>
    public static void Pin(ref SpringRow row, BodyStore bodies)
    {
        if (IsOff(bodies, row.Def.BodyA))
        {
            PinEnd(bodies, ref row.Def.BodyA, ref row.Def.AnchorA, row.Def.Kind, out double angle);
            row.Def.Rest += angle;
        }

        if (IsOff(bodies, row.Def.BodyB))
        {
            PinEnd(bodies, ref row.Def.BodyB, ref row.Def.AnchorB, row.Def.Kind, out double angle);
            row.Def.Rest -= angle;
        }
    }

    /// <summary>Where the ends are; their turns are reckoned from the foreseen middle of the step, see <see cref="Foresight"/>.</summary>
    public static void SetOffsets(ref SpringRow row, BodyStore bodies)
    {
        ref BodyPose a = ref bodies.Pose[row.Def.BodyA];
        ref BodyPose b = ref bodies.Pose[row.Def.BodyB];
        double leadA = row.ActsA != 0 ? bodies.Drive[row.Def.BodyA].Lead : 0;
        double leadB = row.ActsB != 0 ? bodies.Drive[row.Def.BodyB].Lead : 0;
        if (row.Def.Kind == SpringKind.Angular)
        {
            row.OffsetX = b.Angle + leadB - a.Angle - leadA - row.Def.Rest;
            return;
        }

        row.OffsetX = b.X - a.X;
        row.OffsetY = b.Y - a.Y;
        Vector2 p = row.Def.AnchorA;
        Vector2 q = row.Def.AnchorB;
        SetArm(a, leadA, p, out row.ArmAX, out row.ArmAY);
        SetArm(b, leadB, q, out row.ArmBX, out row.ArmBY);
    }

    /// <summary>Fixes the parts of the Jacobian that never change.</summary>
    public static void Place(ref SpringRow row)
    {
        if (row.Def.Kind == SpringKind.Angular)
        {
            row.TurnA = 1;
            row.TurnB = 1;
        }
    }

    /// <summary>
    /// C now, and the Jacobian where the line will be <paramref name="ahead"/> seconds from now: turned by the velocities across it, of
    /// second order for a body that circles. The motion along the line is left to the law: a stiff spring would run past its own end.
    /// </summary>
    public static double FormJacobian(ref SpringRow row, in EndState a, in EndState b, double ahead)
    {
        if (row.Def.Kind == SpringKind.Angular)
        {
            return row.OffsetX + b.Turned - a.Turned;
        }

        Turn(row.ArmAX, row.ArmAY, a, 0, out double ax, out double ay);
        Turn(row.ArmBX, row.ArmBY, b, 0, out double bx, out double by);
        double x = row.OffsetX + (b.X - a.X) + bx - ax;
        double y = row.OffsetY + (b.Y - a.Y) + by - ay;
        double length = Math.Sqrt((x * x) + (y * y));
        if (!(length > 0))
        {
            // The ends coincide: the line has no direction, and the spring no force in this substep.
            row.NormalX = row.NormalY = row.TurnA = row.TurnB = 0;
            return 0;
        }

        double vx = b.VX - (b.W * by) - a.VX + (a.W * ay);
        double vy = b.VY + (b.W * bx) - a.VY - (a.W * ax);
        double across = ahead * ((x * vy) - (y * vx)) / (length * length);
        double nx = x - (across * y);
        double ny = y + (across * x);
        double scale = 1 / Math.Sqrt((nx * nx) + (ny * ny));
        row.NormalX = nx * scale;
        row.NormalY = ny * scale;
        Turn(row.ArmAX, row.ArmAY, a, ahead, out ax, out ay);
        Turn(row.ArmBX, row.ArmBY, b, ahead, out bx, out by);
        row.TurnA = (ax * row.NormalY) - (ay * row.NormalX);
        row.TurnB = (bx * row.NormalY) - (by * row.NormalX);
        return length - row.Def.Rest;
    }

    /// <summary>
    /// A linear spring acts by the exact law, see <see cref="SpringLaw"/>: a kick, and a shift that makes the way of the substep that of
    /// the law.
    /// </summary>
    public static void Kick(ref SpringRow row, BodyStore bodies, double h)
    {
        EndState a = EndState.Read(bodies, row.Def.BodyA, row.MovesA, row.ActsA);
        EndState b = EndState.Read(bodies, row.Def.BodyB, row.MovesB, row.ActsB);
        double x = FormJacobian(ref row, a, b, h / 2);
        double mass = InverseMassA(row) + InverseMassB(row);
        if (!(mass > 0))
        {
            return;
        }

        if (row.LawMass != mass)
        {
            row.Law = new SpringLaw(row.Def.Stiffness * h * h * mass, row.Def.Damping * h * mass);
            row.LawMass = mass;
        }

        double speed = Speed(row, a.VX, a.VY, a.W, b.VX, b.VY, b.W);
        double drive = Speed(row, a.DriveX, a.DriveY, a.DriveW, b.DriveX, b.DriveY, b.DriveW);
        double change = row.Law.Change(x, speed, drive, h);
        double shift = row.Law.Way(x, speed, drive, h) - Plain(speed, change, drive, h);
        double impulse = (change - drive) / mass;
        shift /= mass;
        EndState.Push(
            bodies,
            row.Def.BodyA,
            0,
            -impulse * row.InverseMassA * row.NormalX,
            -impulse * row.InverseMassA * row.NormalY,
            -impulse * row.InverseInertiaA * row.TurnA);
        EndState.Shift(
            bodies,
            row.Def.BodyA,
            -shift * row.InverseMassA * row.NormalX,
            -shift * row.InverseMassA * row.NormalY,
            -shift * row.InverseInertiaA * row.TurnA);
        EndState.Push(
            bodies,
            row.Def.BodyB,
            0,
            impulse * row.InverseMassB * row.NormalX,
            impulse * row.InverseMassB * row.NormalY,
            impulse * row.InverseInertiaB * row.TurnB);
        EndState.Shift(
            bodies,
            row.Def.BodyB,
            shift * row.InverseMassB * row.NormalX,
            shift * row.InverseMassB * row.NormalY,
            shift * row.InverseInertiaB * row.TurnB);
    }

    /// <summary>C' for the given velocities of the ends.</summary>
    public static double Speed(in SpringRow row, double ax, double ay, double aw, double bx, double by, double bw) =>
        (row.NormalX * (bx - ax)) + (row.NormalY * (by - ay)) + (row.TurnB * bw) - (row.TurnA * aw);

    /// <summary>
    /// The way that the integrator gives a velocity v that changes by <paramref name="change"/>: half of the drive's change is taken back.
    /// </summary>
    private static double Plain(double speed, double change, double drive, double h) => h * (speed + change - (drive / 2));

    private static void SetArm(in BodyPose pose, double lead, Vector2 anchor, out double x, out double y)
    {
        StableMath.SinCos(lead, out double sin, out double cos);
        double turnedX = ((double)pose.Cos * anchor.X) - ((double)pose.Sin * anchor.Y);
        double turnedY = ((double)pose.Sin * anchor.X) + ((double)pose.Cos * anchor.Y);
        x = (cos * turnedX) - (sin * turnedY);
        y = (sin * turnedX) + (cos * turnedY);
    }

    private static double Linear(in SpringRow row) => (row.NormalX * row.NormalX) + (row.NormalY * row.NormalY);

    private static bool IsOff(BodyStore bodies, int body) =>
        body != 0 && (bodies.Flags[body] & (BodyFlags.Alive | BodyFlags.Enabled)) != (BodyFlags.Alive | BodyFlags.Enabled);

    private static void PinEnd(BodyStore bodies, ref int body, ref Vector2 anchor, SpringKind kind, out double angle)
    {
        ref BodyPose pose = ref bodies.Pose[body];
        angle = kind == SpringKind.Angular ? pose.Angle : 0;
        anchor = new Vector2(
            (float)(pose.X + ((double)pose.Cos * anchor.X) - ((double)pose.Sin * anchor.Y)),
            (float)(pose.Y + ((double)pose.Sin * anchor.X) + ((double)pose.Cos * anchor.Y)));
        body = 0;
    }

    /// <summary>
    /// The arm after the turn so far and that ahead. With t = ωτ/2 the rotation (1 − t², 2t)/(1 + t²) is that by ωτ to third order,
    /// and it keeps the length.
    /// </summary>
    private static void Turn(double armX, double armY, in EndState end, double ahead, out double x, out double y)
    {
        x = (end.Cos * armX) - (end.Sin * armY);
        y = (end.Sin * armX) + (end.Cos * armY);
        double t = end.W * ahead / 2;
        if (t != 0)
        {
            double scale = 1 / (1 + (t * t));
            double cos = (1 - (t * t)) * scale;
            double sin = 2 * t * scale;
            double turned = (cos * x) - (sin * y);
            y = (sin * x) + (cos * y);
            x = turned;
        }
    }
}
