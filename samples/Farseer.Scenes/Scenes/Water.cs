using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;

namespace Farseer.Scenes;

/// <summary>Floats on water with waves, in pixels with y down as a wave controller needs it.</summary>
public sealed class Water : Scene
{
    private const float Density = 0.001f;
    private readonly List<Geom> _floats = [];
    private Geom? _stone;
    private int _entered;

    public override string Name => "water";

    public override string Title => "Water with waves and floats";

    public override string Description =>
        "Balls half as dense as water fall in and float half immersed on small waves; a stone sinks to the ground.";

    public override int Steps => 1800;

    public override SceneView View => new(new Vector2(-20f, -200f), new Vector2(620f, 320f));

    public override void Build(PhysicsSimulator simulator)
    {
        simulator.Gravity = new Vector2(0f, 200f);
        _floats.Clear();
        _entered = 0;
        Make.Wall(simulator, new Vector2(300f, 310f), 640f, 20f);
        Make.Wall(simulator, new Vector2(-10f, 100f), 20f, 400f);
        Make.Wall(simulator, new Vector2(610f, 100f), 20f, 400f);
        var wave = new WaveController
        {
            Position = Vector2.Zero,
            Width = 600f,
            Height = 300f,
            NodeCount = 31,
            Frequency = 0.05f,
            WaveGeneratorMin = -60f,
            WaveGeneratorMax = 60f,
            WaveGeneratorStep = 10f,
        };
        wave.Initialize();
        var water = new FluidDragController();
        water.Initialize(wave, Density, 40f, 200f, simulator.Gravity);
        water.Entry += _ => _entered++;
        for (int i = 0; i < 4; i++)
        {
            _floats.Add(Ball(simulator, new Vector2(100f + (130f * i), -120f - (20f * i)), 30f, 0.5f));
            water.AddGeom(_floats[i]);
        }

        _stone = Ball(simulator, new Vector2(300f, -180f), 20f, 3f);
        water.AddGeom(_stone);
        simulator.Add(wave);
        simulator.Add(water);
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double highest = 0.0;
        double deepest = 0.0;
        foreach (Geom ball in _floats)
        {
            highest = Math.Max(highest, -ball.Body.PositionY);
            deepest = Math.Max(deepest, ball.Body.PositionY);
        }

        return
        [
            SceneOutcome.Exactly("things that fell in", _entered, 5),

            // Half as dense as water: the centre floats at the surface, but for waves of a few pixels.
            SceneOutcome.AtMost("highest centre above the surface", highest, 8.0),
            SceneOutcome.AtMost("deepest centre below the surface", deepest, 8.0),
            SceneOutcome.Error("centre of the stone on the ground", _stone!.Body.PositionY, 280.0, 1.0),
        ];
    }

    // Enough vertices for a smooth way in.
    private static Geom Ball(PhysicsSimulator simulator, Vector2 position, float radius, float relativeDensity)
    {
        Geom ball = Make.Circle(simulator, position, radius);
        ball.Body.Mass = relativeDensity * Density * 3.14159265f * radius * radius;
        ball.Body.MomentOfInertia = 0.5f * ball.Body.Mass * radius * radius;
        return ball;
    }
}
