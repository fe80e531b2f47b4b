using System;
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

    [Theory]
    [InlineData(30039)] // for which gravity and step a forecast had been made was not restored
    public void RandomWorld_ThatDifferedOnce_GoesOnAsWithoutDetours(ulong seed)
    {
        long steps = 0;
        long detours = 0;
        Assert.Null(StateHunt.Compare(Facades.Find("flash"), seed, null, ref steps, ref detours));
    }

    [Fact]
    public void World_CapturedAndRestored_AllocatesNothingOnceWarm()
    {
        b2World world = World();
        for (int i = 0; i < 100; i++)
        {
            Box(world, 1.01f * i);
        }

        var state = new b2WorldState();
        for (int i = 0; i < 3; i++)
        {
            world.Capture(state);
            world.Step(1f / 60, 10);
            world.Restore(state);
        }

        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 20; i++)
        {
            world.Capture(state);
            world.Restore(state);
        }

        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    [Fact]
    public void Restore_OfABodyThatGotAShapeSince_LeavesTheShapeDestroyed()
    {
        b2World world = World();
        b2Body body = Box(world, 0);
        b2Shape first = body.GetShapeList()!;
        b2WorldState state = world.Capture();
        var round = new b2CircleDef { density = 1, radius = 2 };
        b2Shape since = body.CreateShape(round)!;
        b2Body made = Box(world, 5);
        world.Restore(state);
        Assert.Same(first, body.GetShapeList());
        Assert.Null(first.GetNext());
        Assert.Null(since.GetBody());
        Assert.Throws<InvalidOperationException>(() => made.WakeUp());
        Assert.Throws<ArgumentException>(() => body.DestroyShape(since));
    }

    [Fact]
    public void Restore_OfWhatWasMadeAndDestroyedSince_HasTheSameInstances()
    {
        b2World world = World();
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
        b2World world = World();
        b2WorldState foreign = World().Capture();
        Assert.Equal("state", Assert.Throws<ArgumentException>(() => world.Restore(foreign)).ParamName);
        Assert.Equal("state", Assert.Throws<ArgumentException>(() => world.Restore(new b2WorldState())).ParamName);
        Assert.Equal("state", Assert.Throws<ArgumentNullException>(() => world.Restore(null!)).ParamName);
        Assert.Equal("state", Assert.Throws<ArgumentNullException>(() => world.Capture(null!)).ParamName);
    }

    private static b2World World() =>
        new b2World(new b2AABB { lowerBound = new b2Vec2(-100, -100), upperBound = new b2Vec2(100, 100) }, new b2Vec2(0, -10), true);

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
