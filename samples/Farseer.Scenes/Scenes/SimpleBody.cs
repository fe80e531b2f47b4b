using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>The smallest program: a body, which moves, and a geom, which makes it collide; a floor; a force.</summary>
public sealed class SimpleBody : Scene
{
    private const float Side = 64f;
    private const float Push = 200f;
    private const float Mass = 2f;
    private const int PushedSteps = 60;
    private static readonly Vector2 _start = new(-250f, 100f);
    private Body? _body;

    public override string Name => "simple-body";

    public override string Title => "A body and its geom";

    public override string Description => "A box is pushed for a second while it falls, lands on a floor without friction and glides on.";

    public override int Steps => 300;

    public override SceneView View => new(new Vector2(-320f, 40f), new Vector2(320f, 360f));

    public override void Build(PhysicsSimulator simulator)
    {
        // Any unit of length will do. Here it is pixels, with y down as on a screen.
        simulator.Gravity = new Vector2(0f, 200f);

        // The body has the mass; it is added to the simulator by the factory.
        _body = BodyFactory.Instance.CreateRectangleBody(simulator, Side, Side, Mass);
        _body.Position = _start;
        _body.LinearDragCoefficient = 0f;

        // The geom has the shape. It moves with its body.
        Geom box = GeomFactory.Instance.CreateRectangleGeom(simulator, _body, Side, Side);
        box.FrictionCoefficient = 0f;

        // What never moves is static.
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 800f, 40f, 1f);
        floor.Position = new Vector2(0f, 320f);
        floor.IsStatic = true;
        Geom ground = GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 800f, 40f);
        ground.FrictionCoefficient = 0f;
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        // Forces act for one update, so a push that lasts is given before each of them.
        if (step < PushedSteps)
        {
            _body!.ApplyForce(new Vector2(Push, 0f));
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double pushed = PushedSteps * (double)Dt;
        double glided = (Steps - PushedSteps) * (double)Dt;
        double acceleration = (double)Push / Mass;
        double due = _start.X + (0.5 * acceleration * pushed * pushed) + (acceleration * pushed * glided);
        return
        [
            // 300 velocities of 100 in single precision: rounding of 1e-5 each.
            SceneOutcome.Error("way of the box: a t²/2, then v t", _body!.PositionX, due, 0.01),

            // The floor's top is at 300; the sag is a share of the box's size.
            SceneOutcome.Error("height of the box", _body.PositionY, 300.0 - (0.5 * Side), 0.06),
            SceneOutcome.Error("speed of the box", _body.LinearVelocity.X, acceleration * pushed, 1e-3),
            SceneOutcome.AtMost("tilt (rad)", System.Math.Abs(Measure.Angle(_body)), 1e-4),
        ];
    }
}
