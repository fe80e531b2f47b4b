using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Factories;

/// <content>Polygons.</content>
public partial class GeomFactory
{
    /// <summary>
    /// Makes a polygon of any simple outline, and adds it; the list given is put into the documented order and moved so that its centroid
    /// is at the origin.
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="vertices">A simple outline, which is moved to its centroid; at least three vertices.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreatePolygonGeom(PhysicsSimulator physicsSimulator, Body body, Vertices vertices, float collisionGridCellSize) =>
        Added(Ready(physicsSimulator, body), CreatePolygonGeom(body, vertices, collisionGridCellSize));

    /// <summary>
    /// Makes a polygon of any simple outline; the list given is put into the documented order and moved so that its centroid is at the
    /// origin.
    /// </summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="vertices">A simple outline, which is moved to its centroid; at least three vertices.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreatePolygonGeom(Body body, Vertices vertices, float collisionGridCellSize) =>
        CreatePolygonGeom(body, vertices, Vector2.Zero, 0, collisionGridCellSize);

    /// <summary>
    /// Makes a polygon of any simple outline, and adds it; the list given is put into the documented order and moved so that its centroid
    /// is at the origin.
    /// </summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="vertices">A simple outline, which is moved to its centroid; at least three vertices.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreatePolygonGeom(
        PhysicsSimulator physicsSimulator,
        Body body,
        Vertices vertices,
        Vector2 offset,
        float rotationOffset,
        float collisionGridCellSize) =>
        Added(Ready(physicsSimulator, body), CreatePolygonGeom(body, vertices, offset, rotationOffset, collisionGridCellSize));

    /// <summary>
    /// Makes a polygon of any simple outline; the list given is put into the documented order and moved so that its centroid is at the
    /// origin.
    /// </summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="vertices">A simple outline, which is moved to its centroid; at least three vertices.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreatePolygonGeom(Body body, Vertices vertices, Vector2 offset, float rotationOffset, float collisionGridCellSize)
    {
        Vertices outline = OutlineRules.Normalised(vertices, nameof(vertices));
        Require.NotNull(body, nameof(body));
        Vector2 centroid = outline.GetCentroid();
        outline.Translate(-centroid);
        var geom = new Geom(body, GeomForm.Outline(outline), outline, offset, rotationOffset, collisionGridCellSize);

        // The original changed the caller's list, and programs draw from it: done last, so that a refusal leaves it alone.
        vertices.ForceCounterClockWiseOrder();
        vertices.Translate(-centroid);
        return geom;
    }
}
