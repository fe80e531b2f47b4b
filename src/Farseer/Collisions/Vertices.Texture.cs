using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>Outlines of what is drawn in a bitmap: one uint per pixel, alpha in the highest byte, row by row from the top.</content>
public partial class Vertices
{
    private const byte DefaultAlphaTolerance = 20;
    private const float DefaultHullTolerance = 1.5f;

    /// <summary>Tolerance, in pixels, below which smoothing does nothing worth having.</summary>
    private const float Closest = 0.05f;

    /// <summary>
    /// The outline of the first thing in a bitmap, from pixel to pixel, with an alpha tolerance of 20 and a hull tolerance of 1.5.
    /// </summary>
    /// <param name="textureBits">The pixels.</param>
    /// <param name="textureWidth">Pixels in a row; at least 1.</param>
    /// <param name="textureHeight">Number of rows; at least 1.</param>
    /// <returns>A new list, in pixels from the top left one, clockwise on the screen.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="textureBits"/> is null.</exception>
    /// <exception cref="ArgumentException">The number of pixels is not width times height, or no pixel is solid.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public static Vertices CreatePolygon(uint[] textureBits, int textureWidth, int textureHeight) =>
        CreatePolygon(textureBits, textureWidth, textureHeight, Vector2.Zero, DefaultAlphaTolerance, DefaultHullTolerance);

    /// <summary>As above, relative to a point of the bitmap.</summary>
    /// <param name="textureBits">The pixels.</param>
    /// <param name="textureWidth">Pixels in a row; at least 1.</param>
    /// <param name="textureHeight">Number of rows; at least 1.</param>
    /// <param name="textureOrigin">The pixel that becomes (0, 0); finite.</param>
    /// <returns>A new list.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="textureBits"/> is null.</exception>
    /// <exception cref="ArgumentException">The number of pixels is not width times height, or no pixel is solid.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public static Vertices CreatePolygon(uint[] textureBits, int textureWidth, int textureHeight, Vector2 textureOrigin) =>
        CreatePolygon(textureBits, textureWidth, textureHeight, textureOrigin, DefaultAlphaTolerance, DefaultHullTolerance);

    /// <summary>As above, with an alpha tolerance.</summary>
    /// <param name="textureBits">The pixels.</param>
    /// <param name="textureWidth">Pixels in a row; at least 1.</param>
    /// <param name="textureHeight">Number of rows; at least 1.</param>
    /// <param name="textureOrigin">The pixel that becomes (0, 0); finite.</param>
    /// <param name="alphaTolerance">A pixel is solid if its alpha is at least this.</param>
    /// <returns>A new list.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="textureBits"/> is null.</exception>
    /// <exception cref="ArgumentException">The number of pixels is not width times height, or no pixel is solid.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public static Vertices CreatePolygon(
        uint[] textureBits, int textureWidth, int textureHeight, Vector2 textureOrigin, byte alphaTolerance) =>
        CreatePolygon(textureBits, textureWidth, textureHeight, textureOrigin, alphaTolerance, DefaultHullTolerance);

    /// <summary>
    /// The outline of the first thing in a bitmap: the one whose topmost left pixel comes first. It goes through the centres of the outer
    /// pixels, so it is a pixel narrower than the drawing, and holes are ignored; <see cref="CreatePolygons"/> does better.
    /// </summary>
    /// <param name="textureBits">The pixels.</param>
    /// <param name="textureWidth">Pixels in a row; at least 1.</param>
    /// <param name="textureHeight">Number of rows; at least 1.</param>
    /// <param name="textureOrigin">The pixel that becomes (0, 0); finite.</param>
    /// <param name="alphaTolerance">A pixel is solid if its alpha is at least this.</param>
    /// <param name="hullTolerance">The largest distance by which pixels may bulge out of an edge, in pixels; finite and at least 0.</param>
    /// <returns>A new list, clockwise on the screen. A thing of a few pixels may have less than three vertices.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="textureBits"/> is null.</exception>
    /// <exception cref="ArgumentException">The number of pixels is not width times height, or no pixel is solid.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public static Vertices CreatePolygon(
        uint[] textureBits, int textureWidth, int textureHeight, Vector2 textureOrigin, byte alphaTolerance, float hullTolerance)
    {
        bool[] solid = Solid(textureBits, textureWidth, textureHeight, alphaTolerance);
        Require.Finite(textureOrigin, nameof(textureOrigin));
        Require.NotNegative(hullTolerance, nameof(hullTolerance));
        List<Vector2> outline = HullWalk.Trace(solid, textureWidth, textureHeight, hullTolerance);
        if (outline.Count == 0)
        {
            throw new ArgumentException("No pixel has an alpha of at least " + Text(alphaTolerance) + ".", nameof(textureBits));
        }

        var vertices = new Vertices();
        foreach (Vector2 vertex in outline)
        {
            vertices.Add(vertex - textureOrigin);
        }

        return vertices;
    }

    /// <summary>
    /// The outlines of all islands of a bitmap with their holes, along the edges of the pixels: with a tolerance of 0 they enclose
    /// exactly the solid pixels. Pixels belong together if they share an edge. (An addition to the original.)
    /// </summary>
    /// <param name="textureBits">The pixels.</param>
    /// <param name="textureWidth">Pixels in a row; at least 1.</param>
    /// <param name="textureHeight">Number of rows; at least 1.</param>
    /// <param name="textureOrigin">The point, in pixels, that becomes (0, 0); finite.</param>
    /// <param name="alphaTolerance">A pixel is solid if its alpha is at least this.</param>
    /// <param name="hullTolerance">The largest distance of an outline from the edges of the pixels, in pixels; finite and at least
    /// 0.</param>
    /// <returns>One outline for each island, in the order of their topmost left pixels; empty if no pixel is solid.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="textureBits"/> is null.</exception>
    /// <exception cref="ArgumentException">The number of pixels is not width times height.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public static List<TextureOutline> CreateOutlines(
        uint[] textureBits, int textureWidth, int textureHeight, Vector2 textureOrigin, byte alphaTolerance, float hullTolerance)
    {
        PixelContours contours = Contours(textureBits, textureWidth, textureHeight, textureOrigin, alphaTolerance, hullTolerance);
        var outlines = new List<TextureOutline>();
        for (int i = 1; i <= contours.Count; i++)
        {
            outlines.Add(new TextureOutline(Smooth(contours.Trace(i), textureOrigin, hullTolerance)));
        }

        return outlines;
    }

    /// <summary>
    /// Polygons without holes that together cover all islands of a bitmap, for geoms of one body: an island with holes is cut through
    /// them from top to bottom. (An addition to the original.)
    /// </summary>
    /// <param name="textureBits">The pixels.</param>
    /// <param name="textureWidth">Pixels in a row; at least 1.</param>
    /// <param name="textureHeight">Number of rows; at least 1.</param>
    /// <param name="textureOrigin">The point, in pixels, that becomes (0, 0); finite.</param>
    /// <param name="alphaTolerance">A pixel is solid if its alpha is at least this.</param>
    /// <param name="hullTolerance">The largest distance of an outline from the edges of the pixels, in pixels; finite and at least
    /// 0.</param>
    /// <returns>The polygons, each simple; empty if no pixel is solid.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="textureBits"/> is null.</exception>
    /// <exception cref="ArgumentException">The number of pixels is not width times height.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public static List<Vertices> CreatePolygons(
        uint[] textureBits, int textureWidth, int textureHeight, Vector2 textureOrigin, byte alphaTolerance, float hullTolerance)
    {
        PixelContours contours = Contours(textureBits, textureWidth, textureHeight, textureOrigin, alphaTolerance, hullTolerance);
        contours.CutHoles();
        var polygons = new List<Vertices>();
        for (int i = 1; i <= contours.Count; i++)
        {
            polygons.AddRange(Smooth(contours.Trace(i), textureOrigin, hullTolerance));
        }

        return polygons;
    }

    private static PixelContours Contours(
        uint[] textureBits, int textureWidth, int textureHeight, Vector2 textureOrigin, byte alphaTolerance, float hullTolerance)
    {
        bool[] solid = Solid(textureBits, textureWidth, textureHeight, alphaTolerance);
        Require.Finite(textureOrigin, nameof(textureOrigin));
        Require.NotNegative(hullTolerance, nameof(hullTolerance));
        return new PixelContours(solid, textureWidth, textureHeight);
    }

    private static List<Vertices> Smooth(List<Vertices> contours, Vector2 origin, float tolerance)
    {
        for (int i = 0; i < contours.Count; i++)
        {
            // A tolerance as wide as the thing itself would fold it: then the outline is kept closer.
            Vertices smooth = contours[i].Simplify(tolerance);
            for (float closer = tolerance / 2; !smooth.IsSimple() && closer > Closest; closer /= 2)
            {
                smooth = contours[i].Simplify(closer);
            }

            contours[i] = smooth.IsSimple() ? smooth : contours[i];
            contours[i].Translate(-origin);
        }

        return contours;
    }

    private static bool[] Solid(uint[] textureBits, int textureWidth, int textureHeight, byte alphaTolerance)
    {
        Require.NotNull(textureBits, nameof(textureBits));
        Require.AtLeast(textureWidth, 1, nameof(textureWidth));
        Require.AtLeast(textureHeight, 1, nameof(textureHeight));
        if (textureBits.Length != (long)textureWidth * textureHeight)
        {
            throw new ArgumentException(
                "There are " + Text(textureBits.Length) + " pixels, not " + Text(textureWidth) + " times " + Text(textureHeight) + ".",
                nameof(textureBits));
        }

        var solid = new bool[textureBits.Length];
        for (int i = 0; i < solid.Length; i++)
        {
            solid[i] = textureBits[i] >> 24 >= alphaTolerance;
        }

        return solid;
    }

    private static string Text(int number) => number.ToString(System.Globalization.CultureInfo.InvariantCulture);
}
