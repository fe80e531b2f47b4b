using System;
using System.Collections;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>
/// The geoms that were made for a body, in the order of their making: a view without allocation, see <see cref="Body.Geoms"/>. (An addition
/// to the original.)
/// </summary>
/// <example>
/// <code>
/// foreach (Geom geom in body.Geoms)
/// {
///     geom.FrictionCoefficient = 0.5f;
/// }
/// </code>
/// </example>
public readonly struct BodyGeoms : IReadOnlyList<Geom>, IEquatable<BodyGeoms>
{
    private readonly Body? _body;

    internal BodyGeoms(Body body) => _body = body;

    /// <summary>The number of geoms.</summary>
    public int Count => _body is null ? 0 : _body.GeomCount;

    /// <summary>One of them.</summary>
    /// <param name="index">From 0 to below <see cref="Count"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such geom.</exception>
    public Geom this[int index] => _body!.GeomAt(Require.Within(index, 0, Count - 1, nameof(index)));

    /// <summary>True if both are those of one body.</summary>
    /// <param name="left">One view.</param>
    /// <param name="right">The other.</param>
    /// <returns>True if they are the same.</returns>
    public static bool operator ==(BodyGeoms left, BodyGeoms right) => left.Equals(right);

    /// <summary>True if they are those of two bodies.</summary>
    /// <param name="left">One view.</param>
    /// <param name="right">The other.</param>
    /// <returns>True if they differ.</returns>
    public static bool operator !=(BodyGeoms left, BodyGeoms right) => !left.Equals(right);

    /// <summary>Walks over them. None may be made or disposed meanwhile.</summary>
    /// <returns>An enumerator.</returns>
    public Enumerator GetEnumerator() => new Enumerator(this);

    IEnumerator<Geom> IEnumerable<Geom>.GetEnumerator() => GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    /// <summary>True if the other is of the same body.</summary>
    /// <param name="other">The other view.</param>
    /// <returns>True if they are the same.</returns>
    public bool Equals(BodyGeoms other) => ReferenceEquals(_body, other._body);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is BodyGeoms other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => _body is null ? 0 : _body.GetHashCode();

    /// <summary>Walks over the geoms of a body.</summary>
    public struct Enumerator : IEnumerator<Geom>
    {
        private readonly BodyGeoms _geoms;
        private int _index;

        internal Enumerator(BodyGeoms geoms)
        {
            _geoms = geoms;
            _index = -1;
        }

        /// <summary>The geom that it is at.</summary>
        public readonly Geom Current => _geoms[_index];

        readonly object IEnumerator.Current => Current;

        /// <summary>Goes on to the next.</summary>
        /// <returns>False behind the last.</returns>
        public bool MoveNext() => ++_index < _geoms.Count;

        /// <summary>Goes back before the first.</summary>
        public void Reset() => _index = -1;

        /// <summary>Does nothing.</summary>
        public readonly void Dispose()
        {
        }
    }
}
