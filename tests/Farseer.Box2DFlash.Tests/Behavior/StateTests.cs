using System.Collections.Generic;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Farseer.Hunt;
using Farseer.Hunt.Running;
using Xunit;
using Xunit.Abstractions;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>States are captured and gone back to.</summary>
public sealed class StateTests(ITestOutputHelper output)
{
    [Fact]
    public void RandomWorlds_RestoredAfterDetours_GoOnAsWithout()
    {
        long steps = 0;
        long detours = 0;
        for (ulong seed = 1; seed <= 60; seed++)
        {
            string? wrong = StateHunt.Compare(Facades.Find("flash"), seed, null, ref steps, ref detours);
            Assert.True(wrong is null, $"seed {seed}: {wrong}");
        }

        output.WriteLine($"{detours} captures and restores, {steps} steps: no difference");
        Assert.True(detours > 1000);
    }

    [Fact]
    public void Restore_OfWhatWasMadeAndDestroyedSince_HasTheSameInstances()
    {
        var world = new b2World(new b2AABB { lowerBound = new b2Vec2(-100, -100), upperBound = new b2Vec2(100, 100) }, new b2Vec2(0, -10), true);
        b2Body kept = Box(world, 0);
        b2Body other = Box(world, 3);
        b2WorldState state = world.Capture();
        List<b2Body> bodies = All(world);
        world.DestroyBody(other);
        Box(world, 6);
        world.Step(1f / 60, 10);
        world.Restore(state);
        Assert.Equal(bodies, All(world));
        Assert.Equal(0, kept.GetPosition().y);
        world.Step(1f / 60, 10);
        Assert.True(other.GetPosition().y < 3);
    }

    [Fact]
    public void Restore_OfAnotherWorldsState_IsRefused()
    {
        var room = new b2AABB { lowerBound = new b2Vec2(-100, -100), upperBound = new b2Vec2(100, 100) };
        var world = new b2World(room, new b2Vec2(0, -10), true);
        b2WorldState foreign = new b2World(room, new b2Vec2(0, -10), true).Capture();
        Assert.Equal("state", Assert.Throws<System.ArgumentException>(() => world.Restore(foreign)).ParamName);
        Assert.Equal("state", Assert.Throws<System.ArgumentException>(() => world.Restore(new b2WorldState())).ParamName);
        Assert.Equal("state", Assert.Throws<System.ArgumentNullException>(() => world.Restore(null!)).ParamName);
        Assert.Equal("state", Assert.Throws<System.ArgumentNullException>(() => world.Capture(null!)).ParamName);
    }

    private static b2Body Box(b2World world, float y)
    {
        var place = new b2BodyDef();
        place.position.Set(0, y);
        b2Body body = world.CreateBody(place);
        var box = new b2PolygonDef { density = 1 };
        box.SetAsBox(0.5f, 0.5f);
        body.CreateShape(box);
        body.SetMassFromShapes();
        return body;
    }

    private static List<b2Body> All(b2World world)
    {
        var all = new List<b2Body>();
        for (b2Body? body = world.GetBodyList(); body is not null; body = body.GetNext())
        {
            all.Add(body);
        }

        return all;
    }
}
