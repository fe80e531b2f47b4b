using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Reflection;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>Every method of the two factories exists with and without a simulator, and only the first form adds what it makes.</summary>
[ManualRow("F030")]
public class FactoryOverloadTests
{
    public static TheoryData<string> Methods()
    {
        var data = new TheoryData<string>();
        foreach (MethodInfo method in All().Where(TakesSimulator))
        {
            data.Add(Name(method, method.GetParameters()));
        }

        return data;
    }

    [Theory]
    [MemberData(nameof(Methods))]
    public void Overload_WithASimulator_AddsWhatTheOneWithoutMakes(string name)
    {
        MethodInfo with = All().Where(TakesSimulator).Single(method => Name(method, method.GetParameters()) == name);
        ParameterInfo[] shared = with.GetParameters().Skip(1).ToArray();
        MethodInfo without = Assert.Single(All(), method => !TakesSimulator(method)
            && Name(method, method.GetParameters()) == Name(with, shared));
        var simulator = new PhysicsSimulator();
        object made = without.Invoke(Instance(without), Arguments(shared))!;
        simulator.Update(0.01f);
        Assert.Equal(0, simulator.BodyList.Count + simulator.GeomList.Count);
        object added = with.Invoke(Instance(with), Arguments(shared).Prepend(simulator).ToArray())!;
        simulator.Update(0.01f);
        object inList = added is Body ? Assert.Single(simulator.BodyList) : Assert.Single(simulator.GeomList);
        Assert.Same(added, inList);
        Assert.Equal(added is Body ? 0 : 1, simulator.GeomList.Count);
        AssertAlike(made, added);
        var error = Assert.Throws<TargetInvocationException>(() => with.Invoke(Instance(with), Arguments(shared).Prepend(null).ToArray()));
        Assert.Equal("physicsSimulator", Assert.IsType<ArgumentNullException>(error.InnerException).ParamName);
    }

    [Fact]
    public void Overload_WithoutASimulator_HasOneWithIt()
    {
        var pairs = All().Where(TakesSimulator).Select(method => Name(method, method.GetParameters().Skip(1))).ToHashSet();
        string[] alone = All().Where(method => !TakesSimulator(method))
            .Select(method => Name(method, method.GetParameters()))
            .Where(name => !pairs.Contains(name))
            .ToArray();
        Assert.Empty(alone);
        Assert.True(pairs.Count >= 20, $"Only {pairs.Count} pairs were found.");
    }

    private static IEnumerable<MethodInfo> All() =>
        new[] { typeof(BodyFactory), typeof(GeomFactory) }
            .SelectMany(type => type.GetMethods(BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly))
            .Where(method => method.Name.StartsWith("Create", StringComparison.Ordinal));

    private static bool TakesSimulator(MethodInfo method) => method.GetParameters()[0].ParameterType == typeof(PhysicsSimulator);

    private static string Name(MethodInfo method, IEnumerable<ParameterInfo> parameters) =>
        method.Name + "(" + string.Join(", ", parameters.Select(p => p.ParameterType.Name + " " + p.Name)) + ")";

    private static object Instance(MethodInfo method) =>
        method.DeclaringType == typeof(BodyFactory) ? BodyFactory.Instance : GeomFactory.Instance;

    private static object?[] Arguments(IEnumerable<ParameterInfo> parameters) => parameters.Select(Argument).ToArray();

    private static object? Argument(ParameterInfo parameter) => parameter.ParameterType.Name switch
    {
        nameof(Body) => new Body { Mass = 3, MomentOfInertia = 5, Position = new Vector2(8, 9), Rotation = 0.5f },
        nameof(Geom) => new Geom(new Body(), Vertices.CreateRectangle(6, 4), 1) { FrictionCoefficient = 0.5f },
        nameof(Vertices) => Sandbox.Outline(0, 0, 30, 0, 0, 40),
        nameof(Vector2) => parameter.Name == "end" ? new Vector2(40, 3) : new Vector2(1, 2),
        nameof(Single) => parameter.Name == "rotationOffset" ? 0.25f : parameter.Name == "height" ? 12f : 10f,
        nameof(Int32) => 16,
        nameof(Boolean) => true,
        _ => throw new InvalidOperationException(parameter.ParameterType.Name + " is not known to the test."),
    };

    private static void AssertAlike(object made, object added)
    {
        if (made is Body body)
        {
            var other = (Body)added;
            Assert.Equal(body.Mass, other.Mass);
            Assert.Equal(body.MomentOfInertia, other.MomentOfInertia);
            Assert.Equal(body.Position, other.Position);
            return;
        }

        var first = (Geom)made;
        var second = (Geom)added;
        Assert.Equal(first.LocalVertices, second.LocalVertices);
        Assert.Equal(first.WorldVertices, second.WorldVertices);
        Assert.Equal(first.CollisionGridCellSize, second.CollisionGridCellSize);
        Assert.Equal(first.FrictionCoefficient, second.FrictionCoefficient);
        Assert.Equal(first.Position, second.Position);
        Assert.Equal(first.Rotation, second.Rotation);
    }
}
