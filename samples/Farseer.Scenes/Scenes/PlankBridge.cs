using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>A hanging bridge of 30 planks, nailed at both ends, that carries a hundred times the weight of a plank.</summary>
public sealed class PlankBridge : Scene
{
    private const int Planks = 30;
    private const float Width = 0.97f;
    private const float PlankMass = 10f;
    private const float Load = 100f * PlankMass;
    private Path? _bridge;
    private Body? _load;
    private FixedRevoluteJoint? _left;
    private double _worst;

    public override string Name => "bridge";

    public override string Title => "Bridge of planks";

    public override string Description =>
        "30 planks between two nails carry a box of 100 times a plank's weight: no hinge opens, the nails bear it all.";

    // The load lands and swings with the bridge: after 20 s by 0.04 to 0.055 m/s, however fine the steps, after 40 s by 0.03 at most.
    public override int Steps => 2400;

    public override SceneView View => new(new Vector2(-16f, -9f), new Vector2(16f, 5f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);

        // Taut between two nails and under a load of a hundred planks the bridge needs more than the usual 5 iterations.
        simulator.Iterations = 20;
        Vertices points = [new(-14.4f, 0f), new(0f, -3f), new(14.4f, 0f)];
        _bridge = ComplexFactory.Instance.CreateTrack(points, Width, 0.2f, PlankMass, false, 1, LinkType.RevoluteJoint);
        _left = Chains.Nail(_bridge, _bridge.Bodies[0], points[0]);
        Chains.Nail(_bridge, _bridge.Bodies[^1], _bridge.ControlPoints[2]);
        Chains.Harden(_bridge);
        Chains.SetFriction(_bridge, 0.8f);
        foreach (Body plank in _bridge.Bodies)
        {
            plank.LinearDragCoefficient = 5f;
            plank.RotationalDragCoefficient = 5f;
        }

        _bridge.AddToPhysicsSimulator(simulator);
        Geom box = Make.Box(simulator, new Vector2(0f, -1.9f), 3f, 1.5f, 0.8f);
        box.Body.Mass = Load;
        box.Body.MomentOfInertia = Load * ((3f * 3f) + (1.5f * 1.5f)) / 12f;
        _load = box.Body;
        _worst = 0.0;
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt) => _worst = Math.Max(_worst, Chains.WidestGap(_bridge!));

    public override IReadOnlyList<SceneOutcome> Check()
    {
        // Statics: about the right nail, the force of the left one and all the weights are in balance.
        Vector2 right = _bridge!.ControlPoints[2];
        Vector2 arm = _left!.Anchor - right;
        Vector2 pull = _left.ReactionForce;
        double borne = Math.Abs((arm.X * (double)pull.Y) - (arm.Y * (double)pull.X));
        double weights = Load * Make.Gravity * (right.X - _load!.Position.X);
        foreach (Body plank in _bridge.Bodies)
        {
            weights += PlankMass * Make.Gravity * (right.X - plank.Position.X);
        }

        return
        [
            SceneOutcome.Exactly("planks", _bridge.Bodies.Count, Planks),
            // 1.6e-7 when it was measured.
            SceneOutcome.AtMost("widest gap of a hinge (m)", _worst, 1e-5),
            SceneOutcome.Error("moment of the left nail about the right one, to that of the weights", borne / weights, 1.0, 0.02),
            SceneOutcome.AtMost("speed of the load (m/s)", _load.LinearVelocity.Length(), 0.05),
            SceneOutcome.AtLeast("height of the load (m)", _load.Position.Y, -7.0),
        ];
    }
}
