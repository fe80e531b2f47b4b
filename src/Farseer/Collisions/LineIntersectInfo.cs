using System.Collections.Generic;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>Where a line meets a geom.</summary>
/// <example>
/// <code>
/// var all = new List&lt;LineIntersectInfo&gt;();
/// CollisionHelper.LineSegmentGeomIntersect(new Vector2(-9, 0), new Vector2(9, 0), geom, true, ref all);
/// foreach (LineIntersectInfo met in all)
/// {
///     Console.WriteLine(met.Geom + " at " + met.Points[0]);
/// }
/// </code>
/// </example>
public class LineIntersectInfo
{
    /// <summary>Keeps a geom and the points where a line meets it.</summary>
    /// <param name="geom">The geom.</param>
    /// <param name="points">The points, in world coordinates.</param>
    public LineIntersectInfo(Geom geom, List<Vector2> points)
    {
        Geom = geom;
        Points = points;
    }

    /// <summary>The geom.</summary>
    public Geom Geom { get; }

    /// <summary>The points, in world coordinates.</summary>
    public List<Vector2> Points { get; }
}
