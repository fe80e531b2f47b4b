using System;
using Box2D.Bridge;
using Box2D.Common;
using Box2D.Common.Math;

namespace Box2D.Dynamics;

/// <summary>
/// Draws a world at the end of each <see cref="b2World.Step(float, int)"/>: set <see cref="m_drawFlags"/>, and <see cref="m_sprite"/> or
/// override the drawing methods. Nothing is drawn without flags.
/// </summary>
/// <example>
/// <code>
/// draw.SetFlags(b2DebugDraw.e_shapeBit | b2DebugDraw.e_jointBit);
/// world.SetDebugDraw(draw);
/// world.Step(1f / 60, 10);
/// </code>
/// </example>
public class b2DebugDraw
{
    /// <summary>Shapes.</summary>
    public const uint e_shapeBit = 0x0001;

    /// <summary>Joints.</summary>
    public const uint e_jointBit = 0x0002;

    /// <summary>Core shapes, only together with <see cref="e_shapeBit"/>.</summary>
    public const uint e_coreShapeBit = 0x0004;

    /// <summary>Boxes around the shapes, and that of the world.</summary>
    public const uint e_aabbBit = 0x0008;

    /// <summary>Smallest turned boxes around polygons.</summary>
    public const uint e_obbBit = 0x0010;

    /// <summary>Pairs of shapes whose boxes overlap.</summary>
    public const uint e_pairBit = 0x0020;

    /// <summary>Centres of mass, with the axes of the bodies.</summary>
    public const uint e_centerOfMassBit = 0x0040;

    /// <summary>Makes one that draws nothing yet.</summary>
    public b2DebugDraw()
    {
    }

    /// <summary>What to draw: the sum of flags. Default 0.</summary>
    public uint m_drawFlags { get; set; }

    /// <summary>What is drawn on; null, the default, draws nothing unless the methods are overridden.</summary>
    public IGraphics? m_sprite { get; set; }

    /// <summary>Pixels a metre. Default 1.</summary>
    public float m_drawScale { get; set; } = 1.0f;

    /// <summary>Thickness of lines, pixels. Default 1.</summary>
    public float m_lineThickness { get; set; } = 1.0f;

    /// <summary>Opacity of lines, 0 to 1. Default 1.</summary>
    public float m_alpha { get; set; } = 1.0f;

    /// <summary>Opacity of fillings, 0 to 1. Default 1.</summary>
    public float m_fillAlpha { get; set; } = 1.0f;

    /// <summary>Length of the axes of <see cref="DrawXForm"/>, metres. Default 1.</summary>
    public float m_xformScale { get; set; } = 1.0f;

    /// <summary>Sets what to draw.</summary>
    /// <param name="flags">The sum of flags.</param>
    public void SetFlags(uint flags) => m_drawFlags = flags;

    /// <summary>What is drawn.</summary>
    /// <returns>The sum of flags.</returns>
    public uint GetFlags() => m_drawFlags;

    /// <summary>Adds to what is drawn.</summary>
    /// <param name="flags">The sum of flags.</param>
    public void AppendFlags(uint flags) => m_drawFlags |= flags;

    /// <summary>Takes away from what is drawn.</summary>
    /// <param name="flags">The sum of flags.</param>
    public void ClearFlags(uint flags) => m_drawFlags &= ~flags;

    /// <summary>Draws the rim of a polygon.</summary>
    /// <param name="vertices">Its corners, metres.</param>
    /// <param name="vertexCount">The number of corners that count, at least 1.</param>
    /// <param name="color">Colour.</param>
    /// <exception cref="ArgumentNullException"><paramref name="vertices"/> or <paramref name="color"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="vertexCount"/> is not from 1 to the number of corners.</exception>
    public virtual void DrawPolygon(b2Vec2[] vertices, int vertexCount, b2Color color)
    {
        Require.NotNull(color, nameof(color));
        m_sprite?.lineStyle(m_lineThickness, color.color, m_alpha);
        Rim(vertices, vertexCount);
    }

    /// <summary>Draws a filled polygon.</summary>
    /// <param name="vertices">Its corners, metres.</param>
    /// <param name="vertexCount">The number of corners that count, at least 1.</param>
    /// <param name="color">Colour.</param>
    /// <exception cref="ArgumentNullException"><paramref name="vertices"/> or <paramref name="color"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="vertexCount"/> is not from 1 to the number of corners.</exception>
    public virtual void DrawSolidPolygon(b2Vec2[] vertices, int vertexCount, b2Color color)
    {
        Require.NotNull(color, nameof(color));
        m_sprite?.lineStyle(m_lineThickness, color.color, m_alpha);
        m_sprite?.beginFill(color.color, m_fillAlpha);
        Rim(vertices, vertexCount);
        m_sprite?.endFill();
    }

    /// <summary>Draws the rim of a circle.</summary>
    /// <param name="center">Centre, metres.</param>
    /// <param name="radius">Radius, metres.</param>
    /// <param name="color">Colour.</param>
    /// <exception cref="ArgumentNullException"><paramref name="center"/> or <paramref name="color"/> is null.</exception>
    public virtual void DrawCircle(b2Vec2 center, float radius, b2Color color)
    {
        Require.NotNull(center, nameof(center));
        Require.NotNull(color, nameof(color));
        m_sprite?.lineStyle(m_lineThickness, color.color, m_alpha);
        m_sprite?.drawCircle(center.x * m_drawScale, center.y * m_drawScale, radius * m_drawScale);
    }

    /// <summary>Draws a filled circle and a radius of it.</summary>
    /// <param name="center">Centre, metres.</param>
    /// <param name="radius">Radius, metres.</param>
    /// <param name="axis">Unit vector to where the radius is drawn.</param>
    /// <param name="color">Colour.</param>
    /// <exception cref="ArgumentNullException"><paramref name="center"/>, <paramref name="axis"/> or <paramref name="color"/> is
    /// null.</exception>
    public virtual void DrawSolidCircle(b2Vec2 center, float radius, b2Vec2 axis, b2Color color)
    {
        Require.NotNull(center, nameof(center));
        Require.NotNull(axis, nameof(axis));
        Require.NotNull(color, nameof(color));
        m_sprite?.lineStyle(m_lineThickness, color.color, m_alpha);
        m_sprite?.moveTo(0, 0);
        m_sprite?.beginFill(color.color, m_fillAlpha);
        m_sprite?.drawCircle(center.x * m_drawScale, center.y * m_drawScale, radius * m_drawScale);
        m_sprite?.endFill();
        m_sprite?.moveTo(center.x * m_drawScale, center.y * m_drawScale);
        m_sprite?.lineTo((center.x + (axis.x * radius)) * m_drawScale, (center.y + (axis.y * radius)) * m_drawScale);
    }

    /// <summary>Draws a line.</summary>
    /// <param name="p1">The start, metres.</param>
    /// <param name="p2">The end, metres.</param>
    /// <param name="color">Colour.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public virtual void DrawSegment(b2Vec2 p1, b2Vec2 p2, b2Color color)
    {
        Require.NotNull(p1, nameof(p1));
        Require.NotNull(p2, nameof(p2));
        Require.NotNull(color, nameof(color));
        m_sprite?.lineStyle(m_lineThickness, color.color, m_alpha);
        Line(p1, p2.x, p2.y);
    }

    /// <summary>Draws the axes of a transform: red the first, green the second.</summary>
    /// <param name="xf">The transform.</param>
    /// <exception cref="ArgumentNullException"><paramref name="xf"/> is null.</exception>
    public virtual void DrawXForm(b2XForm xf)
    {
        Require.NotNull(xf, nameof(xf));
        m_sprite?.lineStyle(m_lineThickness, 0xff0000, m_alpha);
        Line(xf.position, xf.position.x + (m_xformScale * xf.R.col1.x), xf.position.y + (m_xformScale * xf.R.col1.y));
        m_sprite?.lineStyle(m_lineThickness, 0x00ff00, m_alpha);
        Line(xf.position, xf.position.x + (m_xformScale * xf.R.col2.x), xf.position.y + (m_xformScale * xf.R.col2.y));
    }

    private void Line(b2Vec2 from, float x, float y)
    {
        m_sprite?.moveTo(from.x * m_drawScale, from.y * m_drawScale);
        m_sprite?.lineTo(x * m_drawScale, y * m_drawScale);
    }

    private void Rim(b2Vec2[] vertices, int vertexCount)
    {
        Require.NotNull(vertices, nameof(vertices));
        if (vertexCount < 1 || vertexCount > vertices.Length)
        {
            throw new ArgumentOutOfRangeException(
                nameof(vertexCount), vertexCount, "The count must be above 0 and not above that of the corners.");
        }

        m_sprite?.moveTo(vertices[0].x * m_drawScale, vertices[0].y * m_drawScale);
        for (int i = 1; i <= vertexCount; i++)
        {
            m_sprite?.lineTo(vertices[i % vertexCount].x * m_drawScale, vertices[i % vertexCount].y * m_drawScale);
        }
    }
}
