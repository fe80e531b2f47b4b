using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using Mask = System.Runtime.Intrinsics.Vector256<float>;
#else
using Mask = System.Numerics.Vector<int>;
#endif

namespace Farseer.Engine.Numerics;

/// <summary>The result of a comparison of <see cref="Wide"/> values: all bits of a lane set, or none.</summary>
internal readonly struct WideMask
{
    private readonly Mask _v;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public WideMask(Mask v) => _v = v;

    /// <summary>Every lane set.</summary>
    public static WideMask All
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
#if NET8_0_OR_GREATER
        get => new WideMask(Mask.AllBitsSet);
#else
        get => new WideMask(~Mask.Zero);
#endif
    }

    public Mask Raw
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _v;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask operator &(WideMask a, WideMask b) => new WideMask(a._v & b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask operator |(WideMask a, WideMask b) => new WideMask(a._v | b._v);
}
