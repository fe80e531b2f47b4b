using System.Numerics;

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
        double lawDamping = 0;
        var law = new DragLaw(lawDamping, substep);
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            marks[i] = 0;
            ref BodyDrive drive = ref bodies.Drive[body];
            BodyFlags flags = bodies.Flags[body];
            if ((flags & (BodyFlags.Static | BodyFlags.Kinematic)) != 0)
            {
                Rest(ref drive);
                if (!StateRange.Holds(bodies.State[body]))
                {
                    marks[i] = 1;
                    found = true;
                    Stop(ref bodies.State[body]);
                }

                continue;
            }

            ref BodyMass mass = ref bodies.Mass[body];
            ref BodyForce force = ref bodies.Force[body];
            ref BodyDrag drag = ref bodies.Drag[body];
            ref BodyState state = ref bodies.State[body];
            Vector2 pull = (flags & BodyFlags.IgnoreGravity) != 0 ? Vector2.Zero : gravity;

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
            }

            drive.X = (float)((pull.X + ((double)force.Force.X * mass.InverseMass)) * law.First);
            drive.Y = (float)((pull.Y + ((double)force.Force.Y * mass.InverseMass)) * law.First);
            drive.W = (float)((double)force.Torque * mass.InverseInertia * substep);
            drive.LinearKeep = (float)law.Keep;
            if (drag.Angular > 0)
            {
                var spinLaw = new DragLaw((double)drag.Angular * mass.InverseInertia, substep);
                drive.W = (float)((double)force.Torque * mass.InverseInertia * spinLaw.First);
                drive.AngularKeep = (float)spinLaw.Keep;
            }
            else
            {
                double spin = (double)drag.Rotational * mass.InverseInertia * System.Math.Abs((double)state.AngularVelocity);
                drive.AngularKeep = spin == 0 ? 1f : (float)(1 / (1 + (spin * substep)));
            }

            if (!StateRange.Holds(state) | !StateRange.Holds(drive.X, drive.Y, drive.W))
            {
                marks[i] = 1;
                found = true;
                Stop(ref state);
                Rest(ref drive);
            }
        }

        return found;
    }

    private static void Rest(ref BodyDrive drive) => drive = new BodyDrive { LinearKeep = 1, AngularKeep = 1, Lead = drive.Lead };

    private static void Stop(ref BodyState state)
    {
        state.LinearVelocity = Vector2.Zero;
        state.AngularVelocity = 0;
    }
}
