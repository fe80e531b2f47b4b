using System.Numerics;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>
/// Contact of a one-sided link (a line of a chain) with another piece of two or more corners, or with another link. A link has no
/// inside that could say which way out is the short one, so three questions come before the contact. Is the other piece in front? Told
/// where it crosses the link and not by its centre: that of a wide floor lies anywhere. Is the link's own face what it touches? Not if
/// its nearest corner is beyond the link's ends and the side that crosses the link is steep: then an end of the link touches that
/// side. Does it meet the open end of a chain? That end has no neighbour that would make the contact in its place.
/// </summary>
internal static unsafe class LinkContact
{
    /// <summary>Cosine of the angle up to which a side that crosses the link lies on it: nearer to flat than to upright.</summary>
    private const float Steep = 0.7071f;

    public static void Collide(in PairInput pair, out Manifold manifold)
    {
        manifold = default;
        var a = new Hull(pair, pair.A);
        var b = new Hull(pair, pair.B);
        Placement bInA;
        bInA.Rotation = pair.RotationB.RelativeTo(pair.RotationA);
        bInA.Offset = pair.RotationA.InverseRotate(pair.Offset);
        Placement aInB;
        aInB.Rotation = new Rotation(bInA.Rotation.Cos, -bInA.Rotation.Sin);
        aInB.Offset = pair.RotationB.InverseRotate(-pair.Offset);
        bool links = a.IsLink && b.IsLink;
        bool faceEachOther = links && Vector2.Dot(a.Normals[0], bInA.Rotation.Rotate(b.Normals[0])) < 0;
        float scale = pair.A.Extent < pair.B.Extent ? pair.A.Extent : pair.B.Extent;

        // Behind each of two links that face each other is the body that it bounds, as thick as the link's extent tells.
        float limit = pair.Margin + a.Radius + b.Radius;
        float most = faceEachOther && scale > limit ? scale : limit;
        AxisQuery fromA = AxisQuery.Find(a, b, bInA, pair.B.Center);
        AxisQuery fromB = AxisQuery.Find(b, a, aInB, pair.A.Center);
        if (fromA.Greatest > most || fromB.Greatest > most
            || (a.IsLink && fromA.RealSeparation > limit) || (b.IsLink && fromB.RealSeparation > limit))
        {
            return;
        }

        // Of the other's sides only the nearest counts: where a neighbour has that one, the link's ends would take any, the far one too.
        bool facesA = fromA.Edge >= 0 && fromA.Edge == fromA.RealEdge;
        bool takesA = facesA;
        bool takesB = fromB.Edge >= 0 && fromB.Edge == fromB.RealEdge;
        if (a.IsLink && (links ? !faceEachOther : IsBehind(a, b, bInA, scale)))
        {
            takesA = false;
            takesB = takesB && a.IsOpenEnd(fromB.Support) && IsShortest(fromB, fromA, links);
        }

        if (b.IsLink && (links ? !faceEachOther : IsBehind(b, a, aInB, scale)))
        {
            takesB = takesB && links;
            takesA = facesA && b.IsOpenEnd(fromA.Support) && IsShortest(fromA, fromB, links);
        }

        float deepest = pair.A.Extent > pair.B.Extent ? -pair.A.Extent : -pair.B.Extent;
        takesA = takesA && (!a.IsLink || Touches(a, b, bInA, fromA, deepest));
        takesB = takesB && (!b.IsLink || Touches(b, a, aInB, fromB, deepest));
        if (takesA && (!takesB || !(fromB.Separation > fromA.Separation + (ConvexConvex.ReferenceBias * scale))))
        {
            EdgeContact.Build(a, b, bInA, fromA, pair.Margin, scale, ref manifold, flipped: false);
            ConvexConvex.ToWorld(ref manifold, pair.RotationA, Vector2.Zero);
        }
        else if (takesB)
        {
            EdgeContact.Build(b, a, aInB, fromB, pair.Margin, scale, ref manifold, flipped: true);
            manifold.Normal = -manifold.Normal;
            ConvexConvex.ToWorld(ref manifold, pair.RotationB, pair.Offset);
        }
    }

    /// <summary>
    /// True if the open end of a link lies less deep under the other's side than in any other way. Past a link's end it is no way out:
    /// there the chain goes on.
    /// </summary>
    private static bool IsShortest(in AxisQuery side, in AxisQuery own, bool links) =>
        side.Separation >= side.Greatest && (links || side.Separation >= own.Greatest);

    /// <summary>
    /// True if, of the part of the other piece that lies over or under the link, more reaches out behind it than before it: the way out
    /// to the back is the shorter one. A little beyond the link's ends belongs to it: of a rod that leans over a joint it would be but the
    /// tip.
    /// </summary>
    private static bool IsBehind(in Hull link, in Hull other, in Placement placement, float beyond)
    {
        var frame = new LinkFrame(link, placement, beyond);
        float lowest = float.MaxValue;
        float highest = float.MinValue;
        Vector2 last = frame.Of(other.Vertices[other.Count - 1]);
        for (int i = 0; i < other.Count; i++)
        {
            Vector2 next = frame.Of(other.Vertices[i]);
            frame.Clip(last, next, ref lowest, ref highest);
            last = next;
        }

        return -lowest > highest;
    }

    /// <summary>
    /// True if the other piece lies on the link's face with its nearest corner or with one of the sides at it, and no deeper than the
    /// larger of the two is thick: beyond is the far side of a floor.
    /// </summary>
    private static bool Touches(in Hull link, in Hull other, in Placement placement, in AxisQuery axis, float deepest)
    {
        int support = axis.Support;
        var frame = new LinkFrame(link, placement, 0);
        float along = frame.Of(other.Vertices[support]).X;
        if (along >= 0 && along <= frame.Length)
        {
            return true;
        }

        Vector2 normal = placement.Rotation.InverseRotate(link.Normals[0]);
        return axis.Separation >= deepest
            && (Vector2.Dot(other.Normals[support], normal) < -Steep
                || Vector2.Dot(other.Normals[other.Previous(support)], normal) < -Steep);
    }

    /// <summary>Places along a link from its start and heights before it.</summary>
    private readonly struct LinkFrame
    {
        public readonly float Length;
        private readonly Placement _placement;
        private readonly Vector2 _origin;
        private readonly Vector2 _normal;
        private readonly float _beyond;

        /// <param name="link">The link.</param>
        /// <param name="placement">Of what is told about.</param>
        /// <param name="beyond">How far past its ends what <see cref="Clip"/> takes may lie.</param>
        public LinkFrame(in Hull link, in Placement placement, float beyond)
        {
            _beyond = beyond;
            _placement = placement;
            _origin = link.Vertices[0];
            _normal = link.Normals[0];
            Length = 0;
            Length = Local(link.Vertices[1]).X;
        }

        public Vector2 Of(Vector2 vertex) => Local(_placement.Apply(vertex));

        /// <summary>Widens the range of heights by that of the part of a side that lies over or under the link.</summary>
        public void Clip(Vector2 from, Vector2 to, ref float lowest, ref float highest)
        {
            float least = -_beyond;
            float most = Length + _beyond;
            if ((from.X < least && to.X < least) || (from.X > most && to.X > most))
            {
                return;
            }

            Take(HeightWithin(from, to), ref lowest, ref highest);
            Take(HeightWithin(to, from), ref lowest, ref highest);
        }

        private float HeightWithin(Vector2 at, Vector2 other)
        {
            float x = at.X < -_beyond ? -_beyond : at.X > Length + _beyond ? Length + _beyond : at.X;
            return x == at.X ? at.Y : at.Y + ((other.Y - at.Y) * ((x - at.X) / (other.X - at.X)));
        }

        private static void Take(float height, ref float lowest, ref float highest)
        {
            lowest = height < lowest ? height : lowest;
            highest = height > highest ? height : highest;
        }

        private Vector2 Local(Vector2 point)
        {
            Vector2 d = point - _origin;
            return new Vector2((d.Y * _normal.X) - (d.X * _normal.Y), Vector2.Dot(d, _normal));
        }
    }
}
