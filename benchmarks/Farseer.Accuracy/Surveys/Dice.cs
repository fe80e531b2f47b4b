using System;
using System.Globalization;

namespace Farseer.Accuracy.Surveys;

/// <summary>
/// Random parameters, the same for the same seed and word on every machine, of four digits so that a printed one can be
/// typed in.
/// </summary>
internal sealed class Dice
{
    private uint _state;

    public Dice(uint seed, string word)
    {
        _state = seed;
        foreach (char letter in word)
        {
            _state = unchecked((1664525u * (_state ^ letter)) + 1013904223u);
        }
    }

    /// <summary>At least 0, less than 1.</summary>
    public double Share()
    {
        _state = unchecked((1664525u * _state) + 1013904223u);
        return (_state >> 8) / 16777216.0;
    }

    public float Between(double least, double most) => Rounded(least + (Share() * (most - least)));

    /// <summary>Every factor between the two is as likely as another.</summary>
    public float Wide(double least, double most) => Rounded(least * Math.Pow(most / least, Share()));

    public int Whole(int least, int most) => least + (int)(Share() * (most - least + 1));

    public T Of<T>(params ReadOnlySpan<T> choices) => choices[(int)(Share() * choices.Length)];

    private static float Rounded(double value) =>
        float.Parse(value.ToString("G4", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
}
