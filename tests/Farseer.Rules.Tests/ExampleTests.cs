using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Reflection;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>The examples in the documentation of types compile, each in a method in which the things that it speaks of are there.</summary>
public sealed class ExampleTests
{
    private const string Surroundings = """
        #pragma warning disable CS0169, CS0649, CS0168, CS0219, CS0618
        using System;
        using System.Collections.Generic;
        using System.IO;
        using System.Numerics;
        using System.Runtime.InteropServices;
        using System.Threading;
        using System.Threading.Tasks;
        using FarseerGames.FarseerPhysics;
        using FarseerGames.FarseerPhysics.Collisions;
        using FarseerGames.FarseerPhysics.Controllers;
        using FarseerGames.FarseerPhysics.Dynamics;
        using FarseerGames.FarseerPhysics.Dynamics.Joints;
        using FarseerGames.FarseerPhysics.Dynamics.Springs;
        using FarseerGames.FarseerPhysics.Factories;
        using FarseerGames.FarseerPhysics.Interfaces;
        using FarseerGames.FarseerPhysics.Mathematics;
        using FarseerGames.FarseerPhysics.Porting;
        using FarseerGames.FarseerPhysics.Views;
        using Path = FarseerGames.FarseerPhysics.Dynamics.Path;

        class Surroundings
        {
            public static PhysicsSimulator simulator, peer;
            public static Body body, second, first;
            public static Geom geom, other;
            public static RevoluteJoint hinge;
            public static LinearSpring spring;
            public static IDebugDraw draw;
            public static float dt, input;
            public static bool jump;
            public static double secondsSinceLastFrame;
            public static uint[] pixels;
            public static PhysicsSimulator MakeScene() => new();
            public static Actor player;
            public static Speaker sounds;
            public float _phase;
            public static void Draw(object sprite, Vector2 position, float rotation) { }
        }

        class Actor
        {
            public Body Body;
            public object Sprite;
            public void ApplyForces() { }
        }

        class PushedBox : BatchedWorld
        {
            public PushedBox()
                : base(new PhysicsSimulator())
            {
            }

            public override void Act(ReadOnlySpan<float> action) { }

            public override void Observe(Span<float> observation) { }
        }

        class Speaker
        {
            public void Play(string name, Vector2 place, float volume) { }
        }

        """;

    private const string FlashSurroundings = """
        #pragma warning disable CS0169, CS0649, CS0168, CS0219, CS0618
        using System;
        using Box2D.Collision;
        using Box2D.Collision.Shapes;
        using Box2D.Common;
        using Box2D.Common.Math;
        using Box2D.Dynamics;
        using Box2D.Dynamics.Contacts;
        using Box2D.Dynamics.Joints;

        class Surroundings
        {
            public static b2World world, other;
            public static b2Body body, second;
            public static b2Shape shape;
            public static b2ContactPoint point;
            public static b2DebugDraw draw;
            public static b2RevoluteJoint hinge;
            public static b2PrismaticJoint slide;
        }

        """;

    /// <summary>Types within others, mostly those of handlers, are shown where the other is.</summary>
    [Theory]
    [InlineData("Farseer", 130)]
    [InlineData("Farseer.Box2DFlash", 45)]
    public void Type_OfALibrary_HasAnExample(string library, int least)
    {
        string assembly = Repository.Library(library, "net8.0");
        HashSet<string> shown = [.. XDocument.Load(Path.ChangeExtension(assembly, ".xml")).Descendants("member")
            .Where(m => m.Element("example") is not null).Select(m => m.Attribute("name")!.Value)];
        List<Type> types = [.. Assembly.Load(library).GetExportedTypes().Where(t => !t.IsNested)];

        Assert.True(types.Count >= least, $"{types.Count} types");
        Assert.Empty(types.Where(t => !shown.Contains("T:" + t.FullName)).Select(t => t.FullName));
    }

    [Theory]
    [InlineData("src/Farseer", Surroundings, 120)]
    [InlineData("src/Farseer.Box2DFlash", FlashSurroundings, 40)]
    public void Example_OfAType_Compiles(string library, string surroundings, int least)
    {
        List<(string File, string Code)> examples = [.. from file in Repository.Files(library, "*.cs")
            from Match block in Regex.Matches(
                File.ReadAllText(file),
                @"^/// <example>\s*\n/// <code>\n((?:///.*\n)*?)/// </code>\n/// </example>",
                RegexOptions.Multiline)
            let lines = block.Groups[1].Value.Split('\n').Select(l => l.Length > 4 ? l[4..] : string.Empty)
            select (Repository.Relative(file), WebUtility.HtmlDecode(string.Join('\n', lines)))];
        StringBuilder source = new(surroundings);
        for (int i = 0; i < examples.Count; i++)
        {
            // An example that begins with a member is what a class has in it, any other one what a method does.
            (string file, string code) = examples[i];
            bool isMember = code.StartsWith("public ", StringComparison.Ordinal);
            string body = $"#line 1 \"{file}\"\n{code}\n";
            source.Append(FormattableString.Invariant(
                $"class Example{i} : Surroundings\n{{\n{(isMember ? body : $"static void Run()\n{{\n{body}}}\n")}}}\n"));
        }

        Assert.True(examples.Count >= least, $"{examples.Count} examples");
        List<string> faults = [.. Snippet.Compile(source.ToString(), string.Empty, "examples").Select(d => d.ToString())];
        Assert.True(faults.Count == 0, string.Join('\n', faults));
    }
}
