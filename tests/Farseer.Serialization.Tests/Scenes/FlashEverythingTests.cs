using System;
using Box2D.Dynamics;
using FarseerGames.FarseerPhysics.Serialization;
using Xunit;

namespace Farseer.Serialization.Tests.Scenes;

/// <summary>A world of the other facade that has one of everything.</summary>
public sealed class FlashEverythingTests
{
    [Theory]
    [InlineData(SceneFormat.Json, false, 0)]
    [InlineData(SceneFormat.Binary, false, 0)]
    [InlineData(SceneFormat.Json, true, 1)]
    [InlineData(SceneFormat.Binary, true, 50)]
    public void World_SavedAndLoaded_StepsWithTheSameBits(SceneFormat format, bool state, int steps)
    {
        b2World world = FlashEverything.Build();
        for (int i = 0; i < steps; i++)
        {
            world.Step(1f / 60, 10);
        }

        b2World loaded = Saves.Loaded(world, format, state);

        for (int i = 1; i <= 120; i++)
        {
            world.Step(1f / 60, 10);
            loaded.Step(1f / 60, 10);
            Assert.True(world.MotionHash() == loaded.MotionHash(), $"step {i} is another one");
        }

        Assert.Equal("ball", Find(loaded, "ball").GetUserData());
        Assert.True(Find(loaded, "ball").IsBullet());
    }

    [Theory]
    [InlineData(SceneFormat.Json)]
    [InlineData(SceneFormat.Binary)]
    public void World_LoadedAndSavedAgain_IsTheSameFile(SceneFormat format)
    {
        byte[] saved = SceneFile.Save(FlashEverything.Build(), Saves.Options(format, false));
        byte[] again = SceneFile.Save(SceneFile.LoadWorld(saved), Saves.Options(format, false));

        Assert.True(saved.AsSpan().SequenceEqual(again), format == SceneFormat.Json ? Saves.FirstDifference(saved, again) : "");
    }

    private static b2Body Find(b2World world, object data)
    {
        for (b2Body? body = world.GetBodyList(); body is not null; body = body.GetNext())
        {
            if (data.Equals(body.GetUserData()))
            {
                return body;
            }
        }

        throw new InvalidOperationException("There is no such body.");
    }
}
