using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Factories;

/// <content>Circles and ellipses.</content>
public partial class GeomFactory
{
    /// <summary>Makes a circle that collides as a true circle, and adds it; its vertices have the number of edges given.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="radius">Radius; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateCircleGeom(PhysicsSimulator physicsSimulator, Body body, float radius, int numberOfEdges) =>
        Added(Ready(physicsSimulator, body), CreateCircleGeom(body, radius, numberOfEdges));

    /// <summary>Makes a circle that collides as a true circle; its vertices have the number of edges given.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="radius">Radius; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateCircleGeom(Body body, float radius, int numberOfEdges) =>
        CreateCircleGeom(body, radius, numberOfEdges, Vector2.Zero, 0, 0);

    /// <summary>Makes a circle that collides as a true circle, and adds it; its vertices have the number of edges given.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="radius">Radius; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateCircleGeom(
        PhysicsSimulator physicsSimulator, Body body, float radius, int numberOfEdges, float collisionGridCellSize) =>
        Added(Ready(physicsSimulator, body), CreateCircleGeom(body, radius, numberOfEdges, collisionGridCellSize));

    /// <summary>Makes a circle that collides as a true circle; its vertices have the number of edges given.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="radius">Radius; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateCircleGeom(Body body, float radius, int numberOfEdges, float collisionGridCellSize) =>
        CreateCircleGeom(body, radius, numberOfEdges, Vector2.Zero, 0, collisionGridCellSize);

    /// <summary>Makes a circle that collides as a true circle, and adds it; its vertices have the number of edges given.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="radius">Radius; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateCircleGeom(
        PhysicsSimulator physicsSimulator, Body body, float radius, int numberOfEdges, Vector2 offset, float rotationOffset) =>
        Added(Ready(physicsSimulator, body), CreateCircleGeom(body, radius, numberOfEdges, offset, rotationOffset));

    /// <summary>Makes a circle that collides as a true circle; its vertices have the number of edges given.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="radius">Radius; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateCircleGeom(Body body, float radius, int numberOfEdges, Vector2 offset, float rotationOffset) =>
        CreateCircleGeom(body, radius, numberOfEdges, offset, rotationOffset, 0);

    /// <summary>Makes a circle that collides as a true circle, and adds it; its vertices have the number of edges given.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="radius">Radius; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateCircleGeom(
        PhysicsSimulator physicsSimulator,
        Body body,
        float radius,
        int numberOfEdges,
        Vector2 offset,
        float rotationOffset,
        float collisionGridCellSize) =>
        Added(Ready(physicsSimulator, body), CreateCircleGeom(body, radius, numberOfEdges, offset, rotationOffset, collisionGridCellSize));

    /// <summary>Makes a circle that collides as a true circle; its vertices have the number of edges given.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="radius">Radius; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateCircleGeom(
        Body body, float radius, int numberOfEdges, Vector2 offset, float rotationOffset, float collisionGridCellSize)
    {
        Require.Length(radius, nameof(radius));
        Require.Within(numberOfEdges, 3, Vertices.MostEdges, nameof(numberOfEdges));
        GeomForm form = GeomForm.Circle(radius, numberOfEdges);
        return new Geom(body, form, form.OwnOutline()!, offset, rotationOffset, collisionGridCellSize);
    }

    /// <summary>Makes an ellipse as a polygon of the number of edges given, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="xRadius">Radius along x; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="yRadius">Radius along y; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateEllipseGeom(PhysicsSimulator physicsSimulator, Body body, float xRadius, float yRadius, int numberOfEdges) =>
        Added(Ready(physicsSimulator, body), CreateEllipseGeom(body, xRadius, yRadius, numberOfEdges));

    /// <summary>Makes an ellipse as a polygon of the number of edges given.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="xRadius">Radius along x; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="yRadius">Radius along y; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateEllipseGeom(Body body, float xRadius, float yRadius, int numberOfEdges) =>
        CreateEllipseGeom(body, xRadius, yRadius, numberOfEdges, Vector2.Zero, 0, 0);

    /// <summary>Makes an ellipse as a polygon of the number of edges given, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="xRadius">Radius along x; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="yRadius">Radius along y; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateEllipseGeom(
        PhysicsSimulator physicsSimulator, Body body, float xRadius, float yRadius, int numberOfEdges, float collisionGridCellSize) =>
        Added(Ready(physicsSimulator, body), CreateEllipseGeom(body, xRadius, yRadius, numberOfEdges, collisionGridCellSize));

    /// <summary>Makes an ellipse as a polygon of the number of edges given.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="xRadius">Radius along x; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="yRadius">Radius along y; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateEllipseGeom(Body body, float xRadius, float yRadius, int numberOfEdges, float collisionGridCellSize) =>
        CreateEllipseGeom(body, xRadius, yRadius, numberOfEdges, Vector2.Zero, 0, collisionGridCellSize);

    /// <summary>Makes an ellipse as a polygon of the number of edges given, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="xRadius">Radius along x; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="yRadius">Radius along y; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateEllipseGeom(
        PhysicsSimulator physicsSimulator,
        Body body,
        float xRadius,
        float yRadius,
        int numberOfEdges,
        Vector2 offset,
        float rotationOffset) =>
        Added(Ready(physicsSimulator, body), CreateEllipseGeom(body, xRadius, yRadius, numberOfEdges, offset, rotationOffset));

    /// <summary>Makes an ellipse as a polygon of the number of edges given.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="xRadius">Radius along x; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="yRadius">Radius along y; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateEllipseGeom(Body body, float xRadius, float yRadius, int numberOfEdges, Vector2 offset, float rotationOffset) =>
        CreateEllipseGeom(body, xRadius, yRadius, numberOfEdges, offset, rotationOffset, 0);

    /// <summary>Makes an ellipse as a polygon of the number of edges given, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="body">The body to attach to.</param>
    /// <param name="xRadius">Radius along x; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="yRadius">Radius along y; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateEllipseGeom(
        PhysicsSimulator physicsSimulator,
        Body body,
        float xRadius,
        float yRadius,
        int numberOfEdges,
        Vector2 offset,
        float rotationOffset,
        float collisionGridCellSize) =>
        Added(
            Ready(physicsSimulator, body),
            CreateEllipseGeom(body, xRadius, yRadius, numberOfEdges, offset, rotationOffset, collisionGridCellSize));

    /// <summary>Makes an ellipse as a polygon of the number of edges given.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="xRadius">Radius along x; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="yRadius">Radius along y; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="numberOfEdges">Edges of the outline; from 3 to 65536.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <returns>The geom.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A number or the outline is out of the range given above.</exception>
    public Geom CreateEllipseGeom(
        Body body, float xRadius, float yRadius, int numberOfEdges, Vector2 offset, float rotationOffset, float collisionGridCellSize)
    {
        Require.Length(xRadius, nameof(xRadius));
        Require.Length(yRadius, nameof(yRadius));
        Require.Within(numberOfEdges, 3, Vertices.MostEdges, nameof(numberOfEdges));
        return new Geom(body, Vertices.CreateEllipse(xRadius, yRadius, numberOfEdges), offset, rotationOffset, collisionGridCellSize);
    }
}
