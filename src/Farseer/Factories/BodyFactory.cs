using System;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Factories;

/// <summary>
/// Makes bodies and works out their moments of inertia. Each method exists with and without a simulator as its first argument. With a
/// simulator the new body gets the drag of <see cref="PhysicsSimulator.Defaults"/> and is added.
/// </summary>
/// <example>
/// <code>
/// Body wheel = BodyFactory.Instance.CreateCircleBody(simulator, radius: 0.4f, mass: 3);
/// </code>
/// </example>
public class BodyFactory
{
    private Farseer201Quirks _quirks;

    private BodyFactory()
    {
    }

    /// <summary>The shared instance.</summary>
    public static BodyFactory Instance { get; } = new BodyFactory();

    /// <summary>
    /// Quirks of the inertia formulas that the overloads without a simulator use too; those with one use the quirks of both.
    /// Default <see cref="Farseer201Quirks.None"/>. (An addition to the original.)
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value has a bit that is no member of the enum.</exception>
    public Farseer201Quirks Quirks
    {
        get => _quirks;
        set => _quirks = (value & ~Farseer201Quirks.All) == 0
            ? value
            : throw Require.Range(nameof(Quirks), value, "must be made of members of the enum Farseer201Quirks");
    }

    /// <summary>Makes a body with the inertia of a rectangle, m (w² + h²) / 12, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="width">Width; finite and above 0.</param>
    /// <param name="height">Height; finite and above 0.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateRectangleBody(PhysicsSimulator physicsSimulator, float width, float height, float mass) =>
        Added(Ready(physicsSimulator), CreateRectangleBody(width, height, mass));

    /// <summary>Makes a body with the inertia of a rectangle, m (w² + h²) / 12.</summary>
    /// <param name="width">Width; finite and above 0.</param>
    /// <param name="height">Height; finite and above 0.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateRectangleBody(float width, float height, float mass)
    {
        double w = Require.Positive(width, nameof(width));
        double h = Require.Positive(height, nameof(height));
        return Make(mass, ((w * w) + (h * h)) / 12);
    }

    /// <summary>Makes a body with the inertia of a disc, m r² / 2, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="radius">Radius; finite and above 0.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateCircleBody(PhysicsSimulator physicsSimulator, float radius, float mass) =>
        Added(Ready(physicsSimulator), CreateCircleBody(radius, mass));

    /// <summary>Makes a body with the inertia of a disc, m r² / 2.</summary>
    /// <param name="radius">Radius; finite and above 0.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateCircleBody(float radius, float mass)
    {
        double r = Require.Positive(radius, nameof(radius));
        return Make(mass, r * r / 2);
    }

    /// <summary>Makes a body with the inertia of an ellipse, m (rx² + ry²) / 4, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to; its quirks decide (see
    /// <see cref="Farseer201Quirks.EllipseInertiaFromRectangle"/>).</param>
    /// <param name="xRadius">Radius along x; finite and above 0.</param>
    /// <param name="yRadius">Radius along y; finite and above 0.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateEllipseBody(PhysicsSimulator physicsSimulator, float xRadius, float yRadius, float mass) =>
        Added(Ready(physicsSimulator), Ellipse(xRadius, yRadius, mass, physicsSimulator.Quirks));

    /// <summary>Makes a body with the inertia of an ellipse, m (rx² + ry²) / 4.</summary>
    /// <param name="xRadius">Radius along x; finite and above 0.</param>
    /// <param name="yRadius">Radius along y; finite and above 0.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateEllipseBody(float xRadius, float yRadius, float mass) => Ellipse(xRadius, yRadius, mass, Farseer201Quirks.None);

    /// <summary>Makes a body with the inertia of a polygon about its centroid, at the centroid, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to; its quirks decide (see
    /// <see cref="Farseer201Quirks.PolygonInertiaUnsigned"/>).</param>
    /// <param name="vertices">A simple outline; not changed.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The outline has fewer than three vertices, no area, or crosses itself.</exception>
    public Body CreatePolygonBody(PhysicsSimulator physicsSimulator, Vertices vertices, float mass) =>
        Added(Ready(physicsSimulator), Polygon(vertices, mass, physicsSimulator.Quirks));

    /// <summary>Makes a body with the inertia of a polygon about its centroid, at the centroid.</summary>
    /// <param name="vertices">A simple outline; not changed.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="vertices"/> is null.</exception>
    /// <exception cref="ArgumentException">The outline has fewer than three vertices, no area, or crosses itself.</exception>
    public Body CreatePolygonBody(Vertices vertices, float mass) => Polygon(vertices, mass, Farseer201Quirks.None);

    /// <summary>
    /// Makes a body with the inertia of a capsule about its middle, and adds it: see
    /// <see cref="GeomFactory.CreateCapsuleGeom(PhysicsSimulator, Body, System.Numerics.Vector2, System.Numerics.Vector2, float)"/>. (An
    /// addition to the original.)
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="length">Length of the axis, without the round ends; finite and above 0.</param>
    /// <param name="radius">Radius; finite and above 0.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateCapsuleBody(PhysicsSimulator physicsSimulator, float length, float radius, float mass) =>
        Added(Ready(physicsSimulator), CreateCapsuleBody(length, radius, mass));

    /// <summary>Makes a body with the inertia of a capsule about its middle. (An addition to the original.)</summary>
    /// <param name="length">Length of the axis, without the round ends; finite and above 0.</param>
    /// <param name="radius">Radius; finite and above 0.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateCapsuleBody(float length, float radius, float mass)
    {
        Require.Positive(length, nameof(length));
        Require.Positive(radius, nameof(radius));
        return Make(mass, GeomArea.CapsuleInertia(length, radius) / GeomArea.CapsuleArea(length, radius));
    }

    /// <summary>
    /// Makes a body with the inertia of a rounded rectangle about its middle, and adds it: see
    /// <see cref="GeomFactory.CreateRoundedRectangleGeom(PhysicsSimulator, Body, float, float, float)"/>. (An addition to the original.)
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="width">Width of the rectangle within; finite and above 0.</param>
    /// <param name="height">Height of the rectangle within; finite and above 0.</param>
    /// <param name="radius">Radius of the corners; finite and above 0.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateRoundedRectangleBody(PhysicsSimulator physicsSimulator, float width, float height, float radius, float mass) =>
        Added(Ready(physicsSimulator), CreateRoundedRectangleBody(width, height, radius, mass));

    /// <summary>Makes a body with the inertia of a rounded rectangle about its middle. (An addition to the original.)</summary>
    /// <param name="width">Width of the rectangle within; finite and above 0.</param>
    /// <param name="height">Height of the rectangle within; finite and above 0.</param>
    /// <param name="radius">Radius of the corners; finite and above 0.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateRoundedRectangleBody(float width, float height, float radius, float mass)
    {
        var size = new System.Numerics.Vector2(Require.Positive(width, nameof(width)), Require.Positive(height, nameof(height)));
        Require.Positive(radius, nameof(radius));
        return Make(mass, GeomArea.RoundedInertia(size, radius) / GeomArea.RoundedArea(size, radius));
    }

    /// <summary>Makes a plain body with a given moment of inertia and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <param name="momentOfInertia">Moment of inertia; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateBody(PhysicsSimulator physicsSimulator, float mass, float momentOfInertia) =>
        Added(Ready(physicsSimulator), CreateBody(mass, momentOfInertia));

    /// <summary>Makes a plain body with a given moment of inertia.</summary>
    /// <param name="mass">Mass; finite and above 0.</param>
    /// <param name="momentOfInertia">Moment of inertia; finite and above 0.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or not above 0.</exception>
    public Body CreateBody(float mass, float momentOfInertia)
    {
        Require.Invertible(mass, nameof(mass));
        Require.Invertible(momentOfInertia, nameof(momentOfInertia));
        return new Body { Mass = mass, MomentOfInertia = momentOfInertia };
    }

    /// <summary>Makes a body like another (see <see cref="Body(Body)"/>) and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to copy.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public Body CreateBody(PhysicsSimulator physicsSimulator, Body body) => AddedAsIs(Ready(physicsSimulator), CreateBody(body));

    /// <summary>Makes a body like another (see <see cref="Body(Body)"/>).</summary>
    /// <param name="body">The body to copy.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    public Body CreateBody(Body body) => new Body(body);

    private Body Ellipse(float xRadius, float yRadius, float mass, Farseer201Quirks quirks)
    {
        double x = Require.Positive(xRadius, nameof(xRadius));
        double y = Require.Positive(yRadius, nameof(yRadius));
        bool wrong = x != y && ((quirks | Quirks) & Farseer201Quirks.EllipseInertiaFromRectangle) != 0;
        return Make(mass, ((x * x) + (y * y)) / (wrong ? 12 : 4));
    }

    private Body Polygon(Vertices vertices, float mass, Farseer201Quirks quirks)
    {
        Vertices outline = OutlineRules.Normalised(vertices, nameof(vertices));
        bool wrong = ((quirks | Quirks) & Farseer201Quirks.PolygonInertiaUnsigned) != 0;
        Body body = Make(mass, wrong ? outline.GetMomentOfInertiaOfAbsoluteTriangles() : outline.GetMomentOfInertia());
        body.Position = outline.GetCentroid();
        return body;
    }

    private static Body Make(float mass, double inertiaPerMass)
    {
        Require.Invertible(mass, nameof(mass));
        return new Body { Mass = mass, MomentOfInertia = (float)(mass * inertiaPerMass) };
    }

    private static Body Added(PhysicsSimulator physicsSimulator, Body body) =>
        AddedAsIs(physicsSimulator, physicsSimulator.Defaults.Applied(body));

    private static Body AddedAsIs(PhysicsSimulator physicsSimulator, Body body)
    {
        physicsSimulator.Add(body);
        return body;
    }

    private static PhysicsSimulator Ready(PhysicsSimulator physicsSimulator)
    {
        Require.NotNull(physicsSimulator, nameof(physicsSimulator)).ThrowIfDisposed();
        return physicsSimulator;
    }
}
