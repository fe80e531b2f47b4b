using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Serialization.Tables;

/// <summary>The members of springs, and how each kind is made. The names of the kinds stand in files.</summary>
internal static class SpringTables
{
    private static readonly Table<Spring> s_spring = new Table<Spring>()
        .Flag("enabled", s => s.Enabled, (s, v) => s.Enabled = v)
        .Number("springConstant", s => s.SpringConstant, (s, v) => s.SpringConstant = v)
        .Number("dampingConstant", s => s.DampingConstant, (s, v) => s.DampingConstant = v)
        .Number("breakpoint", s => s.Breakpoint, (s, v) => s.Breakpoint = v)
        .Without(nameof(Spring.DampningConstant), "another name of dampingConstant");

    /// <summary>All kinds of the library.</summary>
    public static IReadOnlyList<SpringKindOfFile> Kinds { get; } =
    [
        new SpringKindOfFile("Angle", typeof(AngleSpring), () => new AngleSpring(), Bodies1And2, new Table<AngleSpring>(s_spring)
            .Vector("anchor1", s => s.Anchor1, (s, v) => s.Anchor1 = v)
            .Vector("anchor2", s => s.Anchor2, (s, v) => s.Anchor2 = v)
            .Number("maxTorque", s => s.MaxTorque, (s, v) => s.MaxTorque = v)
            .Number("torqueMultiplier", s => s.TorqueMultiplier, (s, v) => s.TorqueMultiplier = v)),
        new SpringKindOfFile("FixedAngle", typeof(FixedAngleSpring), () =>
            new FixedAngleSpring(), Body, new Table<FixedAngleSpring>(s_spring)
            .Number("targetAngle", s => s.TargetAngle, (s, v) => s.TargetAngle = v)
            .Number("maxTorque", s => s.MaxTorque, (s, v) => s.MaxTorque = v)
            .Number("torqueMultiplier", s => s.TorqueMultiplier, (s, v) => s.TorqueMultiplier = v)),
        new SpringKindOfFile("FixedLinear", typeof(FixedLinearSpring), () =>
            new FixedLinearSpring(), Body, new Table<FixedLinearSpring>(s_spring)
            .Vector("bodyAttachPoint", s => s.BodyAttachPoint, (s, v) => s.BodyAttachPoint = v)
            .Vector("worldAttachPoint", s => s.WorldAttachPoint, (s, v) => s.WorldAttachPoint = v)
            .Number("restLength", s => s.RestLength, (s, v) => s.RestLength = v)
            .Without(nameof(FixedLinearSpring.Position), "another name of worldAttachPoint")),
        new SpringKindOfFile("Linear", typeof(LinearSpring), () => new LinearSpring(), Bodies1And2, new Table<LinearSpring>(s_spring)
            .Vector("attachPoint1", s => s.AttachPoint1, (s, v) => s.AttachPoint1 = v)
            .Vector("attachPoint2", s => s.AttachPoint2, (s, v) => s.AttachPoint2 = v)
            .Number("restLength", s => s.RestLength, (s, v) => s.RestLength = v)
            .Without(nameof(LinearSpring.Anchor1), "another name of attachPoint1")
            .Without(nameof(LinearSpring.Anchor2), "another name of attachPoint2")),
    ];

    private static void Bodies1And2(Spring spring, Body? first, Body? second)
    {
        if (spring is AngleSpring angle)
        {
            angle.Body1 = first ?? angle.Body1;
            angle.Body2 = second ?? angle.Body2;
        }
        else if (spring is LinearSpring linear)
        {
            linear.Body1 = first ?? linear.Body1;
            linear.Body2 = second ?? linear.Body2;
        }
    }

    private static void Body(Spring spring, Body? first, Body? second)
    {
        if (spring is FixedAngleSpring angle)
        {
            angle.Body = second ?? angle.Body;
        }
        else if (spring is FixedLinearSpring linear)
        {
            linear.Body = second ?? linear.Body;
        }
    }
}

/// <summary>A kind of spring: its name in files, its members, and how one is made.</summary>
internal sealed class SpringKindOfFile
{
    public SpringKindOfFile(string name, Type type, Func<Spring> make, Action<Spring, Body?, Body?> tie, Table table)
    {
        Name = name;
        Type = type;
        Make = make;
        Tie = tie;
        Table = table;
    }

    public string Name { get; }

    public Type Type { get; }

    public Func<Spring> Make { get; }

    /// <summary>Gives it the bodies of the file: the first, if it has two, and the second or only one.</summary>
    public Action<Spring, Body?, Body?> Tie { get; }

    public Table Table { get; }
}
