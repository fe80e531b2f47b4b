using System;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// What a surface is like, or a pair of them: see <see cref="Geom.SetSegmentMaterial"/> and <see cref="PhysicsSimulator.MixMaterials"/>.
/// (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// geom.SetSegmentMaterial(0, new SurfaceMaterial { Friction = 0.9f, Restitution = 0, Speed = 2 });
/// </code>
/// </example>
public struct SurfaceMaterial : IEquatable<SurfaceMaterial>
{
    private float _friction;
    private float _restitution;
    private float _speed;
    private float _rollingResistance;

    /// <summary>Friction coefficient; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Friction
    {
        readonly get => _friction;
        set => _friction = Require.NotNegative(value, nameof(Friction));
    }

    /// <summary>Part of the approach speed that a bounce gives back; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Restitution
    {
        readonly get => _restitution;
        set => _restitution = Require.NotNegative(value, nameof(Restitution));
    }

    /// <summary>
    /// How fast the surface runs past its body, length/s: see <see cref="Geom.SurfaceSpeed"/>. Of a pair it is the sum of both. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float Speed
    {
        readonly get => _speed;
        set => _speed = Require.Finite(value, nameof(Speed));
    }

    /// <summary>
    /// How hard it is to roll: see <see cref="Geom.RollingResistance"/>; at least 0. Of a pair it is the larger one. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float RollingResistance
    {
        readonly get => _rollingResistance;
        set => _rollingResistance = Require.NotNegative(value, nameof(RollingResistance));
    }

    /// <summary>True if both are the same.</summary>
    /// <param name="left">One material.</param>
    /// <param name="right">The other.</param>
    /// <returns>True if they are equal.</returns>
    public static bool operator ==(SurfaceMaterial left, SurfaceMaterial right) => left.Equals(right);

    /// <summary>True if they differ.</summary>
    /// <param name="left">One material.</param>
    /// <param name="right">The other.</param>
    /// <returns>True if they differ.</returns>
    public static bool operator !=(SurfaceMaterial left, SurfaceMaterial right) => !left.Equals(right);

    /// <summary>True if the other is the same.</summary>
    /// <param name="other">The other material.</param>
    /// <returns>True if they are equal.</returns>
    public readonly bool Equals(SurfaceMaterial other) => _friction == other._friction && _restitution == other._restitution
        && _speed == other._speed && _rollingResistance == other._rollingResistance;

    /// <inheritdoc/>
    public override readonly bool Equals(object? obj) => obj is SurfaceMaterial other && Equals(other);

    /// <inheritdoc/>
    public override readonly int GetHashCode() =>
        (((_friction.GetHashCode() * 397) ^ _restitution.GetHashCode()) * 397) ^ _speed.GetHashCode();
}
