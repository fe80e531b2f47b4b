using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Interfaces;

/// <summary>Says where a fluid is.</summary>
/// <example>
/// <code>
/// public class Well : IFluidContainer
/// {
///     public bool Intersect(AABB aabb) =&gt; aabb.Min.Y &lt; 0;
///
///     public bool Contains(ref Vector2 vector) =&gt; vector.Y &lt; 0;
/// }
/// </code>
/// </example>
public interface IFluidContainer
{
    /// <summary>True if a box may touch the fluid; what is not near it is not looked at further.</summary>
    /// <param name="aabb">The box.</param>
    /// <returns>True if it may.</returns>
    bool Intersect(AABB aabb);

    /// <summary>True if a point is in the fluid.</summary>
    /// <param name="vector">The point, in the world.</param>
    /// <returns>True if it is.</returns>
    bool Contains(ref Vector2 vector);
}
