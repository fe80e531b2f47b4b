using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
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
    /// <summary>A share of a minute's work; the command <c>state</c> of the hunt does more.</summary>
    private const int Worlds = 60;

    [Fact]
    public void RandomWorlds_RestoredAfterDetours_GoOnAsWithout()
    {
        using var log = new StringWriter(CultureInfo.InvariantCulture);
        StateTally tally = StateHunt.Run(Facades.Find("flash"), 1, TimeSpan.MaxValue, Worlds, long.MaxValue, null, log);
        output.WriteLine(log.ToString());
        Assert.True(tally.Different == 0, log.ToString());
        Assert.True(tally.Detours > 1000);
    }

    [Fact]
    public void RollbackBuffer_RewoundToAnyFrame_StepsAgainToTheSameHashes()
    {
        b2World world = World();
        var floor = new b2BodyDef();
        floor.position.Set(0, -1);
        var box = new b2PolygonDef();
        box.SetAsBox(50, 0.5f);
        world.CreateBody(floor)!.CreateShape(box);
        var buffer = new b2RollbackBuffer(world, 90);
        var random = new Random(1);
        var hashes = new List<ulong>();
        for (int round = 0; round < 20; round++)
        {
            for (int i = random.Next(1, 90); i > 0; i--)
            {
                long frame = buffer.Push();
                if (frame == hashes.Count)
                {
                    hashes.Add(world.MotionHash());
                }

                Assert.Equal(hashes[(int)frame], world.MotionHash());
                Play(frame);
            }

            long back = random.NextInt64(buffer.OldestFrame, buffer.NewestFrame + 1);
            buffer.Rewind(back);
            Assert.Equal(hashes[(int)back], world.MotionHash());
            Play(back);
        }

        Assert.Throws<ArgumentOutOfRangeException>(() => buffer.Rewind(buffer.NewestFrame + 1));
        Assert.Throws<ArgumentNullException>(() => new b2RollbackBuffer(null!, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new b2RollbackBuffer(world, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => b2RollbackBuffer.WithBudget(world, 0));

        // What is done depends on the frame alone.
        void Play(long frame)
        {
            if (frame % 9 == 0)
            {
                Box(world, (int)(frame / 9 % 12));
            }

            world.Step(1f / 60, 10);
        }
    }

    [Fact]
    public void Restore_AfterStepsUnderAnotherGravity_GoesOnAsWithout()
    {
        ulong undisturbed = Pile(detour: false);
        Assert.Equal(undisturbed, Pile(detour: true));

        static ulong Pile(bool detour)
        {
            b2World world = World();
            var floor = new b2BodyDef();
            floor.position.Set(0, -1);
            var box = new b2PolygonDef();
            box.SetAsBox(50, 0.5f);
            world.CreateBody(floor)!.CreateShape(box);
            for (int i = 0; i < 12; i++)
            {
                Box(world, i);
            }

            for (int i = 0; i < 60; i++)
            {
                if (detour)
                {
                    b2WorldState state = world.Capture();
                    world.SetGravity(new b2Vec2(3, 5));
                    world.Step(1f / 30, 10);
                    world.Restore(state);
                }

                world.Step(1f / 60, 10);
            }

            return world.MotionHash();
        }
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
        Assert.Throws<InvalidOperationException>(() => made.SetMassFromShapes());
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
