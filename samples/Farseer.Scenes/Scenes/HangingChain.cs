using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>A chain of the factory, nailed at one end and let go from the side: it swings and whips, and stays a chain.</summary>
public sealed class HangingChain : Scene
{
    private const int Links = 20;
    private const float Length = 0.5f;
    private PhysicsSimulator? _simulator;
    private Path? _chain;
    private double _worst;
    private double _start;

    public override string Name => "chain";

    public override string Title => "Hanging chain";

    public override string Description =>
        "20 links of the factory on a nail swing for 10 seconds: no hinge opens, and the energy stays what it was.";

    public override SceneView View => new(new Vector2(-11f, -11f), new Vector2(11f, 5f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        _simulator = simulator;
        _chain = ComplexFactory.Instance.CreateChain(
            simulator,
            Vector2.Zero,
            new Vector2(0.8f * Links * Length, -0.6f * Links * Length),
            Length,
            0.15f,
            0.2f,
            true,
            false,
            1,
            LinkType.RevoluteJoint);
        Chains.Harden(_chain);
        _worst = 0.0;
        _start = 0.0;
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        _worst = Math.Max(_worst, Chains.WidestGap(_chain!));
        _start = step == 1 ? Measure.Energy(simulator) : _start;
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double fall = 0.4 * 0.5 * Links * 0.2 * Make.Gravity * Links * Length;
        return
        [
            SceneOutcome.Exactly("links", _chain!.Bodies.Count, Links),
            SceneOutcome.Exactly("hinges and the nail", _chain.Joints.Count, Links),
            
            // 2.7e-9 and 4.7e-6 when they were measured.
            SceneOutcome.AtMost("widest gap of a hinge (m)", _worst, 1e-6),
            SceneOutcome.Error("energy (share of that of the fall)", (Measure.Energy(_simulator!) - _start) / fall, 0.0, 1e-3),
        ];
    }
}
