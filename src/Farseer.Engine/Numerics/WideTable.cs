using System.Numerics;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.Numerics;

/// <summary>
/// Reads a table at a place for each lane: what a walk over bundles asks of their bodies or islands. One by one, with a branch or a store
/// for each lane, such walks waited for themselves: that over the slots of rows alone was 2.5 % of a step of circle_pile, beside what
/// remains of it.
/// </summary>
internal static unsafe class WideTable
{
    /// <summary>The entries at so many places as there are lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Read(float* table, int* places)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            return Avx2.GatherVector256(table, Vector256.Load(places), sizeof(float)).AsVector();
        }

        if (Wide.Count == 4)
        {
            return Vector128.Create(table[places[0]], table[places[1]], table[places[2]], table[places[3]]).AsVector();
        }
#endif
        float* entries = stackalloc float[Wide.Count];
        for (int lane = 0; lane < Wide.Count; lane++)
        {
            entries[lane] = table[places[lane]];
        }

        return Wide.Load(entries);
    }

    /// <summary>The entries of a table at the numbers that another holds at some places.</summary>
    /// <param name="table">The table.</param>
    /// <param name="numbers">Where in it, by place.</param>
    /// <param name="places">The places.</param>
    /// <param name="room">Receives the numbers.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide ReadThrough(float* table, int* numbers, int* places, int* room)
    {
        Read((float*)numbers, places).Store((float*)room);
        return Read(table, room);
    }

    /// <summary>The larger of two, taken as whole numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide LargerNumber(Wide a, Wide b) => Vector.AsVectorSingle(Vector.Max(Vector.AsVectorInt32(a), Vector.AsVectorInt32(b)));
}
