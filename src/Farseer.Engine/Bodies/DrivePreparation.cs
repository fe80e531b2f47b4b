using System.Numerics;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Bodies;

/// <summary>Works out, once a step, what a substep does to each body of the solver from outside.</summary>
internal static unsafe class DrivePreparation
{
    /// <summary>
    /// A body that forces drive out of range, or that a callback set out of it, stands still in this step, so that it does not drag
    /// along what it touches; it is marked.
    /// </summary>
    /// <param name="bodies">The store.</param>
    /// <param name="list">Bodies.</param>
    /// <param name="count">How many.</param>
    /// <param name="gravity">Acceleration.</param>
    /// <param name="substep">Seconds.</param>
    /// <param name="marks">Gets 1 for each body of the list that is out of range, 0 for the others.</param>
    /// <returns>True if there is one.</returns>
    public static bool Prepare(BodyStore bodies, int* list, int count, Vector2 gravity, double substep, byte* marks)
    {
        bool found = false;
        BodyFlags* allFlags = bodies.Flags.Pointer;
        BodyState* states = bodies.State.Pointer;
        BodyDrive* drives = bodies.Drive.Pointer;
        BodyMass* masses = bodies.Mass.Pointer;
        BodyForce* forces = bodies.Force.Pointer;
        BodyDrag* drags = bodies.Drag.Pointer;
        double lawDamping = 0;
        var law = new DragLaw(lawDamping, substep);
        Vector2 fall = Fall(gravity, law);
        bool fallHolds = StateRange.Holds(fall.X, fall.Y, 0);
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            marks[i] = 0;
            ref BodyDrive drive = ref drives[body];
            BodyFlags flags = allFlags[body];
            ref BodyState state = ref states[body];
            if ((flags & (BodyFlags.Static | BodyFlags.Kinematic)) != 0)
            {
                Rest(ref drive);
                if (!StateRange.Holds(state))
                {
                    marks[i] = 1;
                    found = true;
                    Stop(ref state);
                }

                continue;
            }

            ref BodyMass mass = ref masses[body];
            ref BodyForce force = ref forces[body];
            ref BodyDrag drag = ref drags[body];

            // Quadratic and rotational drag are taken at the step's speed; substeps would differ in the third order only.
            double rate = drag.Linear;
            if ((flags & BodyFlags.QuadraticDrag) != 0)
            {
                Vector2 v = state.LinearVelocity;
                rate += drag.Quadratic * System.Math.Sqrt(((double)v.X * v.X) + ((double)v.Y * v.Y));
            }

            // Most bodies follow the law of the one before: its series are dearer than all the rest.
            double damping = rate * mass.InverseMass;
            if (damping != lawDamping)
            {
                lawDamping = damping;
                law = new DragLaw(damping, substep);
                fall = Fall(gravity, law);
                fallHolds = StateRange.Holds(fall.X, fall.Y, 0);
            }

            // And most are pulled by nothing but gravity.
            bool holds = fallHolds;
            if ((flags & BodyFlags.IgnoreGravity) == 0 && drag.Angular == 0 && drag.Rotational == 0 && IsNone(force))
            {
                drive.X = fall.X;
                drive.Y = fall.Y;
                drive.W = 0;
                drive.Keep((float)law.Keep, 1);
            }
            else
            {
                Vector2 pull = (flags & BodyFlags.IgnoreGravity) != 0 ? Vector2.Zero : gravity;
                Drive(ref drive, pull, law, force, mass, drag, state.AngularVelocity, substep);
                holds = StateRange.Holds(drive.X, drive.Y, drive.W);
            }

            if (!StateRange.Holds(state) | !holds)
            {
                marks[i] = 1;
                found = true;
                Stop(ref state);
                Rest(ref drive);
            }
        }

        return found;
    }

    private static void Drive(
        ref BodyDrive drive,
        Vector2 pull,
        in DragLaw law,
        in BodyForce force,
        in BodyMass mass,
        in BodyDrag drag,
        float spin,
        double substep)
    {
        drive.X = (float)((pull.X + ((double)force.Force.X * mass.InverseMass)) * law.First);
        drive.Y = (float)((pull.Y + ((double)force.Force.Y * mass.InverseMass)) * law.First);
        drive.W = (float)((double)force.Torque * mass.InverseInertia * substep);
        if (drag.Angular > 0)
        {
            var spinLaw = new DragLaw((double)drag.Angular * mass.InverseInertia, substep);
            drive.W = (float)((double)force.Torque * mass.InverseInertia * spinLaw.First);
            drive.Keep((float)law.Keep, (float)spinLaw.Keep);
        }
        else
        {
            double rubbing = (double)drag.Rotational * mass.InverseInertia * System.Math.Abs((double)spin);
            drive.Keep((float)law.Keep, rubbing == 0 ? 1f : (float)(1 / (1 + (rubbing * substep))));
        }
    }

    /// <summary>What gravity alone drives a body by. The 0 that is added is a force of 0, for the sign of zeros.</summary>
    private static Vector2 Fall(Vector2 gravity, in DragLaw law) =>
        new Vector2((float)((gravity.X + 0.0) * law.First), (float)((gravity.Y + 0.0) * law.First));

    /// <summary>No force, by bits: one of -0 is some.</summary>
    private static bool IsNone(in BodyForce force) =>
        (FloatBits.ToInt(force.Force.X) | FloatBits.ToInt(force.Force.Y) | FloatBits.ToInt(force.Torque)) == 0;

    private static void Rest(ref BodyDrive drive)
    {
        drive = new BodyDrive { Lead = drive.Lead };
        drive.Keep(1, 1);
    }

    private static void Stop(ref BodyState state)
    {
        state.LinearVelocity = Vector2.Zero;
        state.AngularVelocity = 0;
    }
}
