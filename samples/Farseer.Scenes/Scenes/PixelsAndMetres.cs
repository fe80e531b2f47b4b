using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes;

/// <summary>The same scene in metres and in pixels, 64 of them a metre: the engine has no unit of its own.</summary>
public sealed class PixelsAndMetres : Scene
{
    // A power of two: then every figure of the pixel world is the other's with another exponent, and equality can be exact.
    private const float Pixels = 64f;
    private const int Count = 12;

    // What comes to rest fades through the smallest floats there are, which lose a digit with every halving.
    private const float Vanishing = 1e-30f;
    private readonly List<Geom> _metres = [];
    private readonly List<Geom> _pixels = [];
    private PhysicsSimulator? _world;
    private int _unequal;

    public override string Name => "pixels-and-metres";

    public override string Title => "Pixels and metres side by side";

    public override string Description => "A heap in metres and its twin in pixels (64 a metre): the same figures, bit for bit, times 64.";

    public override SceneView View => new(new Vector2(-6f, -1f), new Vector2(18f, 10f));

    public override IReadOnlyList<SceneCompanion> Companions =>
        _world is null ? [] : [new SceneCompanion(_world, 0.0, 1f / Pixels, new Vector2(12f, 0f))];

    public override void Build(PhysicsSimulator simulator)
    {
        _world = new PhysicsSimulator { Iterations = simulator.Iterations };
        _unequal = 0;
        Fill(simulator, _metres, 1f);
        Fill(_world, _pixels, Pixels);
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        for (int i = 0; i < Count; i++)
        {
            Body a = _metres[i].Body;
            Body b = _pixels[i].Body;
            bool same = a.Position * Pixels == b.Position && a.Rotation == b.Rotation
                && Same(a.LinearVelocity.X * Pixels, b.LinearVelocity.X) && Same(a.LinearVelocity.Y * Pixels, b.LinearVelocity.Y)
                && Same(a.AngularVelocity, b.AngularVelocity);
            _unequal += same ? 0 : 1;
        }

        _world!.Update(dt);
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double upOrDown = 0.0;
        foreach (Geom geom in _metres)
        {
            upOrDown = Math.Max(upOrDown, Math.Abs(geom.Body.LinearVelocity.Y));
        }

        return
        [
            SceneOutcome.Exactly("states that differ by one bit or more", _unequal, 0),

            // Sideways the round ones may roll for as long as they like: nothing in the scene brakes them.
            SceneOutcome.AtMost("fastest up or down at the end (m/s)", upOrDown, 0.01),
        ];
    }

    private static bool Same(float a, float b) => a == b || Math.Max(Math.Abs(a), Math.Abs(b)) < Vanishing;

    private static void Fill(PhysicsSimulator simulator, List<Geom> geoms, float unit)
    {
        simulator.Gravity = new Vector2(0f, -Make.Gravity * unit);
        Make.Wall(simulator, new Vector2(0f, -0.5f) * unit, 10f * unit, 1f * unit);
        Make.Wall(simulator, new Vector2(-5f, 1f) * unit, 0.5f * unit, 2f * unit);
        Make.Wall(simulator, new Vector2(5f, 1f) * unit, 0.5f * unit, 2f * unit);
        geoms.Clear();
        for (int i = 0; i < Count; i++)
        {
            Vector2 position = new Vector2(0.4f * ((i * 5 % 7) - 3), 0.8f + (0.7f * i)) * unit;
            Geom geom = (i & 1) == 0
                ? Make.Box(simulator, position, 1f * unit, 0.6f * unit)
                : Make.Circle(simulator, position, 0.35f * unit);

            // Mass and inertia do not scale with the drawing: the same weight on another map.
            geom.Body.Mass = 1f;
            geom.Body.MomentOfInertia = 0.1f * unit * unit;
            geoms.Add(geom);
        }
    }
}
