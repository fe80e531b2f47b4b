using System;
using Farseer.Engine.Joints;

namespace Farseer.Benchmarks.Trees;

/// <summary>
/// The kinds of joints as users meet them, each for a crowd of short chains: in the air, hung on the world, and on a floor.
/// </summary>
internal static class TreeKinds
{
    private const JointFlags Plain = JointFlags.Enabled;

    public static readonly Link[] All =
    [
        new("hinge", JointKind.Revolute, Plain),
        new("hinge, limits", JointKind.Revolute, Plain | JointFlags.Limit),
        new("hinge, motor", JointKind.Revolute, Plain | JointFlags.Motor),
        new("hinge, limits and motor", JointKind.Revolute, Plain | JointFlags.Limit | JointFlags.Motor),
        new("hinge, soft", JointKind.Revolute, Plain, Softness: 0.1),
        new("hinge and angle limit", JointKind.Revolute, Plain, With: JointKind.AngleLimit),
        new("hinge and angle joint", JointKind.Revolute, Plain, With: JointKind.Angle),
        new("hinge, angle limit to the world", JointKind.Revolute, Plain, With: JointKind.AngleLimit, WithWorld: true),
        new("hinge, rope to the world", JointKind.Revolute, Plain, With: JointKind.Rope, WithWorld: true),
        new("rod (pin, distance)", JointKind.Distance, Plain),
        new("rod, sprung", JointKind.Distance, Plain | JointFlags.Spring),
        new("pin, soft", JointKind.Pin, Plain, Softness: 0.1),
        new("weld", JointKind.Weld, Plain),
        new("weld, sprung", JointKind.Weld, Plain | JointFlags.Spring),
        new("slide", JointKind.Prismatic, Plain),
        new("slide, limits", JointKind.Prismatic, Plain | JointFlags.Limit),
        new("slide, motor", JointKind.Prismatic, Plain | JointFlags.Motor),
        new("wheel, spring and motor", JointKind.Wheel, Plain | JointFlags.Spring | JointFlags.Motor),
        new("wheel, limits", JointKind.Wheel, Plain | JointFlags.Spring | JointFlags.Limit),
        new("angle", JointKind.Angle, Plain),
        new("angle limit", JointKind.AngleLimit, Plain),
        new("gear", JointKind.Gear, Plain),
        new("slider", JointKind.Slider, Plain),
        new("rope", JointKind.Rope, Plain),
        new("pulley", JointKind.Pulley, Plain),
        new("target (mouse)", JointKind.Target, Plain),
        new("motor joint", JointKind.Motor, Plain),
        new("transmission", JointKind.Transmission, Plain),
    ];

    /// <summary>What joins two links of a chain: one joint, or two, of which the second may hold each link to the world.</summary>
    internal sealed record Link(
        string Name,
        JointKind Kind,
        JointFlags Flags,
        double Softness = 0,
        JointKind? With = null,
        bool WithWorld = false);
}
