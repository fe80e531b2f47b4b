using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>The pairs as the original showed them.</content>
public partial class SweepAndPruneCollider
{
    /// <summary>An unordered pair of geoms.</summary>
    public struct CollisionPair : System.IEquatable<CollisionPair>
    {
        /// <summary>The geom created first.</summary>
        public Geom Geom1;

        /// <summary>The other geom.</summary>
        public Geom Geom2;

        /// <summary>Makes a pair; the order of the arguments does not matter.</summary>
        /// <param name="g1">One geom.</param>
        /// <param name="g2">The other geom.</param>
        /// <exception cref="System.ArgumentNullException">A geom is null.</exception>
        public CollisionPair(Geom g1, Geom g2)
        {
            bool inOrder = Require.NotNull(g1, nameof(g1)) < Require.NotNull(g2, nameof(g2));
            Geom1 = inOrder ? g1 : g2;
            Geom2 = inOrder ? g2 : g1;
        }

        /// <summary>True if both are the same pair.</summary>
        /// <param name="first">One pair.</param>
        /// <param name="second">The other pair.</param>
        /// <returns>True if they are equal.</returns>
        public static bool operator ==(CollisionPair first, CollisionPair second) => first.Equals(second);

        /// <summary>False if both are the same pair.</summary>
        /// <param name="first">One pair.</param>
        /// <param name="second">The other pair.</param>
        /// <returns>True if they differ.</returns>
        public static bool operator !=(CollisionPair first, CollisionPair second) => !first.Equals(second);

        /// <summary>True if the other is the same pair.</summary>
        /// <param name="other">The pair to compare with.</param>
        /// <returns>True if they are equal.</returns>
        public readonly bool Equals(CollisionPair other) => Geom1 == other.Geom1 && Geom2 == other.Geom2;

        /// <inheritdoc/>
        public override readonly bool Equals(object? obj) => obj is CollisionPair other && Equals(other);

        /// <inheritdoc/>
        public override readonly int GetHashCode() => ((Geom1?.Id ?? 0) * 397) ^ (Geom2?.Id ?? 0);
    }

    /// <summary>A set of pairs.</summary>
    public class CollisionPairDictionary : Dictionary<CollisionPair, bool>
    {
        /// <summary>Makes an empty set.</summary>
        public CollisionPairDictionary()
        {
        }

        /// <summary>Puts a pair into the set.</summary>
        /// <param name="g1">One geom.</param>
        /// <param name="g2">The other geom.</param>
        /// <exception cref="System.ArgumentNullException">A geom is null.</exception>
        public void AddPair(Geom g1, Geom g2) => this[new CollisionPair(g1, g2)] = true;

        /// <summary>Takes a pair out of the set.</summary>
        /// <param name="g1">One geom.</param>
        /// <param name="g2">The other geom.</param>
        /// <exception cref="System.ArgumentNullException">A geom is null.</exception>
        public void RemovePair(Geom g1, Geom g2) => Remove(new CollisionPair(g1, g2));
    }
}
