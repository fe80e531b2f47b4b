using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Springs;

/// <summary>A body at one end of a spring, in the middle of a step.</summary>
internal struct EndState
{
    /// <summary>Displacement since the step's start, and turn since its foreseen middle.</summary>
    public double X;
    public double Y;
    public double Sin;
    public double Cos;
    public double Turned;

    /// <summary>Velocity without the drive of this substep.</summary>
    public double VX;
    public double VY;
    public double W;

    /// <summary>What gravity, force and torque add in this substep.</summary>
    public double DriveX;
    public double DriveY;
    public double DriveW;

    /// <summary>An end that neither moves nor has moved.</summary>
    public static EndState AtStart => new EndState { Cos = 1 };

    /// <param name="bodies">The bodies.</param>
    /// <param name="body">Index of the body.</param>
    /// <param name="moves">1 if forces may move it.</param>
    /// <param name="acts">1 if it moves or is driven.</param>
    public static EndState Read(BodyStore bodies, int body, int moves, int acts)
    {
        ref BodyState state = ref bodies.State[body];
        EndState end = AtStart;
        if (acts != 0)
        {
            end.X = state.DeltaPosition.X;
            end.Y = state.DeltaPosition.Y;
            end.Sin = state.DeltaSin;
            end.Cos = state.DeltaCos;
            end.Turned = bodies.Motion[body].Turned;
            if (end.Turned > Integrator.LargestTurn || end.Turned < -Integrator.LargestTurn)
            {
                // What the state tells is for contacts.
                StableMath.SinCos(end.Turned, out end.Sin, out end.Cos);
            }
        }

        if (moves != 0)
        {
            ref BodyDrive drive = ref bodies.Drive[body];
            end.DriveX = drive.X;
            end.DriveY = drive.Y;
            end.DriveW = drive.W;
        }

        end.VX = state.LinearVelocity.X - end.DriveX;
        end.VY = state.LinearVelocity.Y - end.DriveY;
        end.W = state.AngularVelocity - end.DriveW;
        return end;
    }

    /// <summary>
    /// Changes the velocity. Of a body that only springs hold the integrator, which guesses the course of an acceleration from the
    /// changes of the velocity, must not see it: its springs say themselves, by <see cref="Shift"/>, what way belongs to it.
    /// </summary>
    public static void Push(BodyStore bodies, int body, int held, double x, double y, double w)
    {
        if (body == 0)
        {
            return;
        }

        ref BodyState state = ref bodies.State[body];
        float dx = (float)x;
        float dy = (float)y;
        float dw = (float)w;
        state.LinearVelocity.X += dx;
        state.LinearVelocity.Y += dy;
        state.AngularVelocity += dw;
        if (held == 0)
        {
            ref BodyMotion motion = ref bodies.Motion[body];
            motion.StartX += dx;
            motion.StartY += dy;
            motion.StartW += dw;
        }
    }

    /// <summary>Moves and turns a body within the step.</summary>
    public static void Shift(BodyStore bodies, int body, double x, double y, double w)
    {
        if (body != 0)
        {
            ref BodyState state = ref bodies.State[body];
            state.DeltaPosition.X += (float)x;
            state.DeltaPosition.Y += (float)y;
            bodies.Motion[body].Turned += (float)w;
            Turn(ref state, w);
        }
    }

    // The rotation by a small angle, to third order; the integrator works the pair out anew from the angle.
    private static void Turn(ref BodyState state, double angle)
    {
        double half = angle / 2;
        double scale = 1 / (1 + (half * half));
        double cos = (1 - (half * half)) * scale;
        double sin = angle * scale;
        double turned = (cos * state.DeltaCos) - (sin * state.DeltaSin);
        state.DeltaSin = (float)((cos * state.DeltaSin) + (sin * state.DeltaCos));
        state.DeltaCos = (float)turned;
    }
}
