using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Factories;

/// <summary>The springs of <see cref="SpringFactory"/> under the name that the original also gave them.</summary>
/// <example>
/// <code>
/// LinearSpring spring = ControllerFactory.Instance.CreateLinearSpring(
///     simulator, body, Vector2.Zero, second, Vector2.Zero, springConstant: 50, dampningConstant: 2);
/// </code>
/// </example>
public class ControllerFactory
{
    private ControllerFactory()
    {
    }

    /// <summary>The shared instance.</summary>
    public static ControllerFactory Instance { get; } = new ControllerFactory();

    /// <summary>Makes a spring between two bodies whose rest length is the present distance of the attach points, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="attachPoint1">Point of <paramref name="body1"/>, in its coordinates; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="attachPoint2">Point of <paramref name="body2"/>, in its coordinates; finite.</param>
    /// <param name="springConstant">Force per length; finite and at least 0.</param>
    /// <param name="dampningConstant">Force per speed; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public LinearSpring CreateLinearSpring(
        PhysicsSimulator physicsSimulator,
        Body body1,
        Vector2 attachPoint1,
        Body body2,
        Vector2 attachPoint2,
        float springConstant,
        float dampningConstant) =>
        SpringFactory.Instance.CreateLinearSpring(
            physicsSimulator,
            body1,
            attachPoint1,
            body2,
            attachPoint2,
            springConstant,
            Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>Makes a spring between two bodies whose rest length is the present distance of the attach points.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="attachPoint1">Point of <paramref name="body1"/>, in its coordinates; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="attachPoint2">Point of <paramref name="body2"/>, in its coordinates; finite.</param>
    /// <param name="springConstant">Force per length; finite and at least 0.</param>
    /// <param name="dampningConstant">Force per speed; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public LinearSpring CreateLinearSpring(
        Body body1, Vector2 attachPoint1, Body body2, Vector2 attachPoint2, float springConstant, float dampningConstant) =>
        SpringFactory.Instance.CreateLinearSpring(
            body1, attachPoint1, body2, attachPoint2, springConstant, Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>
    /// Makes a spring between a body and a point of the world whose rest length is the present distance of the attach points, and adds it.
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body.</param>
    /// <param name="bodyAttachPoint">Point of the body, in its coordinates; finite.</param>
    /// <param name="worldAttachPoint">Point of the world; finite.</param>
    /// <param name="springConstant">Force per length; finite and at least 0.</param>
    /// <param name="dampningConstant">Force per speed; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedLinearSpring CreateFixedLinearSpring(
        PhysicsSimulator physicsSimulator,
        Body body,
        Vector2 bodyAttachPoint,
        Vector2 worldAttachPoint,
        float springConstant,
        float dampningConstant) =>
        SpringFactory.Instance.CreateFixedLinearSpring(
            physicsSimulator,
            body,
            bodyAttachPoint,
            worldAttachPoint,
            springConstant,
            Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>
    /// Makes a spring between a body and a point of the world whose rest length is the present distance of the attach points.
    /// </summary>
    /// <param name="body">The body.</param>
    /// <param name="bodyAttachPoint">Point of the body, in its coordinates; finite.</param>
    /// <param name="worldAttachPoint">Point of the world; finite.</param>
    /// <param name="springConstant">Force per length; finite and at least 0.</param>
    /// <param name="dampningConstant">Force per speed; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedLinearSpring CreateFixedLinearSpring(
        Body body, Vector2 bodyAttachPoint, Vector2 worldAttachPoint, float springConstant, float dampningConstant) =>
        SpringFactory.Instance.CreateFixedLinearSpring(
            body, bodyAttachPoint, worldAttachPoint, springConstant, Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>
    /// Makes a torsion spring between two bodies whose target angle is the present difference of the rotations, and adds it.
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="springConstant">Torque per radian; finite and at least 0.</param>
    /// <param name="dampningConstant">Torque per angular velocity; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public AngleSpring CreateAngleSpring(
        PhysicsSimulator physicsSimulator, Body body1, Body body2, float springConstant, float dampningConstant) =>
        SpringFactory.Instance.CreateAngleSpring(
            physicsSimulator, body1, body2, springConstant, Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>Makes a torsion spring between two bodies whose target angle is the present difference of the rotations.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="springConstant">Torque per radian; finite and at least 0.</param>
    /// <param name="dampningConstant">Torque per angular velocity; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public AngleSpring CreateAngleSpring(Body body1, Body body2, float springConstant, float dampningConstant) =>
        SpringFactory.Instance.CreateAngleSpring(
            body1, body2, springConstant, Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>Makes a torsion spring between a body and the world whose target angle is the present rotation, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body.</param>
    /// <param name="springConstant">Torque per radian; finite and at least 0.</param>
    /// <param name="dampningConstant">Torque per angular velocity; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedAngleSpring CreateFixedAngleSpring(
        PhysicsSimulator physicsSimulator, Body body, float springConstant, float dampningConstant) =>
        SpringFactory.Instance.CreateFixedAngleSpring(
            physicsSimulator, body, springConstant, Require.NotNegative(dampningConstant, nameof(dampningConstant)));

    /// <summary>Makes a torsion spring between a body and the world whose target angle is the present rotation.</summary>
    /// <param name="body">The body.</param>
    /// <param name="springConstant">Torque per radian; finite and at least 0.</param>
    /// <param name="dampningConstant">Torque per angular velocity; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedAngleSpring CreateFixedAngleSpring(Body body, float springConstant, float dampningConstant) =>
        SpringFactory.Instance.CreateFixedAngleSpring(
            body, springConstant, Require.NotNegative(dampningConstant, nameof(dampningConstant)));
}
