using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Serialization;
using Xunit;

namespace Farseer.Serialization.Tests.Scenes;

/// <summary>A scene that has one of everything.</summary>
public sealed class EverythingTests
{
    [Theory]
    [InlineData(SceneFormat.Json, false, 0)]
    [InlineData(SceneFormat.Binary, false, 0)]
    [InlineData(SceneFormat.Json, true, 0)]
    [InlineData(SceneFormat.Json, true, 1)]
    [InlineData(SceneFormat.Binary, true, 50)]
    public void Everything_SavedAndLoaded_StepsWithTheSameBits(SceneFormat format, bool state, int steps)
    {
        PhysicsSimulator simulator = Everything.Build();
        for (int i = 0; i < steps; i++)
        {
            simulator.Update(1f / 60);
        }

        PhysicsSimulator loaded = Saves.Loaded(simulator, format, state);

        for (int i = 1; i <= 120; i++)
        {
            simulator.Update(1f / 60);
            loaded.Update(1f / 60);
            Assert.True(simulator.MotionHash() == loaded.MotionHash(), $"step {i} is another one");
        }
    }

    [Theory]
    [InlineData(SceneFormat.Json)]
    [InlineData(SceneFormat.Binary)]
    public void Everything_LoadedAndSavedAgain_IsTheSameFile(SceneFormat format)
    {
        PhysicsSimulator simulator = Everything.Build(out FarseerGames.FarseerPhysics.Dynamics.Path path);
        var options = new SceneFileOptions { Format = format, Paths = { path } };
        byte[] saved = SceneFile.Save(simulator, options);

        SceneContents? contents = null;
        PhysicsSimulator loaded = SceneFile.LoadSimulator(saved, new SceneFileOptions { Loaded = c => contents = c });
        byte[] again = SceneFile.Save(loaded, new SceneFileOptions { Format = format, Paths = { contents!.Paths[0] } });

        Assert.True(saved.AsSpan().SequenceEqual(again), format == SceneFormat.Json ? Saves.FirstDifference(saved, again) : "");
    }

    [Fact]
    public void Path_Loaded_RefusesToBeMadeAnewWhileItIsInTheSimulator()
    {
        PhysicsSimulator simulator = Everything.Build(out FarseerGames.FarseerPhysics.Dynamics.Path path);
        SceneContents? contents = null;
        SceneFile.LoadSimulator(
            SceneFile.Save(simulator, new SceneFileOptions { Paths = { path } }), new SceneFileOptions { Loaded = c => contents = c });
        FarseerGames.FarseerPhysics.Dynamics.Path loaded = contents!.Paths[0];

        loaded.Update();
        Assert.Equal(path.Bodies.Count, loaded.Bodies.Count);
        loaded.MoveControlPoint(new Vector2(3, 3), 0);
        Assert.Throws<InvalidOperationException>(loaded.Update);
    }

    [Fact]
    public void Everything_LoadedWithoutItsState_BeginsAnew()
    {
        PhysicsSimulator simulator = Everything.Build();
        byte[] file = SceneFile.Save(simulator, Saves.Options(SceneFormat.Json, true));

        PhysicsSimulator loaded = SceneFile.LoadSimulator(file, new SceneFileOptions { ExactState = false });

        Assert.Empty(loaded.BodyList);
        loaded.Update(1f / 60);
        simulator.Update(1f / 60);
        Assert.Equal(simulator.MotionHash(), loaded.MotionHash());
    }

    [Fact]
    public void State_WithItemsComingAndGoing_GoesOnTheSame()
    {
        PhysicsSimulator simulator = Everything.Build();
        for (int i = 0; i < 20; i++)
        {
            simulator.Update(1f / 60);
        }

        simulator.Remove(simulator.BodyList[3]);
        simulator.BodyList[5].Dispose();
        simulator.JointList[2].Dispose();
        simulator.Remove(simulator.GeomList[7]);
        simulator.Remove(simulator.SpringList[0]);
        var late = new Body { Position = new Vector2(0, 20) };
        FarseerGames.FarseerPhysics.Factories.GeomFactory.Instance.CreateCircleGeom(simulator, late, 1, 12);
        simulator.Add(late);
        PhysicsSimulator loaded = Saves.Loaded(simulator, SceneFormat.Binary, true);

        for (int i = 1; i <= 60; i++)
        {
            simulator.Update(1f / 60);
            loaded.Update(1f / 60);
            Assert.True(simulator.MotionHash() == loaded.MotionHash(), $"step {i} is another one");
        }

        // What is made from now on is younger than all that was loaded, as it would have been.
        foreach (PhysicsSimulator world in new[] { simulator, loaded })
        {
            var body = new Body { Position = new Vector2(3, 3) };
            FarseerGames.FarseerPhysics.Factories.GeomFactory.Instance.CreateRectangleGeom(world, body, 1, 1);
            world.Add(body);
        }

        for (int i = 1; i <= 60; i++)
        {
            simulator.Update(1f / 60);
            loaded.Update(1f / 60);
            Assert.True(simulator.MotionHash() == loaded.MotionHash(), $"step {i} is another one");
        }
    }

    [Fact]
    public void State_Restored_IsTheStateThatWasSaved()
    {
        PhysicsSimulator simulator = Everything.Build();
        for (int i = 0; i < 30; i++)
        {
            simulator.Update(1f / 60);
        }

        byte[] once = SceneFile.Save(simulator, Saves.Options(SceneFormat.Binary, true));
        PhysicsSimulator loaded = SceneFile.LoadSimulator(once);

        // A file has no text that only says what was called last, nothing that is worked out when it is asked for, and makes room anew.
        Assert.All(
            simulator.Compare(loaded, 10_000).Differences,
            d => Assert.Contains(d.Field, new[] { "LastCall", "localVertices", "roomIsDue" }));
        Assert.Equal(simulator.Capture().ByteCount, loaded.Capture().ByteCount);
        Assert.Equal(simulator.BodyList.Select(b => b.Name), loaded.BodyList.Select(b => b.Name));
        Assert.Equal(simulator.Report.Error, loaded.Report.Error);
        Assert.Equal(simulator.SleepingBodyCount, loaded.SleepingBodyCount);
    }

    [Fact]
    public void Tag_OfAnyType_IsSavedByTheUsersFunctions()
    {
        PhysicsSimulator simulator = Everything.Build();
        simulator.Update(0);
        simulator.BodyList[0].Tag = 42;
        byte[] file = SceneFile.Save(simulator, new SceneFileOptions { TagToText = t => t is int number ? "#" + number : null });

        PhysicsSimulator loaded = SceneFile.LoadSimulator(file, new SceneFileOptions { TextToTag = t => int.Parse(t[1..]) });
        loaded.Update(0);

        Assert.Equal(42, loaded.BodyList[0].Tag);
        Assert.Null(loaded.JointList[0].Tag);
    }
}
