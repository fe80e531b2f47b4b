using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Serialization.Tables;

/// <summary>The members of joints, and how each kind is made. The names of the kinds stand in files.</summary>
internal static class JointTables
{
    private static readonly Table<Joint> s_joint = new Table<Joint>()
        .Flag("enabled", j => j.Enabled, (j, v) => j.Enabled = v)
        .Number("breakpoint", j => j.Breakpoint, (j, v) => j.Breakpoint = v)
        .Number("breakForce", j => j.BreakForce, (j, v) => j.BreakForce = v)
        .Number("softness", j => j.Softness, (j, v) => j.Softness = v)
        .Number("biasFactor", j => j.BiasFactor, (j, v) => j.BiasFactor = v)
        .Flag("collideConnected", j => j.CollideConnected, (j, v) => j.CollideConnected = v)
        .Without(nameof(Joint.JointError), "measured in each update");

    private static readonly Table<AnchoredJoint> s_anchored = new Table<AnchoredJoint>(s_joint)
        .Vector("anchor1", j => j.Anchor1, (j, v) => j.Anchor1 = v)
        .Vector("anchor2", j => j.Anchor2, (j, v) => j.Anchor2 = v);

    private static readonly Table<DrivenPairJoint> s_drivenPair = new Table<DrivenPairJoint>(s_joint)
        .Flag("areLimitsEnabled", j => j.AreLimitsEnabled, (j, v) => j.AreLimitsEnabled = v)
        .Number("lowerLimit", j => j.LowerLimit, (j, v) => j.LowerLimit = v)
        .Number("upperLimit", j => j.UpperLimit, (j, v) => j.UpperLimit = v)
        .Flag("isMotorEnabled", j => j.IsMotorEnabled, (j, v) => j.IsMotorEnabled = v)
        .Number("motorSpeed", j => j.MotorSpeed, (j, v) => j.MotorSpeed = v);

    private static readonly Table<DrivenWorldJoint> s_drivenWorld = new Table<DrivenWorldJoint>(s_joint)
        .Flag("areLimitsEnabled", j => j.AreLimitsEnabled, (j, v) => j.AreLimitsEnabled = v)
        .Number("lowerLimit", j => j.LowerLimit, (j, v) => j.LowerLimit = v)
        .Number("upperLimit", j => j.UpperLimit, (j, v) => j.UpperLimit = v)
        .Flag("isMotorEnabled", j => j.IsMotorEnabled, (j, v) => j.IsMotorEnabled = v)
        .Number("motorSpeed", j => j.MotorSpeed, (j, v) => j.MotorSpeed = v);

    /// <summary>All kinds of the library.</summary>
    public static IReadOnlyList<JointKindOfFile> Kinds { get; } =
    [
        Pair("Angle", typeof(AngleJoint), (a, b) => new AngleJoint(a, b), new Table<AngleJoint>(s_joint)
            .Number("targetAngle", j => j.TargetAngle, (j, v) => j.TargetAngle = v)
            .Number("maxImpulse", j => j.MaxImpulse, (j, v) => j.MaxImpulse = v)),
        Pair("AngleLimit", typeof(AngleLimitJoint), (a, b) => new AngleLimitJoint(a, b, 0, 0), new Table<AngleLimitJoint>(s_joint)
            .Number("lowerLimit", j => j.LowerLimit, (j, v) => j.LowerLimit = v)
            .Number("upperLimit", j => j.UpperLimit, (j, v) => j.UpperLimit = v)
            .Number("slop", j => j.Slop, (j, v) => j.Slop = v)),
        Pair("Distance", typeof(DistanceJoint), (a, b) => new DistanceJoint(a, default, b, default), new Table<DistanceJoint>(s_anchored)
            .Number("targetDistance", j => j.TargetDistance, (j, v) => j.TargetDistance = v)
            .Number("frequency", j => j.Frequency, (j, v) => j.Frequency = v)
            .Number("dampingRatio", j => j.DampingRatio, (j, v) => j.DampingRatio = v)
            .Flag("areLimitsEnabled", j => j.AreLimitsEnabled, (j, v) => j.AreLimitsEnabled = v)
            .Number("lowerLimit", j => j.LowerLimit, (j, v) => j.LowerLimit = v)
            .Number("upperLimit", j => j.UpperLimit, (j, v) => j.UpperLimit = v)),
        World("FixedAngle", typeof(FixedAngleJoint), b => new FixedAngleJoint(b), new Table<FixedAngleJoint>(s_joint)
            .Number("targetAngle", j => j.TargetAngle, (j, v) => j.TargetAngle = v)
            .Number("maxImpulse", j => j.MaxImpulse, (j, v) => j.MaxImpulse = v)),
        World("FixedAngleLimit", typeof(FixedAngleLimitJoint), b =>
            new FixedAngleLimitJoint(b, 0, 0), new Table<FixedAngleLimitJoint>(s_joint)
            .Number("lowerLimit", j => j.LowerLimit, (j, v) => j.LowerLimit = v)
            .Number("upperLimit", j => j.UpperLimit, (j, v) => j.UpperLimit = v)
            .Number("slop", j => j.Slop, (j, v) => j.Slop = v)),
        World("FixedPrismatic", typeof(FixedPrismaticJoint), b =>
            new FixedPrismaticJoint(b, default, Vector2.UnitX), new Table<FixedPrismaticJoint>(s_drivenWorld)
            .Number("maxMotorForce", j => j.MaxMotorForce, (j, v) => j.MaxMotorForce = v)),
        World("FixedRevolute", typeof(FixedRevoluteJoint), b =>
            new FixedRevoluteJoint(b, default), new Table<FixedRevoluteJoint>(s_drivenWorld)
            .Number("maxImpulse", j => j.MaxImpulse, (j, v) => j.MaxImpulse = v)
            .Number("maxMotorTorque", j => j.MaxMotorTorque, (j, v) => j.MaxMotorTorque = v)),
        Pair("Gear", typeof(GearJoint), (a, b) => new GearJoint(a, b), new Table<GearJoint>(s_joint)
            .Number("ratio", j => j.Ratio, (j, v) => j.Ratio = v)
            .Number("maxImpulse", j => j.MaxImpulse, (j, v) => j.MaxImpulse = v)),
        Pair("Motor", typeof(MotorJoint), (a, b) => new MotorJoint(a, b), new Table<MotorJoint>(s_joint)
            .Vector("offset", j => j.Offset, (j, v) => j.Offset = v)
            .Number("targetAngle", j => j.TargetAngle, (j, v) => j.TargetAngle = v)
            .Number("maxForce", j => j.MaxForce, (j, v) => j.MaxForce = v)
            .Number("maxTorque", j => j.MaxTorque, (j, v) => j.MaxTorque = v)),
        Pair("Pin", typeof(PinJoint), (a, b) => new PinJoint(a, default, b, default), new Table<PinJoint>(s_anchored)
            .Number("targetDistance", j => j.TargetDistance, (j, v) => j.TargetDistance = v)),
        Pair("Prismatic", typeof(PrismaticJoint), (a, b) =>
            new PrismaticJoint(a, b, default, Vector2.UnitX), new Table<PrismaticJoint>(s_drivenPair)
            .Number("maxMotorForce", j => j.MaxMotorForce, (j, v) => j.MaxMotorForce = v)),
        Pair("Pulley", typeof(PulleyJoint), (a, b) =>
            new PulleyJoint(a, default, default, b, default, default), new Table<PulleyJoint>(s_anchored)
            .Number("ratio", j => j.Ratio, (j, v) => j.Ratio = v)
            .Number("totalLength", j => j.TotalLength, (j, v) => j.TotalLength = v)),
        Pair("Revolute", typeof(RevoluteJoint), (a, b) => new RevoluteJoint(a, b, default), new Table<RevoluteJoint>(s_drivenPair)
            .Number("maxMotorTorque", j => j.MaxMotorTorque, (j, v) => j.MaxMotorTorque = v)),
        Pair("Rope", typeof(RopeJoint), (a, b) => new RopeJoint(a, default, b, default, 0), new Table<RopeJoint>(s_anchored)
            .Number("maxLength", j => j.MaxLength, (j, v) => j.MaxLength = v)),
        Pair("Slider", typeof(SliderJoint), (a, b) => new SliderJoint(a, default, b, default, 0, 0), new Table<SliderJoint>(s_anchored)
            .Number("min", j => j.Min, (j, v) => j.Min = v)
            .Number("max", j => j.Max, (j, v) => j.Max = v)
            .Number("slop", j => j.Slop, (j, v) => j.Slop = v)
            .Without(nameof(SliderJoint.TargetDistance), "the middle of min and max")),
        World("Target", typeof(TargetJoint), b => new TargetJoint(b, default), new Table<TargetJoint>(s_joint)
            .Vector("target", j => j.Target, (j, v) => j.Target = v)
            .Number("maxForce", j => j.MaxForce, (j, v) => j.MaxForce = v)
            .Number("frequency", j => j.Frequency, (j, v) => j.Frequency = v)
            .Number("dampingRatio", j => j.DampingRatio, (j, v) => j.DampingRatio = v)),
        Pair("Weld", typeof(WeldJoint), (a, b) => new WeldJoint(a, b, default), new Table<WeldJoint>(s_joint)
            .Number("frequency", j => j.Frequency, (j, v) => j.Frequency = v)
            .Number("dampingRatio", j => j.DampingRatio, (j, v) => j.DampingRatio = v)),
        Pair("Wheel", typeof(WheelJoint), (a, b) => new WheelJoint(a, b, default, Vector2.UnitX), new Table<WheelJoint>(s_drivenPair)
            .Number("frequency", j => j.Frequency, (j, v) => j.Frequency = v)
            .Number("dampingRatio", j => j.DampingRatio, (j, v) => j.DampingRatio = v)
            .Number("maxMotorTorque", j => j.MaxMotorTorque, (j, v) => j.MaxMotorTorque = v)),
    ];

    private static JointKindOfFile Pair(string name, Type type, Func<Body, Body, Joint> make, Table table) =>
        new JointKindOfFile(name, type, table, make, null);

    private static JointKindOfFile World(string name, Type type, Func<Body, Joint> make, Table table) =>
        new JointKindOfFile(name, type, table, null, make);
}
