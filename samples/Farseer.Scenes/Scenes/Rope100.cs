using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>A rope of 100 light links with a weight of a hundred times their sum, let go from the side.</summary>
public sealed class Rope100 : Scene
{
    private const int Links = 100;
    private const float Width = 0.2f;
    private const float LinkMass = 0.1f;
    private const float Weight = 1000f;
    private Path? _rope;
    private Body? _weight;
    private double _worst;
    private double _longest;
    private double _highest;

    public override string Name => "rope-100";

    public override string Title => "Rope of 100 links";

    public override string Description => "A weight of 1,000 kg swings on 100 links of 100 g: no hinge opens, the rope keeps its length.";

    public override SceneView View => new(new Vector2(-22f, -23f), new Vector2(22f, 2f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);

        // The links swing across the taut rope at up to 200 Hz: at the usual 5 iterations hinges open by up to 1.4 mm.
        simulator.Iterations = 20;
        Vector2 end = new(0.6f * Links * Width, -0.8f * Links * Width);
        _rope = ComplexFactory.Instance.CreateRope(Vector2.Zero, end, Width, 0.08f, LinkMass, true, false, 1, LinkType.RevoluteJoint);
        _weight = BodyFactory.Instance.CreateCircleBody(simulator, 0.8f, Weight);
        _weight.Position = _rope.ControlPoints[2];
        Make.NoDrag(_weight);
        GeomFactory.Instance.CreateCircleGeom(simulator, _weight, 0.8f, 24).CollisionGroup = 1;
        _rope.Add(new RevoluteJoint(_rope.Bodies[^1], _weight, _weight.Position));
        Chains.Harden(_rope);
        _rope.AddToPhysicsSimulator(simulator);
        _worst = 0.0;
        _longest = 0.0;
        _highest = double.NegativeInfinity;
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        _worst = Math.Max(_worst, Chains.WidestGap(_rope!));
        _longest = Math.Max(_longest, _weight!.Position.Length());
        _highest = Math.Max(_highest, _weight.Position.Y);
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double length = Links * Width;
        return
        [
            SceneOutcome.Exactly("links", _rope!.Bodies.Count, Links),
            
            // 4.7e-7 when it was measured.
            SceneOutcome.AtMost("widest gap of a hinge (m)", _worst, 1e-5),
            SceneOutcome.AtMost("rope longer than its links (m)", _longest - length, 1e-3),
            SceneOutcome.AtMost("weight above its start (m)", _highest + (0.8 * length), 0.01),
        ];
    }
}
