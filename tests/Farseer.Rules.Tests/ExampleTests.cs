using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Text;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>The examples in the documentation of types compile, each in a method in which the things that it speaks of are there.</summary>
public sealed class ExampleTests
{
    private const int Least = 40;

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

    [Fact]
    public void Example_OfAType_Compiles()
    {
        List<(string File, string Code)> examples = [.. from file in Repository.Files("src/Farseer", "*.cs")
            from Match block in Regex.Matches(
                File.ReadAllText(file),
                @"^/// <example>\s*\n/// <code>\n((?:///.*\n)*?)/// </code>\n/// </example>",
                RegexOptions.Multiline)
            let lines = block.Groups[1].Value.Split('\n').Select(l => l.Length > 4 ? l[4..] : string.Empty)
            select (Repository.Relative(file), WebUtility.HtmlDecode(string.Join('\n', lines)))];
        StringBuilder source = new(Surroundings);
        for (int i = 0; i < examples.Count; i++)
        {
            // An example that begins with a member is what a class has in it, any other one what a method does.
            (string file, string code) = examples[i];
            bool isMember = code.StartsWith("public ", StringComparison.Ordinal);
            string body = $"#line 1 \"{file}\"\n{code}\n";
            source.Append(FormattableString.Invariant(
                $"class Example{i} : Surroundings\n{{\n{(isMember ? body : $"static void Run()\n{{\n{body}}}\n")}}}\n"));
        }

        Assert.True(examples.Count >= Least, $"{examples.Count} examples");
        Assert.Empty(Snippet.Compile(source.ToString(), string.Empty, "examples"));
    }
}
