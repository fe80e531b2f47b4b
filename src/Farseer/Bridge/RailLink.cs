using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Simulation;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>The engine's joint that keeps a body on a line or at a point.</summary>
internal static class RailLink
{
    public static void Lay(World world, Body body)
    {
        if (!body.Link.Rail.IsNull)
        {
            world.DestroyJoint(body.Link.Rail);
            body.Link.Rail = default;
        }

        MotionLocks locks = body.MotionLocks & (MotionLocks.X | MotionLocks.Y);
        if (locks == MotionLocks.None)
        {
            return;
        }

        ref BodyPose pose = ref body.Link.PoseRef;
        JointSettings settings = default;
        settings.AnchorAX = pose.X;
        settings.AnchorAY = pose.Y;
        settings.AxisX = locks == MotionLocks.Y ? 1 : 0;
        settings.AxisY = locks == MotionLocks.Y ? 0 : 1;
        settings.BiasFactor = 1;
        settings.MaxImpulse = double.PositiveInfinity;
        settings.Breakpoint = double.PositiveInfinity;
        settings.BreakForce = double.PositiveInfinity;
        bool both = locks == (MotionLocks.X | MotionLocks.Y);
        body.Link.Rail = world.CreateJoint(
            both ? JointKind.Revolute : JointKind.Wheel,
            World.WorldFrame,
            body.Link.Handle,
            settings,
            JointFlags.Enabled | JointFlags.CollideConnected);
    }
}
