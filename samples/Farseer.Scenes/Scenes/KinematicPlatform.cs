using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes;

/// <summary>A shuttle and a lift, both driven by velocity: friction and support must carry what stands on them.</summary>
public sealed class KinematicPlatform : Scene
{
    private const float Amplitude = 1f;

    // 1 m at 1.7 rad/s are 2.9 m/s² at the turning points: below the 5 m/s² that friction 0.5 holds, and below g for the lift.
    private const float Frequency = 1.7f;
    private const float LiftX = 10f;
    private Geom? _shuttle;
    private Geom? _lift;
    private Geom? _rider;
    private Geom? _smooth;
    private Geom? _passenger;
    private double _slip;
    private double _gap;

    public override string Name => "kinematic-platform";

    public override string Title => "Kinematic platforms";

    public override string Description =>
        "A rough box rides a shuttle, a smooth one stays where it is, a third rides a lift without leaving it.";

    public override int Steps => 1200;

    public override float Dt => 1f / 120f;

    public override SceneView View => new(new Vector2(-7f, -2f), new Vector2(12f, 5f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        _shuttle = Make.Box(simulator, new Vector2(0f, -0.25f), 12f, 0.5f, 0f);
        _shuttle.Body.IsKinematic = true;
        _lift = Make.Box(simulator, new Vector2(LiftX, -0.25f), 2f, 0.5f);
        _lift.Body.IsKinematic = true;
        _rider = Make.Box(simulator, new Vector2(2f, 0.5f), 1f, 1f, 1f);

        // Friction of a pair is the mean of the two: 0.5 for the rider on the smooth shuttle, 0 for this one.
        _smooth = Make.Box(simulator, new Vector2(-2f, 0.5f), 1f, 1f, 0f);
        _passenger = Make.Box(simulator, new Vector2(LiftX, 0.5f), 1f, 1f);
        _slip = 0.0;
        _gap = 0.0;
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        // The mean velocity over the coming step, so that the platforms are exactly where the cosine says.
        float velocity = (float)((Path((step + 1) * (double)dt) - Path(step * (double)dt)) / dt);
        _shuttle!.Body.LinearVelocity = new Vector2(velocity, 0f);
        _lift!.Body.LinearVelocity = new Vector2(0f, velocity);
        _slip = Math.Max(_slip, Math.Abs(_rider!.Body.Position.X - _shuttle.Body.Position.X - 2f));
        _gap = Math.Max(_gap, Math.Abs(_passenger!.Body.Position.Y - _lift.Body.Position.Y - 0.75));
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double ideal = Path(Steps * (double)Dt);
        double greatest = Amplitude * Frequency * Frequency;
        double slip = greatest * greatest * Math.PI / (4.0 * Frequency) * Dt / (2.0 * 0.5 * Make.Gravity);
        return
        [
            SceneOutcome.Error("shuttle off its path (m)", _shuttle!.Body.Position.X, ideal, 1e-4),
            SceneOutcome.Error("lift off its path (m)", _lift!.Body.Position.Y + 0.25, ideal, 1e-4),

            // The platform's speed jumps by a·dt a step, and friction takes a·dt / (mu g) to follow: the rider slips by
            // (a dt)² / (2 mu g) a step, which sums over a quarter of the swing to the figure below. Three times that is
            // granted; a rider that is not carried would be left behind by two metres.
            SceneOutcome.AtMost("rider slipped on the shuttle (m)", _slip, 3.0 * slip),
            SceneOutcome.Error("smooth box moved (m)", _smooth!.Body.Position.X, -2.0, 1e-3),
            SceneOutcome.AtMost("passenger off the lift (m)", _gap, Make.Tolerance),
        ];
    }

    /// <summary>Starts at rest, so that nothing is jolted.</summary>
    private static double Path(double time) => Amplitude * (1.0 - Math.Cos(Frequency * time));
}
