using Box2D.Common.Math;

namespace Box2D.Collision;

/// <summary>A box whose sides are parallel to the axes.</summary>
/// <example>
/// <code>
/// var area = new b2AABB();
/// area.lowerBound.Set(-100, -100);
/// area.upperBound.Set(100, 100);
/// world = new b2World(area, new b2Vec2(0, 10), true);
/// </code>
/// </example>
public class b2AABB
{
    /// <summary>The corner with the smaller coordinates, metres. Default (0, 0).</summary>
    public b2Vec2 lowerBound { get; set; } = new b2Vec2();

    /// <summary>The corner with the greater coordinates, metres. Default (0, 0).</summary>
    public b2Vec2 upperBound { get; set; } = new b2Vec2();

    /// <summary>Whether the corners are finite and in order.</summary>
    /// <returns>True if they are.</returns>
    public bool IsValid() =>
        upperBound.x - lowerBound.x >= 0 && upperBound.y - lowerBound.y >= 0 && lowerBound.IsValid() && upperBound.IsValid();
}
