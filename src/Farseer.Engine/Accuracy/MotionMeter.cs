using System;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Accuracy;

/// <summary>
/// Estimates how far the way of each body in a step is from the way that ever finer substeps would take, from the velocities v at the ends
/// of the substeps alone, with no second run.
/// <code>
/// |x_n - x_∞| ≲ 2·|D - Q| + T/2·max|Δv_k - Δv_(k-1)|
/// </code>
/// D is the way that the body went and Q = Σ h·(v_(k-1) + v_k)/2 the one by its velocities: what a rule of first order, or moving a body
/// without speed, puts between them shows in full. Twice, for a rule of first order is off by as much in the velocities. The second part
/// is what the velocities may be off by: between two substeps the kick of the constraints went from Δv_(k-1) to Δv_k, nobody knows when,
/// so v is known to half of the difference, for the rest of a step of length T. Turns count with the radius of gyration. For smooth
/// motion it is T·h²·a'/2, of second order as the rules of joints and springs are; a blow makes it T·Δv/2, far more than it is off by as
/// a rule, and what it is off by if the blow comes out otherwise.
/// </summary>
internal sealed class MotionMeter
{
    /// <summary>Share of all changes that the largest has where it is a blow; one has a rise and a fall.</summary>
    private const double BlowShare = 0.4;

    private readonly Column<Track> _tracks = new Column<Track>();
    private int _step;
    private int _end;

    public void BeginStep(int bodyEnd)
    {
        _step++;
        int before = _tracks.Capacity;
        _tracks.EnsureCapacity(bodyEnd);
        _end = bodyEnd;
        for (int i = before; i < _tracks.Capacity; i++)
        {
            _tracks[i] = default;
        }
    }

    /// <summary>The estimate for a body that went through substeps.</summary>
    /// <param name="body">The body.</param>
    /// <param name="way">How far it went in the step.</param>
    /// <param name="radius">Its radius of gyration.</param>
    /// <param name="struck">A single blow makes most of it: it is over, and finer substeps make the next one no better known.</param>
    public double ErrorOf(int body, in VelocityChange way, double radius, out bool struck)
    {
        ref Track t = ref _tracks[body];
        double x = way.X - t.Way.X;
        double y = way.Y - t.Way.Y;
        double off = Math.Sqrt((x * x) + (y * y)) + (radius * Math.Abs(way.W - t.Way.W));
        struck = t.LargestJump > BlowShare * t.Jumps;
        return (2 * off) + (t.Length * t.LargestJump / 2);
    }

    public bool WasFollowed(int body) => body < _end && _tracks[body].Step == _step;

    /// <summary>A substep of a body is over.</summary>
    public void Follow(int body, in VelocityChange before, in VelocityChange now, in VelocityChange driven, double h, double radius)
    {
        ref Track t = ref _tracks[body];
        if (t.Step != _step)
        {
            // A body that flew freely in the step before had the acceleration of its drive.
            if (t.Step != _step - 1 || !(t.Substep > 0))
            {
                t.Kick = driven;
                t.Substep = h;
            }

            t.Step = _step;
            t.Way = default;
            t.Jumps = 0;
            t.Length = 0;
            t.LargestJump = 0;
        }

        VelocityChange kick;
        kick.X = now.X - before.X;
        kick.Y = now.Y - before.Y;
        kick.W = now.W - before.W;
        double scale = h / t.Substep;
        double x = kick.X - (scale * t.Kick.X);
        double y = kick.Y - (scale * t.Kick.Y);
        double w = kick.W - (scale * t.Kick.W);
        double jump = Math.Sqrt((x * x) + (y * y)) + (radius * Math.Abs(w));
        t.Jumps += jump;
        t.LargestJump = Math.Max(t.LargestJump, jump);
        t.Way.X += h * (before.X + now.X) / 2;
        t.Way.Y += h * (before.Y + now.Y) / 2;
        t.Way.W += h * (before.W + now.W) / 2;
        t.Kick = kick;
        t.Substep = h;
        t.Length += h;
    }

    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    private struct Track
    {
        /// <summary>The way by the trapezoidal rule.</summary>
        public VelocityChange Way;

        /// <summary>Of the last substep.</summary>
        public VelocityChange Kick;
        public double Substep;
        public double Jumps;
        public double LargestJump;
        public double Length;
        public int Step;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_tracks);
        s.Value(ref _step);
        s.Value(ref _end);
    }
}
