namespace Box2D.Dynamics.Joints;

/// <summary>A joint as a body sees it: one item of <see cref="b2Body.GetJointList"/>.</summary>
public class b2JointEdge
{
    internal b2JointEdge(b2Joint joint, b2Body other)
    {
        this.joint = joint;
        this.other = other;
    }

    /// <summary>The body at the other side.</summary>
    public b2Body other { get; }

    /// <summary>The joint.</summary>
    public b2Joint joint { get; }

    /// <summary>The edge before this one, or null.</summary>
    public b2JointEdge? prev { get; internal set; }

    /// <summary>The next edge, of a joint made before; or null.</summary>
    public b2JointEdge? next { get; internal set; }
}
