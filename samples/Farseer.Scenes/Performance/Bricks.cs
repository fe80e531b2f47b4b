using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes.Performance;

/// <summary>Adds bodies and geoms; sizes are half sizes, as in the published definitions.</summary>
internal sealed class Bricks
{
    private const float DefaultFriction = 0.6f;
    private readonly PhysicsSimulator _simulator;

    public Bricks(PhysicsSimulator simulator) => _simulator = simulator;

    public PhysicsSimulator Simulator => _simulator;

    /// <summary>Of the geoms made from now on.</summary>
    public float Friction { get; set; } = DefaultFriction;

    /// <summary>Of the geoms made from now on.</summary>
    public float Restitution { get; set; }

    /// <summary>Of the geoms made from now on; geoms of one group above 0 do not collide.</summary>
    public int CollisionGroup { get; set; }

    /// <summary>Mass of a unit area of the bodies made from now on.</summary>
    public float Density { get; set; } = 1f;

    public void StaticBox(float x, float y, float halfWidth, float halfHeight)
    {
        Body body = StaticBody(x, y);
        Finish(GeomFactory.Instance.CreateRectangleGeom(_simulator, body, 2f * halfWidth, 2f * halfHeight));
    }

    /// <summary>A level static segment.</summary>
    public void StaticSegment(float y, float length)
    {
        Body body = StaticBody(0f, y);
        var reach = new Vector2(0.5f * length, 0f);
        Finish(GeomFactory.Instance.CreateSegmentGeom(_simulator, body, -reach, reach));
    }

    /// <summary>A body that does not move and has no geoms yet.</summary>
    public Body StaticBody(float x, float y)
    {
        Body body = AddBody(x, y, 1f, 1f);
        body.IsStatic = true;
        return body;
    }

    public Body Box(float x, float y, float halfWidth, float halfHeight)
    {
        float mass = Density * 4f * halfWidth * halfHeight;
        float inertia = mass * ((halfWidth * halfWidth) + (halfHeight * halfHeight)) / 3f;
        Body body = AddBody(x, y, mass, inertia);
        Finish(GeomFactory.Instance.CreateRectangleGeom(_simulator, body, 2f * halfWidth, 2f * halfHeight));
        return body;
    }

    public Body Circle(float x, float y, float radius)
    {
        float mass = Density * (float)Math.PI * radius * radius;
        Body body = AddBody(x, y, mass, 0.5f * mass * radius * radius);
        Finish(GeomFactory.Instance.CreateCircleGeom(_simulator, body, radius, 16));
        return body;
    }

    /// <summary>A level capsule: all points within a radius of a line.</summary>
    public Body Capsule(float x, float y, float halfLength, float radius)
    {
        // A rectangle of 2l by 2r and two half discs whose centres of mass lie 4r/(3 pi) beyond its ends.
        float rectangle = Density * 4f * halfLength * radius;
        float discs = Density * (float)Math.PI * radius * radius;
        float lever = 4f * radius / (3f * (float)Math.PI);
        float far = halfLength + lever;
        float inertia = (rectangle * ((halfLength * halfLength) + (radius * radius)) / 3f)
            + (discs * ((0.5f * radius * radius) - (lever * lever) + (far * far)));
        Body body = AddBody(x, y, rectangle + discs, inertia);
        var end = new Vector2(halfLength, 0f);
        Finish(GeomFactory.Instance.CreateCapsuleGeom(_simulator, body, -end, end, radius));
        return body;
    }

    /// <summary>All points within a radius of an upright or level box.</summary>
    public Body RoundedBox(float x, float y, float halfWidth, float halfHeight, float radius)
    {
        // The mass of the enclosing box but for its corners, which are small here: the rod is held by a motor without limit.
        float w = halfWidth + radius;
        float h = halfHeight + radius;
        float mass = Density * ((4f * w * h) - ((4f - (float)Math.PI) * radius * radius));
        Body body = AddBody(x, y, mass, mass * ((w * w) + (h * h)) / 3f);
        Finish(GeomFactory.Instance.CreateRoundedRectangleGeom(_simulator, body, 2f * halfWidth, 2f * halfHeight, radius));
        return body;
    }

    /// <summary>A body whose mass follows from its outlines, each given about a point of the world.</summary>
    public Body Compound(float x, float y, params Vector2[][] outlines)
    {
        float mass = 0f;
        Vector2 moment = Vector2.Zero;
        foreach (Vector2[] outline in outlines)
        {
            var vertices = new Vertices(outline);
            float part = Density * vertices.GetArea();
            mass += part;
            moment += part * vertices.GetCentroid();
        }

        // A body's position is its centre of mass.
        Vector2 centre = moment / mass;
        float inertia = 0f;
        foreach (Vector2[] outline in outlines)
        {
            var vertices = new Vertices(outline);
            float part = Density * vertices.GetArea();
            inertia += part * (vertices.GetMomentOfInertia() + (vertices.GetCentroid() - centre).LengthSquared());
        }

        Body body = AddBody(x + centre.X, y + centre.Y, mass, inertia);
        foreach (Vector2[] outline in outlines)
        {
            var moved = new Vertices(outline);
            moved.Translate(-centre);
            Attach(body, moved);
        }

        return body;
    }

    /// <summary>Adds a box about a point of a body.</summary>
    public void AttachBox(Body body, float x, float y, float halfWidth, float halfHeight) =>
        Finish(GeomFactory.Instance.CreateRectangleGeom(_simulator, body, 2f * halfWidth, 2f * halfHeight, new Vector2(x, y), 0f));

    /// <summary>Adds a polygon whose corners are given about the body's origin.</summary>
    public void Attach(Body body, Vertices vertices)
    {
        Finish(GeomFactory.Instance.CreatePolygonGeom(_simulator, body, vertices, vertices.GetCentroid(), 0f, 0f));
    }

    /// <summary>Adds lines that collide on one side.</summary>
    public void AttachLoop(Body body, Vector2[] points) =>
        Finish(GeomFactory.Instance.CreateChainGeom(_simulator, body, new Vertices(points), true));

    public Body AddBody(float x, float y, float mass, float inertia)
    {
        Body body = BodyFactory.Instance.CreateBody(_simulator, mass, inertia);
        body.LinearDragCoefficient = 0f;
        body.RotationalDragCoefficient = 0f;
        body.Position = new Vector2(x, y);
        return body;
    }

    private void Finish(Geom geom)
    {
        geom.FrictionCoefficient = Friction;
        geom.RestitutionCoefficient = Restitution;
        geom.CollisionGroup = CollisionGroup;
    }
}
