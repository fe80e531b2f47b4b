using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Box2D.Dynamics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Viewer;
using FarseerGames.FarseerPhysics.Serialization;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>The public surface changes only on purpose: FARSEER_UPDATE_API=1 writes the baseline anew.</summary>
public sealed class PublicApiTests
{
    [Theory]
    [InlineData(typeof(PhysicsSimulator), "PublicApi.txt")]
    [InlineData(typeof(b2World), "PublicApi.Box2DFlash.txt")]
    [InlineData(typeof(RunRecorder), "PublicApi.Viewer.txt")]
    [InlineData(typeof(SceneFile), "PublicApi.Serialization.txt")]
    public void PublicApi_EqualsBaseline(Type inside, string name)
    {
        string file = Path.Combine(Repository.Root, "tests", "Farseer.Rules.Tests", name);
        List<string> present = [.. inside.Assembly.GetExportedTypes().SelectMany(Describe).Order(StringComparer.Ordinal)];
        if (Environment.GetEnvironmentVariable("FARSEER_UPDATE_API") == "1")
        {
            File.WriteAllText(file, string.Join('\n', present) + "\n");
        }

        string[] baseline = File.ReadAllLines(file);

        Assert.Empty(present.Except(baseline).Select(l => "new: " + l).Concat(baseline.Except(present).Select(l => "gone: " + l)));
    }

    private static IEnumerable<string> Describe(Type type)
    {
        const BindingFlags Declared = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static
            | BindingFlags.DeclaredOnly;
        yield return $"{type.FullName} : {type.BaseType}";
        foreach (MemberInfo member in type.GetMembers(Declared))
        {
            bool visible = member switch
            {
                MethodBase m => m.IsPublic || m.IsFamily || m.IsFamilyOrAssembly,
                FieldInfo f => f.IsPublic || f.IsFamily || f.IsFamilyOrAssembly,
                _ => false, // properties and events show by their accessors, nested types by themselves
            };
            if (visible)
            {
                yield return $"{type.FullName} {member}";
            }
        }
    }
}
