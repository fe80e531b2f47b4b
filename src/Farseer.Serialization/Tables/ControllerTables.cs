using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Controllers;

namespace FarseerGames.FarseerPhysics.Serialization.Tables;

/// <summary>The members of controllers, and how each kind is made. The names of the kinds stand in files.</summary>
internal static class ControllerTables
{
    private static readonly Table<Controller> s_controller = new Table<Controller>()
        .Flag("enabled", c => c.Enabled, (c, v) => c.Enabled = v);

    private static readonly Table<BodyController> s_bodies = new Table<BodyController>(s_controller)
        .Without(nameof(BodyController.Filter), "a handler");

    /// <summary>All kinds of the library.</summary>
    public static IReadOnlyList<ControllerKindOfFile> Kinds { get; } =
    [
        new ControllerKindOfFile(
            "Explosion", typeof(ExplosionController), _ => new ExplosionController(), new Table<ExplosionController>(s_bodies)),
        new ControllerKindOfFile("FluidDrag", typeof(FluidDragController), _ =>
            new FluidDragController(), new Table<FluidDragController>(s_controller)
            .Number("density", c => c.Density, (c, v) => c.Density = v)
            .Number("linearDragCoefficient", c => c.LinearDragCoefficient, (c, v) => c.LinearDragCoefficient = v)
            .Number("rotationalDragCoefficient", c => c.RotationalDragCoefficient, (c, v) => c.RotationalDragCoefficient = v)
            .Without(nameof(FluidDragController.Entry), "a handler")),
        new ControllerKindOfFile("Gravity", typeof(GravityController), _ =>
            new GravityController(default, 0, 1), new Table<GravityController>(s_bodies)
            .Vector("center", c => c.Center, (c, v) => c.Center = v)
            .Number("strength", c => c.Strength, (c, v) => c.Strength = v)
            .Number("minRadius", c => c.MinRadius, (c, v) => c.MinRadius = v)
            .Number("maxRadius", c => c.MaxRadius, (c, v) => c.MaxRadius = v)),
        new ControllerKindOfFile("Inactivity", typeof(InactivityController), s =>
            new InactivityController(s), new Table<InactivityController>(s_controller)
            .Number("activationDistance", c => c.ActivationDistance, (c, v) => c.ActivationDistance = v)
            .Number("maxIdleTime", c => c.MaxIdleTime, (c, v) => c.MaxIdleTime = v)),
        new ControllerKindOfFile("VelocityLimit", typeof(VelocityLimitController), _ =>
            new VelocityLimitController(0, 0), new Table<VelocityLimitController>(s_bodies)
            .Number("maxLinearVelocity", c => c.MaxLinearVelocity, (c, v) => c.MaxLinearVelocity = v)
            .Number("maxAngularVelocity", c => c.MaxAngularVelocity, (c, v) => c.MaxAngularVelocity = v)),
        new ControllerKindOfFile("Wave", typeof(WaveController), _ => new WaveController(), new Table<WaveController>(s_controller)
            .Vector("position", c => c.Position, (c, v) => c.Position = v)
            .Number("width", c => c.Width, (c, v) => c.Width = v)
            .Number("height", c => c.Height, (c, v) => c.Height = v)
            .Whole("nodeCount", c => c.NodeCount, (c, v) => c.NodeCount = v)
            .Number("dampingCoefficient", c => c.DampingCoefficient, (c, v) => c.DampingCoefficient = v)
            .Number("frequency", c => c.Frequency, (c, v) => c.Frequency = v)
            .Number("waveGeneratorMin", c => c.WaveGeneratorMin, (c, v) => c.WaveGeneratorMin = v)
            .Number("waveGeneratorMax", c => c.WaveGeneratorMax, (c, v) => c.WaveGeneratorMax = v)
            .Number("waveGeneratorStep", c => c.WaveGeneratorStep, (c, v) => c.WaveGeneratorStep = v)
            .Vector("vectorPoint", c => c.VectorPoint, (c, v) => c.VectorPoint = v)
            .Vector("vectorNearWaveEdge", c => c.VectorNearWaveEdge, (c, v) => c.VectorNearWaveEdge = v)
            .Vector("vectorFarWaveEdge", c => c.VectorFarWaveEdge, (c, v) => c.VectorFarWaveEdge = v)),
        new ControllerKindOfFile("Wind", typeof(WindController), _ => new WindController(default, 0), new Table<WindController>(s_bodies)
            .Vector("velocity", c => c.Velocity, (c, v) => c.Velocity = v)
            .Number("coefficient", c => c.Coefficient, (c, v) => c.Coefficient = v)),
    ];
}

/// <summary>A kind of controller: its name in files, its members, and how one is made.</summary>
internal sealed class ControllerKindOfFile
{
    public ControllerKindOfFile(string name, Type type, Func<PhysicsSimulator, Controller> make, Table table)
    {
        Name = name;
        Type = type;
        Make = make;
        Table = table;
    }

    public string Name { get; }

    public Type Type { get; }

    public Func<PhysicsSimulator, Controller> Make { get; }

    public Table Table { get; }
}
