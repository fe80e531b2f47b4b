using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>
/// Momentum and angular momentum of some bodies about a point of the world: what of them came of nothing since the start, as
/// a share of what the bodies have one by one.
/// </summary>
internal sealed class MomentumLedger
{
    private readonly IReadOnlyList<Body> _bodies;
    private readonly double _x;
    private readonly double _y;
    private readonly bool _isFree;
    private readonly Sums _start;
    private double _mostLinear;
    private double _mostAngular;

    /// <param name="bodies">Bodies that nothing outside of them pushes.</param>
    public MomentumLedger(IReadOnlyList<Body> bodies)
        : this(bodies, 0, 0, true)
    {
    }

    private MomentumLedger(IReadOnlyList<Body> bodies, double x, double y, bool isFree)
    {
        _bodies = bodies;
        _x = x;
        _y = y;
        _isFree = isFree;
        _start = Now();
    }

    /// <summary>The largest share so far.</summary>
    public double Made { get; private set; }

    /// <summary>Of a body that is pulled at from a point alone, the angular momentum about that point.</summary>
    public static MomentumLedger About(Body body, double x, double y) => new([body], x, y, false);

    public void Look()
    {
        Sums now = Now();
        _mostLinear = Math.Max(_mostLinear, now.Linear);
        _mostAngular = Math.Max(_mostAngular, now.Angular);
        double linear = Math.Max(Math.Abs(now.X - _start.X), Math.Abs(now.Y - _start.Y));
        Note(_isFree ? linear : 0, _mostLinear);
        Note(Math.Abs(now.Turn - _start.Turn), _mostAngular);
    }

    private void Note(double made, double most)
    {
        if (made > 0)
        {
            Made = Math.Max(Made, made / most);
        }
    }

    private Sums Now()
    {
        Sums sums = default;
        foreach (Body body in _bodies)
        {
            double x = (double)body.Mass * body.LinearVelocity.X;
            double y = (double)body.Mass * body.LinearVelocity.Y;
            double spin = (double)body.MomentOfInertia * body.AngularVelocity;
            double armX = body.PositionX - _x;
            double armY = body.PositionY - _y;
            sums.X += x;
            sums.Y += y;
            sums.Turn += spin + (armX * y) - (armY * x);
            sums.Linear += Math.Abs(x) + Math.Abs(y);
            sums.Angular += Math.Abs(spin) + Math.Abs(armX * y) + Math.Abs(armY * x);
        }

        return sums;
    }

    private struct Sums
    {
        public double X;
        public double Y;
        public double Turn;

        /// <summary>Of the bodies one by one.</summary>
        public double Linear;
        public double Angular;
    }
}
