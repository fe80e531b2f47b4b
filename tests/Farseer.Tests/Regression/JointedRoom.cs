using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Tests.Regression;

/// <summary>
/// A closed room in which bodies of several shapes bounce that joints of every kind, their limits and springs hold together as chance has
/// it. Nothing drives them: their energy, that of the springs with it, may only fall.
/// </summary>
internal sealed class JointedRoom : IDisposable
{
    public const float Gravity = 10;

    private readonly Random _random;
    private readonly List<Body> _bodies = new List<Body>();
    private readonly List<LinearSpring> _coils = new List<LinearSpring>();
    private readonly List<AngleSpring> _bars = new List<AngleSpring>();

    public JointedRoom(int seed)
    {
        _random = new Random(seed);
        Simulator = new PhysicsSimulator(new Vector2(0, -Gravity)) { Iterations = _random.Next(1, 6) };
        AddWalls();
        AddBodies();
        Tie();
    }

    public PhysicsSimulator Simulator { get; }

    public double Weight => Energies.Weight(_bodies, Gravity);

    /// <summary>Kinetic and potential energy, J, from the floor on.</summary>
    public double Energy
    {
        get
        {
            double sum = Energies.Whole(_bodies, Gravity);
            foreach (LinearSpring coil in _coils)
            {
                float longer = Vector2.Distance(coil.Anchor1, coil.Anchor2) - coil.RestLength;
                sum += 0.5 * coil.SpringConstant * longer * longer;
            }

            foreach (AngleSpring bar in _bars)
            {
                float bent = bar.Body2!.TotalRotation - bar.Body1!.TotalRotation - bar.TargetAngle;
                sum += 0.5 * bar.SpringConstant * bent * bent;
            }

            return sum;
        }
    }

    public void Dispose() => Simulator.Dispose();

    private void AddWalls()
    {
        foreach (Vector2 place in new[] { new Vector2(0, -3), new Vector2(0, 13), new Vector2(-8, 5), new Vector2(8, 5) })
        {
            Geom wall = Sandbox.Box(Simulator, place, place.X == 0 ? 22 : 6, place.X == 0 ? 6 : 22);
            wall.Body.IsStatic = true;
            wall.RestitutionCoefficient = 0.5f;
        }
    }

    private void AddBodies()
    {
        int count = _random.Next(2, 8);
        for (int i = 0; i < count; i++)
        {
            var place = new Vector2(-3 + (1.2f * (i % 4)), 1 + (1.2f * (i / 4)));
            float mass = Between(0.05f, 2);
            Body body = BodyFactory.Instance.CreateRectangleBody(Simulator, Between(0.3f, 1.4f), Between(0.2f, 0.8f), mass);
            body.Position = place;
            Sandbox.WithoutDrag(body);
            _bodies.Add(body);
            Geom geom = Shape(body);
            geom.RestitutionCoefficient = _random.Next(2) * Between(0, 1);
            geom.FrictionCoefficient = Between(0, 1);
            geom.Body.LinearVelocity = new Vector2(Between(-10, 10), Between(-10, 10));
            geom.Body.AngularVelocity = Between(-5, 5);
        }
    }

    private Geom Shape(Body body) => _random.Next(4) switch
    {
        0 => GeomFactory.Instance.CreateCircleGeom(Simulator, body, Between(0.2f, 0.7f), 16),
        1 => GeomFactory.Instance.CreateCapsuleGeom(
            Simulator, body, new Vector2(Between(0, 0.7f), Between(-0.5f, 0)), new Vector2(Between(0, 0.7f), Between(0, 0.5f)), 0.2f),
        2 => GeomFactory.Instance.CreateRectangleGeom(Simulator, body, Between(0.3f, 1.4f), Between(0.2f, 0.8f)),
        _ => GeomFactory.Instance.CreatePolygonGeom(
            Simulator, body, Sandbox.Outline(Between(0.3f, 0.8f), 0, -0.1f, Between(0.3f, 0.7f), Between(-0.7f, -0.3f), 0.1f, 0, -0.6f), 0),
    };

    private void Tie()
    {
        for (int i = 0; i < _bodies.Count; i++)
        {
            Body body = _bodies[i];
            if (i > 0 && _random.Next(4) != 0)
            {
                Tie(_bodies[i - 1], body);
            }
            else if (_random.Next(6) == 0)
            {
                Simulator.Add(new FixedRevoluteJoint(body, body.Position + new Vector2(Between(-1, 1), Between(0, 1))));
            }

            if (i > 1 && _random.Next(8) == 0)
            {
                Tie(_bodies[i - 2], body);
            }
        }
    }

    private void Tie(Body a, Body b)
    {
        Vector2 anchor = 0.5f * (a.Position + b.Position);
        var inA = new Vector2(Between(-0.3f, 0.3f), Between(-0.3f, 0.3f));
        var inB = new Vector2(Between(-0.3f, 0.3f), Between(-0.3f, 0.3f));
        float distance = Vector2.Distance(a.Position + inA, b.Position + inB);
        switch (_random.Next(18))
        {
            case 0:
            case 1:
                Simulator.Add(new RevoluteJoint(a, b, anchor));
                break;
            case 2:
            case 3:
                Simulator.Add(new RevoluteJoint(a, b, anchor)
                {
                    AreLimitsEnabled = true, LowerLimit = Between(-1, 0), UpperLimit = Between(0, 1),
                });
                break;
            case 4:
                Simulator.Add(new PinJoint(a, inA, b, inB));
                break;
            case 5:
                Simulator.Add(new SliderJoint(a, inA, b, inB, 0.5f * distance, 1.2f * distance));
                break;
            case 6:
                Simulator.Add(new AngleLimitJoint(a, b, Between(-2, 0), Between(0, 2)));
                break;
            case 7:
                Simulator.Add(new RopeJoint(a, inA, b, inB, 1.1f * distance));
                break;
            case 8:
                Simulator.Add(new WeldJoint(a, b, anchor));
                break;
            case 9:
                Simulator.Add(new PrismaticJoint(a, b, anchor, Vector2.UnitX)
                {
                    AreLimitsEnabled = true, LowerLimit = Between(-1, 0), UpperLimit = Between(0, 1),
                });
                break;
            case 10:
                Simulator.Add(new AngleJoint(a, b));
                break;
            case 11:
                Simulator.Add(new RevoluteJoint(a, b, anchor));
                Simulator.Add(new AngleLimitJoint(a, b, Between(-1, 0), Between(0, 1)));
                break;
            case 12:
                Simulator.Add(new GearJoint(a, b, Between(0.5f, 2)));
                break;
            case 13:
                Simulator.Add(new DistanceJoint(a, inA, b, inB)
                {
                    AreLimitsEnabled = true, LowerLimit = 0.7f * distance, UpperLimit = 1.1f * distance,
                });
                break;
            case 14:
                Simulator.Add(new FixedPrismaticJoint(b, b.Position, Vector2.UnitX)
                {
                    AreLimitsEnabled = true, LowerLimit = Between(-1, 0), UpperLimit = Between(0, 1),
                });
                break;
            case 15:
                Simulator.Add(new FixedAngleLimitJoint(b, Between(-1, 0), Between(0, 1)));
                break;
            case 16:
                var coil = new LinearSpring(a, inA, b, inB, Between(1, 300), Between(0, 3));
                _coils.Add(coil);
                Simulator.Add(coil);
                break;
            default:
                var bar = new AngleSpring(a, b, Between(0.1f, 20), Between(0, 0.3f));
                _bars.Add(bar);
                Simulator.Add(bar);
                break;
        }
    }

    private float Between(float low, float high) => low + ((high - low) * (float)_random.NextDouble());
}
