using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Factories;

/// <summary>
/// Makes springs. Each method exists with and without a simulator as its first argument; one that is given adds the new spring to
/// it. A factory sets what its arguments name; everything else of a spring is a property.
/// </summary>
/// <example>
/// <code>
/// LinearSpring rubber = SpringFactory.Instance.CreateLinearSpring(
///     simulator, body, Vector2.Zero, second, Vector2.Zero, springConstant: 50, dampingConstant: 2);
/// </code>
/// </example>
public class SpringFactory
{
    private SpringFactory()
    {
    }

    /// <summary>The shared instance.</summary>
    public static SpringFactory Instance { get; } = new SpringFactory();

    /// <summary>Makes a spring between two bodies whose rest length is the present distance of the attach points, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="attachPoint1">Point of <paramref name="body1"/>, in its coordinates; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="attachPoint2">Point of <paramref name="body2"/>, in its coordinates; finite.</param>
    /// <param name="springConstant">Force per length; finite and at least 0.</param>
    /// <param name="dampingConstant">Force per speed; finite and at least 0.</param>
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
        float dampingConstant) =>
        Added(physicsSimulator, CreateLinearSpring(body1, attachPoint1, body2, attachPoint2, springConstant, dampingConstant));

    /// <summary>Makes a spring between two bodies whose rest length is the present distance of the attach points.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="attachPoint1">Point of <paramref name="body1"/>, in its coordinates; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="attachPoint2">Point of <paramref name="body2"/>, in its coordinates; finite.</param>
    /// <param name="springConstant">Force per length; finite and at least 0.</param>
    /// <param name="dampingConstant">Force per speed; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public LinearSpring CreateLinearSpring(
        Body body1, Vector2 attachPoint1, Body body2, Vector2 attachPoint2, float springConstant, float dampingConstant) =>
        new LinearSpring(body1, attachPoint1, body2, attachPoint2, springConstant, dampingConstant);

    /// <summary>
    /// Makes a spring between a body and a point of the world whose rest length is the present distance of the attach points, and adds it.
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body.</param>
    /// <param name="bodyAttachPoint">Point of the body, in its coordinates; finite.</param>
    /// <param name="worldAttachPoint">Point of the world; finite.</param>
    /// <param name="springConstant">Force per length; finite and at least 0.</param>
    /// <param name="dampingConstant">Force per speed; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedLinearSpring CreateFixedLinearSpring(
        PhysicsSimulator physicsSimulator,
        Body body,
        Vector2 bodyAttachPoint,
        Vector2 worldAttachPoint,
        float springConstant,
        float dampingConstant) =>
        Added(physicsSimulator, CreateFixedLinearSpring(body, bodyAttachPoint, worldAttachPoint, springConstant, dampingConstant));

    /// <summary>
    /// Makes a spring between a body and a point of the world whose rest length is the present distance of the attach points.
    /// </summary>
    /// <param name="body">The body.</param>
    /// <param name="bodyAttachPoint">Point of the body, in its coordinates; finite.</param>
    /// <param name="worldAttachPoint">Point of the world; finite.</param>
    /// <param name="springConstant">Force per length; finite and at least 0.</param>
    /// <param name="dampingConstant">Force per speed; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedLinearSpring CreateFixedLinearSpring(
        Body body, Vector2 bodyAttachPoint, Vector2 worldAttachPoint, float springConstant, float dampingConstant) =>
        new FixedLinearSpring(body, bodyAttachPoint, worldAttachPoint, springConstant, dampingConstant);

    /// <summary>
    /// Makes a torsion spring between two bodies whose target angle is the present difference of the rotations, and adds it.
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="springConstant">Torque per radian; finite and at least 0.</param>
    /// <param name="dampingConstant">Torque per angular velocity; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public AngleSpring CreateAngleSpring(
        PhysicsSimulator physicsSimulator, Body body1, Body body2, float springConstant, float dampingConstant) =>
        Added(physicsSimulator, CreateAngleSpring(body1, body2, springConstant, dampingConstant));

    /// <summary>Makes a torsion spring between two bodies whose target angle is the present difference of the rotations.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="springConstant">Torque per radian; finite and at least 0.</param>
    /// <param name="dampingConstant">Torque per angular velocity; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public AngleSpring CreateAngleSpring(Body body1, Body body2, float springConstant, float dampingConstant) =>
        new AngleSpring(body1, body2, springConstant, dampingConstant);

    /// <summary>Makes a torsion spring between a body and the world whose target angle is the present rotation, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body.</param>
    /// <param name="springConstant">Torque per radian; finite and at least 0.</param>
    /// <param name="dampingConstant">Torque per angular velocity; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedAngleSpring CreateFixedAngleSpring(
        PhysicsSimulator physicsSimulator, Body body, float springConstant, float dampingConstant) =>
        Added(physicsSimulator, CreateFixedAngleSpring(body, springConstant, dampingConstant));

    /// <summary>Makes a torsion spring between a body and the world whose target angle is the present rotation.</summary>
    /// <param name="body">The body.</param>
    /// <param name="springConstant">Torque per radian; finite and at least 0.</param>
    /// <param name="dampingConstant">Torque per angular velocity; finite and at least 0.</param>
    /// <returns>The spring.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedAngleSpring CreateFixedAngleSpring(Body body, float springConstant, float dampingConstant) =>
        new FixedAngleSpring(body, springConstant, dampingConstant);

    private static T Added<T>(PhysicsSimulator physicsSimulator, T spring)
        where T : Spring
    {
        Require.NotNull(physicsSimulator, nameof(physicsSimulator)).Add(spring);
        return spring;
    }
}
