using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// What a step may have made of a body where restitutions above 1 make energy: see <see cref="DrivenBound"/>. What is faster by itself, or
/// by what gravity and forces do on its way, stays so, but a step adds nothing.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class BounceBound
{
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
    public void End(BodyStore bodies, byte* moves, Vector2 gravity, float dt, in DrivenBound bound)
    {
        int end = bodies.Ids.End;
        for (int body = 1; body < end; body++)
        {
            if (moves[body] != 0 && bodies.Mass[body].InverseMass > 0)
            {
                Cut(bodies, body, gravity, dt, bound);
            }
        }
    }

    private void Cut(BodyStore bodies, int body, Vector2 outside, float dt, in DrivenBound bound)
    {
        ref BodyState state = ref bodies.State[body];
        BodyMass mass = bodies.Mass[body];
        BodyForce force = bodies.Force[body];
        BodyPose pose = bodies.Pose[body];
        Start start = _starts[body];
        double most = bound.SpeedOf(bodies, body);

        // What a constant force does on a way is exact for any number of elastic bounces.
        Vector2 gravity = (bodies.Flags[body] & BodyFlags.IgnoreGravity) != 0 ? Vector2.Zero : outside;
        Vector2 gain = gravity + (mass.InverseMass * force.Force);
        double work = (gain.X * (pose.X - start.X)) + (gain.Y * (pose.Y - start.Y));
        double allowed = Math.Max(most * most, start.Square + (2 * work));
        double square = Square(state);
        if (square > allowed)
        {
            state.LinearVelocity *= (float)Math.Sqrt(allowed / square);
        }

        double mostSpin = Math.Max(bound.SpinOf(bodies, body), start.Spin + Math.Abs((double)dt * mass.InverseInertia * force.Torque));
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
