using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>Links held by springs, hung between two points: a soft path that catches a ball.</summary>
public sealed class SoftPath : Scene
{
    private const int Links = 12;
    private const float Stiffness = 600f;
    private const float Damping = 30f;
    private const float BallMass = 4f;
    private Path? _path;
    private FixedLinearSpring? _left;
    private FixedLinearSpring? _right;
    private Body? _ball;

    public override string Name => "soft-path";

    public override string Title => "Soft path";

    public override string Description =>
        "A ball falls on 12 links that springs hold together: it is caught, and the springs at the ends bear all the weight.";

    public override int Steps => 1200;

    public override SceneView View => new(new Vector2(-7f, -6f), new Vector2(7f, 6f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        _path = new Path(0.8f, 0.3f, 0.5f, false);
        _path.Add(new Vector2(-4.8f, 0f));
        _path.Add(new Vector2(0f, 0f));
        _path.Add(new Vector2(4.8f, 0f));
        _path.Update();
        _path.CreateGeoms(1);
        _path.LinkBodies(LinkType.LinearSpring, 0f, 0f, Stiffness, Damping);
        _left = new FixedLinearSpring(_path.Bodies[0], new Vector2(-0.4f, 0f), new Vector2(-5f, 0f), Stiffness, Damping);
        _right = new FixedLinearSpring(_path.Bodies[^1], new Vector2(0.4f, 0f), new Vector2(5f, 0f), Stiffness, Damping);
        _path.Add(_left);
        _path.Add(_right);
        Chains.SetFriction(_path, 0.6f);
        foreach (Body link in _path.Bodies)
        {
            link.LinearDragCoefficient = 0.5f;
            link.RotationalDragCoefficient = 0.5f;
        }

        _path.AddToPhysicsSimulator(simulator);
        Geom ball = Make.Circle(simulator, new Vector2(0.1f, 4f), 0.6f, 0.6f);
        ball.Body.Mass = BallMass;
        ball.Body.LinearDragCoefficient = 1f;
        ball.Body.RotationalDragCoefficient = 1f;
        ball.Body.MomentOfInertia = 0.5f * BallMass * 0.6f * 0.6f;
        _ball = ball.Body;
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double weight = (BallMass + (Links * 0.5)) * Make.Gravity;
        double carried = Pull(_left!) + Pull(_right!);
        return
        [
            SceneOutcome.Exactly("links", _path!.Bodies.Count, Links),
            SceneOutcome.Exactly("springs", _path.Springs.Count, Links + 1),
            SceneOutcome.Error("weight on the springs at the ends (share)", carried / weight, 1.0, 0.01),
            SceneOutcome.AtMost("speed of the ball (m/s)", _ball!.LinearVelocity.Length(), 0.05),
            SceneOutcome.AtLeast("height of the ball (m)", _ball.Position.Y, -5.0),
        ];
    }

    /// <summary>Vertical part of a spring's pull on its link, upwards.</summary>
    private static double Pull(FixedLinearSpring spring)
    {
        Vector2 stretch = spring.WorldAttachPoint - spring.Body!.GetWorldPosition(spring.BodyAttachPoint);
        double length = stretch.Length();
        return Stiffness * (length - spring.RestLength) * stretch.Y / length;
    }
}
