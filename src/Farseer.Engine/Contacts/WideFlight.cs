using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// How the bodies of one side of a bundle move at one moment, with their steady acceleration: where they are, and how fast, some time
/// before and after it. With x, v and a at that moment they were at x - v·t + a·t²/2 a time t before, with the velocity v - a·t; so were
/// their angles.
/// </summary>
internal unsafe struct WideFlight
{
    public WideVelocity Velocity;
    public WideDelta Moved;
    private WideVelocity _gain;
    private Wide _turned;

    /// <summary>At the end of a substep, with what its velocities changed by; what cannot move keeps its own.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFlight AtEnd(BodyState* bodies, BodyMotion* motions, int* index, Wide answer, Wide inverseSubstep)
    {
        WideFlight flight;
        BodyLanes.GatherVelocity(bodies, index, out flight.Velocity);
        BodyLanes.GatherDelta(bodies, index, out flight.Moved);
        BodyLanes.Gather((float*)motions, index, out Wide x, out Wide y, out Wide w, out flight._turned);

        // What cannot move is not integrated: its start is of another time.
        WideMask moves = answer > Wide.Zero;
        flight._gain.X = Wide.Keep(moves, (flight.Velocity.X - x) * inverseSubstep);
        flight._gain.Y = Wide.Keep(moves, (flight.Velocity.Y - y) * inverseSubstep);
        flight._gain.W = Wide.Keep(moves, (flight.Velocity.W - w) * inverseSubstep);
        return flight;
    }

    /// <summary>At the start of a substep, with what is foreseen to drive them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFlight AtStart(BodyState* bodies, BodyMotion* motions, BodyDrive* drives, int* index, Wide inverseSubstep)
    {
        WideFlight flight;
        BodyLanes.GatherVelocity(bodies, index, out flight.Velocity);
        BodyLanes.GatherDelta(bodies, index, out flight.Moved);
        BodyLanes.Gather((float*)motions, index, out _, out _, out _, out flight._turned);
        BodyLanes.Gather((float*)drives, index, out Wide x, out Wide y, out Wide w, out _);
        flight._gain.X = x * inverseSubstep;
        flight._gain.Y = y * inverseSubstep;
        flight._gain.W = w * inverseSubstep;
        return flight;
    }

    /// <summary>Where and how fast they were a <paramref name="time"/> before, or will be, if it is negative.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Before(Wide time, out WideDelta moved, out WideVelocity velocity)
    {
        velocity.X = Velocity.X - (_gain.X * time);
        velocity.Y = Velocity.Y - (_gain.Y * time);
        velocity.W = Velocity.W - (_gain.W * time);
        Wide half = Wide.Splat(0.5f) * time;
        moved.X = Moved.X - (time * (Velocity.X - (half * _gain.X)));
        moved.Y = Moved.Y - (time * (Velocity.Y - (half * _gain.Y)));
        Wide turn = time * (Velocity.W - (half * _gain.W));
        moved.Sin = Moved.Sin;
        moved.Cos = Moved.Cos;
        WideDelta turned = moved;
        Integrator.Show(_turned - turn, ref turned);
        WideMask turns = Wide.Abs(turn) > Wide.Zero;
        moved.Sin = Wide.Select(turns, turned.Sin, Moved.Sin);
        moved.Cos = Wide.Select(turns, turned.Cos, Moved.Cos);
    }

    /// <summary>
    /// Gives bodies what an impact changed their velocities by a <paramref name="time"/> ago: they are where that has brought them since.
    /// The change is taken into the velocity of the substep's start, so that the next impact sees the steady acceleration alone.
    /// </summary>
    /// <remarks>
    /// By value, for a local whose place is given away stays in memory; and by itself, for twice within a kernel was more than the compiler
    /// takes in.
    /// </remarks>
    [MethodImpl(KernelMethod.Optimized)]
    public static void CatchUp(BodyState* bodies, BodyMotion* motions, int* index, WideVelocity change, Wide time)
    {
        BodyLanes.GatherVelocity(bodies, index, out WideVelocity v);
        BodyLanes.GatherDelta(bodies, index, out WideDelta moved);
        v.X = v.X + change.X;
        v.Y = v.Y + change.Y;
        v.W = v.W + change.W;
        BodyLanes.ScatterVelocity(bodies, index, v);
        WideDelta d = moved;
        d.X = d.X + (change.X * time);
        d.Y = d.Y + (change.Y * time);
        BodyLanes.Gather((float*)motions, index, out Wide startX, out Wide startY, out Wide startW, out Wide turned);
        turned = turned + (change.W * time);
        BodyLanes.Scatter((float*)motions, index, startX + change.X, startY + change.Y, startW + change.W, turned);
        Integrator.Show(turned, ref d);
        WideMask turns = Wide.Abs(change.W * time) > Wide.Zero;
        d.Sin = Wide.Select(turns, d.Sin, moved.Sin);
        d.Cos = Wide.Select(turns, d.Cos, moved.Cos);
        BodyLanes.ScatterDelta(bodies, index, d);
    }
}
