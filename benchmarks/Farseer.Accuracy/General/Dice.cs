using System;

namespace Farseer.Accuracy.General;

/// <summary>Random numbers that are the same on every machine (splitmix64).</summary>
internal sealed class Dice
{
    private ulong _state;

    public Dice(uint seed, string purpose)
    {
        _state = seed;
        foreach (char letter in purpose)
        {
            _state = unchecked((_state * 6364136223846793005UL) + letter);
        }
    }

    /// <summary>From 0 to 1, without 1.</summary>
    public double Next()
    {
        unchecked
        {
            _state += 0x9E3779B97F4A7C15UL;
            ulong z = _state;
            z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;
            return ((z ^ (z >> 31)) >> 11) * (1.0 / (1UL << 53));
        }
    }

    public double Between(double least, double most) => least + ((most - least) * Next());

    /// <summary>Even in the logarithm.</summary>
    public double Scale(double least, double most) => least * Math.Pow(most / least, Next());

    /// <summary>Both ends included.</summary>
    public int Whole(int least, int most) => least + (int)((most - least + 1) * Next());

    public double Angle() => Between(-Math.PI, Math.PI);

    public Vec Direction() => new Vec(1, 0).Turned(Angle());

    public T Of<T>(T[] values) => values[Whole(0, values.Length - 1)];
}
