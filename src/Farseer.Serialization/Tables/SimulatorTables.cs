namespace FarseerGames.FarseerPhysics.Serialization.Tables;

/// <summary>The settings of a simulator.</summary>
internal static class SimulatorTables
{
    public static Table<PhysicsSimulator> Settings { get; } = new Table<PhysicsSimulator>()
        .Choice("quirks", s => s.Quirks, (s, v) => s.Quirks = v)
        .Vector("gravity", s => s.Gravity, (s, v) => s.Gravity = v)
        .Whole("iterations", s => s.Iterations, (s, v) => s.Iterations = v)
        .Flag("adaptIterations", s => s.AdaptIterations, (s, v) => s.AdaptIterations = v)
        .Number("allowedPenetration", s => s.AllowedPenetration, (s, v) => s.AllowedPenetration = v)
        .Number("biasFactor", s => s.BiasFactor, (s, v) => s.BiasFactor = v)
        .Flag("isContinuousCollisionEnabled", s => s.IsContinuousCollisionEnabled, (s, v) => s.IsContinuousCollisionEnabled = v)
        .Choice("frictionType", s => s.FrictionType, (s, v) => s.FrictionType = v)
        .Choice("restitutionType", s => s.RestitutionType, (s, v) => s.RestitutionType = v)
        .Whole("maxContactsToDetect", s => s.MaxContactsToDetect, (s, v) => s.MaxContactsToDetect = v)
        .Whole("maxContactsToResolve", s => s.MaxContactsToResolve, (s, v) => s.MaxContactsToResolve = v)
        .Flag("enabled", s => s.Enabled, (s, v) => s.Enabled = v)
        .Flag("allowSleep", s => s.AllowSleep, (s, v) => s.AllowSleep = v)
        .Number("timeToSleep", s => s.TimeToSleep, (s, v) => s.TimeToSleep = v)
        .Number("sleepTolerance", s => s.SleepTolerance, (s, v) => s.SleepTolerance = v)
        .Flag("enableReport", s => s.EnableReport, (s, v) => s.EnableReport = v)
        .Choice("recordedEvents", s => s.RecordedEvents, (s, v) => s.RecordedEvents = v)
        .Number("hitSpeed", s => s.HitSpeed, (s, v) => s.HitSpeed = v)
        .Flag("keepsPoses", s => s.KeepsPoses, (s, v) => s.KeepsPoses = v)
        .Flag("sumImpulses", s => s.SumImpulses, (s, v) => s.SumImpulses = v)
        .Without(nameof(PhysicsSimulator.EnableDiagnostics), "how it runs, and not what it computes")
        .Without(nameof(PhysicsSimulator.WorkerCount), "how it runs, and not what it computes")
        .Without(nameof(PhysicsSimulator.StepScheduler), "how it runs, and not what it computes")
        .Without(nameof(PhysicsSimulator.MixMaterials), "a handler");

    public static Table<SimulatorDefaults> Defaults { get; } = new Table<SimulatorDefaults>()
        .Number("frictionCoefficient", d => d.FrictionCoefficient, (d, v) => d.FrictionCoefficient = v)
        .Number("restitutionCoefficient", d => d.RestitutionCoefficient, (d, v) => d.RestitutionCoefficient = v)
        .Number("linearDragCoefficient", d => d.LinearDragCoefficient, (d, v) => d.LinearDragCoefficient = v)
        .Number("rotationalDragCoefficient", d => d.RotationalDragCoefficient, (d, v) => d.RotationalDragCoefficient = v);

    public static Table<Scaling> Scaling { get; } = new Table<Scaling>()
        .Flag("enabled", s => s.Enabled, (s, v) => s.Enabled = v)
        .Number("maximumUpdateInterval", s => s.MaximumUpdateInterval, (s, v) => s.MaximumUpdateInterval = v)
        .Number("updateInterval", s => s.UpdateInterval, (s, v) => s.UpdateInterval = v);
}
