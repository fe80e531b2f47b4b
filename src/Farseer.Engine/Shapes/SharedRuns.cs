using System.Numerics;
using System.Runtime.InteropServices;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Shapes;

/// <summary>
/// Lets pieces of equal corners and normals share one run of the pools: a pile of a thousand equal boxes then keeps, and reads, one. Runs
/// are compared with the last one of the same hash alone, so that a world in which no two shapes are equal pays next to nothing.
/// </summary>
internal sealed unsafe class SharedRuns
{
    /// <summary>Hashes that are told apart, a power of two.</summary>
    private const int Places = 64;

    private readonly Column<RunUse> _uses;

    /// <summary>By hash, one more than the start of the run that is offered for sharing; 0: none.</summary>
    private readonly int[] _offered = new int[Places];

    /// <param name="vertexSet">Columns indexed by vertex.</param>
    public SharedRuns(ColumnSet vertexSet) => _uses = vertexSet.Add<RunUse>();

    /// <summary>Enters the run of a new piece, or finds one that is equal.</summary>
    /// <returns>The start of the run that the piece is to use: if it is not its own, that one can be given back.</returns>
    public int Enter(in PieceRange own, ShapeStore store)
    {
        ref int offered = ref _offered[PlaceOf(own)];
        if (offered > 0)
        {
            ref RunUse use = ref _uses[offered - 1];
            if (use.Count == own.Count && AreEqual(own, new PieceRange(store, offered - 1, own.Count)))
            {
                use.Pieces++;
                return offered - 1;
            }
        }

        offered = own.Start + 1;
        _uses[own.Start] = new RunUse { Pieces = 1, Count = own.Count };
        return own.Start;
    }

    /// <summary>A piece leaves its run, or is about to change it.</summary>
    /// <returns>True if the run was its alone, and nobody else will be given it.</returns>
    public bool Leave(in PieceRange run)
    {
        if (--_uses[run.Start].Pieces > 0)
        {
            return false;
        }

        ref int offered = ref _offered[PlaceOf(run)];
        offered = offered == run.Start + 1 ? 0 : offered;
        return true;
    }

    private static int PlaceOf(in PieceRange run)
    {
        uint hash = (uint)run.Count;
        int* words = (int*)run.Vertices;
        for (int i = 0; i < run.Count * 2; i++)
        {
            hash = (hash ^ (uint)words[i]) * 0x9E3779B1u;
            hash ^= hash >> 15;
        }

        return (int)(hash % Places);
    }

    private static bool AreEqual(in PieceRange a, in PieceRange b) =>
        AreEqual(a.Vertices, b.Vertices, a.Count) && AreEqual(a.Normals, b.Normals, a.Count)
        && AreEqual(a.Before, b.Before, a.Count) && AreEqual(a.After, b.After, a.Count);

    /// <summary>By their bits: zeros of either sign may lead to different ones.</summary>
    private static bool AreEqual(Vector2* a, Vector2* b, int count)
    {
        long* bitsOfA = (long*)a;
        long* bitsOfB = (long*)b;
        for (int i = 0; i < count; i++)
        {
            if (bitsOfA[i] != bitsOfB[i])
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Of the first vertex of a run: the pieces that use it, and its vertices.</summary>
    [StructLayout(LayoutKind.Sequential)]
    private struct RunUse
    {
        public int Pieces;
        public int Count;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_uses);
        s.Array(_offered);
    }
}
