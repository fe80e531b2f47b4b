using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Benchmarks.Jointed;

/// <summary>Small worlds of the kind that games of the original have: pixels, y down, default dials.</summary>
internal static class JointedScenes
{
    private const float Gravity = 50;

    /// <summary>A hub on eight legs of ten parts: 80 hinges, 48 angle joints that stretch the legs, springs to the feet.</summary>
    public static PhysicsSimulator Spider()
    {
        const int Legs = 8;
        const int Parts = 10;
        const float Part = 14;
        PhysicsSimulator simulator = WithFloor();
        Geom hub = Circle(simulator, new Vector2(0, -150), 20, 10);
        for (int leg = 0; leg < Legs; leg++)
        {
            double angle = Math.PI * (leg + 0.5) / Legs;
            var along = new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle));
            Body before = hub.Body;
            for (int part = 0; part < Parts; part++)
            {
                Vector2 start = hub.Body.Position + (along * (20 + (part * Part)));
                Body link = Bar(simulator, start + (along * (Part / 2)), (float)angle, Part, 4);
                JointFactory.Instance.CreateRevoluteJoint(simulator, before, link, start);
                if (part < 6)
                {
                    FarseerGames.FarseerPhysics.Dynamics.Joints.AngleJoint stiff =
                        JointFactory.Instance.CreateAngleJoint(simulator, before, link);
                    stiff.TargetAngle = link.Rotation - before.Rotation;
                    stiff.Softness = 0.1f;
                }

                before = link;
            }

            SpringFactory.Instance.CreateLinearSpring(simulator, hub.Body, Vector2.Zero, before, Vector2.Zero, 20, 2);
        }

        return simulator;
    }

    /// <summary>A track of links around two wheels on a chassis, dropped on the floor.</summary>
    public static PhysicsSimulator Track()
    {
        const float Radius = 30;
        PhysicsSimulator simulator = WithFloor();
        Body chassis = Bar(simulator, new Vector2(0, -80), 0, 120, 20);
        foreach (float x in new[] { -60f, 60 })
        {
            Geom wheel = Circle(simulator, new Vector2(x, -80), Radius - 6, 4);
            JointFactory.Instance.CreateRevoluteJoint(simulator, chassis, wheel.Body, wheel.Body.Position);
        }

        var around = new List<Vector2>();
        for (int i = 0; i < 32; i++)
        {
            double angle = 2 * Math.PI * i / 32;
            float side = Math.Cos(angle) < 0 ? -60 : 60;
            around.Add(new Vector2(side + (Radius * (float)Math.Cos(angle)), -80 + (Radius * (float)Math.Sin(angle))));
        }

        ComplexFactory.Instance.CreateTrack(simulator, new Vertices(around.ToArray()), 8, 4, 0.3f, true, 1, LinkType.RevoluteJoint);
        return simulator;
    }

    /// <summary>A ring of balls that springs hold to their neighbours, to the next but one and to a hub.</summary>
    public static PhysicsSimulator SoftBody()
    {
        const int Balls = 60;
        const float Radius = 70;
        PhysicsSimulator simulator = WithFloor();
        Geom hub = Circle(simulator, new Vector2(0, -120), 10, 5);
        var ring = new Body[Balls];
        for (int i = 0; i < Balls; i++)
        {
            double angle = 2 * Math.PI * i / Balls;
            ring[i] = Circle(
                simulator, hub.Body.Position + (Radius * new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle))), 3, 0.5f).Body;
        }

        for (int i = 0; i < Balls; i++)
        {
            Tie(ring[i], ring[(i + 1) % Balls]);
            Tie(ring[i], ring[(i + 2) % Balls]);
            Tie(ring[i], hub.Body);
        }

        return simulator;

        void Tie(Body a, Body b) =>
            SpringFactory.Instance.CreateLinearSpring(simulator, a, Vector2.Zero, b, Vector2.Zero, 300, 5);
    }

    private static PhysicsSimulator WithFloor()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, Gravity));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 2000, 40, 1);
        floor.IsStatic = true;
        floor.Position = new Vector2(0, 20);
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 2000, 40);
        return simulator;
    }

    private static Body Bar(PhysicsSimulator simulator, Vector2 place, float angle, float length, float width)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, length, width, 0.5f);
        body.Position = place;
        body.Rotation = angle;
        GeomFactory.Instance.CreateRectangleGeom(simulator, body, length, width).CollisionGroup = 1;
        return body;
    }

    private static Geom Circle(PhysicsSimulator simulator, Vector2 place, float radius, float mass)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, radius, mass);
        body.Position = place;
        return GeomFactory.Instance.CreateCircleGeom(simulator, body, radius, 12);
    }
}
