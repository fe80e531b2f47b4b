using System;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>Checks of the outline.</content>
public partial class Vertices
{
    /// <summary>Tells whether the outline is convex: it turns one way only, and once round.</summary>
    /// <returns>True for a convex polygon; vertices on a straight side are allowed. False for fewer than 3 vertices or no
    /// area.</returns>
    public bool IsConvex()
    {
        if (Count < 3)
        {
            return false;
        }

        var area = SignedArea();
        if (!(Math.Abs(area) > 0d) || double.IsInfinity(area))
        {
            return false;
        }

        var sign = area > 0d ? 1d : -1d;
        var origin = this[0];
        for (var i = 0; i < Count; i++)
        {
            var b = this[NextIndex(i)];
            var c = this[NextIndex(NextIndex(i))];

            // The first test finds dents. The second finds an outline that turns one way but goes round more than once (a star):
            // seen from its first vertex it must run backwards somewhere.
            if (sign * Cross(this[i], b, c) < 0d || sign * Cross(origin, this[i], b) < 0d)
            {
                return false;
            }
        }

        return !HasSpike();
    }

    /// <summary>Tells whether the vertices are a proper outline: see <see cref="CheckPolygon"/>.</summary>
    /// <returns>True if nothing is wrong with them.</returns>
    public bool IsSimple() => CheckPolygon() == PolygonFault.None;

    /// <summary>
    /// Tells what, if anything, keeps the vertices from being the outline of a shape. Geoms and factories ask the same, but for repeated
    /// vertices, which they leave out: what is too thin for the precision of its coordinates has no area, or touches itself.
    /// </summary>
    /// <returns>The first fault found, in the order of <see cref="PolygonFault"/>.</returns>
    public PolygonFault CheckPolygon() => OutlineRules.FaultOf(this, out _, out _);

    /// <summary>The first fault of the vertices as they are, without tolerance; exact for coordinates of like size.</summary>
    internal PolygonFault ExactFault()
    {
        if (Count < 3)
        {
            return PolygonFault.TooFewVertices;
        }

        foreach (var vertex in this)
        {
            if (!Require.IsFinite(vertex))
            {
                return PolygonFault.NotFinite;
            }
        }

        for (var i = 0; i < Count; i++)
        {
            if (this[i] == this[NextIndex(i)])
            {
                return PolygonFault.RepeatedVertex;
            }
        }

        if (!(Math.Abs(SignedArea()) > 0d))
        {
            return PolygonFault.NoArea;
        }

        return HasSpike() || OutlineRules.Crosses(this) ? PolygonFault.SelfIntersecting : PolygonFault.None;
    }

    /// <summary>Whether two edges that follow each other run back on themselves.</summary>
    private bool HasSpike()
    {
        for (var i = 0; i < Count; i++)
        {
            var a = this[i];
            var b = this[NextIndex(i)];
            var c = this[NextIndex(NextIndex(i))];
            var dot = (((double)b.X - a.X) * ((double)c.X - b.X)) + (((double)b.Y - a.Y) * ((double)c.Y - b.Y));
            if (dot < 0d && Cross(a, b, c) == 0d)
            {
                return true;
            }
        }

        return false;
    }
}
