using System;
using System.Globalization;

namespace Farseer.Hunt.Calls;

/// <summary>
/// A row of bytes that decides everything about a world: from a seed, or from whoever looks for bytes that reach new code. When it is
/// spent all is 0.
/// </summary>
internal sealed class Choices(byte[] bytes)
{
    private int _at;

    public bool AreSpent => _at >= bytes.Length;

    public static Choices FromSeed(ulong seed)
    {
        var random = new Random(unchecked((int)(seed ^ (seed >> 32))));

        // Most worlds are small, since small failures are easier to understand; some are large enough for several workers.
        byte[] bytes = new byte[random.Next(8) switch { 0 => 3000, 1 or 2 => 1500, _ => random.Next(100, 800) }];
        random.NextBytes(bytes);
        return new Choices(bytes);
    }

    public int Below(int count) => count <= 1 ? 0 : count <= 256 ? Next() % count : ((Next() << 8) | Next()) % count;

    public bool OneIn(int count) => Below(count) == 0;

    public bool Flag() => OneIn(2);

    /// <summary>From 0 to 1.</summary>
    public float Share() => ((Next() << 8) | Next()) / 65535f;

    /// <summary>Within both, few digits, so that a printed program is short.</summary>
    public float Between(float low, float high)
    {
        double value = low > 0 && high > 20 * low ? low * Math.Pow(high / low, Share()) : low + (((double)high - low) * Share());
        return Rounded((float)Math.Clamp(value, low, high));
    }

    public static float Rounded(float value) =>
        float.IsFinite(value) ? float.Parse(value.ToString("g4", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture) : value;

    private int Next() => _at < bytes.Length ? bytes[_at++] : 0;
}
