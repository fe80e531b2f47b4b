using System;
using System.IO;
using System.Linq;
using System.Text;
using Box2D.Dynamics;
using Farseer.Tests.Shared;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Serialization;
using FarseerGames.FarseerPhysics.Serialization.Scenes;

namespace Farseer.Serialization.Tests;

/// <summary>What the tests of files share.</summary>
internal static class Saves
{
    public static string Folder { get; } = Path.Combine(Clone.Root, "tests", "data", "saves");

    public static SceneFileOptions Options(SceneFormat format, bool state) => new() { Format = format, ExactState = state };

    public static PhysicsSimulator Loaded(PhysicsSimulator simulator, SceneFormat format, bool state) =>
        SceneFile.LoadSimulator(SceneFile.Save(simulator, Options(format, state)));

    public static b2World Loaded(b2World world, SceneFormat format, bool state) =>
        SceneFile.LoadWorld(SceneFile.Save(world, Options(format, state)));

    public static string Json(PhysicsSimulator simulator) => Encoding.UTF8.GetString(SceneFile.Save(simulator));

    /// <summary>Takes away what no file holds, also from what is not in the simulator yet.</summary>
    public static void Unhandle(PhysicsSimulator simulator)
    {
        SceneMembers members = SceneMembers.Of(simulator);
        foreach (Geom geom in members.Geoms)
        {
            geom.OnCollision = null;
            geom.OnSeparation = null;
        }

        simulator.MixMaterials = null;
        foreach (Controller controller in members.Controllers)
        {
            if (controller is BodyController bodies)
            {
                bodies.Filter = null;
            }
        }
    }

    public static string FirstDifference(byte[] one, byte[] other)
    {
        string[] lines = Encoding.UTF8.GetString(one).Split('\n');
        string[] others = Encoding.UTF8.GetString(other).Split('\n');
        int line = lines.Zip(others).TakeWhile(pair => pair.First == pair.Second).Count();
        return string.Join('\n', lines.Skip(Math.Max(0, line - 4)).Take(6)) + "\n--\n"
            + string.Join('\n', others.Skip(Math.Max(0, line - 4)).Take(6));
    }
}
