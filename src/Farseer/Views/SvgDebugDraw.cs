using System;
using System.Globalization;
using System.IO;
using System.Numerics;
using System.Text;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Views;

/// <summary>
/// Draws into an SVG picture of a rectangle of the world:
/// <code>
/// var picture = new SvgDebugDraw(new Vector2(0, 0), new Vector2(1024, 768), 1024, 768);
/// new PhysicsSimulatorView(simulator, picture).Draw();
/// picture.Save("step.svg");
/// </code>
/// </summary>
/// <example>
/// <code>
/// var picture = new SvgDebugDraw(new Vector2(-5, -5), new Vector2(5, 5), 600, 600);
/// new PhysicsSimulatorView(simulator, picture).Draw();
/// picture.Save("scene.svg");
/// </code>
/// </example>
public sealed class SvgDebugDraw : IDebugDraw
{
    private const string LineWidth = "1";

    private readonly StringBuilder _body = new StringBuilder();
    private readonly double _scale;
    private readonly double _left;
    private readonly double _top;
    private readonly int _up;
    private readonly int _width;
    private readonly int _height;

    /// <summary>Makes an empty picture with y downwards, as on a screen.</summary>
    /// <param name="min">Smallest coordinates that are seen; finite.</param>
    /// <param name="max">Largest coordinates that are seen; above <paramref name="min"/>.</param>
    /// <param name="width">Width in pixels; at least 1.</param>
    /// <param name="height">Height in pixels; at least 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
    public SvgDebugDraw(Vector2 min, Vector2 max, int width, int height)
        : this(min, max, width, height, yUp: false)
    {
    }

    /// <summary>Makes an empty picture.</summary>
    /// <param name="min">Smallest coordinates that are seen; finite.</param>
    /// <param name="max">Largest coordinates that are seen; above <paramref name="min"/>.</param>
    /// <param name="width">Width in pixels; at least 1.</param>
    /// <param name="height">Height in pixels; at least 1.</param>
    /// <param name="yUp">True: y upwards, as on paper.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
    public SvgDebugDraw(Vector2 min, Vector2 max, int width, int height, bool yUp)
    {
        Require.Finite(min, nameof(min));
        Require.Finite(max, nameof(max));
        if (!(max.X > min.X) || !(max.Y > min.Y))
        {
            throw new ArgumentOutOfRangeException(nameof(max), max, "max must be above min.");
        }

        _width = Require.AtLeast(width, 1, nameof(width));
        _height = Require.AtLeast(height, 1, nameof(height));
        _up = yUp ? -1 : 1;

        // Lengths are equal either way; what is left over is a margin on both sides.
        _scale = Math.Min(width / ((double)max.X - min.X), height / ((double)max.Y - min.Y));
        _left = (width / 2.0) - (_scale * ((double)min.X + max.X) / 2);
        _top = (height / 2.0) - (_up * _scale * ((double)min.Y + max.Y) / 2);
    }

    /// <inheritdoc />
    public void DrawLine(Vector2 start, Vector2 end, DebugColor color)
    {
        _body.Append("<line x1=\"").Append(X(start)).Append("\" y1=\"").Append(Y(start));
        _body.Append("\" x2=\"").Append(X(end)).Append("\" y2=\"").Append(Y(end)).Append('"');
        Stroke(color);
        _body.Append("/>\n");
    }

    /// <inheritdoc />
    public void DrawPolygon(Vertices vertices, DebugColor line, DebugColor fill)
    {
        Require.NotNull(vertices, nameof(vertices));
        _body.Append("<polygon points=\"");
        for (int i = 0; i < vertices.Count; i++)
        {
            _body.Append(i > 0 ? " " : string.Empty).Append(X(vertices[i])).Append(',').Append(Y(vertices[i]));
        }

        _body.Append('"');
        Fill(fill);
        Stroke(line);
        _body.Append("/>\n");
    }

    /// <inheritdoc />
    public void DrawCircle(Vector2 center, float radius, DebugColor line, DebugColor fill)
    {
        Circle(center, radius * _scale);
        Fill(fill);
        Stroke(line);
        _body.Append("/>\n");
    }

    /// <inheritdoc />
    public void DrawPoint(Vector2 position, float size, DebugColor color)
    {
        Circle(position, size / 2.0);
        Fill(color);
        _body.Append("/>\n");
    }

    /// <summary>The picture so far, as a whole SVG document.</summary>
    /// <returns>The text.</returns>
    public override string ToString()
    {
        string size = FormattableString.Invariant($"width=\"{_width}\" height=\"{_height}\" viewBox=\"0 0 {_width} {_height}\"");
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + ">\n"
            + "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" + _body + "</svg>\n";
    }

    /// <summary>Writes the picture.</summary>
    /// <param name="path">Path of the file; one that is there is replaced.</param>
    /// <exception cref="ArgumentNullException"><paramref name="path"/> is null.</exception>
    public void Save(string path) => File.WriteAllText(Require.NotNull(path, nameof(path)), ToString());

    private static string Text(double value) => value.ToString("0.##", CultureInfo.InvariantCulture);

    private string X(Vector2 point) => Text(_left + (_scale * point.X));

    private string Y(Vector2 point) => Text(_top + (_up * _scale * point.Y));

    private void Circle(Vector2 center, double radius)
    {
        _body.Append("<circle cx=\"").Append(X(center)).Append("\" cy=\"").Append(Y(center));
        _body.Append("\" r=\"").Append(Text(radius)).Append('"');
    }

    private void Fill(DebugColor color)
    {
        _body.Append(" fill=\"").Append(color.A == 0 ? "none" : Hex(color)).Append('"');
        if (color.A > 0 && color.A < 255)
        {
            _body.Append(" fill-opacity=\"").Append(Text(color.A / 255.0)).Append('"');
        }
    }

    private void Stroke(DebugColor color)
    {
        _body.Append(" stroke=\"").Append(color.A == 0 ? "none" : Hex(color)).Append("\" stroke-width=\"" + LineWidth + "\"");
        if (color.A > 0 && color.A < 255)
        {
            _body.Append(" stroke-opacity=\"").Append(Text(color.A / 255.0)).Append('"');
        }
    }

    private static string Hex(DebugColor color) => FormattableString.Invariant($"#{color.R:x2}{color.G:x2}{color.B:x2}");
}
