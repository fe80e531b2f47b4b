using System.Collections.Generic;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// The outline of the first thing in a bitmap as version 2.0.1 found it: from pixel to neighbouring pixel, clockwise on the screen,
/// starting at the topmost left one. A vertex is made where the pixels passed bulge out of the line from the last vertex to the present
/// pixel by more than the tolerance, at the one that bulges most.
/// </summary>
internal static class HullWalk
{
    private static readonly int[] _stepX = { 1, 1, 0, -1, -1, -1, 0, 1 };
    private static readonly int[] _stepY = { 0, 1, 1, 1, 0, -1, -1, -1 };

    public static List<Vector2> Trace(bool[] solid, int width, int height, float tolerance)
    {
        var vertices = new List<Vector2>();
        int start = System.Array.IndexOf(solid, true);
        if (start < 0)
        {
            return vertices;
        }

        int startX = start % width;
        int startY = start / width;
        vertices.Add(new Vector2(startX, startY));
        var passed = new List<Vector2> { new Vector2(startX, startY) };
        int x = startX;
        int y = startY;
        int firstHeading = Next(solid, width, height, startX, startY, 0);
        int heading = firstHeading;
        while (heading >= 0)
        {
            x += _stepX[heading];
            y += _stepY[heading];
            heading = Next(solid, width, height, x, y, heading);
            if (x == startX && y == startY && heading == firstHeading)
            {
                break;
            }

            // The pixel just reached does not count yet: so did the original, which is why an outline may end with a bulge to its start.
            int bulge = Farthest(passed, tolerance);
            if (bulge > 0)
            {
                vertices.Add(passed[bulge]);
                passed.RemoveRange(0, bulge);
            }

            passed.Add(new Vector2(x, y));
        }

        return vertices;
    }

    /// <summary>Direction of the next pixel, the leftmost turn first; −1 if the pixel is alone.</summary>
    private static int Next(bool[] solid, int width, int height, int x, int y, int heading)
    {
        for (int i = 0; i < 8; i++)
        {
            // From the last pixel that was looked at in vain, which is two eighths left of straight on, or three after a diagonal step.
            int direction = (heading + (heading % 2 == 0 ? 6 : 5) + i) % 8;
            int nextX = x + _stepX[direction];
            int nextY = y + _stepY[direction];
            if (nextX >= 0 && nextY >= 0 && nextX < width && nextY < height && solid[(nextY * width) + nextX])
            {
                return direction;
            }
        }

        return -1;
    }

    private static int Farthest(List<Vector2> passed, float tolerance)
    {
        Vector2 line = passed[passed.Count - 1] - passed[0];
        float length = line.Length();
        int farthest = 0;
        float most = tolerance;
        for (int i = 1; i < passed.Count - 1; i++)
        {
            Vector2 arm = passed[i] - passed[0];
            float distance = length > 0 ? System.Math.Abs((line.X * arm.Y) - (line.Y * arm.X)) / length : arm.Length();
            if (distance > most)
            {
                most = distance;
                farthest = i;
            }
        }

        return farthest;
    }
}
