using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Factories;

/// <content>Capsules, segments and chains.</content>
public partial class GeomFactory
{
    /// <summary>
    /// Makes a capsule: all points within a radius of a line. It is added to the simulator. (An addition to the original.)
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="start">One end of the axis, in body coordinates.</param>
    /// <param name="end">The other end of the axis, in body coordinates.</param>
    /// <param name="radius">Radius; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateCapsuleGeom(PhysicsSimulator physicsSimulator, Body body, Vector2 start, Vector2 end, float radius) =>
        Added(Ready(physicsSimulator, body), CreateCapsuleGeom(body, start, end, radius));

    /// <summary>Makes a capsule: all points within a radius of a line. (An addition to the original.)</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="start">One end of the axis, in body coordinates.</param>
    /// <param name="end">The other end of the axis, in body coordinates.</param>
    /// <param name="radius">Radius; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateCapsuleGeom(Body body, Vector2 start, Vector2 end, float radius)
    {
        Require.Length(radius, nameof(radius));
        CheckLine(start, end);
        return new Geom(
            body,
            new GeomForm(FormKind.Capsule, new[] { start, end }, radius, default, false),
            CapsuleOutline(start, end, radius),
            Vector2.Zero,
            0,
            0);
    }

    /// <summary>
    /// Makes a line without thickness that collides on both sides. It is added to the simulator. (An addition to the original.)
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="start">One end of the axis, in body coordinates.</param>
    /// <param name="end">The other end of the axis, in body coordinates.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateSegmentGeom(PhysicsSimulator physicsSimulator, Body body, Vector2 start, Vector2 end) =>
        Added(Ready(physicsSimulator, body), CreateSegmentGeom(body, start, end));

    /// <summary>Makes a line without thickness that collides on both sides. (An addition to the original.)</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="start">One end of the axis, in body coordinates.</param>
    /// <param name="end">The other end of the axis, in body coordinates.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateSegmentGeom(Body body, Vector2 start, Vector2 end)
    {
        CheckLine(start, end);
        return new Geom(
            body, new GeomForm(FormKind.Segment, new[] { start, end }, 0, default, false), new Vertices { start, end }, Vector2.Zero, 0, 0);
    }

    /// <summary>
    /// Makes a chain of lines that feels no seams and collides on one side, the one that (y, -x) of the way from point to point looks to:
    /// outwards for a loop in the order from the x axis to the y axis. The open ends of a chain that is no loop collide with what they meet
    /// point first, from either side. It is added to the simulator. (An addition to the original.)
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="points">The points in order, in body coordinates; at least two different ones.</param>
    /// <param name="loop">True joins the last point to the first.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateChainGeom(PhysicsSimulator physicsSimulator, Body body, Vertices points, bool loop) =>
        Added(Ready(physicsSimulator, body), CreateChainGeom(body, points, loop));

    /// <summary>
    /// Makes a chain of lines that feels no seams and collides on one side, the one that (y, -x) of the way from point to point looks to:
    /// outwards for a loop in the order from the x axis to the y axis. The open ends of a chain that is no loop collide with what they meet
    /// point first, from either side. (An addition to the original.)
    /// </summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="points">The points in order, in body coordinates; at least two different ones.</param>
    /// <param name="loop">True joins the last point to the first.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateChainGeom(Body body, Vertices points, bool loop)
    {
        Vertices chain = OutlineRules.NormalisedChain(points, loop, nameof(points));
        return new Geom(body, new GeomForm(FormKind.Chain, chain.ToArray(), 0, default, loop), chain, Vector2.Zero, 0, 0);
    }

    private static void CheckLine(Vector2 start, Vector2 end)
    {
        Require.Place(start, nameof(start));
        Require.Place(end, nameof(end));
        if (Math.Max(Math.Abs(start.X - end.X), Math.Abs(start.Y - end.Y)) < StateRange.Least)
        {
            throw new ArgumentException(
                "The two ends, " + start + " and " + end + ", are the same point, or nearer than 1.1E-19.", nameof(end));
        }
    }

    /// <summary>Eight points around each end, for drawing.</summary>
    private static Vertices CapsuleOutline(Vector2 start, Vector2 end, float radius)
    {
        const int PointsAnEnd = 8;
        Vertices circle = Vertices.CreateCircle(radius, 2 * (PointsAnEnd - 1));
        double dx = (double)end.X - start.X;
        double dy = (double)end.Y - start.Y;
        double length = Math.Sqrt((dx * dx) + (dy * dy));
        var along = new Vector2((float)(dx / length), (float)(dy / length));
        var outline = new Vertices();
        for (int i = 0; i < 2 * PointsAnEnd; i++)
        {
            // A quarter turn back, so that each half of the circle is about its end of the axis.
            Vector2 p = circle[((i % PointsAnEnd) + (i < PointsAnEnd ? 0 : PointsAnEnd - 1)) % circle.Count];
            var turned = new Vector2(-p.Y, p.X);
            outline.Add((i < PointsAnEnd ? end : start)
                + new Vector2((along.X * turned.X) - (along.Y * turned.Y), (along.Y * turned.X) + (along.X * turned.Y)));
        }

        outline.ForceCounterClockWiseOrder();
        return outline;
    }
}
