using System;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Numerics;

/// <summary>
/// Elementary functions that give the same bits on every platform, framework and build: only + − · / and bit operations,
/// in a fixed order, never fused. Library sines differ between C runtimes, so one of them in the engine would let two machines drift apart.
/// Results are within 2 units in the last place of the exact value (sine and cosine: up to |x| = 10⁵, then within 10⁻¹⁵ up to 10⁹).
/// </summary>
/// <remarks>
/// The polynomials are plain Taylor series, cut where the next term lies below the last place: reducing the argument a
/// little further costs less than minimax coefficients that nobody could check by eye.
/// </remarks>
internal static unsafe partial class StableMath
{
    public const double Pi = 3.141592653589793;
    public const double HalfPi = 1.5707963267948966;

    // Adding and subtracting 1.5·2⁵² rounds |v| < 2⁵¹ to the nearest whole number, and leaves it in the low bits.
    private const double RoundToWhole = 6755399441055744.0;

    /// <summary>The square root, correctly rounded by IEEE 754: the double root of a float rounds to the same float.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Sqrt(float value) => (float)Math.Sqrt(value);

    public static float Sin(float angle) => (float)Sin((double)angle);

    public static float Cos(float angle) => (float)Cos((double)angle);

    public static float Atan2(float y, float x) => (float)Atan2((double)y, (double)x);

    public static float Exp(float value) => (float)Exp((double)value);

    public static float Log(float value) => (float)Log((double)value);

    /// <summary>The rotation by <paramref name="angle"/> radians, each part rounded once from double.</summary>
    public static Rotation FromAngle(double angle)
    {
        SinCos(angle, out double sin, out double cos);
        return new Rotation((float)cos, (float)sin);
    }

    private static long ToBits(double value) => *(long*)&value;

    private static double FromBits(long bits) => *(double*)&bits;

    /// <summary>2 to a whole power within the normal range, −1022 … 1023.</summary>
    private static double PowerOfTwo(int exponent) => FromBits((long)(exponent + 1023) << 52);
}
