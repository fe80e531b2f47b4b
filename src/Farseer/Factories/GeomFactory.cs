using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Factories;

/// <summary>
/// Makes geoms, and picks the cell size of their grids. Each method exists with and without a simulator as its first argument. With a
/// simulator the new geom gets the friction and restitution of <see cref="PhysicsSimulator.Defaults"/> and is added.
/// </summary>
/// <example>
/// <code>
/// Geom tyre = GeomFactory.Instance.CreateCircleGeom(simulator, body, radius: 0.4f, numberOfEdges: 24);
/// </code>
/// </example>
public partial class GeomFactory
{
    private float _gridCellSizeAABBFactor = 0.1f;

    private GeomFactory()
    {
    }

    /// <summary>The shared instance.</summary>
    public static GeomFactory Instance { get; } = new GeomFactory();

    /// <summary>Size of a grid cell as a share of the shorter side of the geom's box, where no size is given. Default 0.1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or not above 0.</exception>
    public float GridCellSizeAABBFactor
    {
        get => _gridCellSizeAABBFactor;
        set => _gridCellSizeAABBFactor = Require.Positive(value, nameof(GridCellSizeAABBFactor));
    }

    /// <summary>The cell size picked for an outline: the shorter side of its box times <see cref="GridCellSizeAABBFactor"/>.</summary>
    /// <param name="vertices">The outline.</param>
    /// <returns>The cell size.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="vertices"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="vertices"/> is empty.</exception>
    public float CalculateGridCellSizeFromAABB(Vertices vertices) => new AABB(vertices).GetShortestSide() * _gridCellSizeAABBFactor;

    /// <summary>
    /// Makes a copy of a geom for another body, and adds it: shape, material and filters are copied, handlers and tag are not.
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="geometry">The geom to copy.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateGeom(PhysicsSimulator physicsSimulator, Body body, Geom geometry) =>
        AddedAsIs(Ready(physicsSimulator, body), CreateGeom(body, geometry));

    /// <summary>Makes a copy of a geom for another body: shape, material and filters are copied, handlers and tag are not.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="geometry">The geom to copy.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateGeom(Body body, Geom geometry) => new Geom(body, geometry);

    /// <summary>Makes a copy of a geom for another body at another offset, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="geometry">The geom to copy.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateGeom(PhysicsSimulator physicsSimulator, Body body, Geom geometry, Vector2 offset, float rotationOffset) =>
        AddedAsIs(Ready(physicsSimulator, body), CreateGeom(body, geometry, offset, rotationOffset));

    /// <summary>Makes a copy of a geom for another body at another offset.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="geometry">The geom to copy.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateGeom(Body body, Geom geometry, Vector2 offset, float rotationOffset) =>
        new Geom(body, geometry, offset, rotationOffset);

    private static Geom Added(PhysicsSimulator physicsSimulator, Geom geom) =>
        AddedAsIs(physicsSimulator, physicsSimulator.Defaults.Applied(geom));

    private static Geom AddedAsIs(PhysicsSimulator physicsSimulator, Geom geom)
    {
        physicsSimulator.Add(geom);
        return geom;
    }

    /// <summary>Checks simulator and body before a geom is made: a refusal must not leave a geom on the body.</summary>
    private static PhysicsSimulator Ready(PhysicsSimulator physicsSimulator, Body body)
    {
        Require.NotNull(physicsSimulator, nameof(physicsSimulator)).ThrowIfDisposed();
        Require.NotNull(body, nameof(body)).ThrowIfDisposed();
        if (body.Simulator is not null && !ReferenceEquals(body.Simulator, physicsSimulator))
        {
            throw new ArgumentException("The body belongs to another simulator.", nameof(body));
        }

        return physicsSimulator;
    }
}
