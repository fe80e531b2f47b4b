using System.Runtime.CompilerServices;

namespace Farseer.Engine.Numerics;

/// <summary>Bit-level float operations that netstandard2.0 lacks; exact on every platform.</summary>
internal static unsafe class FloatBits
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int ToInt(float value) => *(int*)&value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float ToFloat(int bits) => *(float*)&bits;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsFinite(float value) => (ToInt(value) & 0x7F800000) != 0x7F800000;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsFinite(double value) => (*(long*)&value & 0x7FF0000000000000L) != 0x7FF0000000000000L;

    /// <summary>The nearest finite float: what is too large for one is the largest, not infinite.</summary>
    public static float Nearest(double value) => (float)System.Math.Max(-float.MaxValue, System.Math.Min(float.MaxValue, value));

    /// <summary>The largest float that is not above <paramref name="value"/>.</summary>
    public static float RoundDown(double value)
    {
        float f = (float)value;
        return f > value ? Previous(f) : f;
    }

    /// <summary>The smallest float that is not below <paramref name="value"/>.</summary>
    public static float RoundUp(double value)
    {
        float f = (float)value;
        return f < value ? -Previous(-f) : f;
    }

    private static float Previous(float value)
    {
        if (value == 0)
        {
            return -float.Epsilon;
        }

        int bits = ToInt(value);
        return ToFloat(value > 0 ? bits - 1 : bits + 1);
    }
}
