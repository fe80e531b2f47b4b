using Box2D.Bridge;
using Box2D.Collision.Shapes;

namespace Box2D.Dynamics;

/// <summary>
/// Decides which shapes collide. Derive from it for rules of your own. It is asked once when the boxes around two shapes begin to
/// overlap; the answer holds until they part, or until <see cref="b2World.Refilter"/>.
/// </summary>
/// <example>
/// <code>
/// public class Teams : b2ContactFilter
/// {
///     public override bool ShouldCollide(b2Shape shape1, b2Shape shape2) =&gt;
///         !Equals(shape1.GetUserData(), shape2.GetUserData()) &amp;&amp; base.ShouldCollide(shape1, shape2);
/// }
/// </code>
/// </example>
public class b2ContactFilter
{
    /// <summary>The rule that a new world has.</summary>
    public static b2ContactFilter b2_defaultFilter { get; } = new b2ContactFilter();

    /// <summary>
    /// Shapes of the same group other than 0 collide if it is above 0; all others if each wants a category of the other.
    /// </summary>
    /// <param name="shape1">First shape.</param>
    /// <param name="shape2">Second shape.</param>
    /// <returns>True lets them collide.</returns>
    /// <exception cref="System.ArgumentNullException">A shape is null.</exception>
    public virtual bool ShouldCollide(b2Shape shape1, b2Shape shape2)
    {
        b2FilterData a = Require.NotNull(shape1, nameof(shape1)).Filter;
        b2FilterData b = Require.NotNull(shape2, nameof(shape2)).Filter;
        if (a.groupIndex == b.groupIndex && a.groupIndex != 0)
        {
            return a.groupIndex > 0;
        }

        return (a.maskBits & b.categoryBits) != 0 && (a.categoryBits & b.maskBits) != 0;
    }
}
