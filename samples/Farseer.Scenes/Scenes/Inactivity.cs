using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes;

/// <summary>The inactivity controller with a thousand bodies.</summary>
public sealed class Inactivity : Scene
{
    private const int Columns = 40;
    private const int Rows = 25;
    private readonly List<Geom> _balls = [];
    private PhysicsSimulator? _simulator;
    private Geom? _striker;
    private int _atRest;
    private int _afterStrike;

    public override string Name => "inactivity";

    public override string Title => "A thousand bodies at rest";

    public override string Description =>
        "1,000 balls lie still and are disabled; one that is shot through them wakes only those near its way, and all go to rest again.";

    public override SceneView View => new(new Vector2(-40f, -20f), new Vector2(840f, 520f));

    public override void Build(PhysicsSimulator simulator)
    {
        _simulator = simulator;
        simulator.Gravity = Vector2.Zero;
        simulator.InactivityController.Enabled = true;
        simulator.InactivityController.MaxIdleTime = 1000f;
        simulator.InactivityController.ActivationDistance = 60f;
        _balls.Clear();
        for (int i = 0; i < Columns * Rows; i++)
        {
            Geom ball = Make.Circle(simulator, new Vector2(20f * (i % Columns), 20f * (i / Columns)), 6f);
            ball.Body.Mass = 1f;
            ball.Body.LinearDragCoefficient = 2f;
            ball.Body.RotationalDragCoefficient = 2f;
            ball.Body.MinimumVelocity = 10f;
            ball.Body.IsAutoIdle = true;
            _balls.Add(ball);
        }

        _striker = _balls[0];
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        if (step == 90)
        {
            _atRest = simulator.InactivityController.BodiesEnabled;
            _striker!.Body.Enabled = true;
            _striker.Body.LinearVelocity = new Vector2(600f, 40f);
        }
        else if (step == 120)
        {
            _afterStrike = simulator.InactivityController.BodiesEnabled;
        }
    }

    public override IReadOnlyList<SceneOutcome> Check() =>
    [
        SceneOutcome.Exactly("enabled after 1.5 s", _atRest, 0),
        SceneOutcome.AtLeast("enabled half a second after the shot", _afterStrike, 5),
        SceneOutcome.AtMost("enabled half a second after the shot", _afterStrike, 400),
        SceneOutcome.Exactly("enabled at the end", _simulator!.InactivityController.BodiesEnabled, 0),
    ];
}
