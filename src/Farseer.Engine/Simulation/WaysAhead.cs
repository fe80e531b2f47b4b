using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;

namespace Farseer.Engine.Simulation;

/// <summary>Where bodies go in a step if nothing but what is known at its start moves them.</summary>
internal static class WaysAhead
{
    /// <summary>Where the present velocity leads. What touches something is held up against gravity by it.</summary>
    public static BodyPath Path(in ContactUpdateInput input, int body, bool isFree)
    {
        BodyPath path = BodyPath.Resting(input.Bodies.Pose[body]);
        BodyFlags flags = input.Bodies.Flags[body];
        if ((flags & BodyFlags.Static) != 0)
        {
            return path;
        }

        ref BodyState state = ref input.Bodies.State[body];
        double dt = input.Dt;
        path.VelocityX = state.LinearVelocity.X * dt;
        path.VelocityY = state.LinearVelocity.Y * dt;
        path.Spin = state.AngularVelocity * dt;
        if (isFree && (flags & BodyFlags.IgnoreGravity) == 0)
        {
            Vector2 gravity = input.Settings.Gravity;
            path.AccelerationX = gravity.X * dt * dt;
            path.AccelerationY = gravity.Y * dt * dt;
        }

        return path;
    }

    /// <summary>The body slides on to the next piece of one surface.</summary>
    public static bool IsHidden(in ContactUpdateInput input, int contact, in Manifold manifold, in BodyPath way, double time)
    {
        SeamInput seam;
        seam.Shapes = input.Shapes;
        seam.Bodies = input.Bodies;
        seam.Contacts = input.Contacts;
        seam.Ahead = (float)(time * input.Dt);
        return HiddenContact.Is(seam, contact, manifold, way.PoseAt(time));
    }
}
