using System;

namespace Box2D.Common;

/// <summary>A colour for debug drawing, of three parts from 0 to 1.</summary>
/// <example>
/// <code>
/// draw.DrawSegment(new b2Vec2(0, 0), new b2Vec2(1, 0), new b2Color(1, 0, 0));
/// </code>
/// </example>
public class b2Color
{
    private byte _r;
    private byte _g;
    private byte _b;

    /// <summary>Makes a colour.</summary>
    /// <param name="rr">Red, 0 to 1; values outside are taken to the nearer end.</param>
    /// <param name="gg">Green.</param>
    /// <param name="bb">Blue.</param>
    public b2Color(float rr, float gg, float bb) => Set(rr, gg, bb);

    /// <summary>Sets red, 0 to 1; values outside are taken to the nearer end.</summary>
    public float r
    {
        set => _r = Part(value);
    }

    /// <summary>Sets green, 0 to 1; values outside are taken to the nearer end.</summary>
    public float g
    {
        set => _g = Part(value);
    }

    /// <summary>Sets blue, 0 to 1; values outside are taken to the nearer end.</summary>
    public float b
    {
        set => _b = Part(value);
    }

    /// <summary>The colour as 0xRRGGBB.</summary>
    public uint color => ((uint)_r << 16) | ((uint)_g << 8) | _b;

    /// <summary>Sets all three parts.</summary>
    /// <param name="rr">Red, 0 to 1; values outside are taken to the nearer end.</param>
    /// <param name="gg">Green.</param>
    /// <param name="bb">Blue.</param>
    public void Set(float rr, float gg, float bb)
    {
        _r = Part(rr);
        _g = Part(gg);
        _b = Part(bb);
    }

    private static byte Part(float value) => (byte)System.Math.Min(255f, System.Math.Max(0f, 255f * value));
}
