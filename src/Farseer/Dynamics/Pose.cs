using System;
using System.Globalization;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>
/// Where a body is and how far it is turned, in full precision: see <see cref="Body.GetPose(float)"/>. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// Pose pose = body.GetPose(alpha: 0.5f);
/// Vector2 place = pose.Position;
/// </code>
/// </example>
public readonly struct Pose : IEquatable<Pose>
{
    /// <summary>Makes a pose.</summary>
    /// <param name="x">x of the position; finite, within ±9.2·10¹⁸.</param>
    /// <param name="y">y of the position; the same range.</param>
    /// <param name="totalRotation">The rotation with whole turns, radians; the same range.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the range given above.</exception>
    public Pose(double x, double y, double totalRotation)
    {
        X = Require.Place(x, nameof(x));
        Y = Require.Place(y, nameof(y));
        TotalRotation = Require.Place(totalRotation, nameof(totalRotation));
    }

    /// <summary>x of the position of the centre of mass.</summary>
    public double X { get; }

    /// <summary>y of the position of the centre of mass.</summary>
    public double Y { get; }

    /// <summary>The rotation with whole turns, radians.</summary>
    public double TotalRotation { get; }

    /// <summary>The position of the centre of mass, as floats: fit for drawing.</summary>
    public Vector2 Position => new Vector2((float)X, (float)Y);

    /// <summary>The rotation, as a float: fit for drawing.</summary>
    public float Rotation => (float)Math.IEEERemainder(TotalRotation, 2 * Math.PI);

    /// <summary>True if both are the same.</summary>
    /// <param name="left">One pose.</param>
    /// <param name="right">The other.</param>
    /// <returns>True if they are equal.</returns>
    public static bool operator ==(Pose left, Pose right) => left.Equals(right);

    /// <summary>True if they differ.</summary>
    /// <param name="left">One pose.</param>
    /// <param name="right">The other.</param>
    /// <returns>True if they differ.</returns>
    public static bool operator !=(Pose left, Pose right) => !left.Equals(right);

    /// <summary>True if the other is the same.</summary>
    /// <param name="other">The other pose.</param>
    /// <returns>True if they are equal.</returns>
    public bool Equals(Pose other) => X == other.X && Y == other.Y && TotalRotation == other.TotalRotation;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Pose other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => (((X.GetHashCode() * 397) ^ Y.GetHashCode()) * 397) ^ TotalRotation.GetHashCode();

    /// <summary>Place and rotation, for a debugger.</summary>
    /// <returns>A line of text.</returns>
    public override string ToString() => string.Format(CultureInfo.InvariantCulture, "({0:G6}, {1:G6}) at {2:G6} rad", X, Y, TotalRotation);
}
