using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net.Http;
using System.Threading;
using System.Threading.Tasks;
using FarseerGames.FarseerPhysics;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Xunit;

namespace Farseer.Porting.Tests
{
    /// <summary>Under the property a program that draws with XNA, MonoGame or FNA keeps its using of that framework.</summary>
    public sealed class FrameworkNamesTests
    {
        /// <summary>The mathematics of the framework, as far as names go; those that draw do not matter here.</summary>
        private const string Framework = @"namespace Microsoft.Xna.Framework {
public struct Vector2 { public float X, Y; } public struct Vector3 { } public struct Vector4 { } public struct Matrix { }
public static class MathHelper { public const float Pi = 3; }
public class Curve { } public class CurveKey { } public class CurveKeyCollection { }
public enum CurveContinuity { } public enum CurveLoopType { } public enum CurveTangent { }
public struct Quaternion { } public struct Point { } public struct Rectangle { } public struct Plane { } public struct Ray { }
public struct BoundingBox { } public struct BoundingSphere { } public enum ContainmentType { } public enum PlayerIndex { }
public class GameTime { } public class Game { } public class GameComponent { } public struct Color { } }";

        /// <summary>What the SDK brings, without what the property takes out.</summary>
        private static readonly string[] Implicit =
        {
            "System", "System.Collections.Generic", "System.Linq", "System.Net.Http", "System.Threading", "System.Threading.Tasks",
        };

        /// <summary>What every program has a using of, and what it may have one of.</summary>
        private static readonly string[] Needed =
        {
            "Microsoft.Xna.Framework", "FarseerGames.FarseerPhysics", "FarseerGames.FarseerPhysics.Dynamics",
            "FarseerGames.FarseerPhysics.Collisions",
        };

        private static readonly string[] Others =
        {
            "FarseerGames.FarseerPhysics.Mathematics", "FarseerGames.FarseerPhysics.Factories", "FarseerGames.FarseerPhysics.Controllers",
            "System", "System.Collections.Generic",
        };

        /// <summary>What old programs write with the names that both have.</summary>
        private static readonly string[] Uses =
        {
            "float a = MathHelper.Pi + MathHelper.ToRadians(90) + MathHelper.Clamp(2f, 0f, 1f) + MathHelper.Lerp(0, 1, .5f);",
            @"var curve = new Curve { PreLoop = CurveLoopType.Cycle, PostLoop = CurveLoopType.Constant };
              curve.Keys.Add(new CurveKey(0, 1)); float y = curve.Evaluate(0);",
            @"var curve = new Curve(); curve.ComputeTangents(CurveTangent.Smooth);
              CurveKeyCollection keys = curve.Keys; CurveContinuity c = CurveContinuity.Step;",
            "Vector2 v = new Vector2(1, 2); v.Normalize(); Vector2.Add(ref v, ref v, out v); float l = v.Length();",
            @"Body body = new Body(); Vector2 up = new Vector2(body.GetBodyMatrix().Up.X, body.GetBodyMatrix().Right.Y);
              Matrix m = body.GetBodyRotationMatrix(); Vector3 left = m.Left;",
            @"Body body = new Body(); body.Position = new Vector2(3, 4); body.Name = ""hero"";
              Matrix i = Matrix.Invert(body.GetBodyMatrix()); Vector2 p = Vector2.Transform(body.Position, i);",
            @"var vertices = new Vector2[] { new Vector2(0, 0), new Vector2(1, 0), new Vector2(0, 1) };
              Vertices.Triangulate(vertices, Vertices.WindingOrder.CounterClockwise, out vertices, out short[] indices);",
            "Path path = new Path(1, 2, 3, false); path.Add(new Vector2(1, 2));",
        };

        [Fact]
        public void Programs_WithAFrameworksUsing_Compile()
        {
            var random = new Random(1);
            for (int i = 0; i < 200; i++)
            {
                // Any order of usings, and any number of those that the lines can do without; code at the top or in a namespace.
                IEnumerable<string> usings = Needed.Concat(Others.Where(_ => random.Next(2) == 0)).OrderBy(_ => random.Next());
                string head = string.Concat(usings.Select(u => $"using {u};\n"));
                IEnumerable<string> chosen = Uses.OrderBy(_ => random.Next()).Take(random.Next(1, Uses.Length + 1));
                string lines = string.Concat(chosen.Select((use, k) => $"static void M{k}() {{ {use} }}\n"));
                string type = $"class Program{i} {{\n{lines}}}\n";
                string source = head + (random.Next(2) == 0 ? type : $"namespace Game {{\n{type}}}\n");
                string[] errors = Errors(source, random.Next(2) == 0);
                Assert.True(errors.Length == 0, $"{i}: {string.Join('\n', errors)}\n{source}");
            }
        }

        [Fact]
        public void AliasOfAFile_BelowItsNamespace_Wins()
        {
            foreach (string name in new[] { "Vector2", "Vector3", "Vector4", "Matrix", "MathHelper", "Curve", "CurveKey", "CurveLoopType" })
            {
                string use = $"class P {{ static void M(Microsoft.Xna.Framework.{name} x) {{ }} }}";
                if (name == "MathHelper")
                {
                    use = "class P { const float X = MathHelper.Pi; static int[] one = new int[(int)X - 2]; }";
                }

                Assert.Empty(Errors($"namespace Game {{ using {name} = Microsoft.Xna.Framework.{name}; {use} }}", false));
                Assert.Empty(Errors($"namespace Game; using {name} = Microsoft.Xna.Framework.{name}; {use}", false));

                // Above it the compiler says so.
                string[] errors = Errors($"using {name} = Microsoft.Xna.Framework.{name}; namespace Game {{ {use} }}", false);
                Assert.Contains(errors, e => e.StartsWith("CS1537", StringComparison.Ordinal));
            }
        }

        [Fact]
        public void Names_OfTheLibrary_AreInNoNamespaceThatIsImplicit_ButForPath()
        {
            HashSet<string> names = typeof(PhysicsSimulator).Assembly.GetExportedTypes()
                .Where(t => !t.IsNested).Select(t => t.Name).ToHashSet();
            Type[] roots = { typeof(object), typeof(List<int>), typeof(Enumerable), typeof(HttpClient), typeof(Thread), typeof(Task) };
            foreach (Type root in roots)
            {
                IEnumerable<Type> implicitly = root.Assembly.GetExportedTypes().Where(t => t.Namespace == root.Namespace);
                Assert.Empty(implicitly.Where(t => names.Contains(t.Name)).Select(t => t.FullName));
            }

            Assert.Contains(nameof(Path), names);
        }

        /// <summary>The errors of a source under the property, code and text.</summary>
        private static string[] Errors(string source, bool implicitUsings)
        {
            string usings = BuildProperty.GlobalUsings;
            if (implicitUsings)
            {
                usings += string.Concat(Implicit.Select(name => $"global using {name};\n"));
            }

            var options = new CSharpParseOptions(LanguageVersion.CSharp14);
            string[] assemblies = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")).Split(System.IO.Path.PathSeparator);
            var compilation = CSharpCompilation.Create(
                "Names",
                new[] { source, usings, Framework }.Select(text => CSharpSyntaxTree.ParseText(text, options)),
                assemblies.Append(typeof(PhysicsSimulator).Assembly.Location).Distinct().Select(a => MetadataReference.CreateFromFile(a)),
                new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));
            return compilation.GetDiagnostics()
                .Where(d => d.Severity == DiagnosticSeverity.Error).Select(d => d.Id + " " + d.GetMessage()).ToArray();
        }
    }
}
