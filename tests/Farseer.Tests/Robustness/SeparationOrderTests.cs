using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>
/// A geom hears that another has parted only if it heard before that they touch, whatever leaves in whichever handler: what a pair of
/// boxes was accepted for may be gone when its contact is told.
/// </summary>
public class SeparationOrderTests
{
    private const int Geoms = 6;

    private static readonly Dictionary<string, Action<PhysicsSimulator, Geom>> _deeds = new(StringComparer.Ordinal)
    {
        ["dispose the body"] = (_, g) => g.Body.Dispose(),
        ["dispose the geom"] = (_, g) => g.Dispose(),
        ["remove the body"] = (s, g) => s.Remove(g.Body),
        ["remove the geom"] = (s, g) => s.Remove(g),
        ["dispose and add another"] = (s, g) =>
        {
            g.Body.Dispose();
            GeomFactory.Instance.CreateCircleGeom(s, BodyFactory.Instance.CreateCircleBody(s, 1, 1), 1, 12);
        },
    };

    public static TheoryData<string> Colliders => new() { "SelectiveSweep", "SweepAndPrune", "Grid", "BruteForce" };

    [Theory]
    [MemberData(nameof(Colliders))]
    public void Separation_WhateverLeavesInAnyHandler_ComesAfterItsCollision(string collider)
    {
        foreach ((string deed, Action<PhysicsSimulator, Geom> act) in _deeds)
        {
            foreach (string place in new[] { "broad phase", "collision", "separation" })
            {
                for (int call = 0; call < 12; call++)
                {
                    string which = $"{deed} in call {call} of {place}";
                    Run(collider, place, call, act, which);
                }
            }
        }
    }

    private static void Run(string collider, string place, int call, Action<PhysicsSimulator, Geom> act, string which)
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, 10));
        simulator.BroadPhaseCollider = collider switch
        {
            "SelectiveSweep" => new SelectiveSweepCollider(simulator),
            "SweepAndPrune" => new SweepAndPruneCollider(simulator),
            "Grid" => new GridCollider(simulator),
            _ => new BruteForceCollider(simulator),
        };
        var geoms = new List<Geom>();
        var touching = new HashSet<(Geom, Geom)>();
        var wrong = new List<string>();
        int calls = 0;
        void Count(string at)
        {
            // Another one each time, some of them of the very pair that is told of.
            if (at == place && calls++ == call)
            {
                act(simulator, geoms[call % Geoms]);
            }
        }

        simulator.BroadPhaseCollider.OnBroadPhaseCollision += (_, _) =>
        {
            Count("broad phase");
            return true;
        };
        for (int i = 0; i < Geoms; i++)
        {
            Body body = BodyFactory.Instance.CreateCircleBody(simulator, 1, 1);
            body.Position = new Vector2(0.8f * i, i % 2 * 1.2f);
            body.LinearVelocity = new Vector2(i % 3 == 0 ? 3 : -3, 0);
            Geom geom = i % 3 == 2
                ? GeomFactory.Instance.CreateRectangleGeom(simulator, body, 2, 2)
                : GeomFactory.Instance.CreateCircleGeom(simulator, body, 1, 16);
            geom.OnCollision += (a, b, _) =>
            {
                touching.Add((a, b));
                Count("collision");
                return true;
            };
            geom.OnSeparation += (a, b) =>
            {
                if (!touching.Remove((a, b)))
                {
                    wrong.Add($"{a.Id} and {b.Id}");
                }

                Count("separation");
            };
            geoms.Add(geom);
        }

        for (int step = 0; step < 40; step++)
        {
            simulator.Update(1f / 60);
        }

        Assert.True(wrong.Count == 0, which + ": parted and never touched: " + string.Join(", ", wrong));
        Assert.True(calls > 0, which);
    }
}
