using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>An event of two geoms, which goes by the creation of the older one, then of the other.</summary>
internal interface IPairEvent
{
    ulong Order { get; }
}

/// <summary>Orders events of pairs.</summary>
internal static class PairOrder
{
    public static ulong Of(Geom one, Geom other) => one.Id < other.Id ? Pack(one, other) : Pack(other, one);

    private static ulong Pack(Geom older, Geom newer) => ((ulong)(uint)older.Id << 32) | (uint)newer.Id;
}
