using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Solver;

/// <summary>Ends a step: displacements of the solver go into the double poses, forces are used up, bad states are caught.</summary>
internal static unsafe class FinishBodies
{
    public static void Run(BodyStore bodies, int* list, int count)
    {
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            ref BodyState state = ref bodies.State[body];
            ref BodyPose pose = ref bodies.Pose[body];
            ref BodyMotion motion = ref bodies.Motion[body];
            pose.X += state.DeltaPosition.X;
            pose.Y += state.DeltaPosition.Y;
            if (motion.Turned != 0)
            {
                pose.Angle += motion.Turned;
                UpdateRotor(ref pose);
            }

            state.DeltaPosition = Vector2.Zero;
            state.DeltaSin = 0;
            state.DeltaCos = 1;
            motion.Turned = 0;
        }
    }

    public static void UpdateRotor(ref BodyPose pose)
    {
        StableMath.SinCos(pose.Angle, out double sin, out double cos);
        pose.Sin = (float)sin;
        pose.Cos = (float)cos;
    }

    /// <summary>True if every number of the body's state is finite.</summary>
    public static bool IsFinite(BodyStore bodies, int body)
    {
        ref BodyPose pose = ref bodies.Pose[body];
        ref BodyState state = ref bodies.State[body];

        // A sum of products with 0 is 0 unless one of them is infinite or not a number.
        double sum = (pose.X * 0) + (pose.Y * 0) + (pose.Angle * 0)
            + (state.LinearVelocity.X * 0.0) + (state.LinearVelocity.Y * 0.0) + (state.AngularVelocity * 0.0);
        return sum == 0;
    }
}
