using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Settings;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Restitutions above 1 make energy at each bounce, without end: sooner or later a body gets further in a step than its impacts can be
/// followed, and leaves its room. In worlds that have them a body is driven on only as far as <see cref="MostExtents"/> in a step. What is
/// faster by itself, or by what gravity and forces do on its way, stays so, but a step adds nothing.
/// </summary>
internal sealed unsafe class BounceBound
{
    /// <summary>
    /// Way in a step in extents of the body, each half of its shorter side. Rooms of up to ten bodies keep them at this, and lose some at several
    /// times as much.
    /// </summary>
    private const double MostExtents = 8;

    private readonly Column<Start> _starts = new Column<Start>();

    /// <summary>Notes how fast the bodies are, before the step moves them.</summary>
    public void Begin(BodyStore bodies, byte* moves)
    {
        int end = bodies.Ids.End;
        _starts.EnsureCapacity(end);
        for (int body = 1; body < end; body++)
        {
            if (moves[body] != 0)
            {
                BodyState state = bodies.State[body];
                BodyPose pose = bodies.Pose[body];
                Start start;
                start.X = pose.X;
                start.Y = pose.Y;
                start.Square = Square(state);
                start.Spin = Math.Abs(state.AngularVelocity);
                _starts[body] = start;
            }
        }
    }

    /// <summary>Cuts what the step has made faster than it may.</summary>
    public void End(BodyStore bodies, byte* moves, WorldSettings settings, float dt)
    {
        int end = bodies.Ids.End;
        for (int body = 1; body < end; body++)
        {
            if (moves[body] != 0 && bodies.Mass[body].InverseMass > 0)
            {
                Cut(bodies, body, settings, dt);
            }
        }
    }

    private void Cut(BodyStore bodies, int body, WorldSettings settings, float dt)
    {
        ref BodyState state = ref bodies.State[body];
        BodyMass mass = bodies.Mass[body];
        BodyForce force = bodies.Force[body];
        BodyPose pose = bodies.Pose[body];
        BodySize size = bodies.Size[body];
        Start start = _starts[body];
        double way = MostExtents * size.Extent / dt;
        double most = Math.Min(way, settings.MostDrivenSpeed);

        // What a constant force does on a way is exact for any number of elastic bounces.
        Vector2 gravity = (bodies.Flags[body] & BodyFlags.IgnoreGravity) != 0 ? Vector2.Zero : settings.Gravity;
        Vector2 gain = gravity + (mass.InverseMass * force.Force);
        double work = (gain.X * (pose.X - start.X)) + (gain.Y * (pose.Y - start.Y));
        double allowed = Math.Max(most * most, start.Square + (2 * work));
        double square = Square(state);
        if (square > allowed)
        {
            state.LinearVelocity *= (float)Math.Sqrt(allowed / square);
        }

        double mostSpin = size.Reach > 0 ? Math.Min(way / size.Reach, settings.MostDrivenSpin) : settings.MostDrivenSpin;
        mostSpin = Math.Max(mostSpin, start.Spin + Math.Abs((double)dt * mass.InverseInertia * force.Torque));
        if (Math.Abs(state.AngularVelocity) > mostSpin)
        {
            state.AngularVelocity = (float)(state.AngularVelocity > 0 ? mostSpin : -mostSpin);
        }
    }

    private static double Square(in BodyState state) =>
        ((double)state.LinearVelocity.X * state.LinearVelocity.X) + ((double)state.LinearVelocity.Y * state.LinearVelocity.Y);

    private struct Start
    {
        public double X;
        public double Y;
        public double Square;
        public double Spin;
    }
}
