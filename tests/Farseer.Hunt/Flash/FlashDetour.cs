using System;
using System.Collections.Generic;
using System.Linq;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;

namespace Farseer.Hunt.Flash;

/// <content>Captures and restores.</content>
internal sealed partial class FlashObserver
{
    private readonly b2WorldState _state = new();
    private readonly b2WorldState _again = new();
    private b2RollbackBuffer? _buffer;

    protected override bool TakeDetour(object world, Random random)
    {
        var made = (b2World)world;
        made.Capture(_state);
        b2RollbackBuffer buffer =
            _buffer is not null && ReferenceEquals(_buffer.World, made) ? _buffer : _buffer = new b2RollbackBuffer(made, 6);
        long frame = buffer.Push();
        for (int i = 1 + random.Next(6); i > 0; i--)
        {
            try
            {
                Mischief(made, random);
            }
            catch (Exception exception) when (exception is ArgumentException or InvalidOperationException)
            {
                // As refused as anywhere.
            }
        }

        if (random.Next(2) == 0)
        {
            made.Restore(_state);
        }
        else
        {
            for (int i = random.Next(3); i > 0; i--)
            {
                buffer.Push();
            }

            buffer.Rewind(frame);
        }

        made.Capture(_again);
        if (!_state.IsSameAs(_again))
        {
            Problems.Add(("a restored state is another one", _state.Compare(_again, 1).ToString()));
        }

        return true;
    }

    protected override object Traced(object world)
    {
        var state = new b2WorldState();
        state.BeginTrace();
        ((b2World)world).Capture(state);
        return state;
    }

    protected override IEnumerable<string> Differences(object state, object other) =>
        ((b2WorldState)state).Compare((b2WorldState)other, MostDifferences).Differences.Select(d => d.ToString());

    private static void Mischief(b2World world, Random random)
    {
        b2Body body = world.GetBodyList()!;
        for (int i = random.Next(world.GetBodyCount()); i > 0 && body.GetNext() is { } next; i--)
        {
            body = next;
        }

        switch (random.Next(8))
        {
            case 0:
                world.DestroyBody(body);
                break;
            case 1 when body.GetShapeList() is { } shape:
                body.DestroyShape(shape);
                break;
            case 2 when world.GetJointList() is { } joint:
                world.DestroyJoint(joint);
                break;
            case 3:
                var place = new b2BodyDef();
                place.position.Set(random.Next(-5, 5), random.Next(1, 20));
                b2Body added = world.CreateBody(place);
                var box = new b2PolygonDef { density = 1 };
                box.SetAsBox(0.5f, 0.5f);
                added.CreateShape(box);
                added.SetMassFromShapes();
                break;
            case 4:
                world.SetGravity(new b2Vec2(3, 5));
                break;
            case 5:
                body.SetLinearVelocity(new b2Vec2(random.Next(-20, 20), random.Next(-20, 20)));
                body.WakeUp();
                break;
            case 6:
                world.SetContactFilter(random.Next(2) == 0 ? null : b2ContactFilter.b2_defaultFilter);
                break;
        }

        for (int i = random.Next(5); i > 0; i--)
        {
            world.Step(1f / 60, 10);
        }
    }
}
