using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Simulation;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics;

/// <content>Bodies that gravity pulls otherwise than the rest, and those on rails.</content>
public partial class PhysicsSimulator
{
    private readonly List<Body> _scaled = new List<Body>();
    private readonly List<Body> _railed = new List<Body>();

    /// <summary>A body came, or its gravity changed.</summary>
    internal void NoteGravity(Body body)
    {
        if (!body.IsGravityNoted && body.GravityScale != 1)
        {
            body.IsGravityNoted = true;
            _scaled.Add(body);
        }
    }

    /// <summary>The rails of a body are to be laid anew at the next update.</summary>
    internal void NoteRails(Body body)
    {
        if (!body.IsRailNoted)
        {
            body.IsRailNoted = true;
            _railed.Add(body);
        }
    }

    /// <summary>Pulls at bodies as much as their gravity says: the engine leaves gravity out for them.</summary>
    private void PullScaled()
    {
        int kept = 0;
        for (int i = 0; i < _scaled.Count; i++)
        {
            Body body = _scaled[i];
            if (!ReferenceEquals(body.Simulator, this) || body.Link.World is null || body.GravityScale == 1)
            {
                body.IsGravityNoted = false;
                continue;
            }

            _scaled[kept++] = body;
            if (!body.IgnoreGravity && body.Awake && body.Link.IsSimulated)
            {
                body.Link.ForceRef.Force += body.Mass * body.GravityScale * Gravity;
            }
        }

        _scaled.RemoveRange(kept, _scaled.Count - kept);
    }

    /// <summary>Lays the rails of bodies that were locked, let go or moved.</summary>
    private void LayRails()
    {
        for (int i = 0; i < _railed.Count; i++)
        {
            Body body = _railed[i];
            body.IsRailNoted = false;
            if (ReferenceEquals(body.Simulator, this) && body.Link.World is not null)
            {
                LayRail(body);
            }
        }

        _railed.Clear();
    }

    private void LayRail(Body body)
    {
        if (!body.Link.Rail.IsNull)
        {
            World.DestroyJoint(body.Link.Rail);
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
        body.Link.Rail = World.CreateJoint(
            both ? JointKind.Revolute : JointKind.Wheel, World.WorldFrame, body.Link.Handle, settings, JointFlags.Enabled | JointFlags.CollideConnected);
    }
}
