using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>A tank on one endless track of hinged links around driven wheels.</summary>
public sealed class TankTrack : Scene
{
    private const float WheelRadius = 0.5f;
    private const float HalfBase = 1.5f;
    private const float Thickness = 0.1f;

    /// <summary>Between the wheels and the track as it is made: a tight track jams.</summary>
    private const float Slack = 0.06f;
    private const int Links = 38;
    private const float Spin = -4f;
    private readonly List<Body> _wheels = [];
    private Path? _track;
    private Body? _hull;
    private double _worst;
    private double _furthest;

    public override string Name => "track";

    public override string Title => "Tank track";

    public override string Description =>
        "Driven wheels in a track of 38 hinged links: the tank drives off, and the track stays around its wheels.";

    public override SceneView View => new(new Vector2(-5f, -2f), new Vector2(25f, 6f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        simulator.Iterations = 20;
        _wheels.Clear();
        Geom floor = Make.Floor(simulator, 80f, 20f, 0.9f);
        floor.CollisionCategories = CollisionCategory.Cat1;
        float height = WheelRadius + Thickness;

        Geom hull = Make.Box(simulator, new Vector2(0f, height + 0.2f), 3f, 0.5f);
        hull.CollisionCategories = CollisionCategory.Cat3;
        hull.CollidesWith = CollisionCategory.Cat1;
        _hull = hull.Body;
        _hull.Mass = 10f;
        _hull.MomentOfInertia = 10f * ((3f * 3f) + (0.5f * 0.5f)) / 12f;
        for (int i = -1; i <= 1; i++)
        {
            Geom wheel = Make.Circle(simulator, new Vector2(i * HalfBase, height), WheelRadius, 0.9f);
            wheel.CollisionCategories = CollisionCategory.Cat3;
            wheel.CollidesWith = CollisionCategory.Cat2;
            _wheels.Add(wheel.Body);
            RevoluteJoint axle = JointFactory.Instance.CreateRevoluteJoint(simulator, _hull, wheel.Body, wheel.Body.Position);
            axle.IsMotorEnabled = true;
            axle.MotorSpeed = Spin;
            axle.MaxMotorTorque = 200f;
        }

        _track = ComplexFactory.Instance.CreateTrack(Around(height), 0.2578f, Thickness, 0.3f, true, 1, LinkType.RevoluteJoint);
        Chains.Harden(_track);
        Chains.SetFriction(_track, 0.9f);
        foreach (Geom link in _track.Geoms)
        {
            link.CollisionCategories = CollisionCategory.Cat2;
            link.CollidesWith = CollisionCategory.Cat1 | CollisionCategory.Cat3;
        }

        _track.AddToPhysicsSimulator(simulator);
        _worst = 0.0;
        _furthest = 0.0;
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        _worst = Math.Max(_worst, Chains.WidestGap(_track!));
        foreach (Body link in _track!.Bodies)
        {
            _furthest = Math.Max(_furthest, (link.Position - _hull!.Position).Length());
        }
    }

    public override IReadOnlyList<SceneOutcome> Check() =>
    [
        SceneOutcome.Exactly("links", _track!.Bodies.Count, Links),
        SceneOutcome.Exactly("hinges", _track.Joints.Count, Links),

        // A link that is stopped on its way between wheel and ground leaves its neighbours for one step: 22 mm, once; 0.3 mm else.
        SceneOutcome.AtMost("widest gap of a hinge (m)", _worst, 0.05),
        SceneOutcome.AtMost("widest gap at the end (m)", Chains.WidestGap(_track), 1e-3),
        SceneOutcome.AtMost("link furthest from the hull (m)", _furthest, 3.0),

        // The wheels roll in the track, which lies on the ground: as far as their rims turn.
        SceneOutcome.Error("way of the hull (m)", _hull!.Position.X, -Spin * WheelRadius * Steps * (double)Dt, 1.0),
        SceneOutcome.AtMost("tilt of the hull (rad)", Math.Abs(Measure.Angle(_hull)), 0.1),
    ];

    /// <summary>Points of the track's middle line, a stadium around the outer wheels, from the middle of its top and back to it.</summary>
    private static Vertices Around(float height)
    {
        const double Middle = WheelRadius + (0.5 * Thickness) + Slack;
        Vertices points = [];
        for (int i = 0; i <= 4; i++)
        {
            points.Add(new Vector2(HalfBase * i / 4f, height + (float)Middle));
        }

        Bend(points, HalfBase, 0.5, height, Middle);
        for (int i = 1; i <= 8; i++)
        {
            points.Add(new Vector2(HalfBase - (2f * HalfBase * i / 8f), height - (float)Middle));
        }

        Bend(points, -HalfBase, -0.5, height, Middle);
        for (int i = 1; i <= 4; i++)
        {
            points.Add(new Vector2(-HalfBase + (HalfBase * i / 4f), height + (float)Middle));
        }

        return points;
    }

    private static void Bend(Vertices points, float centre, double from, float height, double radius)
    {
        for (int i = 1; i <= 8; i++)
        {
            double angle = Math.PI * (from - (i / 8.0));
            points.Add(new Vector2(centre + (float)(radius * Math.Cos(angle)), height + (float)(radius * Math.Sin(angle))));
        }
    }
}
