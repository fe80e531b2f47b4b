using System;

namespace FarseerGames.FarseerPhysics.Views;

/// <summary>A colour of the debug view, 0 to 255 each.</summary>
/// <example>
/// <code>
/// var view = new PhysicsSimulatorView(simulator, draw) { SensorColor = new DebugColor(255, 0, 0) };
/// </code>
/// </example>
public readonly struct DebugColor : IEquatable<DebugColor>
{
    /// <summary>Makes a colour.</summary>
    /// <param name="red">Red.</param>
    /// <param name="green">Green.</param>
    /// <param name="blue">Blue.</param>
    /// <param name="alpha">Opacity: 255, the default, covers what is below.</param>
    public DebugColor(byte red, byte green, byte blue, byte alpha = 255)
    {
        R = red;
        G = green;
        B = blue;
        A = alpha;
    }

    /// <summary>Red.</summary>
    public byte R { get; }

    /// <summary>Green.</summary>
    public byte G { get; }

    /// <summary>Blue.</summary>
    public byte B { get; }

    /// <summary>Opacity: 255 covers what is below.</summary>
    public byte A { get; }

    /// <summary>True if all parts are equal.</summary>
    /// <param name="left">One colour.</param>
    /// <param name="right">The other.</param>
    /// <returns>True if they are.</returns>
    public static bool operator ==(DebugColor left, DebugColor right) => left.Equals(right);

    /// <summary>True if a part differs.</summary>
    /// <param name="left">One colour.</param>
    /// <param name="right">The other.</param>
    /// <returns>True if it does.</returns>
    public static bool operator !=(DebugColor left, DebugColor right) => !left.Equals(right);

    /// <summary>The colour with another opacity.</summary>
    /// <param name="alpha">Opacity.</param>
    /// <returns>The new colour.</returns>
    public DebugColor WithAlpha(byte alpha) => new DebugColor(R, G, B, alpha);

    /// <summary>True if all parts are equal.</summary>
    /// <param name="other">The other colour.</param>
    /// <returns>True if they are.</returns>
    public bool Equals(DebugColor other) => R == other.R && G == other.G && B == other.B && A == other.A;

    /// <summary>True if the object is an equal colour.</summary>
    /// <param name="obj">The object.</param>
    /// <returns>True if it is.</returns>
    public override bool Equals(object? obj) => obj is DebugColor other && Equals(other);

    /// <summary>A number made of the parts.</summary>
    /// <returns>The number.</returns>
    public override int GetHashCode() => R | (G << 8) | (B << 16) | (A << 24);
}
