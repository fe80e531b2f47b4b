using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.Contacts;

/// <summary>Where the neighbours of a contact are looked for.</summary>
internal ref struct SeamInput
{
    public ShapeStore Shapes;
    public BodyStore Bodies;
    public ContactStore Contacts;

    /// <summary>Seconds from where the bodies are to the moment that is asked about.</summary>
    public float Ahead;
}

/// <summary>
/// Pieces that cannot move and lie side by side are one surface, whatever bodies they belong to. Where the surface goes on, the side of
/// the next piece and the slanting normals of its corner are hidden: a body that is sunk in by the depth of rest, or falls on the seam,
/// has overlap with that side and no business with it. As <see cref="OutlineCone"/> says of the parts of one outline, a direction is
/// admitted at a corner that two pieces share only if it lies in the cones of both. So a contact with one piece is hidden by another if
/// <list type="bullet">
/// <item>the body has a contact with the other, itself not hidden, in a direction that a face of the first looks to as well;</item>
/// <item>the contact's normal leans over the other's face, by more than the other's own contact leans over a face of the first: of two
/// that hide each other the one that leans less stays, so something always holds;</item>
/// <item>it is no contact with that face of the first, but with what comes before its end; and</item>
/// <item>moved to where it just touches the other, the body would pass over that end. What stands higher by more than a glance is a
/// wall.</item>
/// </list>
/// Neither velocities nor depths are asked for.
/// </summary>
internal static unsafe class HiddenContact
{
    /// <summary>
    /// Sine of what a normal may lean by: above rounding, and below the slant of a corner that a circle's centre has all but reached.
    /// </summary>
    private const float Upright = 1e-5f;

    /// <summary>Faces nearer to each other than this (cosine) belong to a bend, not to a corner.</summary>
    private const float Corner = 0.5f;

    /// <summary>The other's contact must lean less by this factor.</summary>
    private const float Clearly = 0.5f;

    /// <summary>
    /// Faces that lean towards each other by more than this (sine) meet at a corner: their nearer point alone says with what the contact
    /// is.
    /// </summary>
    private const float Level = 0.1f;

    /// <summary>Corners of the body that are no farther back than this share of its extent are its front.</summary>
    private const float FrontShare = 0.25f;

    /// <summary>Whether a contact of a body with a piece that cannot move is hidden by another such piece.</summary>
    /// <param name="input">Where the neighbours are looked for.</param>
    /// <param name="contact">The pair; one side of it can move.</param>
    /// <param name="manifold">Its points, from the centre of its body A.</param>
    /// <param name="pose">Where the body that can move is.</param>
    public static bool Is(in SeamInput input, int contact, in Manifold manifold, in BodyPose pose)
    {
        ref ContactRecord record = ref input.Contacts.Records[contact];
        int mover = record.Mover;
        int first = input.Contacts.FirstAtFixed(mover);
        if (input.Contacts.NextAtFixed(first) < 0)
        {
            return false;
        }

        bool movesA = mover == record.PieceA;
        var own = new FixedPiece(input, movesA ? record.PieceB : record.PieceA, pose);
        Touch touch = Touch.Of(manifold, movesA ? -1 : 1, movesA ? Vector2.Zero : own.Offset);
        return IsHidden(input, contact, own, touch, pose, byShown: true);
    }

    /// <summary>Whether one of the body's other contacts hides one.</summary>
    /// <param name="input">Where these are looked for.</param>
    /// <param name="contact">The pair.</param>
    /// <param name="own">Its piece that cannot move.</param>
    /// <param name="touch">Its contact.</param>
    /// <param name="pose">Where the body is.</param>
    /// <param name="byShown">Only those count that are not hidden themselves.</param>
    private static bool IsHidden(
        in SeamInput input, int contact, in FixedPiece own, in Touch touch, in BodyPose pose, bool byShown)
    {
        int mover = input.Contacts.Records[contact].Mover;
        float glance = FastPairs.Glance(input.Shapes.Pieces[mover], input.Shapes.Pieces[own.Index]);
        for (int next = input.Contacts.FirstAtFixed(mover); next >= 0; next = input.Contacts.NextAtFixed(next))
        {
            float margin = glance + Math.Max(touch.Separation, 0);
            if (next == contact || !Holds(input, next)
                || !TryTouch(input, next, margin, pose, out FixedPiece other, out Touch held))
            {
                continue;
            }

            float lean = other.Lean(held.Normal, touch, glance);
            if (!(lean > Upright) || !(own.Lean(held.Normal, held, glance) < Clearly * lean))
            {
                continue;
            }

            ref Piece piece = ref input.Shapes.Pieces[mover];
            var turn = new Rotation(pose.Cos, pose.Sin);
            float low = FrontLow(input.Shapes, piece, turn, held.Normal, touch.Normal) - held.Separation;
            if (own.EndsBelow(held.Normal, touch, low, glance)
                && (!byShown || !IsHidden(input, next, other, held, pose, byShown: false)))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>
    /// The pair gives impulses if it touches. What a handler refused is forgotten once nobody hears of the pair, which workers may be
    /// about to note.
    /// </summary>
    private static bool Holds(in SeamInput input, int contact)
    {
        ref ContactRecord record = ref input.Contacts.Records[contact];
        ColliderFlags a = input.Shapes.ColliderAt(record.PieceA).Flags;
        ColliderFlags b = input.Shapes.ColliderAt(record.PieceB).Flags;
        const ColliderFlags Wants = ColliderFlags.WantsContact | ColliderFlags.WantsSeparation;
        bool isRefused = (record.Flags & ContactFlags.Vetoed) != 0 && ((a | b) & Wants) != 0;
        return !isRefused && (a & b & ColliderFlags.ResponseEnabled) != 0;
    }

    /// <summary>Another contact of the body as it is there, if there is one.</summary>
    private static bool TryTouch(in SeamInput input, int contact, float margin, in BodyPose pose, out FixedPiece other, out Touch held)
    {
        ref ContactRecord record = ref input.Contacts.Records[contact];
        int mover = record.Mover;
        other = new FixedPiece(input, mover == record.PieceA ? record.PieceB : record.PieceA, pose);
        PairInput pair;
        pair.Vertices = input.Shapes.Vertices.Pointer;
        pair.Normals = input.Shapes.Normals.Pointer;
        pair.OutlineBefore = input.Shapes.OutlineBefore.Pointer;
        pair.OutlineAfter = input.Shapes.OutlineAfter.Pointer;
        pair.PieceA = input.Shapes.Pieces.Pointer + other.Index;
        pair.PieceB = input.Shapes.Pieces.Pointer + mover;
        pair.RotationA = other.Turn;
        pair.RotationB = new Rotation(pose.Cos, pose.Sin);
        pair.Offset = -other.Offset;
        pair.Margin = margin;
        Collision.Collide(pair, out Manifold manifold);
        held = Touch.Of(manifold, 1, other.Offset);
        return manifold.Count > 0;
    }

    /// <summary>The lowest that the front of the body reaches.</summary>
    private static float FrontLow(ShapeStore shapes, in Piece piece, Rotation turn, Vector2 up, Vector2 back)
    {
        Vector2* v = shapes.Vertices.Pointer + piece.VertexStart;
        Vector2 ownUp = turn.InverseRotate(up);
        Vector2 ownBack = turn.InverseRotate(back);
        float front = float.MaxValue;
        for (int i = 0; i < piece.VertexCount; i++)
        {
            front = Math.Min(front, Vector2.Dot(ownBack, v[i]));
        }

        front += FrontShare * piece.Extent;
        float low = float.MaxValue;
        for (int i = 0; i < piece.VertexCount; i++)
        {
            low = Vector2.Dot(ownBack, v[i]) <= front ? Math.Min(low, Vector2.Dot(ownUp, v[i])) : low;
        }

        return low - piece.Radius;
    }

    /// <summary>A contact of the body, from its centre.</summary>
    private struct Touch
    {
        /// <summary>From the piece to the body.</summary>
        public Vector2 Normal;

        /// <summary>Points of the piece; the second is the first if there is one, or if it is nearer than the second.</summary>
        public Vector2 Point0;
        public Vector2 Point1;

        /// <summary>The least of the points.</summary>
        public float Separation;

        /// <param name="manifold">From some centre.</param>
        /// <param name="sign">1 if its normal points from the piece to the body, else -1.</param>
        /// <param name="center">That centre from the body's.</param>
        public static Touch Of(in Manifold manifold, float sign, Vector2 center)
        {
            Touch touch;
            touch.Normal = sign * manifold.Normal;
            touch.Separation = manifold.Point0.Separation;
            touch.Point0 = manifold.Point0.Anchor + center - (touch.Normal * (0.5f * manifold.Point0.Separation));
            touch.Point1 = touch.Point0;
            if (manifold.Count > 1)
            {
                touch.Point1 = manifold.Point1.Anchor + center - (touch.Normal * (0.5f * manifold.Point1.Separation));
                float farther = manifold.Point1.Separation - touch.Separation;
                touch.Separation = Math.Min(touch.Separation, manifold.Point1.Separation);
                if (Math.Abs(farther) > Level * (touch.Point1 - touch.Point0).Length())
                {
                    touch.Point0 = farther > 0 ? touch.Point0 : touch.Point1;
                    touch.Point1 = touch.Point0;
                }
            }

            return touch;
        }
    }

    /// <summary>A piece that cannot move, as seen from the body's centre.</summary>
    private readonly struct FixedPiece
    {
        public readonly int Index;
        public readonly Rotation Turn;

        /// <summary>The centre of its body from that of the one that can move.</summary>
        public readonly Vector2 Offset;
        private readonly Vector2* _vertices;
        private readonly Vector2* _normals;
        private readonly Vector2* _outline;
        private readonly int _faces;
        private readonly float _radius;

        public FixedPiece(in SeamInput input, int index, in BodyPose from)
        {
            ref Piece piece = ref input.Shapes.Pieces[index];
            BodyPose pose = input.Bodies.Pose[piece.Body];
            Turn = new Rotation(pose.Cos, pose.Sin);
            if (input.Ahead != 0 && (input.Bodies.Flags[piece.Body] & BodyFlags.Static) == 0)
            {
                BodyState state = input.Bodies.State[piece.Body];
                pose.X += (double)state.LinearVelocity.X * input.Ahead;
                pose.Y += (double)state.LinearVelocity.Y * input.Ahead;
                Turn = StableMath.FromAngle(pose.Angle + ((double)state.AngularVelocity * input.Ahead));
            }

            Index = index;
            Offset = new Vector2((float)(pose.X - from.X), (float)(pose.Y - from.Y));
            _vertices = input.Shapes.Vertices.Pointer + piece.VertexStart;
            _normals = input.Shapes.Normals.Pointer + piece.VertexStart;
            _outline = input.Shapes.OutlineAfter.Pointer + piece.VertexStart;
            _faces = piece.VertexCount > 1 ? piece.VertexCount : 0;
            _radius = piece.Radius;
        }

        /// <summary>
        /// By how much a contact leans over that face of this piece that looks up most (sine), where its points are: at an end of the
        /// face it may lean outwards. 0 if no face looks that way.
        /// </summary>
        public float Lean(Vector2 up, in Touch touch, float glance)
        {
            Vector2 ownUp = Turn.InverseRotate(up);
            float best = Corner;
            int face = -1;
            for (int i = 0; i < _faces; i++)
            {
                float alike = Vector2.Dot(_normals[i], ownUp);
                if (alike > best && _outline[i] == _normals[i])
                {
                    best = alike;
                    face = i;
                }
            }

            if (face < 0)
            {
                return 0;
            }

            var along = new Vector2(-_normals[face].Y, _normals[face].X);
            float lean = Vector2.Dot(along, Turn.InverseRotate(touch.Normal));
            float start = Vector2.Dot(along, _vertices[face]);
            float length = Vector2.Dot(along, _vertices[Next(face)]) - start;
            float first = Vector2.Dot(along, Turn.InverseRotate(touch.Point0 - Offset)) - start;
            float second = Vector2.Dot(along, Turn.InverseRotate(touch.Point1 - Offset)) - start;
            return Math.Min(LeanAt(first, length, lean, glance), LeanAt(second, length, lean, glance));
        }

        /// <summary>
        /// Whether a face that looks up has an end that is not above a level, while the points are those of what comes before this end:
        /// its corner, or what is below the face there.
        /// </summary>
        public bool EndsBelow(Vector2 up, in Touch touch, float level, float glance)
        {
            Vector2 ownUp = Turn.InverseRotate(up);
            Vector2 ownNormal = Turn.InverseRotate(touch.Normal);
            Vector2 point0 = Turn.InverseRotate(touch.Point0 - Offset);
            Vector2 point1 = Turn.InverseRotate(touch.Point1 - Offset);
            float top = Math.Max(Vector2.Dot(ownUp, point0), Vector2.Dot(ownUp, point1));
            float most = level + glance - Vector2.Dot(up, Offset);
            for (int i = 0; i < _faces; i++)
            {
                if (!(Vector2.Dot(_normals[i], ownUp) > Corner) || _outline[i] != _normals[i])
                {
                    continue;
                }

                var along = new Vector2(-_normals[i].Y, _normals[i].X);
                // A contact that this face does not look to is none with it, though a point of it may be on it: the face of the body
                // was clipped there.
                bool looks = Vector2.Dot(_normals[i], ownNormal) > Corner;
                Vector2 rounding = _normals[i] * _radius;
                for (int end = 0; end < 2; end++)
                {
                    Vector2 corner = _vertices[end == 0 ? i : Next(i)] + rounding;
                    Vector2 inwards = end == 0 ? along : -along;
                    float height = Vector2.Dot(ownUp, corner);
                    bool isOff = !looks || (IsOff(point0 - corner, inwards, _normals[i], glance)
                        && IsOff(point1 - corner, inwards, _normals[i], glance));
                    if (isOff && height <= most && top <= height + glance)
                    {
                        return true;
                    }
                }
            }

            return false;
        }

        private static float LeanAt(float place, float length, float lean, float glance)
        {
            bool atStart = place < glance;
            bool atEnd = place > length - glance;
            return atStart ? (atEnd ? 0 : Math.Max(lean, 0)) : atEnd ? Math.Max(-lean, 0) : Math.Abs(lean);
        }

        private static bool IsOff(Vector2 point, Vector2 inwards, Vector2 normal, float glance) =>
            Vector2.Dot(point, inwards) <= glance || Vector2.Dot(point, normal) < -0.1f * glance;

        private int Next(int vertex) => vertex + 1 == _faces ? 0 : vertex + 1;
    }
}
