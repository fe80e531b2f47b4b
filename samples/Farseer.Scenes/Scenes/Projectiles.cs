using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes;

/// <summary>Three throws: through vacuum, through air with linear drag, and with a spin that drag does not touch.</summary>
public sealed class Projectiles : Scene
{
    private const float Drag = 0.5f;
    private const float Spin = 7f;
    private static readonly Vector2 _launch = new(6f, 12f);
    private Geom? _free;
    private Geom? _dragged;

    public override string Name => "projectiles";

    public override string Title => "Projectiles";

    public override string Description => "Throws with and without air: free flight is the parabola, drag its exponential.";

    public override int Steps => 120;

    public override SceneView View => new(new Vector2(-1f, -1f), new Vector2(14f, 10f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        _free = Make.Box(simulator, Vector2.Zero, 0.6f, 0.3f);
        _free.Body.LinearVelocity = _launch;
        _free.Body.AngularVelocity = Spin;
        _dragged = Make.Circle(simulator, Vector2.Zero, 0.3f);
        _dragged.Body.LinearVelocity = _launch;
        _dragged.Body.LinearDragCoefficient = Drag;
        _free.CollisionGroup = 1;
        _dragged.CollisionGroup = 1;
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double t = Steps * (double)Dt;
        double freeX = _launch.X * t;
        double freeY = (_launch.Y * t) - (0.5 * Make.Gravity * t * t);
        Vector2 free = _free!.Body.Position;

        // v' = g - k v with k = c / m: v = g/k + (v0 - g/k) exp(-k t), and x its integral.
        double k = Drag / _dragged!.Body.Mass;
        double decay = (1.0 - Math.Exp(-k * t)) / k;
        double terminal = -Make.Gravity / k;
        double draggedX = _launch.X * decay;
        double draggedY = (terminal * t) + ((_launch.Y - terminal) * decay);
        Vector2 dragged = _dragged.Body.Position;
        return
        [
            // Float velocities round 120 times at 12 m/s: about 1e-6 m/s each, over two seconds.
            SceneOutcome.AtMost("free flight off the parabola (m)", Distance(free, freeX, freeY), 1e-4),

            // The engine puts gravity and drag together step by step.
            SceneOutcome.AtMost("drag flight off its closed form (m)", Distance(dragged, draggedX, draggedY), 1e-2),
            SceneOutcome.Error("turn of the spinning box (rad)", _free.Body.TotalRotation, Spin * t, 1e-4),
        ];
    }

    private static double Distance(Vector2 position, double x, double y) =>
        Math.Sqrt(((position.X - x) * (position.X - x)) + ((position.Y - y) * (position.Y - y)));
}
