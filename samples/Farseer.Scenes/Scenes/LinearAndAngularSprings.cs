using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>Linear and angular springs: one that swings undamped, a chain of stiff ones, a torsion bar.</summary>
public sealed class LinearAndAngularSprings : Scene
{
    private const float Stiffness = 40f;
    private const int Links = 8;
    private Geom? _swinging;
    private Geom? _last;
    private Geom? _twisted;
    private double _lowest;

    public override string Name => "springs";

    public override string Title => "Linear and angular springs";

    public override string Description =>
        "A weight swings on a spring without losing energy, a chain of stiff springs hangs by its weight, a bar turns to its angle.";

    public override SceneView View => new(new Vector2(-8f, -14f), new Vector2(8f, 2f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        _lowest = 0;
        _swinging = Make.Box(simulator, new Vector2(-5f, -4f), 1f, 1f);
        FixedLinearSpring swing = SpringFactory.Instance.CreateFixedLinearSpring(
            simulator, _swinging.Body, Vector2.Zero, new Vector2(-5f, 0f), Stiffness, 0f);
        swing.RestLength = 4f;

        Geom? above = null;
        for (int i = 0; i < Links; i++)
        {
            Geom link = Make.Circle(simulator, new Vector2(0f, -1f - i), 0.2f);
            if (above is null)
            {
                SpringFactory.Instance.CreateFixedLinearSpring(simulator, link.Body, Vector2.Zero, Vector2.Zero, 1e6f, 20f);
            }
            else
            {
                SpringFactory.Instance.CreateLinearSpring(simulator, above.Body, Vector2.Zero, link.Body, Vector2.Zero, 1e6f, 20f);
            }

            above = link;
        }

        _last = above;
        _twisted = Make.Box(simulator, new Vector2(5f, -4f), 3f, 0.4f);
        _twisted.Body.IgnoreGravity = true;
        SpringFactory.Instance.CreateFixedAngleSpring(simulator, _twisted.Body, 30f, 6f).TargetAngle = 1f;
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt) =>
        _lowest = Math.Min(_lowest, _swinging?.Body.PositionY ?? 0);

    public override IReadOnlyList<SceneOutcome> Check()
    {
        Body swinging = _swinging!.Body;

        // Released at the spring's rest length it swings by m g / k about m g / k below; 10 s later it is where the cosine says.
        double sag = Make.Gravity / Stiffness;
        double time = Steps * (double)Dt;
        double due = -4.0 - (sag * (1.0 - Math.Cos(Math.Sqrt(Stiffness) * time)));
        return
        [
            SceneOutcome.Error("height of the swinging weight (m)", swinging.PositionY, due, 1e-3),
            SceneOutcome.Error("its lowest point (m)", _lowest, -4.0 - (2.0 * sag), 1e-3),

            // 8 links stretch stiff springs by less than a hundredth of a millimetre in all.
            SceneOutcome.Error("end of the chain (m)", _last!.Body.PositionY, -Links, 1e-3),
            SceneOutcome.Error("angle of the bar (rad)", _twisted!.Body.TotalRotation, 1.0, 1e-3),
        ];
    }
}
