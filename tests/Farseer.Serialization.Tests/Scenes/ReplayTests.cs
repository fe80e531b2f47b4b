using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Serialization;
using Xunit;
using SceneFile = FarseerGames.FarseerPhysics.Serialization.SceneFile;
using SceneFileException = FarseerGames.FarseerPhysics.Serialization.SceneFileException;

namespace Farseer.Serialization.Tests.Scenes;

/// <summary>Recordings show what was, without the program that was recorded and its handlers.</summary>
public sealed class ReplayTests
{
    private const int Steps = 90;

    public static TheoryData<string> Names => [.. SceneLibrary.All.Select(s => s.Name).Where(name => name != "own-joint")];

    [Theory]
    [MemberData(nameof(Names))]
    public void SampleScene_RecordedWithItsHandlers_PlaysTheSame(string name)
    {
        Scene scene = SceneLibrary.Find(name)!;
        var simulator = new PhysicsSimulator();
        scene.Build(simulator);
        var recorder = new SimulationRecorder(simulator, 40);
        var hashes = new List<ulong> { simulator.MotionHash() };
        for (int step = 0; step < Steps; step++)
        {
            scene.Act(simulator, step, scene.Dt);
            recorder.Update(scene.Dt);
            hashes.Add(simulator.MotionHash());
        }

        Replay replay = Replay.Load(recorder.ToArray());
        AssertPlays(replay, hashes);
        foreach (int frame in new[] { 85, 0, 39, 41, 40, 90, 1 })
        {
            replay.Seek(frame);
            Assert.Equal(hashes[frame], replay.Simulator.MotionHash());
        }

        replay.Seek(Steps);
        Assert.Equal(simulator.BodyList.Select(b => b.PositionX), replay.Simulator.BodyList.Select(b => b.PositionX));
        Assert.Null(replay.Divergence);
    }

    [Fact]
    public void Recording_OfAllSortsOfChanges_PlaysTheSame()
    {
        PhysicsSimulator simulator = Everything.Build();
        var recorder = new SimulationRecorder(simulator);
        var hashes = new List<ulong> { simulator.MotionHash() };
        for (int step = 0; step < 60; step++)
        {
            Act(simulator, step);
            recorder.Update(step == 30 ? 0 : 1f / 60);
            hashes.Add(simulator.MotionHash());
        }

        AssertPlays(Replay.Load(recorder.ToArray()), hashes);
    }

    [Fact]
    public void Recording_OfAHandlerThatAddsAndThrows_PlaysTheSame()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 40, 1, 1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 40, 1);
        Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 0.5f, 1);
        ball.Position = new Vector2(0, 1.5f);
        int told = 0;
        GeomFactory.Instance.CreateCircleGeom(simulator, ball, 0.5f, 16).OnCollision = (_, _, _) =>
        {
            Body debris = BodyFactory.Instance.CreateRectangleBody(simulator, 0.2f, 0.2f, 0.1f);
            debris.Position = new Vector2(told, 4);
            GeomFactory.Instance.CreateRectangleGeom(simulator, debris, 0.2f, 0.2f);
            ball.LinearVelocity = new Vector2(0.5f, 1);
            return told++ == 2 ? throw new InvalidOperationException("told") : told % 2 == 0;
        };
        var recorder = new SimulationRecorder(simulator);
        var hashes = new List<ulong> { simulator.MotionHash() };
        for (int step = 0; step < 90; step++)
        {
            Record.Exception(() => recorder.Update(1f / 60));
            hashes.Add(simulator.MotionHash());
        }

        Assert.True(told > 3);
        AssertPlays(Replay.Load(recorder.ToArray()), hashes);
    }

    [Fact]
    public void Replay_WhoseSimulatorIsChanged_SaysFromWhichFrameItIsAnotherWorld()
    {
        PhysicsSimulator simulator = Everything.Build();
        var recorder = new SimulationRecorder(simulator);
        for (int step = 0; step < 20; step++)
        {
            recorder.Update(1f / 60);
        }

        Replay replay = Replay.Load(recorder.ToArray());
        replay.Seek(10);
        replay.Simulator.BodyList[5].ApplyImpulse(Vector2.One);
        replay.Seek(20);

        Assert.Equal(11, replay.Divergence);
    }

    [Fact]
    public void Recording_ThatWasChanged_IsRefused()
    {
        var recorder = new SimulationRecorder(Everything.Build());
        recorder.Update(1f / 60);
        byte[] file = recorder.ToArray();
        file[file.Length / 2] ^= 1;

        Assert.Throws<SceneFileException>(() => Replay.Load(file));
        Assert.Throws<SceneFileException>(() => SceneFile.LoadSimulator(recorder.ToArray()));
        Assert.Throws<SceneFileException>(() => Replay.Load(SceneFile.Save(Everything.Build())));
        Assert.Throws<ArgumentOutOfRangeException>(() => recorder.Update(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => Replay.Load(recorder.ToArray()).Seek(2));
        Assert.Throws<ArgumentOutOfRangeException>(() => new SimulationRecorder(Everything.Build(), 0));
        Assert.Throws<ArgumentNullException>(() => new SimulationRecorder(null!));
        Assert.Throws<ArgumentNullException>(() => Replay.Load((byte[])null!));
    }

    private static void Act(PhysicsSimulator simulator, int step)
    {
        switch (step)
        {
            case 3:
                simulator.BodyList[4].ApplyImpulse(new Vector2(3, 5));
                break;
            case 7:
                simulator.BodyList[6].Dispose();
                simulator.Remove(simulator.JointList[3]);
                break;
            case 12:
                var late = new Body { Position = new Vector2(2, 9) };
                GeomFactory.Instance.CreateRectangleGeom(simulator, late, 1, 1);
                simulator.Add(late);
                break;
            case 20:
                simulator.GeomList[8].SetVertices(new FarseerGames.FarseerPhysics.Collisions.Vertices(
                    new Vector2[] { new(-1, -1), new(1, -1), new(0, 1) }));
                simulator.Gravity = new Vector2(1, -5);
                break;
            case 40:
                simulator.Iterations = 9;
                simulator.Scaling = new Scaling(0.01f, 0.02f);
                simulator.SpringList[0].Dispose();
                break;
            case 50:
                simulator.Restore(simulator.Capture());
                simulator.BodyList[2].MotionLocks = MotionLocks.All;
                break;
        }
    }

    private static void AssertPlays(Replay replay, List<ulong> hashes)
    {
        Assert.Equal(hashes.Count - 1, replay.FrameCount);
        do
        {
            replay.Simulator.WorkerCount = 2;
            Assert.True(hashes[replay.Frame] == replay.Simulator.MotionHash(), $"frame {replay.Frame} is another one");
        }
        while (replay.MoveNext());
        Assert.Null(replay.Divergence);
    }
}
