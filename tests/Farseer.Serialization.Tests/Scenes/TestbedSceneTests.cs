using System;
using System.Linq;
using Box2D.Dynamics;
using Farseer.Testbed;
using FarseerGames.FarseerPhysics.Serialization;
using Xunit;

namespace Farseer.Serialization.Tests.Scenes;

/// <summary>Scenes of the other facade, saved and loaded, step with the same bits.</summary>
public sealed class TestbedSceneTests
{
    private const int Steps = 60;

    public static TheoryData<int, SceneFormat> Scenes
    {
        get
        {
            TheoryData<int, SceneFormat> data = [];
            for (int i = 0; i < SceneList.Makers.Count; i++)
            {
                data.Add(i, SceneFormat.Json);
                data.Add(i, SceneFormat.Binary);
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Scene_SavedFreshAndLoaded_StepsAsTheOneThatWasBuilt(int scene, SceneFormat format)
    {
        b2World world = Build(scene, 0);

        AssertSameSteps(world, Saves.Loaded(world, format, state: false));
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Scene_SavedInMotionWithItsState_GoesOnAsTheOneThatWasSaved(int scene, SceneFormat format)
    {
        b2World world = Build(scene, 47);
        b2World loaded = Saves.Loaded(world, format, state: true);
        loaded.SetWorkerCount(2);

        Assert.Equal(world.MotionHash(), loaded.MotionHash());
        AssertSameSteps(world, loaded);
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Scene_LoadedAndSavedAgain_IsTheSameFile(int scene, SceneFormat format)
    {
        byte[] saved = SceneFile.Save(Build(scene, 20), Saves.Options(format, false));
        byte[] again = SceneFile.Save(SceneFile.LoadWorld(saved), Saves.Options(format, false));

        Assert.True(saved.AsSpan().SequenceEqual(again), format == SceneFormat.Json ? Saves.FirstDifference(saved, again) : "");
    }

    private static b2World Build(int scene, int steps)
    {
        TestScene made = SceneList.Makers[scene]();
        for (int step = 0; step < steps; step++)
        {
            made.Step(step);
        }

        made.World.SetContactListener(null);
        made.World.SetDestructionListener(null);
        made.World.SetBoundaryListener(null);
        return made.World;
    }

    private static void AssertSameSteps(b2World world, b2World loaded)
    {
        for (int step = 1; step <= Steps; step++)
        {
            world.Step(TestScene.Dt, TestScene.Iterations);
            loaded.Step(TestScene.Dt, TestScene.Iterations);
            Assert.True(world.MotionHash() == loaded.MotionHash(), $"step {step} is another one");
        }

        Assert.Equal(world.GetBodyCount(), loaded.GetBodyCount());
        Assert.Equal(world.GetJointCount(), loaded.GetJointCount());
        Assert.Equal(world.GetContactCount(), loaded.GetContactCount());
    }
}
