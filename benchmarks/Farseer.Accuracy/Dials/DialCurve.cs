using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Dials;

/// <summary>What a dial gave and took: the default first, then one doubling after the other.</summary>
/// <param name="Points">Errors in the unit of the kind, costs in ns a body and 1/60 s.</param>
/// <param name="Floor">Errors below are rounding or chance, and not asked to fall.</param>
internal sealed record DialCurve(IReadOnlyList<(double Error, double Cost)> Points, double Floor)
{
    public double Default => Points[0].Error;

    public double Doubled => Points[1].Error;

    /// <summary>Time of one doubling over that of the default.</summary>
    public double CostFactor => Points[1].Cost / Points[0].Cost;

    /// <summary>
    /// Log2 of what a doubling divides the error by, over all doublings up to the first that is at the floor; NaN if the default is.
    /// </summary>
    public double Order => Slope(point => 1);

    /// <summary>The same for what doubles the time, by which dials of different prices compare.</summary>
    public double OrderOfTime => Slope(last => Math.Log2(Points[last].Cost / Points[0].Cost) / last);

    private double Slope(Func<int, double> priceOfADoubling)
    {
        int last = 0;
        while (last + 1 < Points.Count && Points[last].Error > Floor)
        {
            last++;
        }

        return last == 0 ? double.NaN : Math.Log2(Default / Math.Max(Points[last].Error, Floor)) / (last * priceOfADoubling(last));
    }
}

/// <summary>Both dials of a kind.</summary>
/// <param name="Kind">What was run.</param>
/// <param name="Chance">How far two runs with far more substeps are apart; 0 where there is a closed form.</param>
/// <param name="Iterations">The curve of <c>Iterations</c>.</param>
/// <param name="Steps">The curve of 1/dt.</param>
internal sealed record DialResult(DialKind Kind, double Chance, DialCurve Iterations, DialCurve Steps)
{
    /// <summary>Dials whose orders differ by less than this factor are alike: what is left is the noise of the clock.</summary>
    private const double Alike = 1.15;

    /// <summary>Errors that are not larger than this many times what chance leaves open are chance themselves.</summary>
    private const double Chances = 3;

    /// <summary>A doubling that divides the error by less than 1.5 gains too little; floors of sweeps are found by the same.</summary>
    private static readonly double _leastOrder = Math.Log2(1.5);

    /// <summary>Which dial buys more for the same time.</summary>
    public string Turn
    {
        get
        {
            if (Iterations.Default <= Kind.Rounding)
            {
                return "neither: exact";
            }

            if (Iterations.Default <= Chances * Chance)
            {
                return "neither: chance";
            }

            if (Iterations.Order < _leastOrder && Steps.Order < _leastOrder)
            {
                return "neither helps";
            }

            double ratio = Math.Max(Iterations.OrderOfTime, 0.01) / Math.Max(Steps.OrderOfTime, 0.01);
            return ratio > Alike ? "`Iterations`" : ratio < 1 / Alike ? "1/dt" : "either";
        }
    }
}
