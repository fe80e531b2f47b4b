using System;
using System.IO;
using System.Linq;
using Box2D.Dynamics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Serialization;
using Xunit;

namespace Farseer.Serialization.Tests.Files;

/// <summary>
/// Files of each version, kept in tests/data/saves, load for ever. FARSEER_UPDATE_SAVES=1 writes those of the present version that are not
/// there yet; one that is there is never written anew.
/// </summary>
public sealed class VersionTests
{
    private const int Bodies = 51;
    private const int FlashBodies = 11;

    public static TheoryData<string> Names
    {
        get
        {
            if (Environment.GetEnvironmentVariable("FARSEER_UPDATE_SAVES") == "1")
            {
                WriteMissing();
            }

            return [.. Directory.GetFiles(Saves.Folder, "*.*", SearchOption.AllDirectories)
                .Select(file => Path.GetRelativePath(Saves.Folder, file)).Order()];
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void File_OfAnyVersion_Loads(string name)
    {
        byte[] file = File.ReadAllBytes(Path.Combine(Saves.Folder, name));
        var scene = new SceneFileOptions { ExactState = false };
        if (name.Contains("box2dflash", StringComparison.Ordinal))
        {
            b2World world = SceneFile.LoadWorld(file, scene);
            world.Step(1f / 60, 10);
            Assert.Equal(FlashBodies, world.GetBodyCount());
        }
        else
        {
            PhysicsSimulator simulator = SceneFile.LoadSimulator(file, scene);
            simulator.Update(1f / 60);
            Assert.Equal(Bodies, simulator.BodyList.Count);
            Assert.Equal(28, simulator.JointList.Count);
            Assert.Equal(8, simulator.ControllerList.Count);
        }
    }

    /// <summary>The scene that it was made of is still built by the same code: what a file has lost shows here.</summary>
    [Theory]
    [InlineData("v1/farseer.json")]
    [InlineData("v1/farseer.bin")]
    public void Scene_OfAnyVersion_StepsAsTheOneThatIsBuilt(string name)
    {
        PhysicsSimulator loaded = SceneFile.LoadSimulator(File.ReadAllBytes(Path.Combine(Saves.Folder, name)));
        PhysicsSimulator built = Everything.Build();
        for (int i = 0; i < 60; i++)
        {
            built.Update(1f / 60);
            loaded.Update(1f / 60);
            Assert.Equal(built.MotionHash(), loaded.MotionHash());
        }
    }

    /// <summary>As long as the layout is the one that they were saved with, on whichever asset and processor.</summary>
    [Theory]
    [InlineData("v1/farseer-state.json")]
    [InlineData("v1/farseer-state.bin")]
    [InlineData("v1/box2dflash-state.bin")]
    public void State_OfAnyVersion_LoadsOrIsRefusedByName(string name)
    {
        byte[] file = File.ReadAllBytes(Path.Combine(Saves.Folder, name));
        Exception? exception = Record.Exception(() =>
        {
            if (name.Contains("box2dflash", StringComparison.Ordinal))
            {
                SceneFile.LoadWorld(file).Step(1f / 60, 10);
            }
            else
            {
                SceneFile.LoadSimulator(file).Update(1f / 60);
            }
        });

        Assert.True(exception is null || exception is SceneFileException { ItemPath: "state" } refused
            && refused.Message.Contains("another version of the library"), $"{exception}");
    }

    private static void WriteMissing()
    {
        PhysicsSimulator simulator = Everything.Build(out FarseerGames.FarseerPhysics.Dynamics.Path path);
        PhysicsSimulator moved = Everything.Build();
        b2World world = FlashEverything.Build();
        b2World movedWorld = FlashEverything.Build();
        for (int i = 0; i < 60; i++)
        {
            moved.Update(1f / 60);
            movedWorld.Step(1f / 60, 10);
        }

        foreach (SceneFormat format in Enum.GetValues<SceneFormat>())
        {
            string extension = format == SceneFormat.Json ? ".json" : ".bin";
            Write("farseer" + extension, () => SceneFile.Save(simulator, new SceneFileOptions { Format = format, Paths = { path } }));
            Write("farseer-state" + extension, () => SceneFile.Save(moved, Saves.Options(format, true)));
            Write("box2dflash" + extension, () => SceneFile.Save(world, Saves.Options(format, false)));
            Write("box2dflash-state" + extension, () => SceneFile.Save(movedWorld, Saves.Options(format, true)));
        }

        static void Write(string name, Func<byte[]> save)
        {
            string file = Path.Combine(Saves.Folder, "v" + SceneFile.Version, name);
            if (!File.Exists(file))
            {
                Directory.CreateDirectory(Path.GetDirectoryName(file)!);
                File.WriteAllBytes(file, save());
            }
        }
    }
}
