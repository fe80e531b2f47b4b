using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Solver;

namespace Farseer.Engine.Continuous;

/// <summary>
/// A stretch of free flight of one body between two impacts, up to the end of the step: its way, and the acceleration that goes on
/// whatever it meets.
/// </summary>
internal struct FreeLeg
{
    public BodyPath Path;
    public int Body;
    private double _gainX;
    private double _gainY;
    private double _gainW;

    public readonly Vector2 Gain => new Vector2((float)_gainX, (float)_gainY);

    /// <summary>
    /// The way of a body that flew the whole step. Its mean velocity is what brought the body from its start to its end, drag included;
    /// over the stretch it changes as evenly as it did in all.
    /// </summary>
    public static FreeLeg Of(BodyStore bodies, in FastMotion motion, double time)
    {
        BodyState end = bodies.State[motion.Body];
        BodyPose pose = bodies.Pose[motion.Body];
        FreeLeg leg = default;
        leg.Body = motion.Body;
        leg._gainX = ((double)end.LinearVelocity.X - motion.VelocityX) / time;
        leg._gainY = ((double)end.LinearVelocity.Y - motion.VelocityY) / time;
        leg._gainW = ((double)end.AngularVelocity - motion.AngularVelocity) / time;
        ref BodyPath path = ref leg.Path;
        path.X = motion.X;
        path.Y = motion.Y;
        path.Angle = motion.Angle;
        path.AccelerationX = leg._gainX * time * time;
        path.AccelerationY = leg._gainY * time * time;
        path.SpinGain = leg._gainW * time * time;
        path.VelocityX = pose.X - motion.X - (0.5 * path.AccelerationX);
        path.VelocityY = pose.Y - motion.Y - (0.5 * path.AccelerationY);
        path.Spin = pose.Angle - motion.Angle - (0.5 * path.SpinGain);
        return leg;
    }

    /// <summary>The way from where the body has been placed.</summary>
    public void GoOn(BodyStore bodies, double time)
    {
        BodyState state = bodies.State[Body];
        Path = BodyPath.Resting(bodies.Pose[Body]);
        Set(state.LinearVelocity.X, state.LinearVelocity.Y, state.AngularVelocity, time);
    }

    /// <summary>The way from where this one is at a share of it, with new velocities.</summary>
    /// <param name="at">Share of the present way.</param>
    /// <param name="velocityX">Lengths a second.</param>
    /// <param name="velocityY">Lengths a second.</param>
    /// <param name="spin">Radians a second.</param>
    /// <param name="time">Seconds left.</param>
    public void GoOn(double at, double velocityX, double velocityY, double spin, double time)
    {
        Path.X = Path.XAt(at);
        Path.Y = Path.YAt(at);
        Path.Angle = Path.AngleAt(at);
        Set(velocityX, velocityY, spin, time);
    }

    /// <summary>The body as an impact finds it.</summary>
    /// <param name="bodies">The store.</param>
    /// <param name="at">Share of the way.</param>
    /// <param name="left">Seconds that the way takes.</param>
    public readonly Mover MoverAt(BodyStore bodies, double at, double left)
    {
        Mover mover = default;
        mover.VelocityX = Path.VelocityXAt(at) / left;
        mover.VelocityY = Path.VelocityYAt(at) / left;
        mover.Spin = Path.SpinAt(at) / left;
        mover.InverseMass = bodies.Mass[Body].InverseMass;
        mover.InverseInertia = bodies.Mass[Body].InverseInertia;
        mover.Reach = bodies.Size[Body].Reach;
        return mover;
    }

    /// <summary>Puts the body where its way is at a share of it, with the velocity that it has there.</summary>
    public readonly void Place(in SweepInput input, double at, double left)
    {
        ref BodyPose pose = ref input.Bodies.Pose[Body];
        ref BodyState state = ref input.Bodies.State[Body];
        pose.X = Path.XAt(at);
        pose.Y = Path.YAt(at);
        pose.Angle = Path.AngleAt(at);
        FinishBodies.UpdateRotor(ref pose);
        if (left > 0)
        {
            state.LinearVelocity = new Vector2((float)(Path.VelocityXAt(at) / left), (float)(Path.VelocityYAt(at) / left));
            state.AngularVelocity = (float)(Path.SpinAt(at) / left);
        }

        ref BodyMotion motion = ref input.Bodies.Motion[Body];
        double substep = left > 0 ? input.Substep / (left * left) : 0;
        motion.StartX = (float)(state.LinearVelocity.X - (Path.AccelerationX * substep));
        motion.StartY = (float)(state.LinearVelocity.Y - (Path.AccelerationY * substep));
        motion.StartW = (float)(state.AngularVelocity - (Path.SpinGain * substep));
    }

    private void Set(double velocityX, double velocityY, double spin, double time)
    {
        Path.VelocityX = velocityX * time;
        Path.VelocityY = velocityY * time;
        Path.Spin = spin * time;
        Path.AccelerationX = _gainX * time * time;
        Path.AccelerationY = _gainY * time * time;
        Path.SpinGain = _gainW * time * time;
    }
}

/// <summary>A body as it was when nobody else had it in hand: whether a handler changed it since.</summary>
internal readonly struct BodySeen
{
    private readonly BodyPose _pose;
    private readonly BodyState _state;
    private readonly BodyFlags _flags;

    public BodySeen(BodyStore bodies, int body)
    {
        _pose = bodies.Pose[body];
        _state = bodies.State[body];
        _flags = bodies.Flags[body];
    }

    public bool HasChanged(BodyStore bodies, int body)
    {
        BodyPose now = bodies.Pose[body];
        BodyState moving = bodies.State[body];
        return now.X != _pose.X || now.Y != _pose.Y || now.Angle != _pose.Angle || bodies.Flags[body] != _flags
            || moving.LinearVelocity != _state.LinearVelocity || moving.AngularVelocity != _state.AngularVelocity;
    }
}
