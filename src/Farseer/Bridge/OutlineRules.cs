using System;
using System.Globalization;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Shapes;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// What the library accepts as an outline: repeated, collinear and clockwise vertices are put right, the rest is refused.
/// </summary>
internal static class OutlineRules
{
    /// <summary>A copy in the documented order, without vertices that repeat the one before.</summary>
    public static Vertices Normalised(Vertices vertices, string name)
    {
        Require.NotNull(vertices, name);
        var outline = new Vertices();
        for (int i = 0; i < vertices.Count; i++)
        {
            Vector2 vertex = vertices[i];
            Require.Place(vertex, name);
            if (outline.Count == 0 || outline[outline.Count - 1] != vertex)
            {
                outline.Add(vertex);
            }
        }

        while (outline.Count > 1 && outline[0] == outline[outline.Count - 1])
        {
            outline.RemoveAt(outline.Count - 1);
        }

        PolygonFault fault = FaultOf(outline, out int index, out bool isOfPrecision);
        if (fault != PolygonFault.None)
        {
            throw new ArgumentException(isOfPrecision ? Message(fault, index, outline) : Message(fault, outline), name);
        }

        outline.ForceCounterClockWiseOrder();
        return outline;
    }

    /// <summary>What keeps vertices from being an outline.</summary>
    /// <param name="outline">The vertices.</param>
    /// <param name="index">The vertex at fault, of a fault of precision; -1: all of them.</param>
    /// <param name="isOfPrecision">Exactly there is no fault, but there is one within the precision of the coordinates.</param>
    public static PolygonFault FaultOf(Vertices outline, out int index, out bool isOfPrecision)
    {
        index = -1;
        isOfPrecision = false;
        PolygonFault fault = outline.ExactFault();
        if (fault != PolygonFault.None)
        {
            return fault;
        }

        // The exact checks do not see what is too thin for the precision of its own coordinates; those of the engine do.
        OutlineProblem problem = Outline.Check(outline.ToArray(), out index);
        if (problem != OutlineProblem.None)
        {
            isOfPrecision = true;
            return problem == OutlineProblem.SelfIntersecting ? PolygonFault.SelfIntersecting : PolygonFault.NoArea;
        }

        return IsInRange(outline) ? PolygonFault.None : PolygonFault.OutOfRange;
    }

    /// <summary>Whether two edges touch that do not follow each other.</summary>
    public static bool Crosses(Vertices outline) => EdgeCrossing.First(outline.ToArray()) >= 0;

    /// <summary>A copy without points that repeat the one before, for a chain.</summary>
    public static Vertices NormalisedChain(Vertices points, bool loop, string name)
    {
        Require.NotNull(points, name);
        var chain = new Vertices();
        for (int i = 0; i < points.Count; i++)
        {
            Vector2 point = Require.Place(points[i], name);
            if (chain.Count == 0 || chain[chain.Count - 1] != point)
            {
                chain.Add(point);
            }
        }

        if (loop && chain.Count > 1 && chain[0] == chain[chain.Count - 1])
        {
            chain.RemoveAt(chain.Count - 1);
        }

        int least = loop ? 3 : 2;
        if (chain.Count < least)
        {
            throw new ArgumentException(
                "The chain has " + chain.Count.ToString(CultureInfo.InvariantCulture) + " different points; it needs at least "
                + least.ToString(CultureInfo.InvariantCulture) + ".",
                name);
        }

        CheckSize(chain, name);
        return chain;
    }

    private static void CheckSize(Vertices points, string name)
    {
        if (!(Size(points) >= StateRange.Least && Size(points) <= StateRange.Limit))
        {
            throw new ArgumentException(SizeMessage(points), name);
        }
    }

    private static bool IsInRange(Vertices points)
    {
        foreach (Vector2 point in points)
        {
            if (!(Math.Abs(point.X) <= StateRange.Limit && Math.Abs(point.Y) <= StateRange.Limit))
            {
                return false;
            }
        }

        return Size(points) >= StateRange.Least && Size(points) <= StateRange.Limit;
    }

    private static float Size(Vertices points)
    {
        var box = new AABB(points);
        return Math.Max(box.Width, box.Height);
    }

    private static string SizeMessage(Vertices points) =>
        "The size of " + points.Count.ToString(CultureInfo.InvariantCulture) + " points, "
        + Size(points).ToString(CultureInfo.InvariantCulture) + ", must be from 1.1E-19 to 9.2E18.";

    private static string Message(PolygonFault fault, int index, Vertices outline)
    {
        string place = index < 0 ? "" : " at vertex " + index.ToString(CultureInfo.InvariantCulture) + ", " + outline[index] + ",";
        string what = fault == PolygonFault.SelfIntersecting ? "touches or crosses itself" : "has no area";
        return "Within the precision of its coordinates the outline of " + outline.Count.ToString(CultureInfo.InvariantCulture)
            + " vertices" + place + " " + what + ".";
    }

    private static string Message(PolygonFault fault, Vertices outline)
    {
        string many = outline.Count.ToString(CultureInfo.InvariantCulture);
        return fault switch
        {
            PolygonFault.TooFewVertices => "The outline has " + many + " different vertices; it needs at least 3.",
            PolygonFault.NoArea => "The outline of " + many + " vertices has no area.",
            PolygonFault.SelfIntersecting => "The outline of " + many + " vertices touches or crosses itself.",
            PolygonFault.OutOfRange => SizeMessage(outline),
            _ => "The outline of " + many + " vertices has the fault " + fault + ".",
        };
    }
}
