using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Accuracy;

/// <summary>One world of a scene. The clock runs inside <c>Update</c> only.</summary>
internal sealed partial class Rig : IDisposable
{
    private const double ExplodedBeyond = 3e7;

    private readonly PhysicsSimulator _simulator;
    private readonly List<Actor> _actors = [];
    private readonly List<Geom> _made = [];
    private readonly float _dt;
    private int _dynamicCount;

    public Rig(Dial dial, double gravity)
    {
        _dt = (float)dial.Dt;
        _simulator = new PhysicsSimulator(new Vector2(0, (float)-gravity))
        {
            Iterations = dial.Iterations,
        };
        dial.Tune?.Invoke(_simulator);
    }

    /// <summary>Both coefficients of the geoms added from now on.</summary>
    public double Friction { get; set; } = 0.6;

    public double Restitution { get; set; }

    public IReadOnlyList<Actor> Actors => _actors;

    /// <summary>For what only the simulator itself can tell.</summary>
    public PhysicsSimulator Simulator => _simulator;

    public int Steps { get; private set; }

    /// <summary>The step really taken: <c>Update</c> receives a float.</summary>
    public double Dt => _dt;

    /// <summary>The time that references use: steps × the float step, in double.</summary>
    public double Time => Steps * Dt;

    /// <summary>What the clock said of each step.</summary>
    public List<long> StepTicks { get; } = [];

    public double BodySteps => (double)Steps * _dynamicCount;

    public void Dispose() => _simulator.Dispose();

    /// <summary>"ground": static, 60×1, top face y = 0.</summary>
    public Actor AddGround() => AddStaticBox(0, -0.5, 60, 1);

    public Actor AddStaticBox(double x, double y, double width, double height, double angle = 0)
    {
        Actor actor = Add(new Vec(x, y), angle, 1, 1, [Outlines.Box(width, height)], isStatic: true, out Body body);
        Attach(GeomFactory.Instance.CreateRectangleGeom(_simulator, body, (float)width, (float)height));
        return actor;
    }

    public Actor AddBox(double x, double y, double width, double height, double angle = 0, double density = 1)
    {
        double mass = density * width * height;
        double inertia = mass * ((width * width) + (height * height)) / 12.0;
        Actor actor = Add(new Vec(x, y), angle, mass, inertia, [Outlines.Box(width, height)], isStatic: false, out Body body);
        Attach(GeomFactory.Instance.CreateRectangleGeom(_simulator, body, (float)width, (float)height));
        return actor;
    }

    public Actor AddCircle(double x, double y, double radius, double? mass = null, double angle = 0)
    {
        double m = mass ?? (Math.PI * radius * radius);
        Actor actor = Add(new Vec(x, y), angle, m, 0.5 * m * radius * radius, [], isStatic: false, out Body body);
        Attach(GeomFactory.Instance.CreateCircleGeom(_simulator, body, (float)radius, 32));
        return actor;
    }

    /// <summary>A body of one simple polygon, which may be concave: then <paramref name="pieces"/> are its convex pieces.</summary>
    public Actor AddPolygon(Vec position, double angle, Vec[] outline, IReadOnlyList<Vec[]> pieces)
    {
        double mass = Outlines.Area(outline);
        Actor actor = Add(position, angle, mass, Outlines.SecondMoment(outline), pieces, isStatic: false, out Body body);
        var corners = new Vector2[outline.Length];
        for (int i = 0; i < corners.Length; i++)
        {
            corners[i] = new Vector2((float)outline[i].X, (float)outline[i].Y);
        }

        var vertices = new Vertices(corners);
        float cell = GeomFactory.Instance.CalculateGridCellSizeFromAABB(vertices);
        Attach(GeomFactory.Instance.CreatePolygonGeom(_simulator, body, vertices, cell));
        return actor;
    }

    /// <summary>From the centre of a body to the origin.</summary>
    public void AddFixedSpring(Actor actor, double restLength, double stiffness, double damping)
    {
        FixedLinearSpring spring = SpringFactory.Instance.CreateFixedLinearSpring(
            _simulator, actor.Body, Vector2.Zero, Vector2.Zero, (float)stiffness, (float)damping);
        spring.RestLength = (float)restLength;
    }

    /// <summary>A spring without damping between the centres of two bodies.</summary>
    public void AddPairSpring(Actor a, Actor b, double restLength, double stiffness)
    {
        LinearSpring spring = SpringFactory.Instance.CreateLinearSpring(
            _simulator, a.Body, Vector2.Zero, b.Body, Vector2.Zero, (float)stiffness, 0);
        spring.RestLength = (float)restLength;
    }

    public void Step() => Step(_dt);

    /// <summary>A step of another length; <see cref="Time"/> does not know of it.</summary>
    public void Step(float dt)
    {
        long start = Stopwatch.GetTimestamp();
        _simulator.Update(dt);
        StepTicks.Add(Stopwatch.GetTimestamp() - start);
        Steps++;
        foreach (Actor actor in _actors)
        {
            Vec p = actor.Position;
            bool sound = Math.Abs(p.X) <= ExplodedBeyond && Math.Abs(p.Y) <= ExplodedBeyond && actor.Enabled;
            if (!sound)
            {
                throw new ExplodedException();
            }
        }
    }

    public void Run(double seconds, Action? afterStep = null) => RunSteps(StepsIn(seconds), afterStep);

    public void RunSteps(int steps, Action? afterStep = null)
    {
        for (int i = 0; i < steps; i++)
        {
            Step();
            afterStep?.Invoke();
        }
    }

    public int StepsIn(double seconds) => (int)Math.Round(seconds / Dt);

    private Actor Add(Vec position, double angle, double mass, double inertia, IReadOnlyList<Vec[]> pieces, bool isStatic, out Body body)
    {
        body = BodyFactory.Instance.CreateBody(_simulator, (float)mass, (float)inertia);
        body.IsStatic = isStatic;

        // The scenes are without damping; the documented default of the drag coefficients is 0.001.
        body.LinearDragCoefficient = 0;
        body.RotationalDragCoefficient = 0;
        body.SetPosition(position.X, position.Y);
        body.Rotation = (float)angle;
        var actor = new Actor(body, position, angle, mass, inertia, pieces);
        _actors.Add(actor);
        if (!isStatic)
        {
            _dynamicCount++;
        }

        return actor;
    }

    private void Attach(Geom geom)
    {
        _made.Add(geom);
        geom.FrictionCoefficient = (float)Friction;
        geom.RestitutionCoefficient = (float)Restitution;
    }
}
