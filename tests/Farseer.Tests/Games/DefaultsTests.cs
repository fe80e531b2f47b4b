using System;
using System.Linq;
using System.Numerics;
using System.Reflection;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Games;

/// <summary>What new bodies and geoms begin with.</summary>
public sealed class DefaultsTests
{
    private const float Friction = 0.5f;
    private const float Restitution = 0.25f;
    private const float Drag = 0.125f;
    private const float Turning = 2;

    [Fact]
    public void Defaults_OfANewSimulator_AreThoseOfBodyAndGeom()
    {
        var simulator = new PhysicsSimulator();
        var body = new Body();
        Geom geom = GeomFactory.Instance.CreateCircleGeom(body, 1, 12);

        Assert.Equal(body.LinearDragCoefficient, simulator.Defaults.LinearDragCoefficient);
        Assert.Equal(body.RotationalDragCoefficient, simulator.Defaults.RotationalDragCoefficient);
        Assert.Equal(geom.FrictionCoefficient, simulator.Defaults.FrictionCoefficient);
        Assert.Equal(geom.RestitutionCoefficient, simulator.Defaults.RestitutionCoefficient);
    }

    [Fact]
    public void Defaults_OfTheSimulator_AreThoseOfAllThatItsFactoriesMake()
    {
        PhysicsSimulator simulator = WithDefaults();

        // Every method that takes the simulator and copies nothing: a new one is asked too.
        int bodies = 0;
        foreach (MethodInfo method in Makers(typeof(BodyFactory), typeof(Body)))
        {
            var body = (Body)method.Invoke(BodyFactory.Instance, Arguments(method, simulator))!;
            Assert.Equal((Drag, Turning), (body.LinearDragCoefficient, body.RotationalDragCoefficient));
            bodies++;
        }

        int geoms = 0;
        foreach (MethodInfo method in Makers(typeof(GeomFactory), typeof(Geom)))
        {
            var geom = (Geom)method.Invoke(GeomFactory.Instance, Arguments(method, simulator))!;
            Assert.Equal((Friction, Restitution), (geom.FrictionCoefficient, geom.RestitutionCoefficient));
            geoms++;
        }

        Path rope = ComplexFactory.Instance.CreateChain(
            simulator, new Vector2(0, 50), new Vector2(10, 50), 1, 0.5f, 1, true, true, 1, LinkType.RevoluteJoint);

        Assert.True(bodies >= 7 && geoms >= 15, $"{bodies} bodies, {geoms} geoms");
        Assert.All(rope.Bodies, b => Assert.Equal((Drag, Turning), (b.LinearDragCoefficient, b.RotationalDragCoefficient)));
        Assert.All(rope.Geoms, g => Assert.Equal((Friction, Restitution), (g.FrictionCoefficient, g.RestitutionCoefficient)));
    }

    [Fact]
    public void Defaults_LeaveCopiesAndWhatIsThereAndWhatTheSimulatorDoesNotMake()
    {
        PhysicsSimulator simulator = WithDefaults();
        var smooth = new Body { LinearDragCoefficient = 0, RotationalDragCoefficient = 1 };
        Geom ice = GeomFactory.Instance.CreateCircleGeom(smooth, 1, 12);
        simulator.Add(smooth);
        simulator.Add(ice);
        Body body = BodyFactory.Instance.CreateBody(simulator, smooth);
        Geom geom = GeomFactory.Instance.CreateGeom(simulator, body, ice);
        Vehicle car = Vehicle.Create(simulator, Vector2.Zero, 4, 1000);
        simulator.Update(Step);

        Assert.Equal((0, 1), (body.LinearDragCoefficient, body.RotationalDragCoefficient));
        Assert.Equal((0, 1), (smooth.LinearDragCoefficient, smooth.RotationalDragCoefficient));
        Assert.Equal((0, 0), (geom.FrictionCoefficient, geom.RestitutionCoefficient));
        Assert.Equal((0, 0), (ice.FrictionCoefficient, ice.RestitutionCoefficient));

        // Tyres have a friction of their own.
        Assert.Equal(1.5f, car.Wheels[0].Geoms[0].FrictionCoefficient);
    }

    [Fact]
    public void Defaults_GoBackWithTheState()
    {
        PhysicsSimulator simulator = WithDefaults();
        PhysicsSimulatorState state = simulator.Capture();
        ulong before = simulator.StateHash();
        simulator.Defaults.FrictionCoefficient = 1;
        Assert.NotEqual(before, simulator.StateHash());
        Assert.Contains("friction", simulator.Compare(WithDefaults()).ToString(), StringComparison.OrdinalIgnoreCase);
        simulator.Restore(state);

        Assert.Equal(Friction, simulator.Defaults.FrictionCoefficient);
        Assert.Equal(before, simulator.StateHash());
    }

    [Theory]
    [InlineData(nameof(SimulatorDefaults.FrictionCoefficient))]
    [InlineData(nameof(SimulatorDefaults.RestitutionCoefficient))]
    [InlineData(nameof(SimulatorDefaults.LinearDragCoefficient))]
    [InlineData(nameof(SimulatorDefaults.RotationalDragCoefficient))]
    public void Defaults_RefuseWhatBodiesAndGeomsRefuse(string name)
    {
        SimulatorDefaults defaults = WithDefaults().Defaults;
        PropertyInfo property = typeof(SimulatorDefaults).GetProperty(name)!;
        object? before = property.GetValue(defaults);
        foreach (float value in new[] { -1, float.NaN, float.PositiveInfinity })
        {
            Exception? exception = Assert.Throws<TargetInvocationException>(() => property.SetValue(defaults, value)).InnerException;
            Assert.Equal(name, Assert.IsType<ArgumentOutOfRangeException>(exception).ParamName);
        }

        Assert.Equal(before, property.GetValue(defaults));
    }

    private static PhysicsSimulator WithDefaults()
    {
        PhysicsSimulator simulator = Falling();
        simulator.Defaults.FrictionCoefficient = Friction;
        simulator.Defaults.RestitutionCoefficient = Restitution;
        simulator.Defaults.LinearDragCoefficient = Drag;
        simulator.Defaults.RotationalDragCoefficient = Turning;
        return simulator;
    }

    private static MethodInfo[] Makers(Type factory, Type made) =>
    [
        .. factory.GetMethods().Where(m => m.ReturnType == made && m.GetParameters() is [{ } first, ..]
            && first.ParameterType == typeof(PhysicsSimulator) && !m.GetParameters().Any(p => p.ParameterType == made)),
    ];

    private static object[] Arguments(MethodInfo method, PhysicsSimulator simulator) =>
        [.. method.GetParameters().Select(p => Argument(p, simulator))];

    private static object Argument(ParameterInfo parameter, PhysicsSimulator simulator) => parameter.ParameterType switch
    {
        Type t when t == typeof(PhysicsSimulator) => simulator,
        Type t when t == typeof(Body) => new Body(),
        Type t when t == typeof(Vertices) => Outline(0, 0, 2, 0, 2, 1, 0, 1),
        Type t when t == typeof(Vector2) => parameter.Name == "start" ? Vector2.Zero : Vector2.UnitX,
        Type t when t == typeof(int) => 12,
        Type t when t == typeof(bool) => false,
        _ => 0.5f,
    };
}
