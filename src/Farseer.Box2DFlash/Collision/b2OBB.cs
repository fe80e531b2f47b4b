using Box2D.Common.Math;

namespace Box2D.Collision;

/// <summary>A box that may be turned.</summary>
/// <example>
/// <code>
/// b2OBB box = ((b2PolygonShape)shape).GetOBB();
/// float half = box.extents.x;
/// </code>
/// </example>
public class b2OBB
{
    /// <summary>The rotation against the body. Default none.</summary>
    public b2Mat22 R { get; set; } = new b2Mat22();

    /// <summary>The centre, in the body, metres. Default (0, 0).</summary>
    public b2Vec2 center { get; set; } = new b2Vec2();

    /// <summary>Half the sides, metres. Default (0, 0).</summary>
    public b2Vec2 extents { get; set; } = new b2Vec2();
}
