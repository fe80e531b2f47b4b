using System.Collections.Generic;
using System.Linq;
using Box2D.Collision.Shapes;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Serialization.Flash;

/// <summary>What is in a world, in the order in which it was made.</summary>
internal sealed class WorldContents
{
    public WorldContents(b2World world) => World = world;

    public b2World World { get; }

    /// <summary>The ground body among them, where the engine got it.</summary>
    public List<b2Body> Bodies { get; } = new List<b2Body>();

    public List<b2Shape> Shapes { get; } = new List<b2Shape>();

    public List<b2Joint> Joints { get; } = new List<b2Joint>();

    public static WorldContents Of(b2World world)
    {
        var contents = new WorldContents(world);
        b2Body ground = world.GetGroundBody();
        for (b2Body? body = world.GetBodyList(); body is not null; body = body.GetNext())
        {
            if (!ReferenceEquals(body, ground))
            {
                contents.Bodies.Add(body);
            }
        }

        contents.Bodies.Reverse();

        // The ground comes to the engine when something first needs it.
        int before = ground.Link.IsAttached ? contents.Bodies.FindIndex(body => body.Link.Index > ground.Link.Index) : -1;
        contents.Bodies.Insert(before < 0 ? contents.Bodies.Count : before, ground);
        foreach (b2Body body in contents.Bodies)
        {
            int first = contents.Shapes.Count;
            for (b2Shape? shape = body.GetShapeList(); shape is not null; shape = shape.GetNext())
            {
                contents.Shapes.Add(shape);
            }

            contents.Shapes.Reverse(first, contents.Shapes.Count - first);
        }

        List<b2Shape> made = contents.Shapes.OrderBy(contents.OrderOf).ToList();
        contents.Shapes.Clear();
        contents.Shapes.AddRange(made);
        for (b2Joint? joint = world.GetJointList(); joint is not null; joint = joint.GetNext())
        {
            contents.Joints.Add(joint);
        }

        contents.Joints.Reverse();
        return contents;
    }

    // A frozen body's shapes have left the engine, and collide with nothing any more.
    private long OrderOf(b2Shape shape) =>
        shape.Link.IsAttached ? World.Engine.World.Shapes.Order[shape.Link.Collider.Index] : long.MaxValue;
}
