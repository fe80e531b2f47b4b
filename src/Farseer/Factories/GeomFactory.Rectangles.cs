using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Factories;

/// <content>Rectangles.</content>
public partial class GeomFactory
{
    /// <summary>
    /// Makes a rectangle of 16 vertices (corners and quarter points) that collides as a box of four corners, and adds it.
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="width">Width; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="height">Height; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateRectangleGeom(PhysicsSimulator physicsSimulator, Body body, float width, float height) =>
        Added(Ready(physicsSimulator, body), CreateRectangleGeom(body, width, height));

    /// <summary>Makes a rectangle of 16 vertices (corners and quarter points) that collides as a box of four corners.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="width">Width; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="height">Height; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateRectangleGeom(Body body, float width, float height) =>
        CreateRectangleGeom(body, width, height, Vector2.Zero, 0, 0);

    /// <summary>
    /// Makes a rectangle of 16 vertices (corners and quarter points) that collides as a box of four corners, and adds it.
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="width">Width; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="height">Height; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateRectangleGeom(PhysicsSimulator physicsSimulator, Body body, float width, float height, float collisionGridCellSize) =>
        Added(Ready(physicsSimulator, body), CreateRectangleGeom(body, width, height, collisionGridCellSize));

    /// <summary>Makes a rectangle of 16 vertices (corners and quarter points) that collides as a box of four corners.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="width">Width; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="height">Height; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateRectangleGeom(Body body, float width, float height, float collisionGridCellSize) =>
        CreateRectangleGeom(body, width, height, Vector2.Zero, 0, collisionGridCellSize);

    /// <summary>
    /// Makes a rectangle of 16 vertices (corners and quarter points) that collides as a box of four corners, and adds it.
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="width">Width; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="height">Height; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateRectangleGeom(
        PhysicsSimulator physicsSimulator, Body body, float width, float height, Vector2 offset, float rotationOffset) =>
        Added(Ready(physicsSimulator, body), CreateRectangleGeom(body, width, height, offset, rotationOffset));

    /// <summary>Makes a rectangle of 16 vertices (corners and quarter points) that collides as a box of four corners.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="width">Width; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="height">Height; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateRectangleGeom(Body body, float width, float height, Vector2 offset, float rotationOffset) =>
        CreateRectangleGeom(body, width, height, offset, rotationOffset, 0);

    /// <summary>
    /// Makes a rectangle of 16 vertices (corners and quarter points) that collides as a box of four corners, and adds it.
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="width">Width; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="height">Height; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateRectangleGeom(
        PhysicsSimulator physicsSimulator,
        Body body,
        float width,
        float height,
        Vector2 offset,
        float rotationOffset,
        float collisionGridCellSize) =>
        Added(Ready(physicsSimulator, body), CreateRectangleGeom(body, width, height, offset, rotationOffset, collisionGridCellSize));

    /// <summary>Makes a rectangle of 16 vertices (corners and quarter points) that collides as a box of four corners.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="width">Width; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="height">Height; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateRectangleGeom(Body body, float width, float height, Vector2 offset, float rotationOffset, float collisionGridCellSize)
    {
        Require.Length(width, nameof(width));
        Require.Length(height, nameof(height));
        return new Geom(
            body, GeomForm.Box(width, height), Vertices.CreateRectangle(width, height), offset, rotationOffset, collisionGridCellSize);
    }
}
