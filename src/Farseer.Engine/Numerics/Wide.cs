using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using Lanes = System.Runtime.Intrinsics.Vector256<float>;
#else
using System.Numerics;
using Lanes = System.Numerics.Vector<float>;
#endif

namespace Farseer.Engine.Numerics;

/// <summary>
/// A few floats side by side: the one type that kernels compute with. Rows are stored in bundles of <see cref="BundleLanes"/>
/// lanes on every machine; a kernel walks a bundle in strides of <see cref="Count"/>. No operation crosses lanes and none is
/// fused, so each lane gives the bits of the scalar formula at any width.
/// </summary>
internal readonly unsafe struct Wide
{
    /// <summary>Lanes of a stored bundle, the same everywhere so that the state has one layout.</summary>
    public const int BundleLanes = 8;

    private readonly Lanes _v;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Wide(Lanes v) => _v = v;

    /// <summary>Lanes computed at once: 8 on the net8.0 asset, 4 or 8 on netstandard2.0.</summary>
    public static int Count
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Lanes.Count;
    }

    public Lanes Raw
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _v;
    }

    public static Wide Zero
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new Wide(Lanes.Zero);
    }

    public static Wide One
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new Wide(Lanes.One);
    }

#if NET8_0_OR_GREATER
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Splat(float value) => new Wide(Vector256.Create(value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Load(float* source) => new Wide(Vector256.Load(source));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(float* target) => _v.Store(target);

    /// <summary>a &gt; b ? a : b, in every lane and on every processor.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Max(Wide a, Wide b) => Avx.IsSupported
        ? new Wide(Avx.Max(a._v, b._v))
        : new Wide(Vector256.ConditionalSelect(Vector256.GreaterThan(a._v, b._v), a._v, b._v));

    /// <summary>a &lt; b ? a : b, in every lane and on every processor.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Min(Wide a, Wide b) => Avx.IsSupported
        ? new Wide(Avx.Min(a._v, b._v))
        : new Wide(Vector256.ConditionalSelect(Vector256.LessThan(a._v, b._v), a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Sqrt(Wide a) => new Wide(Vector256.Sqrt(a._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Abs(Wide a) => new Wide(Vector256.Abs(a._v));

    /// <summary>Where the mask is set <paramref name="a"/>, elsewhere <paramref name="b"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Select(WideMask mask, Wide a, Wide b) => new Wide(Vector256.ConditionalSelect(mask.Raw, a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask operator >(Wide a, Wide b) => new WideMask(Vector256.GreaterThan(a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask operator <(Wide a, Wide b) => new WideMask(Vector256.LessThan(a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask operator >=(Wide a, Wide b) => new WideMask(Vector256.GreaterThanOrEqual(a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask operator <=(Wide a, Wide b) => new WideMask(Vector256.LessThanOrEqual(a._v, b._v));
#else
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Splat(float value) => new Wide(new Lanes(value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Load(float* source) => new Wide(Unsafe.ReadUnaligned<Lanes>(source));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(float* target) => Unsafe.WriteUnaligned(target, _v);

    /// <summary>a &gt; b ? a : b, in every lane and on every processor.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Max(Wide a, Wide b) => new Wide(Vector.ConditionalSelect(Vector.GreaterThan(a._v, b._v), a._v, b._v));

    /// <summary>a &lt; b ? a : b, in every lane and on every processor.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Min(Wide a, Wide b) => new Wide(Vector.ConditionalSelect(Vector.LessThan(a._v, b._v), a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Sqrt(Wide a) => new Wide(Vector.SquareRoot(a._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Abs(Wide a) => new Wide(Vector.Abs(a._v));

    /// <summary>Where the mask is set <paramref name="a"/>, elsewhere <paramref name="b"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Select(WideMask mask, Wide a, Wide b) => new Wide(Vector.ConditionalSelect(mask.Raw, a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask operator >(Wide a, Wide b) => new WideMask(Vector.GreaterThan(a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask operator <(Wide a, Wide b) => new WideMask(Vector.LessThan(a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask operator >=(Wide a, Wide b) => new WideMask(Vector.GreaterThanOrEqual(a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask operator <=(Wide a, Wide b) => new WideMask(Vector.LessThanOrEqual(a._v, b._v));
#endif

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide operator +(Wide a, Wide b) => new Wide(a._v + b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide operator -(Wide a, Wide b) => new Wide(a._v - b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide operator *(Wide a, Wide b) => new Wide(a._v * b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide operator /(Wide a, Wide b) => new Wide(a._v / b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide operator -(Wide a) => new Wide(Lanes.Zero - a._v);
}
