using Box2D.Bridge;
using Box2D.Common.Math;

namespace Box2D.Collision;

/// <summary>A line from one point to another.</summary>
/// <example>
/// <code>
/// var ray = new b2Segment { p1 = new b2Vec2(-5, 0), p2 = new b2Vec2(5, 0) };
/// var lambda = new float[1];
/// bool hit = shape.TestSegment(body.GetXForm(), lambda, new b2Vec2(), ray, 1);
/// </code>
/// </example>
public class b2Segment
{
    /// <summary>The start, metres. Default (0, 0).</summary>
    public b2Vec2 p1 { get; set; } = new b2Vec2();

    /// <summary>The end, metres. Default (0, 0).</summary>
    public b2Vec2 p2 { get; set; } = new b2Vec2();

    /// <summary>Whether this line meets another one from its front.</summary>
    /// <param name="lambda">Its first item becomes the position on <paramref name="segment"/>, 0 its start, 1 its end; untouched on a
    /// miss.</param>
    /// <param name="normal">Set to the normal of this line there, towards the start of <paramref name="segment"/>; untouched on a
    /// miss.</param>
    /// <param name="segment">The other line.</param>
    /// <param name="maxLambda">The share of the other line to search, 0 to 1.</param>
    /// <returns>True if they meet.</returns>
    /// <exception cref="System.ArgumentException">An argument is null or not finite, or <paramref name="lambda"/> has no room.</exception>
    public bool TestSegment(float[] lambda, b2Vec2 normal, b2Segment segment, float maxLambda)
    {
        Check(lambda, normal, segment, maxLambda);
        double rX = (double)segment.p2.x - segment.p1.x;
        double rY = (double)segment.p2.y - segment.p1.y;
        double dX = (double)p2.x - p1.x;
        double dY = (double)p2.y - p1.y;
        double nX = dY;
        double nY = -dX;
        double denominator = -((rX * nX) + (rY * nY));

        // Parallel lines and those that come from behind do not meet; "parallel" goes by the lengths, not by a constant.
        double scale = System.Math.Sqrt(((rX * rX) + (rY * rY)) * ((dX * dX) + (dY * dY)));
        if (!(denominator > 1e-12 * scale))
        {
            return false;
        }

        double bX = (double)segment.p1.x - p1.x;
        double bY = (double)segment.p1.y - p1.y;
        double a = (bX * nX) + (bY * nY);
        double mu = (rY * bX) - (rX * bY);
        if (a < 0 || a > maxLambda * denominator || mu < -1e-7 * denominator || mu > denominator * (1 + 1e-7))
        {
            return false;
        }

        double length = System.Math.Sqrt((nX * nX) + (nY * nY));
        lambda[0] = (float)(a / denominator);
        normal.Set((float)(nX / length), (float)(nY / length));
        return true;
    }

    /// <summary>What every search along a segment asks of its arguments; the old content of the results does not matter.</summary>
    internal static void Check(float[] lambda, b2Vec2 normal, b2Segment segment, float maxLambda)
    {
        Require.Room(lambda, nameof(lambda));
        Require.NotNull(normal, nameof(normal));
        Require.NotNull(segment, nameof(segment));
        Require.Vector(segment.p1, nameof(segment));
        Require.Vector(segment.p2, nameof(segment));
        Require.Finite(maxLambda, nameof(maxLambda));
    }
}
