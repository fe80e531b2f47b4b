using System.Numerics;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Numerics;

/// <summary>
/// Turns records into lanes and back where nobody offers shuffles: the framework's transposition of a matrix moves numbers and computes
/// nothing, and a runtime that knows vectors keeps it in registers. What it writes are halves of a lane vector. To read the whole vector at
/// once waits until both halves have left the processor, and everything before them: passes turn several bundles before they compute with
/// the first.
/// </summary>
internal static unsafe class MatrixTurn
{
    /// <summary>
    /// Vectors of no more lanes than that are filled by turning, for want of something better. (A constant, as the length of vectors is to
    /// the compiler: of two ways it looks at one.)
    /// </summary>
#if NET8_0_OR_GREATER
    public const int MostLanes = 4;
#else
    public const int MostLanes = 8;
#endif

    /// <summary>Records that a matrix holds.</summary>
    public const int Records = 4;

    /// <summary>Turns four floats of each of four records into four columns.</summary>
    /// <param name="r0">A record.</param>
    /// <param name="r1">A record.</param>
    /// <param name="r2">A record.</param>
    /// <param name="r3">A record.</param>
    /// <param name="target">The first column.</param>
    /// <param name="stride">Floats from one column to the next.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ToColumns(float* r0, float* r1, float* r2, float* r3, float* target, int stride)
    {
        Matrix4x4 block = Turned(*(Vector4*)r0, *(Vector4*)r1, *(Vector4*)r2, *(Vector4*)r3);
        var rows = (Vector4*)&block;
        *(Vector4*)target = rows[0];
        *(Vector4*)(target + stride) = rows[1];
        *(Vector4*)(target + (2 * stride)) = rows[2];
        *(Vector4*)(target + (3 * stride)) = rows[3];
    }

    /// <summary>The same without the fourth column.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ToThreeColumns(float* r0, float* r1, float* r2, float* r3, float* target, int stride)
    {
        Matrix4x4 block = Turned(*(Vector4*)r0, *(Vector4*)r1, *(Vector4*)r2, *(Vector4*)r3);
        var rows = (Vector4*)&block;
        *(Vector4*)target = rows[0];
        *(Vector4*)(target + stride) = rows[1];
        *(Vector4*)(target + (2 * stride)) = rows[2];
    }

    /// <summary>The same with nothing but the first two, wherever these are to be.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ToTwoColumns(float* r0, float* r1, float* r2, float* r3, float* first, float* second)
    {
        Matrix4x4 block = Turned(*(Vector4*)r0, *(Vector4*)r1, *(Vector4*)r2, *(Vector4*)r3);
        var rows = (Vector4*)&block;
        *(Vector4*)first = rows[0];
        *(Vector4*)second = rows[1];
    }

    /// <summary>
    /// The same of points of a pool, to be read when all that is needed has been turned; what lies behind a point is read as well.
    /// </summary>
    /// <param name="pool">Where the points lie.</param>
    /// <param name="index">Their places.</param>
    /// <param name="count">How many, a multiple of <see cref="Records"/>.</param>
    /// <param name="x">Where their x go.</param>
    /// <param name="y">Where their y go.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ToTwoColumns(Vector2* pool, int* index, int count, float* x, float* y)
    {
        for (int i = 0; i < count; i += Records)
        {
            ToTwoColumns(
                (float*)(pool + index[i]),
                (float*)(pool + index[i + 1]),
                (float*)(pool + index[i + 2]),
                (float*)(pool + index[i + 3]),
                x + i,
                y + i);
        }
    }

    /// <summary>The same with the first and third column in one place, the second and fourth in another.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ToPairs(float* r0, float* r1, float* r2, float* r3, float* odd, float* even, int stride)
    {
        Matrix4x4 block = Turned(*(Vector4*)r0, *(Vector4*)r1, *(Vector4*)r2, *(Vector4*)r3);
        var rows = (Vector4*)&block;
        *(Vector4*)odd = rows[0];
        *(Vector4*)even = rows[1];
        *(Vector4*)(odd + stride) = rows[2];
        *(Vector4*)(even + stride) = rows[3];
    }

    /// <summary>Turns columns into four floats of each of four records.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ToRecords(Vector4 c0, Vector4 c1, Vector4 c2, Vector4 c3, float* r0, float* r1, float* r2, float* r3)
    {
        Matrix4x4 block = Turned(c0, c1, c2, c3);
        var rows = (Vector4*)&block;
        *(Vector4*)r0 = rows[0];
        *(Vector4*)r1 = rows[1];
        *(Vector4*)r2 = rows[2];
        *(Vector4*)r3 = rows[3];
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Matrix4x4 Turned(Vector4 r0, Vector4 r1, Vector4 r2, Vector4 r3)
    {
        Matrix4x4 block;
        var rows = (Vector4*)&block;
        rows[0] = r0;
        rows[1] = r1;
        rows[2] = r2;
        rows[3] = r3;
        return Matrix4x4.Transpose(block);
    }
}

/// <summary>Four lane vectors side by side in memory.</summary>
internal struct FourColumns
{
    public Wide A;
    public Wide B;
    public Wide C;
    public Wide D;
}
