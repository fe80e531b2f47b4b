namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>What can be wrong with the outline of a shape; the answers of <see cref="Vertices.CheckPolygon"/>.</summary>
/// <example>
/// <code>
/// var outline = new Vertices { new Vector2(0, 0), new Vector2(2, 2), new Vector2(2, 0), new Vector2(0, 2) };
/// if (outline.CheckPolygon() == PolygonFault.SelfIntersecting)
/// {
///     Console.WriteLine("Its edges cross.");
/// }
/// </code>
/// </example>
public enum PolygonFault
{
    /// <summary>Nothing: a proper outline.</summary>
    None = 0,

    /// <summary>Fewer than 3 vertices.</summary>
    TooFewVertices = 1,

    /// <summary>A coordinate is infinite or not a number.</summary>
    NotFinite = 2,

    /// <summary>Two vertices that follow each other, or the last and the first, are at the same position.</summary>
    RepeatedVertex = 3,

    /// <summary>The area is 0: all vertices are on a line, or the parts of the outline cancel.</summary>
    NoArea = 4,

    /// <summary>Two edges cross, touch or run back on each other.</summary>
    SelfIntersecting = 5,

    /// <summary>The outline is smaller than 1.1·10⁻¹⁹ or larger than 9.2·10¹⁸, or a coordinate is beyond that.</summary>
    OutOfRange = 6,
}
