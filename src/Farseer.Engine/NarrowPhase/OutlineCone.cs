using System.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary>The outward directions in which the outline itself, not only one of its pieces, is farthest at a vertex.</summary>
internal static class OutlineCone
{
    /// <summary>
    /// Radians by which a direction may leave the cone. Within it the direction is moved to the border rather than refused:
    /// over a seam, rounding must not let both neighbours refuse the same contact.
    /// </summary>
    public const float Tolerance = 0.002f;

    /// <summary>False if the direction lies outside; a reflex vertex admits nothing.</summary>
    public static bool Clamp(Vector2 before, Vector2 after, ref Vector2 direction)
    {
        float opening = Cross(before, after);
        if (opening < -Tolerance)
        {
            return false;
        }

        float fromBefore = Cross(before, direction);
        float toAfter = Cross(direction, after);
        bool ahead = Vector2.Dot(direction, before) + Vector2.Dot(direction, after) >= 0;
        if (!ahead || fromBefore < -Tolerance || toAfter < -Tolerance)
        {
            return false;
        }

        if (fromBefore < 0)
        {
            direction = before;
        }
        else if (toAfter < 0)
        {
            direction = after;
        }

        return true;
    }

    public static float Cross(Vector2 a, Vector2 b) => (a.X * b.Y) - (a.Y * b.X);
}
