using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Solver;

/// <summary>Ends a step: displacements of the solver go into the double poses, states that left their range are caught.</summary>
internal static unsafe class FinishBodies
{
    /// <summary>A body out of range keeps its pose and is put into <paramref name="outcasts"/>.</summary>
    /// <returns>How many there are.</returns>
    /// <param name="bodies">The store.</param>
    /// <param name="list">The solver's bodies.</param>
    /// <param name="count">How many.</param>
    /// <param name="outcasts">Room for as many.</param>
    /// <param name="fast">Where to note the bodies that moved by more than their size.</param>
    public static int Run(BodyStore bodies, int* list, int count, int* outcasts, FastList fast)
    {
        int found = 0;
        BodySize* sizes = bodies.Size.Pointer;
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            ref BodyState state = ref bodies.State[body];
            ref BodyPose pose = ref bodies.Pose[body];
            ref BodyMotion motion = ref bodies.Motion[body];
            double x = pose.X + state.DeltaPosition.X;
            double y = pose.Y + state.DeltaPosition.Y;
            double turned = (double)motion.Turned + bodies.Drive[body].Lead;
            if (StateRange.Holds(state) & StateRange.Holds(x, y, pose.Angle + turned))
            {
                float way = Math.Abs(state.DeltaPosition.X) + Math.Abs(state.DeltaPosition.Y) + (Math.Abs((float)turned) * sizes[body].Reach);
                if (way > sizes[body].Extent)
                {
                    fast.Add(bodies, body, pose, state, isFree: false);
                }

                pose.X = x;
                pose.Y = y;
                if (turned != 0)
                {
                    pose.Angle += turned;
                    UpdateRotor(ref pose);
                }
            }
            else
            {
                outcasts[found++] = body;
            }

            state.DeltaPosition = Vector2.Zero;
            ForgetTurn(bodies, body);
        }

        return found;
    }

    public static void ForgetTurn(BodyStore bodies, int body)
    {
        ref BodyState state = ref bodies.State[body];
        state.DeltaSin = 0;
        state.DeltaCos = 1;
        bodies.Motion[body].Turned = 0;
    }

    public static void UpdateRotor(ref BodyPose pose)
    {
        StableMath.SinCos(pose.Angle, out double sin, out double cos);
        pose.Sin = (float)sin;
        pose.Cos = (float)cos;
    }
}
