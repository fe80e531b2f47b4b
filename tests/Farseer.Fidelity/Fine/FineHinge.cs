namespace Farseer.Fidelity.Fine;

/// <summary>A body's point held at a point of the world.</summary>
internal sealed class FineHinge
{
    private readonly FineBody _body;
    private readonly (double X, double Y) _local;
    private readonly double _x;
    private readonly double _y;

    public FineHinge(FineBody body, double x, double y)
    {
        _body = body;
        _local = body.ToLocal((x, y));
        (_x, _y) = (x, y);
    }

    /// <summary>
    /// Brings the point to where it belongs by the end of the small step: K has rows (m + i ry², -i rx ry), (-i rx ry, m + i rx²).
    /// </summary>
    public void Solve(double step)
    {
        (double px, double py) = _body.ToWorld(_local);
        (double rx, double ry) = (px - _body.X, py - _body.Y);
        (double vx, double vy) = _body.VelocityAt(px, py);
        vx += (px - _x) / step;
        vy += (py - _y) / step;
        double i = _body.InverseInertia;
        double k11 = _body.InverseMass + (i * ry * ry);
        double k12 = -i * rx * ry;
        double k22 = _body.InverseMass + (i * rx * rx);
        double determinant = (k11 * k22) - (k12 * k12);
        _body.Push(px, py, -((k22 * vx) - (k12 * vy)) / determinant, -((k11 * vy) - (k12 * vx)) / determinant);
    }
}
