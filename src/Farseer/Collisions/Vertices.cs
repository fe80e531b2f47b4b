using System;
using System.Collections.Generic;
using System.Globalization;
using System.Numerics;
using System.Text;
using FarseerGames.FarseerPhysics.Mathematics;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>The outline of a shape: a list of corners, joined in order, the last one to the first (manual: "Geometry").</summary>
/// <remarks>
/// <para>
/// Add the corners with <see cref="List{T}.Add"/>, in either direction, without repeating the first one at the end. Lengths are
/// in the units of the world. Edge <c>i</c> leads from vertex <c>i</c> to vertex <see cref="NextIndex"/>(i).
/// </para>
/// <para>
/// Normals are an edge turned by a quarter from the x axis towards the y axis; they point out of the shape when the order is that of
/// <see cref="ForceCounterClockWiseOrder"/>, and into it otherwise.
/// </para>
/// <para>
/// The list itself accepts any values; <see cref="CheckPolygon"/> tells what, if anything, keeps it from being a proper outline.
/// </para>
/// </remarks>
/// <example>
/// <code>
/// Vertices triangle = new() { new Vector2(-1, 0), new Vector2(1, 0), new Vector2(0, 2) };
/// Body wedge = BodyFactory.Instance.CreatePolygonBody(simulator, triangle, 1);
/// GeomFactory.Instance.CreatePolygonGeom(simulator, wedge, triangle, 0.1f);
/// </code>
/// </example>
public partial class Vertices : List<Vector2>
{
    /// <summary>More edges than that a circle surely has by mistake; the work that they cause grows faster than their number.</summary>
    internal const int MostEdges = 65536;

    /// <summary>Makes an empty list.</summary>
    public Vertices()
    {
    }

    /// <summary>Makes a list of the points of an array.</summary>
    /// <param name="vector2">The points; the array is copied.</param>
    /// <exception cref="ArgumentNullException"><paramref name="vector2"/> is null.</exception>
    public Vertices(Vector2[] vector2)
        : base(Require.NotNull(vector2, nameof(vector2)))
    {
    }

    /// <summary>Makes a copy of a list.</summary>
    /// <param name="vertices">The list to copy.</param>
    /// <exception cref="ArgumentNullException"><paramref name="vertices"/> is null.</exception>
    public Vertices(Vertices vertices)
        : base(Require.NotNull(vertices, nameof(vertices)))
    {
    }

    /// <summary>Makes a rectangle around the origin.</summary>
    /// <param name="width">Its width, in world units; above 0.</param>
    /// <param name="height">Its height, in world units; above 0.</param>
    /// <returns>16 points: the corners and, on each side, the quarter points; first (-width/2, -height/2), then along the side
    /// towards (-width/2, height/2).</returns>
    /// <exception cref="ArgumentOutOfRangeException">A side is not a finite number above 0.</exception>
    public static Vertices CreateRectangle(float width, float height)
    {
        Require.Positive(width, nameof(width));
        Require.Positive(height, nameof(height));
        var x = width * 0.5f;
        var y = height * 0.5f;
        var quarterX = width * 0.25f;
        var quarterY = height * 0.25f;
        return new Vertices
        {
            new Vector2(-x, -y),
            new Vector2(-x, -quarterY),
            new Vector2(-x, 0f),
            new Vector2(-x, quarterY),
            new Vector2(-x, y),
            new Vector2(-quarterX, y),
            new Vector2(0f, y),
            new Vector2(quarterX, y),
            new Vector2(x, y),
            new Vector2(x, quarterY),
            new Vector2(x, 0f),
            new Vector2(x, -quarterY),
            new Vector2(x, -y),
            new Vector2(quarterX, -y),
            new Vector2(0f, -y),
            new Vector2(-quarterX, -y),
        };
    }

    /// <summary>Makes a regular polygon that approximates a circle around the origin.</summary>
    /// <param name="radius">The distance of the corners from the origin, in world units; above 0.</param>
    /// <param name="numberOfEdges">The number of corners; from 3 to 65536.</param>
    /// <returns>The corners, from (radius, 0) on towards negative y.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="radius"/> is not a finite number above 0, or
    /// <paramref name="numberOfEdges"/> is out of its range.</exception>
    public static Vertices CreateCircle(float radius, int numberOfEdges)
    {
        Require.Positive(radius, nameof(radius));
        return CreateEllipse(radius, radius, numberOfEdges);
    }

    /// <summary>Makes a polygon that approximates an ellipse around the origin.</summary>
    /// <param name="xRadius">Half its width, in world units; above 0.</param>
    /// <param name="yRadius">Half its height, in world units; above 0.</param>
    /// <param name="numberOfEdges">The number of corners; from 3 to 65536.</param>
    /// <returns>The corners, from (xRadius, 0) on towards negative y, at equal steps of the parameter angle.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A radius is not a finite number above 0, or
    /// <paramref name="numberOfEdges"/> is out of its range.</exception>
    public static Vertices CreateEllipse(float xRadius, float yRadius, int numberOfEdges)
    {
        Require.Positive(xRadius, nameof(xRadius));
        Require.Positive(yRadius, nameof(yRadius));
        Require.Within(numberOfEdges, 3, MostEdges, nameof(numberOfEdges));

        // The angle is rounded to float before the sine is taken: that gives the very points of version 2.0.1.
        var step = MathHelper.TwoPi / numberOfEdges;
        var vertices = new Vertices { new Vector2(xRadius, 0f) };
        for (var i = 1; i < numberOfEdges; i++)
        {
            var angle = step * i;
            vertices.Add(new Vector2(xRadius * Calculator.Cos(angle), -yRadius * Calculator.Sin(angle)));
        }

        return vertices;
    }

    /// <summary>The index that follows, round the outline.</summary>
    /// <param name="index">The index of a vertex.</param>
    /// <returns>The next index; 0 after the last.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such vertex.</exception>
    public int NextIndex(int index)
    {
        CheckIndex(index);
        return index == Count - 1 ? 0 : index + 1;
    }

    /// <summary>The index that goes before, round the outline.</summary>
    /// <param name="index">The index of a vertex.</param>
    /// <returns>The index before; the last before 0.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such vertex.</exception>
    public int PreviousIndex(int index)
    {
        CheckIndex(index);
        return index == 0 ? Count - 1 : index - 1;
    }

    /// <summary>The vector from a vertex to the next.</summary>
    /// <param name="index">The index of the vertex at which the edge starts.</param>
    /// <returns>The edge, in world units.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such vertex.</exception>
    public Vector2 GetEdge(int index) => this[NextIndex(index)] - this[index];

    /// <inheritdoc cref="GetEdge(int)" path="/summary|/param[@name='index']|/exception"/>
    /// <param name="index">The index of the vertex at which the edge starts.</param>
    /// <param name="edge">The edge, in world units.</param>
    public void GetEdge(int index, out Vector2 edge) => edge = GetEdge(index);

    /// <summary>The middle of an edge.</summary>
    /// <param name="index">The index of the vertex at which the edge starts.</param>
    /// <returns>The point half way to the next vertex.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such vertex.</exception>
    public Vector2 GetEdgeMidPoint(int index)
    {
        CheckIndex(index);
        return this[index] + (GetEdge(index) * 0.5f);
    }

    /// <summary>The middle of an edge.</summary>
    /// <param name="index">The index of the vertex at which the edge starts.</param>
    /// <param name="midPoint">The point half way to the next vertex.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such vertex.</exception>
    public void GetEdgeMidPoint(int index, out Vector2 midPoint) => midPoint = GetEdgeMidPoint(index);

    /// <summary>The unit normal of an edge: the edge turned by a quarter from the x axis towards the y axis.</summary>
    /// <param name="index">The index of the vertex at which the edge starts.</param>
    /// <returns>The normal; it points outwards when the order is that of <see cref="ForceCounterClockWiseOrder"/>. (0, 0) for an
    /// edge without length.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such vertex.</exception>
    public Vector2 GetEdgeNormal(int index)
    {
        var edge = GetEdge(index);
        return UnitOrZero(new Vector2(-edge.Y, edge.X));
    }

    /// <summary>The unit normal of an edge: the edge turned by a quarter from the x axis towards the y axis.</summary>
    /// <param name="index">The index of the vertex at which the edge starts.</param>
    /// <param name="edgeNormal">The normal; see <see cref="GetEdgeNormal(int)"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such vertex.</exception>
    public void GetEdgeNormal(int index, out Vector2 edgeNormal) => edgeNormal = GetEdgeNormal(index);

    /// <summary>The unit normal at a vertex: half way between those of the two edges that meet there.</summary>
    /// <param name="index">The index of the vertex.</param>
    /// <returns>The normal; (0, 0) where the edges run back on each other.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such vertex.</exception>
    public Vector2 GetVertexNormal(int index) => UnitOrZero(GetEdgeNormal(index) + GetEdgeNormal(PreviousIndex(index)));

    /// <summary>The unit normal at a vertex: half way between those of the two edges that meet there.</summary>
    /// <param name="index">The index of the vertex.</param>
    /// <param name="vertexNormal">The normal; see <see cref="GetVertexNormal(int)"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such vertex.</exception>
    public void GetVertexNormal(int index, out Vector2 vertexNormal) => vertexNormal = GetVertexNormal(index);

    /// <summary>The length of the shortest edge.</summary>
    /// <returns>A length in world units; 0 for a list of one point.</returns>
    /// <exception cref="InvalidOperationException">The list is empty.</exception>
    public float GetShortestEdge()
    {
        if (Count == 0)
        {
            throw new InvalidOperationException("An empty list of vertices has no edge.");
        }

        var shortest = float.MaxValue;
        for (var i = 0; i < Count; i++)
        {
            shortest = Math.Min(shortest, GetEdge(i).Length());
        }

        return shortest;
    }

    /// <summary>
    /// Cuts every edge that is longer than a length into equal pieces that are not (manual: "Known issues": a geom with long edges
    /// and few vertices can let others slip in, because contacts are found at vertices).
    /// </summary>
    /// <param name="maxEdgeLength">The longest edge wanted, in world units; above 0.</param>
    /// <remarks>
    /// The shape stays as it is, up to the rounding of the new points; an edge can exceed the length by that rounding only.
    /// </remarks>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="maxEdgeLength"/> is not a finite number above 0.</exception>
    /// <exception cref="InvalidOperationException">A vertex is not finite, or the length is so small that an edge would fall into
    /// more than a million pieces; the list is then left as it was.</exception>
    public void SubDivideEdges(float maxEdgeLength)
    {
        Require.Positive(maxEdgeLength, nameof(maxEdgeLength));
        const double MostPieces = 1_000_000d;
        var result = new List<Vector2>(Count);
        for (var i = 0; i < Count; i++)
        {
            var start = this[i];
            var edge = GetEdge(i);
            var pieces = Math.Ceiling(edge.Length() / (double)maxEdgeLength);
            if (!(pieces <= MostPieces))
            {
                throw new InvalidOperationException(
                    $"Edge {i}, of length {edge.Length()}, cannot be cut into pieces of {maxEdgeLength}: too many, or not finite.");
            }

            result.Add(start);
            for (var k = 1; k < pieces; k++)
            {
                result.Add(start + (edge * (float)(k / pieces)));
            }
        }

        Clear();
        AddRange(result);
    }

    /// <summary>
    /// The range that the outline covers along a direction: the smallest and the largest scalar product of a vertex with it.
    /// </summary>
    /// <param name="axis">The direction; not changed. With a unit vector the range is in world units.</param>
    /// <param name="min">The least product.</param>
    /// <param name="max">The largest product.</param>
    /// <exception cref="InvalidOperationException">The list is empty.</exception>
    public void ProjectToAxis(ref Vector2 axis, out float min, out float max)
    {
        if (Count == 0)
        {
            throw new InvalidOperationException("An empty list of vertices covers no range.");
        }

        min = Vector2.Dot(axis, this[0]);
        max = min;
        for (var i = 1; i < Count; i++)
        {
            var product = Vector2.Dot(axis, this[i]);
            min = Math.Min(min, product);
            max = Math.Max(max, product);
        }
    }

    /// <summary>Moves all vertices.</summary>
    /// <param name="vector">The displacement, in world units.</param>
    /// <exception cref="ArgumentOutOfRangeException">A coordinate is not finite.</exception>
    public void Translate(Vector2 vector)
    {
        Require.Finite(vector, nameof(vector));
        for (var i = 0; i < Count; i++)
        {
            this[i] += vector;
        }
    }

    /// <summary>Multiplies all vertices, so that the outline grows or shrinks about the origin.</summary>
    /// <param name="value">The factors along x and y. One negative factor mirrors the outline and so turns its order round.</param>
    /// <exception cref="ArgumentOutOfRangeException">A factor is not finite.</exception>
    public void Scale(Vector2 value)
    {
        Require.Finite(value, nameof(value));
        for (var i = 0; i < Count; i++)
        {
            this[i] *= value;
        }
    }

    /// <summary>Copies the vertices into an array.</summary>
    /// <returns>A new array.</returns>
    public Vector2[] GetVerticesArray() => ToArray();

    /// <summary>A text that shows the vertices in order.</summary>
    /// <returns>The text, in the invariant culture, for messages and the debugger.</returns>
    public override string ToString()
    {
        var text = new StringBuilder();
        foreach (var vertex in this)
        {
            text.Append(text.Length == 0 ? "(" : " (");
            text.Append(vertex.X.ToString(CultureInfo.InvariantCulture)).Append(", ");
            text.Append(vertex.Y.ToString(CultureInfo.InvariantCulture)).Append(')');
        }

        return text.ToString();
    }

    private static Vector2 UnitOrZero(Vector2 value)
    {
        // The reciprocal of the length, as version 2.0.1 has it; the quotient would differ in the last bit.
        var length = (float)Math.Sqrt((value.X * value.X) + (value.Y * value.Y));
        if (length > 0f)
        {
            return value * (1f / length);
        }

        return Vector2.Zero;
    }

    private void CheckIndex(int index)
    {
        if ((uint)index >= (uint)Count)
        {
            throw new ArgumentOutOfRangeException(nameof(index), index, $"There are {Count} vertices.");
        }
    }
}
