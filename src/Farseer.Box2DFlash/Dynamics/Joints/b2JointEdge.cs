using Farseer.Engine.Storage;

namespace Box2D.Dynamics.Joints;

/// <summary>A joint as a body sees it: one item of <see cref="b2Body.GetJointList"/>.</summary>
/// <example>
/// <code>
/// for (b2JointEdge edge = body.GetJointList(); edge != null; edge = edge.next)
/// {
///     Console.WriteLine(edge.other.GetUserData());
/// }
/// </code>
/// </example>
public class b2JointEdge
{
    internal b2JointEdge(b2Joint joint, b2Body other)
    {
        this.joint = joint;
        this.other = other;
    }

    /// <summary>The body at the other side.</summary>
    [NotState(Why.Fixed)]
    public b2Body other { get; }

    /// <summary>The joint.</summary>
    [NotState(Why.Fixed)]
    public b2Joint joint { get; }

    /// <summary>The edge before this one, or null.</summary>
    public b2JointEdge? prev { get; internal set; }

    /// <summary>The next edge, of a joint made before; or null.</summary>
    public b2JointEdge? next { get; internal set; }

    /// <summary>Whether there is a edge: ActionScript's <c>if (edge)</c>, and <c>for (…; edge; …)</c>.</summary>
    /// <param name="edge">The edge, or null.</param>
    /// <returns>True if it is not null.</returns>
    public static bool operator true(b2JointEdge? edge) => edge is not null;

    /// <summary>Whether there is no edge.</summary>
    /// <param name="edge">The edge, or null.</param>
    /// <returns>True if it is null.</returns>
    public static bool operator false(b2JointEdge? edge) => edge is null;

    /// <summary>Whether there is no edge.</summary>
    /// <param name="edge">The edge, or null.</param>
    /// <returns>True if it is null.</returns>
    public static bool operator !(b2JointEdge? edge) => edge is null;

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    internal void Visit(StateStream s)
    {
        prev = s.Reference(prev);
        next = s.Reference(next);
    }
}
