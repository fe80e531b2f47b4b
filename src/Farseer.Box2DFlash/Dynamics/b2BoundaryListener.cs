namespace Box2D.Dynamics;

/// <summary>Hears of bodies that leave the world. Derive from it and hand it to <see cref="b2World.SetBoundaryListener"/>.</summary>
/// <example>
/// <code>
/// public class Edge : b2BoundaryListener
/// {
///     public override void Violation(b2Body body) =&gt; Console.WriteLine(body.GetUserData() + " left the world");
/// }
/// </code>
/// </example>
public class b2BoundaryListener
{
    /// <summary>
    /// A body left the box of the world, or its speed what the engine can hold, and is frozen from now on. The world must not be changed
    /// here.
    /// </summary>
    /// <param name="body">The body.</param>
    public virtual void Violation(b2Body body)
    {
    }
}
