using System.Collections.Generic;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Testbed;

/// <summary>What came out of a scene, in words, and whether it had to.</summary>
public readonly record struct Outcome(string What, bool Holds);

/// <summary>A scene of the testbed: makes a world, acts on it before each step, and knows what must come out.</summary>
public abstract class TestScene
{
    public const float Dt = 1f / 60;
    public const int Iterations = 10;

    protected TestScene(float gravity = -10)
    {
        b2AABB region = new();
        region.lowerBound.Set(-100, -100);
        region.upperBound.Set(100, 100);
        World = new b2World(region, new b2Vec2(0, gravity), true);
    }

    /// <summary>As typed on the command line.</summary>
    public abstract string Name { get; }

    /// <summary>One sentence: what is shown.</summary>
    public abstract string Description { get; }

    /// <summary>Steps after which <see cref="Check"/> is meant.</summary>
    public virtual int Steps => 300;

    /// <summary>Half the width of what is worth looking at, and its middle.</summary>
    public virtual (float HalfWidth, float X, float Y) View => (20, 0, 6);

    public b2World World { get; }

    public void Step(int step)
    {
        Act(step);
        World.Step(Dt, Iterations);
        After(step);
    }

    public abstract IEnumerable<Outcome> Check();

    /// <summary>Before a step.</summary>
    protected virtual void Act(int step)
    {
    }

    /// <summary>After a step, when the world may be changed.</summary>
    protected virtual void After(int step)
    {
    }

    protected b2Body Ground(float y = 0)
    {
        b2BodyDef def = new();
        def.position.Set(0, y - 10);
        b2Body body = World.CreateBody(def);
        body.CreateShape(Box(50, 10, 0));
        return body;
    }

    protected b2Body Add(float x, float y, params b2ShapeDef[] shapes) => Add(new b2BodyDef { position = new b2Vec2(x, y) }, shapes);

    protected b2Body Add(b2BodyDef def, params b2ShapeDef[] shapes)
    {
        b2Body body = World.CreateBody(def);
        foreach (b2ShapeDef shape in shapes)
        {
            body.CreateShape(shape);
        }

        body.SetMassFromShapes();
        return body;
    }

    protected static b2PolygonDef Box(float hx, float hy, float density = 1, float friction = 0.3f)
    {
        b2PolygonDef def = new() { density = density, friction = friction };
        def.SetAsBox(hx, hy);
        return def;
    }

    protected static b2CircleDef Circle(float radius, float density = 1, float restitution = 0)
        => new() { radius = radius, density = density, restitution = restitution, friction = 0.3f };

    protected static Outcome Near(string what, double value, double wanted, double most)
        => new($"{what}: {value:0.###} (wanted {wanted:0.###} within {most:0.###})", System.Math.Abs(value - wanted) <= most);

    protected static Outcome That(string what, bool holds) => new(what, holds);
}
