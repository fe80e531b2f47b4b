using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Outlines along the edges of pixels: solid pixels that share an edge make an island, its holes are the gaps in it. The outlines
/// enclose exactly the area of the pixels, but for corners at which two pixels of an island touch diagonally: a thirtieth of a pixel is
/// cut off there, so that no outline touches itself.
/// </summary>
internal sealed class PixelContours
{
    private const float Chamfer = 0.25f;

    private static readonly int[] _dx = { 1, 0, -1, 0 };
    private static readonly int[] _dy = { 0, 1, 0, -1 };

    private readonly int _width;
    private readonly int _height;
    private readonly int[] _labels;

    /// <summary>The pixels of each island in the order of rows: what is done to an island does not look at all the others.</summary>
    private readonly List<List<int>> _pixels = new List<List<int>>();

    public PixelContours(bool[] solid, int width, int height)
    {
        _width = width;
        _height = height;
        _labels = new int[solid.Length];
        for (int i = 0; i < solid.Length; i++)
        {
            _labels[i] = solid[i] ? 0 : -1;
        }

        var all = new List<int>(solid.Length);
        for (int i = 0; i < solid.Length; i++)
        {
            all.Add(i);
        }

        LabelUnmarked(all);
    }

    /// <summary>Number of islands, in the order of their topmost left pixels.</summary>
    public int Count => _pixels.Count;

    /// <summary>
    /// Outer outline first, then the holes, of an island from 1 to <see cref="Count"/>; the outline clockwise on the screen, holes the
    /// other way.
    /// </summary>
    public List<Vertices> Trace(int island)
    {
        var visited = new HashSet<int>();
        var contours = new List<Vertices>();
        foreach (int pixel in _pixels[island - 1])
        {
            int x = pixel % _width;
            int y = pixel / _width;

            // Every contour has an edge that runs to the right along the top of a pixel.
            if (Label(x, y - 1) != island && !visited.Contains(pixel))
            {
                contours.Add(Follow(island, x, y, visited));
            }
        }

        return contours;
    }

    /// <summary>
    /// Cuts islands with holes along columns of pixels until none has a hole; new islands get new numbers.
    /// </summary>
    public void CutHoles()
    {
        for (int island = 1; island <= Count; island++)
        {
            List<Vertices> contours = Trace(island);
            while (contours.Count > 1)
            {
                CutThrough(island, contours[1]);
                contours = Trace(island);
            }
        }
    }

    private int Label(int x, int y) => x < 0 || y < 0 || x >= _width || y >= _height ? -1 : _labels[(y * _width) + x];

    /// <summary>Pixels of the island right of the middle of the hole become islands of their own.</summary>
    private void CutThrough(int island, Vertices hole)
    {
        float min = float.MaxValue;
        float max = float.MinValue;
        foreach (Vector2 vertex in hole)
        {
            min = Math.Min(min, vertex.X);
            max = Math.Max(max, vertex.X);
        }

        int column = (int)((min + max) / 2);
        List<int> pixels = _pixels[island - 1];
        foreach (int pixel in pixels)
        {
            _labels[pixel] = pixel % _width >= column ? 0 : island;
        }

        // What is left of the column may have fallen apart, too.
        int first = pixels.Find(pixel => _labels[pixel] == island);
        List<int> kept = Flood(first, island, -2 - island);
        foreach (int pixel in pixels)
        {
            _labels[pixel] = _labels[pixel] == -2 - island ? island : 0;
        }

        _pixels[island - 1] = kept;
        LabelUnmarked(pixels);
    }

    private void LabelUnmarked(List<int> pixels)
    {
        foreach (int pixel in pixels)
        {
            if (_labels[pixel] == 0)
            {
                _pixels.Add(Flood(pixel, 0, Count + 1));
            }
        }
    }

    /// <summary>Gives connected pixels of a label another one, and lists them.</summary>
    private List<int> Flood(int start, int from, int to)
    {
        var flooded = new List<int> { start };
        _labels[start] = to;
        for (int i = 0; i < flooded.Count; i++)
        {
            for (int d = 0; d < 4; d++)
            {
                int x = (flooded[i] % _width) + _dx[d];
                int y = (flooded[i] / _width) + _dy[d];
                if (Label(x, y) == from)
                {
                    _labels[(y * _width) + x] = to;
                    flooded.Add((y * _width) + x);
                }
            }
        }

        flooded.Sort();
        return flooded;
    }

    private Vertices Follow(int island, int startX, int startY, HashSet<int> visited)
    {
        var contour = new Vertices();
        int x = startX;
        int y = startY;
        int heading = 0;
        do
        {
            if (heading == 0)
            {
                visited.Add((y * _width) + x);
            }

            // Along the edge to the corner; right and left of the way on are the pixels ahead.
            x += _dx[heading];
            y += _dy[heading];
            bool right = IsAhead(island, x, y, heading, 1);
            bool left = IsAhead(island, x, y, heading, -1);
            if (!right)
            {
                if (left)
                {
                    contour.Add(new Vector2(x - (Chamfer * _dx[heading]), y - (Chamfer * _dy[heading])));
                    heading = (heading + 1) % 4;
                    contour.Add(new Vector2(x + (Chamfer * _dx[heading]), y + (Chamfer * _dy[heading])));
                }
                else
                {
                    contour.Add(new Vector2(x, y));
                    heading = (heading + 1) % 4;
                }
            }
            else if (left)
            {
                contour.Add(new Vector2(x, y));
                heading = (heading + 3) % 4;
            }
        }
        while (x != startX || y != startY || heading != 0);

        return contour;
    }

    /// <summary>True if the pixel ahead of a corner, on the right (side 1) or left (−1) of the way, is of the island.</summary>
    private bool IsAhead(int island, int cornerX, int cornerY, int heading, int side)
    {
        // The centre of that pixel is half a step ahead and half a step to the side of the corner.
        int rightX = -_dy[heading] * side;
        int rightY = _dx[heading] * side;
        int pixelX = (2 * cornerX) + _dx[heading] + rightX - 1;
        int pixelY = (2 * cornerY) + _dy[heading] + rightY - 1;
        return Label(pixelX / 2, pixelY / 2) == island && pixelX >= 0 && pixelY >= 0;
    }
}
