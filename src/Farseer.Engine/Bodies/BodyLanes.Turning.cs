using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Bodies;

internal static unsafe partial class BodyLanes
{
    /// <summary>Turns four floats of each record of 32 bytes into columns in memory.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Turn(float* records, int* index, FourColumns* columns) =>
        TurnRecords(records, index, 8, (float*)columns, Wide.Count);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void TurnRecords(float* records, int* index, int stride, float* target, int columnStride)
    {
        for (int i = 0; i < Wide.Count; i += MatrixTurn.Records)
        {
            MatrixTurn.ToColumns(
                records + ((nint)index[i] * stride),
                records + ((nint)index[i + 1] * stride),
                records + ((nint)index[i + 2] * stride),
                records + ((nint)index[i + 3] * stride),
                target + i,
                columnStride);
        }
    }
}
