using System;
using System.Linq;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Serialization;
using Xunit;
using SceneFile = FarseerGames.FarseerPhysics.Serialization.SceneFile;

namespace Farseer.Serialization.Tests.Scenes;

/// <summary>Scenes of the library of samples, saved and loaded, step with the same bits.</summary>
public sealed class SampleSceneTests
{
    private const int Steps = 60;

    /// <summary>Scenes with items of their own types, which no file holds.</summary>
    private static readonly string[] _withOwnTypes = ["own-joint"];

    public static TheoryData<string, SceneFormat> Names
    {
        get
        {
            TheoryData<string, SceneFormat> data = [];
            foreach (Scene scene in SceneLibrary.All)
            {
                data.Add(scene.Name, SceneFormat.Json);
                data.Add(scene.Name, SceneFormat.Binary);
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Scene_SavedFreshAndLoaded_StepsAsTheOneThatWasBuilt(string name, SceneFormat format)
    {
        if (Build(name, 0) is not { } simulator)
        {
            return;
        }

        PhysicsSimulator loaded = Saves.Loaded(simulator, format, state: false);

        AssertSameSteps(simulator, loaded);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Scene_SavedInMotionWithItsState_GoesOnAsTheOneThatWasSaved(string name, SceneFormat format)
    {
        if (Build(name, 47) is not { } simulator)
        {
            return;
        }

        PhysicsSimulator loaded = Saves.Loaded(simulator, format, state: true);
        loaded.WorkerCount = 2;

        Assert.Equal(simulator.MotionHash(), loaded.MotionHash());
        AssertSameSteps(simulator, loaded);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Scene_LoadedAndSavedAgain_IsTheSameFile(string name, SceneFormat format)
    {
        if (Build(name, 20) is not { } simulator)
        {
            return;
        }

        byte[] saved = SceneFile.Save(simulator, Saves.Options(format, false));
        byte[] again = SceneFile.Save(SceneFile.LoadSimulator(saved), Saves.Options(format, false));

        Assert.True(saved.AsSpan().SequenceEqual(again), format == SceneFormat.Json ? Saves.FirstDifference(saved, again) : "");
    }

    private static PhysicsSimulator? Build(string name, int steps)
    {
        Scene scene = SceneLibrary.Find(name)!;
        var simulator = new PhysicsSimulator();
        scene.Build(simulator);
        if (_withOwnTypes.Contains(name))
        {
            Assert.Throws<NotSupportedException>(() => SceneFile.Save(simulator));
            return null;
        }

        for (int step = 0; step < steps; step++)
        {
            scene.Step(simulator, step, scene.Dt);
        }

        Saves.Unhandle(simulator);
        SceneFile.LoadSimulator(SceneFile.Save(simulator), new SceneFileOptions { Loaded = c => Assert.NotEmpty(c.Bodies) });
        return simulator;
    }

    private static void AssertSameSteps(PhysicsSimulator simulator, PhysicsSimulator loaded)
    {
        for (int step = 1; step <= Steps; step++)
        {
            simulator.Update(1f / 60);
            loaded.Update(1f / 60);
            Assert.True(simulator.MotionHash() == loaded.MotionHash(), $"step {step} is another one");
        }

        Assert.Equal(simulator.BodyList.Count, loaded.BodyList.Count);
        Assert.Equal(simulator.GeomList.Count, loaded.GeomList.Count);
        Assert.Equal(simulator.JointList.Count, loaded.JointList.Count);
        Assert.Equal(simulator.SpringList.Count, loaded.SpringList.Count);
        Assert.Equal(simulator.ControllerList.Count, loaded.ControllerList.Count);
    }
}
