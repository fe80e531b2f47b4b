using System;
using System.ComponentModel;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Factories;

/// <summary>
/// The spring factory under the names of arguments that the manual prints, <c>anchor1</c>, <c>anchor2</c> and <c>dampningConstant</c>. A
/// call that names none of them means the methods of <see cref="SpringFactory"/>.
/// </summary>
/// <example>
/// <code>
/// SpringFactory.Instance.CreateAngleSpring(body1: first, body2: second, springConstant: 50, dampningConstant: 2);
/// </code>
/// </example>
[EditorBrowsable(EditorBrowsableState.Never)]
public static class SpringFactoryManual
{
    private const string TwoAnchors = "The arguments are called attachPoint1, attachPoint2 and dampingConstant.";
    private const string FixedAnchor = "The arguments are called bodyAttachPoint, worldAttachPoint and dampingConstant.";
    private const string Damping = "The argument is called dampingConstant.";

    /// <summary>
    /// <see cref="SpringFactory.CreateLinearSpring(PhysicsSimulator, Body, Vector2, Body, Vector2, float, float)"/>
    /// by the manual's names.
    /// </summary>
    [Obsolete(TwoAnchors)]
    public static LinearSpring CreateLinearSpring(
        this SpringFactory factory,
        PhysicsSimulator physicsSimulator,
        Body body1,
        Vector2 anchor1,
        Body body2,
        Vector2 anchor2,
        float springConstant,
        float dampningConstant) =>
        Require.NotNull(factory, nameof(factory)).CreateLinearSpring(
            physicsSimulator,
            body1,
            Require.Finite(anchor1, nameof(anchor1)),
            body2,
            Require.Finite(anchor2, nameof(anchor2)),
            springConstant,
            Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>
    /// <see cref="SpringFactory.CreateLinearSpring(Body, Vector2, Body, Vector2, float, float)"/>
    /// by the manual's names.
    /// </summary>
    [Obsolete(TwoAnchors)]
    public static LinearSpring CreateLinearSpring(
        this SpringFactory factory,
        Body body1,
        Vector2 anchor1,
        Body body2,
        Vector2 anchor2,
        float springConstant,
        float dampningConstant) =>
        Require.NotNull(factory, nameof(factory)).CreateLinearSpring(
            body1,
            Require.Finite(anchor1, nameof(anchor1)),
            body2,
            Require.Finite(anchor2, nameof(anchor2)),
            springConstant,
            Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>
    /// <see cref="SpringFactory.CreateFixedLinearSpring(PhysicsSimulator, Body, Vector2, Vector2, float, float)"/>
    /// by the manual's names.
    /// </summary>
    [Obsolete(FixedAnchor)]
    public static FixedLinearSpring CreateFixedLinearSpring(
        this SpringFactory factory,
        PhysicsSimulator physicsSimulator,
        Body body,
        Vector2 anchor1,
        Vector2 anchor2,
        float springConstant,
        float dampningConstant) =>
        Require.NotNull(factory, nameof(factory)).CreateFixedLinearSpring(
            physicsSimulator,
            body,
            Require.Finite(anchor1, nameof(anchor1)),
            Require.Finite(anchor2, nameof(anchor2)),
            springConstant,
            Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>
    /// <see cref="SpringFactory.CreateFixedLinearSpring(Body, Vector2, Vector2, float, float)"/>
    /// by the manual's names.
    /// </summary>
    [Obsolete(FixedAnchor)]
    public static FixedLinearSpring CreateFixedLinearSpring(
        this SpringFactory factory,
        Body body,
        Vector2 anchor1,
        Vector2 anchor2,
        float springConstant,
        float dampningConstant) =>
        Require.NotNull(factory, nameof(factory)).CreateFixedLinearSpring(
            body,
            Require.Finite(anchor1, nameof(anchor1)),
            Require.Finite(anchor2, nameof(anchor2)),
            springConstant,
            Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>
    /// <see cref="SpringFactory.CreateAngleSpring(PhysicsSimulator, Body, Body, float, float)"/>
    /// by the manual's names.
    /// </summary>
    [Obsolete(Damping)]
    public static AngleSpring CreateAngleSpring(
        this SpringFactory factory,
        PhysicsSimulator physicsSimulator,
        Body body1,
        Body body2,
        float springConstant,
        float dampningConstant) =>
        Require.NotNull(factory, nameof(factory)).CreateAngleSpring(
            physicsSimulator,
            body1,
            body2,
            springConstant,
            Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>
    /// <see cref="SpringFactory.CreateAngleSpring(Body, Body, float, float)"/>
    /// by the manual's names.
    /// </summary>
    [Obsolete(Damping)]
    public static AngleSpring CreateAngleSpring(
        this SpringFactory factory,
        Body body1,
        Body body2,
        float springConstant,
        float dampningConstant) =>
        Require.NotNull(factory, nameof(factory)).CreateAngleSpring(
            body1,
            body2,
            springConstant,
            Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>
    /// <see cref="SpringFactory.CreateFixedAngleSpring(PhysicsSimulator, Body, float, float)"/>
    /// by the manual's names.
    /// </summary>
    [Obsolete(Damping)]
    public static FixedAngleSpring CreateFixedAngleSpring(
        this SpringFactory factory,
        PhysicsSimulator physicsSimulator,
        Body body,
        float springConstant,
        float dampningConstant) =>
        Require.NotNull(factory, nameof(factory)).CreateFixedAngleSpring(
            physicsSimulator,
            body,
            springConstant,
            Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>
    /// <see cref="SpringFactory.CreateFixedAngleSpring(Body, float, float)"/>
    /// by the manual's names.
    /// </summary>
    [Obsolete(Damping)]
    public static FixedAngleSpring CreateFixedAngleSpring(
        this SpringFactory factory,
        Body body,
        float springConstant,
        float dampningConstant) =>
        Require.NotNull(factory, nameof(factory)).CreateFixedAngleSpring(
            body,
            springConstant,
            Require.NotNegative(dampningConstant, nameof(dampningConstant)));
}
