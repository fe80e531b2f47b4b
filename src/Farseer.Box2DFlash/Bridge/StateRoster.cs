using System.Collections.Generic;
using Box2D.Collision.Shapes;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Bridge;

/// <summary>Everybody whose state is part of a world's.</summary>
internal sealed class StateRoster
{
    public List<b2Body> Bodies { get; } = new List<b2Body>();

    public List<b2Shape> Shapes { get; } = new List<b2Shape>();

    public List<b2Joint> Joints { get; } = new List<b2Joint>();

    public void Clear()
    {
        Bodies.Clear();
        Shapes.Clear();
        Joints.Clear();
    }

    /// <summary>Writes, or reads, who is in it.</summary>
    public void Visit(StateStream s)
    {
        s.Of("Roster").Section();
        s.References(Bodies);
        s.Section();
        s.References(Shapes);
        s.Section();
        s.References(Joints);
    }
}
