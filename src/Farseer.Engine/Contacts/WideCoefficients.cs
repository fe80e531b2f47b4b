using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>What follows from <see cref="ContactCoefficients"/>, on lanes.</summary>
internal static class WideCoefficients
{
    /// <summary>η for contacts whose smaller pieces have the sizes <paramref name="size"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide FeedShare(in ContactCoefficients c, Wide size)
    {
        Wide share = Wide.Min(size * Wide.Splat(c.Smallness), Wide.One);
        return Wide.One - Wide.Max(Wide.Splat(ContactCoefficients.FeedRest) * share, Wide.Splat(ContactCoefficients.SmallestFeedRest));
    }

    /// <summary><see cref="ContactCoefficients.Sag"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Sag(in ContactCoefficients c, Wide load) => load * Wide.Splat(c.Substep) * Wide.Splat(c.SagShare);
}
