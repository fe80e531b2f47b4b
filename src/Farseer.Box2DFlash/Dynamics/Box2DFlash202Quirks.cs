using System;

namespace Box2D.Dynamics;

/// <summary>
/// Behaviour of version 2.0.2 that is plainly wrong or in the way, each to be had again by a flag of
/// <see cref="b2World.Quirks"/>. By default the right behaviour holds.
/// </summary>
/// <example>
/// <code>
/// world.Quirks = Box2DFlash202Quirks.SpeedLimits | Box2DFlash202Quirks.MouseJointStiffness;
/// </code>
/// </example>
[Flags]
public enum Box2DFlash202Quirks
{
    /// <summary>None: everything behaves as it should.</summary>
    None = 0,

    /// <summary>
    /// <see cref="b2Body.GetLinearVelocityFromLocalPoint"/>, and with it the velocity of contact points, is
    /// (v.x + ω·ry, v.x − ω·rx).
    /// </summary>
    LocalPointVelocity = 1,

    /// <summary>The reaction force of a prismatic joint has both of its parts squared.</summary>
    PrismaticForceSquared = 2,

    /// <summary>The reaction force of a pulley has the opposite sign, and is that of the first side's rope, limits left out.</summary>
    PulleyForceSign = 4,

    /// <summary>The reaction torque of a revolute joint is that of its limit only, without its motor's.</summary>
    RevoluteTorqueOfLimitOnly = 8,

    /// <summary>
    /// Calls that change the world from within a listener do nothing, or return null, instead of throwing;
    /// <see cref="b2Body.SetXForm"/> returns true.
    /// </summary>
    LockedCallsDoNothing = 16,

    /// <summary>
    /// Setting a velocity, gravity, or a motor or limit of a joint, and making a joint, leave sleeping bodies asleep.
    /// </summary>
    SettersWakeNobody = 32,

    /// <summary>A body made static keeps its velocity, and moves on with it when it has mass again.</summary>
    StaticKeepsVelocity = 64,

    /// <summary>Bodies are cut to 200 m/s and 250 rad/s.</summary>
    SpeedLimits = 128,

    /// <summary>The box around a polygon is that around its smallest turned box, so it may be too large.</summary>
    BoxOfTurnedBox = 256,

    /// <summary>Each step takes 2 % of the angular velocity of a body that a mouse joint drags.</summary>
    MouseJointSlowsTurn = 512,

    /// <summary>
    /// A mouse joint is as stiff as its frequency says divided by <see cref="Joints.b2MouseJointDef.timeStep"/>: 60 times at 1/60 s.
    /// </summary>
    MouseJointStiffness = 1024,
}
