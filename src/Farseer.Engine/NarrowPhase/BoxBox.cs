using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>
/// The most frequent pair, in scalars and without loops: the same choice of axis, the same clip and the same ids as
/// <see cref="ConvexConvex"/>, which also does the rare cases (corner against corner).
/// In a box's own frame edge 1 faces +x, edge 2 +y, edge 3 -x and edge 0 -y.
/// </summary>
internal static class BoxBox
{
    public static void Collide(in PairInput pair, out Manifold manifold)
    {
        manifold = default;
        var a = new BoxFrame(pair.A, pair.RotationA, default);
        var b = new BoxFrame(pair.B, pair.RotationB, pair.Offset);
        float dx = b.X - a.X;
        float dy = b.Y - a.Y;
        float cos = (a.Cos * b.Cos) + (a.Sin * b.Sin);
        float sin = (a.Cos * b.Sin) - (a.Sin * b.Cos);
        float c = Abs(cos);
        float s = Abs(sin);

        // Centre of B in A's frame, and of A in B's frame with the sign turned.
        float ax = (a.Cos * dx) + (a.Sin * dy);
        float ay = (a.Cos * dy) - (a.Sin * dx);
        float bx = (b.Cos * dx) + (b.Sin * dy);
        float by = (b.Cos * dy) - (b.Sin * dx);
        float sepAx = Abs(ax) - a.HalfX - ((c * b.HalfX) + (s * b.HalfY));
        float sepAy = Abs(ay) - a.HalfY - ((s * b.HalfX) + (c * b.HalfY));
        float sepBx = Abs(bx) - b.HalfX - ((c * a.HalfX) + (s * a.HalfY));
        float sepBy = Abs(by) - b.HalfY - ((s * a.HalfX) + (c * a.HalfY));
        bool axisAx = sepAx > sepAy;
        bool axisBx = sepBx > sepBy;
        float sepA = axisAx ? sepAx : sepAy;
        float sepB = axisBx ? sepBx : sepBy;
        if (sepA > pair.Margin || sepB > pair.Margin)
        {
            return;
        }

        float scale = pair.A.Extent < pair.B.Extent ? pair.A.Extent : pair.B.Extent;
        bool done;
        if (sepB > sepA + (ConvexConvex.ReferenceBias * scale))
        {
            var view = new BoxView(b, -bx, -by, axisBx, cos, -sin, a.HalfX, a.HalfY);
            done = view.Build(b, pair.Margin, flipped: true, ref manifold);
        }
        else
        {
            var view = new BoxView(a, ax, ay, axisAx, cos, sin, b.HalfX, b.HalfY);
            done = view.Build(a, pair.Margin, flipped: false, ref manifold);
        }

        if (!done)
        {
            ConvexConvex.Collide(pair, out manifold);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Abs(float value) => Math.Abs(value);

    /// <summary>A box in world axes about the centre of body A.</summary>
    private readonly struct BoxFrame
    {
        public readonly float X;
        public readonly float Y;
        public readonly float Cos;
        public readonly float Sin;
        public readonly float HalfX;
        public readonly float HalfY;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public BoxFrame(in Piece piece, Rotation rotation, Vector2 offset)
        {
            HalfX = piece.Half.X;
            HalfY = piece.Half.Y;
            Cos = (rotation.Cos * piece.Axis.X) - (rotation.Sin * piece.Axis.Y);
            Sin = (rotation.Sin * piece.Axis.X) + (rotation.Cos * piece.Axis.Y);
            X = (rotation.Cos * piece.Center.X) - (rotation.Sin * piece.Center.Y) + offset.X;
            Y = (rotation.Sin * piece.Center.X) + (rotation.Cos * piece.Center.Y) + offset.Y;
        }
    }

    /// <summary>
    /// The other box seen from the reference face: coordinates along the face and out of it, from the reference's centre.
    /// </summary>
    private readonly struct BoxView
    {
        private readonly float _normalX;
        private readonly float _normalY;
        private readonly float _halfLength;
        private readonly float _halfDepth;
        private readonly float _lowX;
        private readonly float _lowY;
        private readonly float _highX;
        private readonly float _highY;
        private readonly float _slope;
        private readonly int _edge;
        private readonly int _incident;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public BoxView(in BoxFrame reference, float dx, float dy, bool axisX, float cos, float sin, float otherX, float otherY)
        {
            float sign = (axisX ? dx : dy) < 0 ? -1f : 1f;
            _edge = axisX ? (dx < 0 ? 3 : 1) : (dy < 0 ? 0 : 2);
            _halfDepth = axisX ? reference.HalfX : reference.HalfY;
            _halfLength = axisX ? reference.HalfY : reference.HalfX;
            float out0 = (axisX ? dx : dy) * sign;
            float along0 = (axisX ? dy : -dx) * sign;

            // The face normal in the other box's frame; its larger component names the face that looks back.
            float mx = (axisX ? cos : sin) * sign;
            float my = (axisX ? -sin : cos) * sign;
            bool faceX = Abs(mx) > Abs(my);
            float facing = faceX ? Abs(mx) : Abs(my);
            float depth = faceX ? otherX : otherY;
            float length = faceX ? otherY : otherX;
            _incident = faceX ? (mx < 0 ? 1 : 3) : (my < 0 ? 2 : 0);

            // The incident normal is -facing·n + lean·t; its face runs along -facing·t - lean·n.
            float lean = faceX ? (mx < 0 ? -my : my) : (my < 0 ? mx : -mx);
            float middleX = along0 + (lean * depth);
            float middleY = out0 - (facing * depth) - _halfDepth;
            _highX = middleX + (facing * length);
            _highY = middleY + (lean * length);
            _lowX = middleX - (facing * length);
            _lowY = middleY - (lean * length);
            _slope = lean / facing;
            _normalX = (axisX ? reference.Cos : -reference.Sin) * sign;
            _normalY = (axisX ? reference.Sin : reference.Cos) * sign;
        }

        /// <summary>
        /// False if the case is not face against face. A near corner beyond the end of the reference face is still one if the
        /// way from that end falls on the other face: boxes side by side, which have sunk by different amounts, are all like that.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool Build(in BoxFrame reference, float margin, bool flipped, ref Manifold manifold)
        {
            float nearX = _highY < _lowY ? _highX : _lowX;
            float nearY = _highY < _lowY ? _highY : _lowY;
            float lo = _lowX > -_halfLength ? _lowX : -_halfLength;
            float hi = _highX < _halfLength ? _highX : _halfLength;
            float far = _highY < _lowY ? _lowX - nearX : _highX - nearX;
            float rise = Abs(_highY - _lowY);
            float gap = (nearX < 0 ? -_halfLength : _halfLength) - nearX;
            if (hi < lo || (nearY > 0 && Abs(nearX) > _halfLength && (gap * far) - (nearY * rise) <= 0))
            {
                return false;
            }

            float yLo = _lowX > -_halfLength ? _lowY : _lowY - ((_lowX + _halfLength) * _slope);
            float yHi = _highX < _halfLength ? _highY : _highY + ((_halfLength - _highX) * _slope);
            ManifoldPoint pointLo;
            ManifoldPoint pointHi;
            float outLo = _halfDepth + (0.5f * yLo);
            float outHi = _halfDepth + (0.5f * yHi);
            pointLo.Anchor =
                new Vector2(reference.X + (_normalX * outLo) - (_normalY * lo), reference.Y + (_normalY * outLo) + (_normalX * lo));
            pointHi.Anchor =
                new Vector2(reference.X + (_normalX * outHi) - (_normalY * hi), reference.Y + (_normalY * outHi) + (_normalX * hi));
            pointLo.Separation = yLo;
            pointHi.Separation = yHi;
            pointLo.Id = EdgeContact.Id(_edge, (_incident + 1) & 3, flipped);
            pointHi.Id = EdgeContact.Id((_edge + 1) & 3, _incident, flipped);
            bool keepLo = yLo <= margin;
            bool keepHi = yHi <= margin;
            manifold.Normal = flipped ? new Vector2(-_normalX, -_normalY) : new Vector2(_normalX, _normalY);
            manifold.Count = (keepLo ? 1 : 0) + (keepHi ? 1 : 0);
            bool highFirst = flipped ? keepHi : !keepLo;
            manifold.Point0 = highFirst ? pointHi : pointLo;
            manifold.Point1 = highFirst ? pointLo : pointHi;
            if (manifold.Count < 2)
            {
                manifold.Point1 = default;
            }

            return true;
        }
    }
}
