using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Factories;

/// <content>Joints that the original does not have.</content>
public partial class JointFactory
{
    /// <summary>Makes a joint that keeps the distance of two points, and adds it. (An addition to the original.)</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public DistanceJoint CreateDistanceJoint(PhysicsSimulator physicsSimulator, Body body1, Vector2 anchor1, Body body2, Vector2 anchor2) =>
        Added(physicsSimulator, CreateDistanceJoint(body1, anchor1, body2, anchor2));

    /// <summary>Makes a joint that keeps the distance of two points. (An addition to the original.)</summary>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public DistanceJoint CreateDistanceJoint(Body body1, Vector2 anchor1, Body body2, Vector2 anchor2) =>
        new DistanceJoint(body1, anchor1, body2, anchor2);

    /// <summary>
    /// Makes a rope that lets two points come nearer and no farther apart than its length, and adds it. (An addition to the original.)
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <param name="maxLength">Largest distance of the anchors; finite and at least 0.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public RopeJoint CreateRopeJoint(
        PhysicsSimulator physicsSimulator, Body body1, Vector2 anchor1, Body body2, Vector2 anchor2, float maxLength) =>
        Added(physicsSimulator, CreateRopeJoint(body1, anchor1, body2, anchor2, maxLength));

    /// <summary>
    /// Makes a rope that lets two points come nearer and no farther apart than its length. (An addition to the original.)
    /// </summary>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <param name="maxLength">Largest distance of the anchors; finite and at least 0.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public RopeJoint CreateRopeJoint(Body body1, Vector2 anchor1, Body body2, Vector2 anchor2, float maxLength) =>
        new RopeJoint(body1, anchor1, body2, anchor2, maxLength);

    /// <summary>
    /// Makes a rope over two wheels that hang in the world, taut as the bodies stand, and adds it. (An addition to the original.)
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="groundAnchor1">Point over which the rope to the first body runs, in world coordinates; finite.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="groundAnchor2">Point over which the rope to the second body runs, in world coordinates; finite.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <param name="ratio">Weight of the second side, as in a block and tackle; finite and above 0.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public PulleyJoint CreatePulleyJoint(
        PhysicsSimulator physicsSimulator,
        Body body1,
        Vector2 groundAnchor1,
        Vector2 anchor1,
        Body body2,
        Vector2 groundAnchor2,
        Vector2 anchor2,
        float ratio) =>
        Added(physicsSimulator, CreatePulleyJoint(body1, groundAnchor1, anchor1, body2, groundAnchor2, anchor2, ratio));

    /// <summary>Makes a rope over two wheels that hang in the world, taut as the bodies stand. (An addition to the original.)</summary>
    /// <param name="body1">First body.</param>
    /// <param name="groundAnchor1">Point over which the rope to the first body runs, in world coordinates; finite.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="groundAnchor2">Point over which the rope to the second body runs, in world coordinates; finite.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <param name="ratio">Weight of the second side, as in a block and tackle; finite and above 0.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public PulleyJoint CreatePulleyJoint(
        Body body1, Vector2 groundAnchor1, Vector2 anchor1, Body body2, Vector2 groundAnchor2, Vector2 anchor2, float ratio) =>
        new PulleyJoint(body1, groundAnchor1, anchor1, body2, groundAnchor2, anchor2, ratio);

    /// <summary>Makes a joint that makes one of two bodies, as they stand, and adds it. (An addition to the original.)</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor">The point at which they are joined, in world coordinates; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public WeldJoint CreateWeldJoint(PhysicsSimulator physicsSimulator, Body body1, Body body2, Vector2 anchor) =>
        Added(physicsSimulator, CreateWeldJoint(body1, body2, anchor));

    /// <summary>Makes a joint that makes one of two bodies, as they stand. (An addition to the original.)</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor">The point at which they are joined, in world coordinates; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public WeldJoint CreateWeldJoint(Body body1, Body body2, Vector2 anchor) =>
        new WeldJoint(body1, body2, anchor);

    /// <summary>Makes a slide between two bodies, at 0 as they stand, and adds it. (An addition to the original.)</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor">The point at which they are joined, in world coordinates; finite.</param>
    /// <param name="axis">Direction of the slide, in world coordinates, of any length; finite and not (0, 0).</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public PrismaticJoint CreatePrismaticJoint(PhysicsSimulator physicsSimulator, Body body1, Body body2, Vector2 anchor, Vector2 axis) =>
        Added(physicsSimulator, CreatePrismaticJoint(body1, body2, anchor, axis));

    /// <summary>Makes a slide between two bodies, at 0 as they stand. (An addition to the original.)</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor">The point at which they are joined, in world coordinates; finite.</param>
    /// <param name="axis">Direction of the slide, in world coordinates, of any length; finite and not (0, 0).</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public PrismaticJoint CreatePrismaticJoint(Body body1, Body body2, Vector2 anchor, Vector2 axis) =>
        new PrismaticJoint(body1, body2, anchor, axis);

    /// <summary>Makes a sprung wheel on a car, its spring relaxed as they stand, and adds it. (An addition to the original.)</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">The car.</param>
    /// <param name="body2">The wheel.</param>
    /// <param name="anchor">The hub, in world coordinates; finite.</param>
    /// <param name="axis">Direction of the spring, in world coordinates, of any length; finite and not (0, 0).</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public WheelJoint CreateWheelJoint(PhysicsSimulator physicsSimulator, Body body1, Body body2, Vector2 anchor, Vector2 axis) =>
        Added(physicsSimulator, CreateWheelJoint(body1, body2, anchor, axis));

    /// <summary>Makes a sprung wheel on a car, its spring relaxed as they stand. (An addition to the original.)</summary>
    /// <param name="body1">The car.</param>
    /// <param name="body2">The wheel.</param>
    /// <param name="anchor">The hub, in world coordinates; finite.</param>
    /// <param name="axis">Direction of the spring, in world coordinates, of any length; finite and not (0, 0).</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public WheelJoint CreateWheelJoint(Body body1, Body body2, Vector2 anchor, Vector2 axis) =>
        new WheelJoint(body1, body2, anchor, axis);

    /// <summary>
    /// Makes a joint that drives a body to a position and an angle relative to another, and holds it as it stands until these are set, and
    /// adds it. (An addition to the original.)
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    public MotorJoint CreateMotorJoint(PhysicsSimulator physicsSimulator, Body body1, Body body2) =>
        Added(physicsSimulator, CreateMotorJoint(body1, body2));

    /// <summary>
    /// Makes a joint that drives a body to a position and an angle relative to another, and holds it as it stands until these are set. (An
    /// addition to the original.)
    /// </summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    public MotorJoint CreateMotorJoint(Body body1, Body body2) =>
        new MotorJoint(body1, body2);

    /// <summary>Makes a slide between a body and the world, at 0 as the body stands, and adds it. (An addition to the original.)</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body.</param>
    /// <param name="anchor">A point of the line, in world coordinates; finite.</param>
    /// <param name="axis">Direction of the line, in world coordinates, of any length; finite and not (0, 0).</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedPrismaticJoint CreateFixedPrismaticJoint(PhysicsSimulator physicsSimulator, Body body, Vector2 anchor, Vector2 axis) =>
        Added(physicsSimulator, CreateFixedPrismaticJoint(body, anchor, axis));

    /// <summary>Makes a slide between a body and the world, at 0 as the body stands. (An addition to the original.)</summary>
    /// <param name="body">The body.</param>
    /// <param name="anchor">A point of the line, in world coordinates; finite.</param>
    /// <param name="axis">Direction of the line, in world coordinates, of any length; finite and not (0, 0).</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedPrismaticJoint CreateFixedPrismaticJoint(Body body, Vector2 anchor, Vector2 axis) =>
        new FixedPrismaticJoint(body, anchor, axis);

    /// <summary>
    /// Makes a joint that pulls a point of a body to a point of the world, as a mouse does, and adds it. (An addition to the original.)
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body.</param>
    /// <param name="target">The point, in world coordinates: it is taken for that of the body and for its target; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public TargetJoint CreateTargetJoint(PhysicsSimulator physicsSimulator, Body body, Vector2 target) =>
        Added(physicsSimulator, CreateTargetJoint(body, target));

    /// <summary>
    /// Makes a joint that pulls a point of a body to a point of the world, as a mouse does. (An addition to the original.)
    /// </summary>
    /// <param name="body">The body.</param>
    /// <param name="target">The point, in world coordinates: it is taken for that of the body and for its target; finite.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public TargetJoint CreateTargetJoint(Body body, Vector2 target) =>
        new TargetJoint(body, target);
}
