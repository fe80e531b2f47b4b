using Box2D.Collision;
using Box2D.Dynamics.Contacts;

namespace Box2D.Dynamics;

/// <summary>
/// Hears of contact points. Derive from it and hand it to <see cref="b2World.SetContactListener"/>. The objects handed over are
/// used again, and the world must not be changed within these calls: keep what you need and act after the step.
/// </summary>
/// <example>
/// <code>
/// public class Damage : b2ContactListener
/// {
///     public float Hardest { get; private set; }
///
///     public override void Result(b2ContactResult point) =&gt; Hardest = b2Math.b2Max(Hardest, point.normalImpulse);
/// }
/// </code>
/// </example>
public class b2ContactListener
{
    /// <summary>Called when a contact point begins.</summary>
    /// <param name="point">The point, before the solver.</param>
    public virtual void Add(b2ContactPoint point)
    {
    }

    /// <summary>Called when a contact point has lasted since the last step.</summary>
    /// <param name="point">The point, before the solver.</param>
    public virtual void Persist(b2ContactPoint point)
    {
    }

    /// <summary>Called when a contact point ends.</summary>
    /// <param name="point">The point as it last was.</param>
    public virtual void Remove(b2ContactPoint point)
    {
    }

    /// <summary>Called with what the solver did at a point; not for sensors.</summary>
    /// <param name="point">The impulses.</param>
    public virtual void Result(b2ContactResult point)
    {
    }
}
