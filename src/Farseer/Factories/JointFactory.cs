using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Factories;

/// <summary>
/// Makes joints. Each method exists with and without a simulator as its first argument; one that is given adds the new joint to
/// it. Not every property of a joint is a parameter: set the others on the joint.
/// </summary>
/// <example>
/// <code>
/// RevoluteJoint hinge = JointFactory.Instance.CreateRevoluteJoint(simulator, body, second, new Vector2(1, 0));
/// </code>
/// </example>
public partial class JointFactory
{
    private JointFactory()
    {
    }

    /// <summary>The shared instance.</summary>
    public static JointFactory Instance { get; } = new JointFactory();

    /// <summary>Makes a hinge between two bodies at a point of the world, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="initialAnchorPosition">The hinge, in world coordinates; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public RevoluteJoint CreateRevoluteJoint(PhysicsSimulator physicsSimulator, Body body1, Body body2, Vector2 initialAnchorPosition) =>
        Added(physicsSimulator, CreateRevoluteJoint(body1, body2, initialAnchorPosition));

    /// <summary>Makes a hinge between two bodies at a point of the world.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="initialAnchorPosition">The hinge, in world coordinates; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public RevoluteJoint CreateRevoluteJoint(Body body1, Body body2, Vector2 initialAnchorPosition) =>
        new RevoluteJoint(body1, body2, Require.Finite(initialAnchorPosition, nameof(initialAnchorPosition)));

    /// <summary>Makes a joint that nails a body to a point of the world, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body.</param>
    /// <param name="anchor">The nail, in world coordinates; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedRevoluteJoint CreateFixedRevoluteJoint(PhysicsSimulator physicsSimulator, Body body, Vector2 anchor) =>
        Added(physicsSimulator, CreateFixedRevoluteJoint(body, anchor));

    /// <summary>Makes a joint that nails a body to a point of the world.</summary>
    /// <param name="body">The body.</param>
    /// <param name="anchor">The nail, in world coordinates; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedRevoluteJoint CreateFixedRevoluteJoint(Body body, Vector2 anchor) => new FixedRevoluteJoint(body, anchor);

    /// <summary>Makes a rod between two anchors, as long as they are apart, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public PinJoint CreatePinJoint(PhysicsSimulator physicsSimulator, Body body1, Vector2 anchor1, Body body2, Vector2 anchor2) =>
        Added(physicsSimulator, CreatePinJoint(body1, anchor1, body2, anchor2));

    /// <summary>Makes a rod between two anchors, as long as they are apart.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public PinJoint CreatePinJoint(Body body1, Vector2 anchor1, Body body2, Vector2 anchor2) =>
        new PinJoint(body1, anchor1, body2, anchor2);

    /// <summary>Makes a joint that keeps the distance of two anchors between limits, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <param name="min">Smallest distance; finite and at least 0.</param>
    /// <param name="max">Largest distance; finite, at least 0 and not below <paramref name="min"/>.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public SliderJoint CreateSliderJoint(
        PhysicsSimulator physicsSimulator, Body body1, Vector2 anchor1, Body body2, Vector2 anchor2, float min, float max) =>
        Added(physicsSimulator, CreateSliderJoint(body1, anchor1, body2, anchor2, min, max));

    /// <summary>Makes a joint that keeps the distance of two anchors between limits.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <param name="min">Smallest distance; finite and at least 0.</param>
    /// <param name="max">Largest distance; finite, at least 0 and not below <paramref name="min"/>.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public SliderJoint CreateSliderJoint(Body body1, Vector2 anchor1, Body body2, Vector2 anchor2, float min, float max) =>
        new SliderJoint(body1, anchor1, body2, anchor2, min, max);

    /// <summary>Makes a joint that turns two bodies to the same angle, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    public AngleJoint CreateAngleJoint(PhysicsSimulator physicsSimulator, Body body1, Body body2) =>
        Added(physicsSimulator, CreateAngleJoint(body1, body2));

    /// <summary>Makes a joint that turns two bodies to the same angle.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    public AngleJoint CreateAngleJoint(Body body1, Body body2) => new AngleJoint(body1, body2);

    /// <summary>Makes a joint that turns two bodies to the same angle, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="softness">See <see cref="Joint.Softness"/>; at least 0.</param>
    /// <param name="biasFactor">See <see cref="Joint.BiasFactor"/>; at least 0.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public AngleJoint CreateAngleJoint(PhysicsSimulator physicsSimulator, Body body1, Body body2, float softness, float biasFactor) =>
        Added(physicsSimulator, CreateAngleJoint(body1, body2, softness, biasFactor));

    /// <summary>Makes a joint that turns two bodies to the same angle.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="softness">See <see cref="Joint.Softness"/>; at least 0.</param>
    /// <param name="biasFactor">See <see cref="Joint.BiasFactor"/>; at least 0.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public AngleJoint CreateAngleJoint(Body body1, Body body2, float softness, float biasFactor)
    {
        Require.NotNegative(softness, nameof(softness));
        Require.NotNegative(biasFactor, nameof(biasFactor));
        return new AngleJoint(body1, body2) { Softness = softness, BiasFactor = biasFactor };
    }

    /// <summary>Makes a joint that turns a body to the angle 0, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public FixedAngleJoint CreateFixedAngleJoint(PhysicsSimulator physicsSimulator, Body body) =>
        Added(physicsSimulator, CreateFixedAngleJoint(body));

    /// <summary>Makes a joint that turns a body to the angle 0.</summary>
    /// <param name="body">The body.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    public FixedAngleJoint CreateFixedAngleJoint(Body body) => new FixedAngleJoint(body);

    /// <summary>Makes a joint that keeps the relative angle of two bodies between limits, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="min">Smallest angle, radians; finite.</param>
    /// <param name="max">Largest angle, radians; finite and not below <paramref name="min"/>.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public AngleLimitJoint CreateAngleLimitJoint(PhysicsSimulator physicsSimulator, Body body1, Body body2, float min, float max) =>
        Added(physicsSimulator, CreateAngleLimitJoint(body1, body2, min, max));

    /// <summary>Makes a joint that keeps the relative angle of two bodies between limits.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="min">Smallest angle, radians; finite.</param>
    /// <param name="max">Largest angle, radians; finite and not below <paramref name="min"/>.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public AngleLimitJoint CreateAngleLimitJoint(Body body1, Body body2, float min, float max) =>
        new AngleLimitJoint(
            body1,
            body2,
            Require.Finite(min, nameof(min)),
            Require.NotBelow(Require.Finite(max, nameof(max)), min, nameof(max), nameof(min)));

    /// <summary>Makes a joint that keeps the angle of a body between limits, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body.</param>
    /// <param name="min">Smallest angle, radians; finite.</param>
    /// <param name="max">Largest angle, radians; finite and not below <paramref name="min"/>.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedAngleLimitJoint CreateFixedAngleLimitJoint(PhysicsSimulator physicsSimulator, Body body, float min, float max) =>
        Added(physicsSimulator, CreateFixedAngleLimitJoint(body, min, max));

    /// <summary>Makes a joint that keeps the angle of a body between limits.</summary>
    /// <param name="body">The body.</param>
    /// <param name="min">Smallest angle, radians; finite.</param>
    /// <param name="max">Largest angle, radians; finite and not below <paramref name="min"/>.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedAngleLimitJoint CreateFixedAngleLimitJoint(Body body, float min, float max) =>
        new FixedAngleLimitJoint(
            body, Require.Finite(min, nameof(min)), Require.NotBelow(Require.Finite(max, nameof(max)), min, nameof(max), nameof(min)));

    /// <summary>Makes a gear between two bodies, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="ratio">Turns of the second body for each turn of the first, the other way; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public GearJoint CreateGearJoint(PhysicsSimulator physicsSimulator, Body body1, Body body2, float ratio) =>
        Added(physicsSimulator, CreateGearJoint(body1, body2, ratio));

    /// <summary>Makes a gear between two bodies.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="ratio">Turns of the second body for each turn of the first, the other way; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public GearJoint CreateGearJoint(Body body1, Body body2, float ratio) => new GearJoint(body1, body2, ratio);

    private static T Added<T>(PhysicsSimulator physicsSimulator, T joint)
        where T : Joint
    {
        Require.NotNull(physicsSimulator, nameof(physicsSimulator)).Add(joint);
        return joint;
    }
}
