using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Accuracy.Surveys;

/// <summary>How a piece of ground is made.</summary>
internal enum Piece
{
    /// <summary>A rectangle.</summary>
    Box,

    /// <summary>A polygon of four corners.</summary>
    Polygon,

    /// <summary>A line alone.</summary>
    Segment,
}

/// <summary>A small world in metres: bodies without drag, of friction 0.5 and no restitution unless told otherwise.</summary>
internal sealed class Yard : IDisposable
{
    public const float UsualDt = 1 / 60f;

    /// <summary>The depth of contacts that a simulator has by default.</summary>
    public const float UsualDepth = 0.05f;

    private const int CircleEdges = 16;
    private const float TurnsHardly = 1e20f;

    private readonly float _dt;
    private bool _hasLost;

    public Yard(float depth, float gravity = -10, int iterations = Options.DefaultIterations, float dt = UsualDt)
    {
        _dt = dt;
        Simulator = new PhysicsSimulator(new Vector2(0, gravity)) { AllowedPenetration = depth, Iterations = iterations };
        Simulator.BodyQuarantined += (_, _) => _hasLost = true;
    }

    public PhysicsSimulator Simulator { get; }

    public void Step() => Simulator.Update(_dt);

    public void Steps(int count, Action? before = null, Action? after = null)
    {
        for (int i = 0; i < count; i++)
        {
            before?.Invoke();
            Step();
            after?.Invoke();
        }
    }

    /// <summary>The figure of a world; not a number if one of its bodies was taken out.</summary>
    public double Figure(double value) => _hasLost ? double.NaN : value;

    public Body Box(float x, float y, float width, float height, float mass = 1, float friction = 0.5f, float bounce = 0)
    {
        Body body = Placed(BodyFactory.Instance.CreateRectangleBody(Simulator, width, height, mass), x, y);
        Touching(GeomFactory.Instance.CreateRectangleGeom(Simulator, body, width, height), friction, bounce);
        return body;
    }

    public Body Ball(float x, float y, float radius, float mass = 1, float friction = 0.5f, float bounce = 0)
    {
        Body body = Placed(BodyFactory.Instance.CreateCircleBody(Simulator, radius, mass), x, y);
        Touching(GeomFactory.Instance.CreateCircleGeom(Simulator, body, radius, CircleEdges), friction, bounce);
        return body;
    }

    public Body RoundedBox(float x, float y, float width, float height, float radius, float friction = 0.5f, float bounce = 0)
    {
        Body body = Placed(BodyFactory.Instance.CreateRectangleBody(Simulator, width, height, 1), x, y);
        Touching(GeomFactory.Instance.CreateRoundedRectangleGeom(Simulator, body, width, height, radius), friction, bounce);
        return body;
    }

    /// <summary>A capsule that lies along x.</summary>
    public Body Capsule(float x, float y, float length, float radius, float friction = 0.5f, float bounce = 0)
    {
        Body body = Placed(BodyFactory.Instance.CreateRectangleBody(Simulator, length + (2 * radius), 2 * radius, 1), x, y);
        var end = new Vector2(length / 2, 0);
        Touching(GeomFactory.Instance.CreateCapsuleGeom(Simulator, body, -end, end, radius), friction, bounce);
        return body;
    }

    /// <summary>A body that meets nothing.</summary>
    public Body Loose(Vector2 place, float mass, float inertia) =>
        Placed(BodyFactory.Instance.CreateBody(Simulator, mass, inertia), place.X, place.Y);

    /// <summary>A point of the world for joints.</summary>
    public Body Anchor(Vector2 place) => Fixed(Placed(BodyFactory.Instance.CreateBody(Simulator, 1, 1), place.X, place.Y));

    /// <summary>A regular polygon whose lowest edge is level.</summary>
    public Body Regular(float x, float y, int corners, float radius, float friction = 0.5f, float bounce = 0)
    {
        var outline = new Vertices();
        for (int i = 0; i < corners; i++)
        {
            double angle = (2 * Math.PI * (i + 0.5) / corners) - (Math.PI / 2);
            outline.Add(new Vector2((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle))));
        }

        Body body = Placed(BodyFactory.Instance.CreatePolygonBody(Simulator, new Vertices(outline.ToArray()), 1), x, y);
        Touching(GeomFactory.Instance.CreatePolygonGeom(Simulator, body, outline, 0), friction, bounce);
        return body;
    }

    /// <summary>Two balls side by side on one body, their centres a distance of <paramref name="apart"/> apart.</summary>
    public Body BallPair(float x, float y, float apart, float radius, float friction = 0.5f, float bounce = 0)
    {
        Body body = Placed(BodyFactory.Instance.CreateRectangleBody(Simulator, apart + (2 * radius), 2 * radius, 1), x, y);
        foreach (float side in (ReadOnlySpan<float>)[-apart / 2, apart / 2])
        {
            Geom ball = GeomFactory.Instance.CreateCircleGeom(Simulator, body, radius, CircleEdges, new Vector2(side, 0), 0);
            Touching(ball, friction, bounce);
        }

        return body;
    }

    /// <summary>The mass and inertia of a polygon of 1 kg, whose outline is a chain; the outline is about its centroid.</summary>
    public Body Chain(float x, float y, Vertices outline, bool loop, float bounce)
    {
        Body body = Placed(BodyFactory.Instance.CreatePolygonBody(Simulator, new Vertices(outline.ToArray()), 1), x, y);
        Touching(GeomFactory.Instance.CreateChainGeom(Simulator, body, outline, loop), 0.5f, bounce);
        return body;
    }

    /// <summary>
    /// Fixed pieces of ground between each two neighbours of some points; what they hold up is on the left of the way along
    /// them.
    /// </summary>
    public void Lay(Piece piece, IReadOnlyList<Vector2> points, bool oneBody = false, float friction = 0)
    {
        Body? shared = oneBody ? Anchor(Vector2.Zero) : null;
        for (int i = 1; i < points.Count; i++)
        {
            LayOne(piece, points[i - 1], points[i], shared, friction);
        }
    }

    /// <summary>One fixed piece from a point to another, 1 m thick if it is no line; what it holds up is on the left of the way.</summary>
    public void LayOne(Piece piece, Vector2 from, Vector2 to, Body? shared = null, float friction = 0)
    {
        Vector2 along = to - from;
        float length = along.Length();
        Vector2 down = new Vector2(along.Y, -along.X) / length;
        Vector2 centre = ((from + to) / 2) + (down / 2);
        Body body = shared ?? Anchor(centre);
        Vector2 offset = centre - body.Position;
        Geom geom = piece switch
        {
            Piece.Segment => GeomFactory.Instance.CreateSegmentGeom(Simulator, body, from - body.Position, to - body.Position),
            Piece.Polygon => GeomFactory.Instance.CreatePolygonGeom(
                Simulator, body, new Vertices(new[] { from - centre, from + down - centre, to + down - centre, to - centre }),
                offset, 0, 0),
            _ => GeomFactory.Instance.CreateRectangleGeom(Simulator, body, length, 1, offset, MathF.Atan2(along.Y, along.X)),
        };
        Touching(geom, friction, 0);
    }

    public static Body Fixed(Body body)
    {
        body.IsStatic = true;
        return body;
    }

    /// <summary>Of such an inertia that nothing in a survey turns it.</summary>
    public static Body Upright(Body body)
    {
        body.MomentOfInertia = TurnsHardly;
        return body;
    }

    public static double Energy(Body body) =>
        0.5 * ((body.Mass * body.LinearVelocity.LengthSquared())
            + (body.MomentOfInertia * (double)body.AngularVelocity * body.AngularVelocity));

    public void Dispose() => Simulator.Dispose();

    private static Body Placed(Body body, float x, float y)
    {
        body.Position = new Vector2(x, y);
        body.LinearDragCoefficient = body.RotationalDragCoefficient = 0;
        return body;
    }

    private static void Touching(Geom geom, float friction, float bounce)
    {
        geom.FrictionCoefficient = friction;
        geom.RestitutionCoefficient = bounce;
    }
}
