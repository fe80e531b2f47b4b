using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Tests.Regression;

/// <summary>
/// Bodies of 7 g to 3 kg that hinges, welds and slides hold together as chance has it, with levers up to three times their size and limits
/// that leave next to no way, on a floor, and four boxes that fall on them. Nothing bounces or drives: energy may only fall.
/// </summary>
internal sealed class LinkageUnderBoxes : IDisposable
{
    public const float Gravity = 10;
    private const float LongestLever = 3;

    private readonly Random _random;
    private readonly List<Body> _bodies = new List<Body>();

    public LinkageUnderBoxes(int seed)
    {
        _random = new Random(seed);
        Simulator = new PhysicsSimulator(new Vector2(0, -Gravity)) { Iterations = _random.Next(1, 6) };
        Sandbox.Box(Simulator, new Vector2(0, -3), 3000, 6).Body.IsStatic = true;
        int count = _random.Next(2, 7);
        for (int i = 0; i < count; i++)
        {
            Body body = AddBody(
                new Vector2(-3 + (1.5f * i), 1 + Between(0, 2)), Between(0.3f, 1.4f), Between(0.2f, 0.8f), MathF.Exp(Between(-5, 1)));
            body.LinearVelocity = new Vector2(Between(-5, 5), Between(-5, 5));
        }

        for (int i = 1; i < count; i++)
        {
            int parent = _random.Next(i);
            Tie(_bodies[parent], _bodies[i]);
            if (i > 1 && _random.Next(5) == 0)
            {
                Tie(_bodies[(parent + 1) % i], _bodies[i]);
            }
        }

        for (int chances = 2; chances <= 4; chances += 2)
        {
            if (_random.Next(chances) == 0)
            {
                Fix(_bodies[_random.Next(count)]);
            }
        }

        for (int i = 0; i < 4; i++)
        {
            AddBody(new Vector2(Between(-4, 6), 4 + i), 0.5f, 0.5f, Between(0.1f, 2));
        }
    }

    public PhysicsSimulator Simulator { get; }

    public double Energy => Energies.Whole(_bodies, Gravity);

    public double Weight => Energies.Weight(_bodies, Gravity);

    public void Dispose() => Simulator.Dispose();

    private Body AddBody(Vector2 place, float width, float height, float mass)
    {
        Geom geom = Sandbox.Box(Simulator, place, width, height, mass);
        geom.RestitutionCoefficient = 0;
        geom.FrictionCoefficient = Between(0, 1);
        _bodies.Add(geom.Body);
        return geom.Body;
    }

    private void Tie(Body a, Body b)
    {
        Vector2 anchor = a.Position + Lever();
        Simulator.Add(_random.Next(4) switch
        {
            0 => new RevoluteJoint(a, b, anchor),
            1 => new WeldJoint(a, b, anchor),
            2 => new PrismaticJoint(a, b, anchor, Direction()),
            _ => new PrismaticJoint(a, b, anchor, Direction())
            {
                AreLimitsEnabled = true, LowerLimit = 0, UpperLimit = _random.Next(2) * Between(0, 0.2f),
            },
        });
    }

    private void Fix(Body body)
    {
        Vector2 anchor = body.Position + Lever();
        Simulator.Add(_random.Next(2) == 0 ? new FixedRevoluteJoint(body, anchor) : new FixedPrismaticJoint(body, anchor, Direction()));
    }

    private Vector2 Lever() => MathF.Exp(Between(0, MathF.Log(LongestLever))) * Direction();

    private Vector2 Direction()
    {
        float angle = Between(0, MathF.Tau);
        return new Vector2(MathF.Cos(angle), MathF.Sin(angle));
    }

    private float Between(float low, float high) => low + ((high - low) * (float)_random.NextDouble());
}
