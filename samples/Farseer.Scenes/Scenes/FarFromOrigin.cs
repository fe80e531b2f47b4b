using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes;

/// <summary>The same tumbling heap at the origin and a thousand kilometres away.</summary>
public sealed class FarFromOrigin : Scene
{
    private const double Far = 1e6;
    private const int Count = 6;
    private readonly List<Geom> _near = [];
    private readonly List<Geom> _distant = [];
    private PhysicsSimulator? _world;

    public override string Name => "far-from-origin";

    public override string Title => "Far from the origin";

    public override string Description => "One heap of boxes at x = 0, its twin at x = 1 000 000 m: they do the same.";

    public override SceneView View => new(new Vector2(-5f, -1f), new Vector2(15f, 9f));

    public override IReadOnlyList<SceneCompanion> Companions =>
        _world is null ? [] : [new SceneCompanion(_world, -Far, 1f, new Vector2(10f, 0f))];

    public override void Build(PhysicsSimulator simulator)
    {
        _world = new PhysicsSimulator { Iterations = simulator.Iterations };
        Fill(simulator, _near, 0.0);
        Fill(_world, _distant, Far);
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt) => _world!.Update(dt);

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double apart = 0.0;
        double turned = 0.0;
        for (int i = 0; i < Count; i++)
        {
            Body near = _near[i].Body;
            Body far = _distant[i].Body;
            apart = Math.Max(apart, Math.Abs(far.PositionX - Far - near.PositionX));
            apart = Math.Max(apart, Math.Abs(far.PositionY - near.PositionY));
            turned = Math.Max(turned, Math.Abs(far.TotalRotation - near.TotalRotation));
        }

        return
        [
            // A double at 1e6 has steps of 1e-10 m; ten seconds of falling and leaning make more of them, but not a tenth of a millimetre.
            SceneOutcome.AtMost("position against the twin (m)", apart, 1e-4),
            SceneOutcome.AtMost("turn against the twin (rad)", turned, 1e-4),
            SceneOutcome.AtMost("fastest point at the end (m/s)", Measure.FastestSpeed(_distant), 5e-3),
        ];
    }

    private static void Fill(PhysicsSimulator simulator, List<Geom> boxes, double x)
    {
        Make.Metres(simulator);
        Geom floor = Make.Floor(simulator, 8f);
        floor.Body.SetPosition(x, -0.5);
        boxes.Clear();
        for (int i = 0; i < Count; i++)
        {
            Geom box = Make.Box(simulator, new Vector2(0f, 0.7f + (1.3f * i)), 1f, 1f);

            // Each a little to one side, or nothing would tell a right place from a rounded one.
            box.Body.SetPosition(x + (0.125 * (i & 1)), 0.7 + (1.3 * i));
            boxes.Add(box);
        }
    }
}
