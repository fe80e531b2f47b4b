using System;
using System.Globalization;

namespace Farseer.Fidelity.Judging;

/// <summary>One comparison: what was compared, the error, the limit, and where the error is worst.</summary>
public sealed record Check(string What, double Error, double Limit, string Where)
{
    public bool Passed => Error <= Limit;

    public static Check Of(string what, string? problem)
        => new(what, problem is null ? 0 : double.PositiveInfinity, 0, problem ?? string.Empty);

    public override string ToString()
    {
        if (double.IsPositiveInfinity(Error) && Limit == 0)
        {
            return What + ": " + Where;
        }

        string text = What + " " + Number(Error) + " of " + Number(Limit);
        return Where.Length == 0 ? text : text + " (" + Where + ")";
    }

    private static string Number(double value) =>
        value.ToString(Math.Abs(value) is >= 1e-3 and < 1e5 or 0 ? "0.####" : "0.##e+0", CultureInfo.InvariantCulture);
}
