using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Factories;

/// <content>Rectangles with rounded corners.</content>
public partial class GeomFactory
{
    /// <summary>Points of an outline for drawing in each rounded corner.</summary>
    private const int PointsACorner = 5;

    /// <summary>
    /// Makes a rounded rectangle: all points within a radius of a rectangle about the body's origin. It is added to the simulator. (An
    /// addition to the original.)
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="width">Width of the rectangle within; the geom is wider by two radii. Above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="height">Height of the rectangle within; the same range.</param>
    /// <param name="radius">Radius of the corners; the same range.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number is out of the range given above.</exception>
    public Geom CreateRoundedRectangleGeom(PhysicsSimulator physicsSimulator, Body body, float width, float height, float radius) =>
        Added(Ready(physicsSimulator, body), CreateRoundedRectangleGeom(body, width, height, radius));

    /// <summary>
    /// Makes a rounded rectangle: all points within a radius of a rectangle about the body's origin. (An addition to the original.)
    /// </summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="width">Width of the rectangle within; the geom is wider by two radii. Above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="height">Height of the rectangle within; the same range.</param>
    /// <param name="radius">Radius of the corners; the same range.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number is out of the range given above.</exception>
    public Geom CreateRoundedRectangleGeom(Body body, float width, float height, float radius)
    {
        Require.Length(width, nameof(width));
        Require.Length(height, nameof(height));
        Require.Length(radius, nameof(radius));
        var half = new Vector2(0.5f * width, 0.5f * height);
        Vector2[] corners = { -half, new Vector2(half.X, -half.Y), half, new Vector2(-half.X, half.Y) };
        return new Geom(
            body, new GeomForm(FormKind.Rounded, corners, radius, default, true), RoundedOutline(corners, radius), Vector2.Zero, 0, 0);
    }

    private static Vertices RoundedOutline(Vector2[] corners, float radius)
    {
        Vertices circle = Vertices.CreateCircle(radius, 4 * (PointsACorner - 1));
        var outline = new Vertices();
        for (int corner = 0; corner < corners.Length; corner++)
        {
            for (int i = 0; i < PointsACorner; i++)
            {
                // The first quarter, whichever way the circle goes round.
                Vector2 spoke = Vector2.Abs(circle[i]);

                // The first corner is lower left: a half turn from the circle's start at the right, and a quarter more for each.
                Vector2 turned = corner switch
                {
                    0 => -spoke,
                    1 => new Vector2(spoke.Y, -spoke.X),
                    2 => spoke,
                    _ => new Vector2(-spoke.Y, spoke.X),
                };
                outline.Add(corners[corner] + turned);
            }
        }

        outline.ForceCounterClockWiseOrder();
        return outline;
    }
}
