using System;
using System.IO;
using System.Text;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Serialization;
using Xunit;

namespace Farseer.Serialization.Tests.Files;

/// <summary>Files that cannot be loaded say where and why.</summary>
public sealed class BadFileTests
{
    private const string Head = "{ \"format\": \"farseer\", \"version\": 1";

    [Theory]
    [InlineData("", 1, 1, "", "is no JSON")]
    [InlineData("{ \"format\": ", 1, 13, "", "is no JSON")]
    [InlineData("[1]", 1, 1, "", "must be an object")]
    [InlineData("{ \"version\": 1 }", 1, 1, "", "needs the member format")]
    [InlineData("{ \"format\": \"box2dflash\", \"version\": 1 }", 1, 13, "format", "must be \"farseer\"")]
    [InlineData("{ \"format\": \"farseer\", \"version\": 2 }", 1, 35, "version", "is newer than this library")]
    [InlineData("{ \"format\": \"farseer\", \"version\": 0 }", 1, 35, "version", "must be at least 1")]
    [InlineData(Head + ", \"extra\": 1 }", 1, 47, "extra", "is unknown")]
    [InlineData(Head + ",\n \"bodies\": [{}, { \"mass\": -3 }] }", 2, 27, "bodies[1].mass", "cannot be used")]
    [InlineData(Head + ",\n \"bodies\": [{ \"mass\": 1, \"mass\": 2 }] }", 2, 34, "bodies[0].mass", "stands there twice")]
    [InlineData(Head + ",\n \"bodies\": [{ \"mass\": true }] }", 2, 23, "bodies[0].mass", "must be a number")]
    [InlineData(Head + ",\n \"bodies\": [{ \"mass\": 1e99 }] }", 2, 23, "bodies[0].mass", "must be a number")]
    [InlineData(Head + ",\n \"bodies\": [{ \"iterationFactor\": 2.5 }] }", 2, 34, "bodies[0].iterationFactor", "must be a whole number")]
    [InlineData(
        Head + ",\n \"bodies\": [{ \"motionLocks\": \"Z\" }] }", 2, 30, "bodies[0].motionLocks", "must be made of members of the enum")]
    [InlineData(Head + ",\n \"bodies\": [{ \"linearVelocity\": [1] }] }", 2, 33, "bodies[0].linearVelocity", "must be two numbers")]
    [InlineData(
        Head + ",\n \"bodies\": [{}], \"geoms\": [{ \"body\": 1, \"shape\": \"Circle\", \"radius\": 1 }] }",
        2,
        38,
        "geoms[0].body",
        "must be the place of an item")]
    [InlineData(Head + ",\n \"bodies\": [{}], \"geoms\": [{ \"body\": 0, \"shape\": \"Star\" }] }", 2, 50, "geoms[0].shape", "is no shape")]
    [InlineData(
        Head + ",\n \"bodies\": [{}], \"geoms\": [{ \"body\": 0, \"shape\": \"Outline\", \"points\": [0, 0, 1, 0] }] }",
        2,
        28,
        "geoms[0]",
        "cannot be used")]
    [InlineData(
        Head + ",\n \"bodies\": [{}], \"joints\": [{ \"kind\": \"Weld\", \"body1\": 0, \"body2\": 0 }] }",
        2,
        29,
        "joints[0]",
        "A joint needs two different bodies")]
    [InlineData(Head + ",\n \"simulator\": { \"bodies\": [0] } }", 2, 27, "simulator.bodies", "must be the place of an item")]
    public void Json_ThatCannotBeLoaded_NamesPlaceAndReason(string text, long line, long position, string path, string reason)
    {
        SceneFileException exception = Assert.Throws<SceneFileException>(() => SceneFile.LoadSimulator(Encoding.UTF8.GetBytes(text)));

        Assert.Equal((line, position, path), (exception.Line, exception.Position, exception.ItemPath));
        Assert.Contains(reason, exception.Message);
    }

    [Fact]
    public void Json_WithAWrongValue_TellsTheValue()
    {
        SceneFileException exception = Assert.Throws<SceneFileException>(
            () => SceneFile.LoadSimulator(Encoding.UTF8.GetBytes(Head + ", \"bodies\": [{ \"mass\": -3 }] }")));

        Assert.Equal("-3", exception.Value);
        Assert.StartsWith("line 1, position 59: bodies[0].mass cannot be used: ", exception.Message);
        Assert.EndsWith(": -3", exception.Message);
    }

    [Fact]
    public void Json_WrittenByHand_LoadsWithCommentsAndDefaults()
    {
        const string Text = Head + """
            ,
              // A ball.
              "simulator": { "gravity": [0, -10], "bodies": [0], "geoms": [0], },
              "bodies": [ { "y": 5 } ],
              "geoms": [ { "body": 0, "shape": "Circle", "radius": 0.5 } ],
            }
            """;

        PhysicsSimulator simulator = SceneFile.LoadSimulator(Encoding.UTF8.GetBytes(Text));
        simulator.Update(0.5f);

        Assert.Equal(5 - (0.5 * 10 * 0.25), simulator.BodyList[0].PositionY, 0.01);
        Assert.Equal(1, simulator.BodyList[0].Mass);
    }

    [Fact]
    public void Binary_CutAnywhere_IsRefused()
    {
        byte[] file = SceneFile.Save(Small(), Saves.Options(SceneFormat.Binary, false));
        for (int length = 0; length < file.Length; length++)
        {
            Assert.Throws<SceneFileException>(() => SceneFile.LoadSimulator(file[..length]));
        }
    }

    [Fact]
    public void State_OfAChangedFile_IsRefused()
    {
        byte[] file = SceneFile.Save(Small(), Saves.Options(SceneFormat.Json, true));
        string text = Encoding.UTF8.GetString(file);
        string changed = text.Replace("\"mass\": 1,", "\"mass\": 2,", StringComparison.Ordinal);
        Assert.NotEqual(text, changed);

        SceneFileException exception = Assert.Throws<SceneFileException>(() => SceneFile.LoadSimulator(Encoding.UTF8.GetBytes(changed)));

        Assert.Equal("state", exception.ItemPath);
        Assert.Contains("has been changed", exception.Message);
        Assert.NotNull(SceneFile.LoadSimulator(Encoding.UTF8.GetBytes(changed), new SceneFileOptions { ExactState = false }));
        Assert.NotNull(SceneFile.LoadSimulator(Encoding.UTF8.GetBytes(text.Replace("\n", "\r\n", StringComparison.Ordinal))));
    }

    [Fact]
    public void File_LargerThanAllowed_IsRefusedBeforeItIsRead()
    {
        byte[] file = SceneFile.Save(Small());
        var options = new SceneFileOptions { MostBytes = file.Length - 1 };

        Assert.Throws<SceneFileException>(() => SceneFile.LoadSimulator(file, options));
        Assert.Throws<SceneFileException>(() => SceneFile.LoadSimulator(new MemoryStream(file), options));
        Assert.Throws<ArgumentOutOfRangeException>(() => options.MostBytes = 0);
    }

    [Fact]
    public void Save_WithinAnUpdateOrOfOwnTypes_IsRefused()
    {
        PhysicsSimulator simulator = Small();
        Exception? caught = null;
        simulator.Update(0);
        simulator.GeomList[0].OnCollision = (_, _, _) =>
        {
            caught = Record.Exception(() => SceneFile.Save(simulator));
            return true;
        };
        simulator.Update(0.01f);
        Assert.IsType<InvalidOperationException>(caught);

        simulator.Add(new Drift());
        Assert.Contains(nameof(Drift), Assert.Throws<NotSupportedException>(() => SceneFile.Save(simulator)).Message);
        Assert.Contains(
            nameof(Drift),
            Assert.Throws<NotSupportedException>(() => SceneFile.Save(simulator, new SceneFileOptions { ExactState = true })).Message);
        Assert.Throws<ArgumentNullException>(() => SceneFile.Save((PhysicsSimulator)null!));
        Assert.Throws<ArgumentNullException>(() => SceneFile.LoadSimulator((byte[])null!));
    }

    private static PhysicsSimulator Small()
    {
        var simulator = new PhysicsSimulator();
        for (int i = 0; i < 2; i++)
        {
            FarseerGames.FarseerPhysics.Dynamics.Body body =
                FarseerGames.FarseerPhysics.Factories.BodyFactory.Instance.CreateBody(simulator, 1, 1);
            FarseerGames.FarseerPhysics.Factories.GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1);
            body.Position = new System.Numerics.Vector2(0, 0.75f * i);
        }

        return simulator;
    }

    private sealed class Drift : Controller
    {
        public override void Validate()
        {
        }

        public override void Update(float dt)
        {
        }
    }
}
