using System.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.Queries;

/// <summary>The last word on which colliders a query sees.</summary>
internal interface IQueryPredicate
{
    /// <summary>Asked in no particular order, and for a collider of several pieces perhaps more than once.</summary>
    bool Accept(int collider);
}

/// <summary>Which colliders a query sees; those of bodies that are not enabled it never does.</summary>
internal struct QueryFilter
{
    /// <summary>Flags that a collider must all have.</summary>
    public ColliderFlags Required;

    /// <summary>A collider must belong to one of these categories.</summary>
    public uint Categories;

    /// <summary>A body that is not seen; 0: all are.</summary>
    public int IgnoredBody;

    /// <summary>Another one.</summary>
    public int OtherIgnoredBody;

    public IQueryPredicate? Predicate;

    /// <summary>Sees every collider.</summary>
    public static QueryFilter All => new QueryFilter { Categories = uint.MaxValue };
}

/// <summary>Where a ray or a moving shape meets a collider.</summary>
internal struct RayHit
{
    public int Collider;

    /// <summary>True if it was in or on the collider at its start: then there is no normal.</summary>
    public bool StartsInside;

    /// <summary>Share of the way, 0 to 1.</summary>
    public double Fraction;

    /// <summary>World point on the collider.</summary>
    public double X;
    public double Y;

    /// <summary>Outward unit normal of the collider there.</summary>
    public Vector2 Normal;
}

/// <summary>The nearest point of a collider.</summary>
internal struct NearHit
{
    public int Collider;

    /// <summary>Distance from the outline, negative inside.</summary>
    public double Distance;

    /// <summary>World point on the outline.</summary>
    public double X;
    public double Y;
}

/// <summary>A way from a point.</summary>
internal struct RayInput
{
    public double X;
    public double Y;
    public double DirectionX;
    public double DirectionY;
}
