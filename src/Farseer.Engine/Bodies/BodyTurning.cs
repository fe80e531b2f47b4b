using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Bodies;

/// <summary>What passes over several bundles have turned before they compute with the first: see <see cref="MatrixTurn"/>.</summary>
internal static unsafe class BodyTurning
{
    /// <summary>
    /// Turns the states of a bundle's bodies into columns, to be read when the bundles that follow have been turned as well.
    /// </summary>
    /// <param name="bodies">All states.</param>
    /// <param name="index">The bodies.</param>
    /// <param name="velocity">Three columns.</param>
    /// <param name="delta">Four columns.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void TurnStates(BodyState* bodies, int* index, float* velocity, float* delta)
    {
        for (int i = 0; i < WideLanes.BundleLanes; i += MatrixTurn.Records)
        {
            var r0 = (float*)(bodies + index[i]);
            var r1 = (float*)(bodies + index[i + 1]);
            var r2 = (float*)(bodies + index[i + 2]);
            var r3 = (float*)(bodies + index[i + 3]);
            MatrixTurn.ToThreeColumns(r0, r1, r2, r3, velocity + i, WideLanes.BundleLanes);
            MatrixTurn.ToColumns(r0 + 4, r1 + 4, r2 + 4, r3 + 4, delta + i, WideLanes.BundleLanes);
        }
    }

    /// <summary>As <see cref="TurnStates"/>, velocities only.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void TurnVelocities(BodyState* bodies, int* index, float* velocity)
    {
        for (int i = 0; i < WideLanes.BundleLanes; i += MatrixTurn.Records)
        {
            MatrixTurn.ToThreeColumns(
                (float*)(bodies + index[i]),
                (float*)(bodies + index[i + 1]),
                (float*)(bodies + index[i + 2]),
                (float*)(bodies + index[i + 3]),
                velocity + i,
                WideLanes.BundleLanes);
        }
    }

    /// <summary>As <see cref="BodyLanes.GatherOffset"/>, one by one, to be read later.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void StoreOffsets(BodyPose* poses, int* a, int* b, float* x, float* y)
    {
        for (int i = 0; i < Wide.Count; i++)
        {
            BodyPose* from = poses + a[i];
            BodyPose* to = poses + b[i];
            x[i] = (float)(to->X - from->X);
            y[i] = (float)(to->Y - from->Y);
        }
    }
}
