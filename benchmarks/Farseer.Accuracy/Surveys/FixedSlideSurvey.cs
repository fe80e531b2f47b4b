using System;
using System.Collections.Generic;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;

namespace Farseer.Accuracy.Surveys;

/// <summary>A slide of the other facade holds bodies on its axis that cannot turn, alone and side by side.</summary>
internal sealed class FixedSlideSurvey : Survey
{
    private const double Limit = 1e-3;

    private const float Force = 20;
    private const int Steps = 120;

    private static readonly string[] _partners = ["ground", "static", "fixed", "turning"];
    private static readonly string[] _pushes = ["speed", "force", "gravity"];

    public override string Name => "K6";

    public override string What => "slides between bodies of fixed rotation: metres off the axis in 2 s; at most 0.001";

    public override int Draws => 200;

    public override IEnumerable<Variation> Grid()
    {
        foreach (string partner in _partners)
        {
            foreach (string push in _pushes)
            {
                foreach (int count in (int[])[1, 4])
                {
                    yield return Slide(new Setup(partner, push, 0.5f * MathF.PI, 1, 1, count, 10, false, false));
                    yield return Slide(new Setup(partner, push, 0.3f, 1, 1, count, 10, true, true));
                }
            }
        }
    }

    public override Variation Draw(Dice dice) => Slide(new Setup(
        dice.Of(_partners), dice.Of(_pushes), dice.Between(0, 6.28), dice.Wide(0.1, 10), dice.Wide(0.1, 10), dice.Whole(1, 5),
        dice.Whole(1, 20), dice.Of(true, false), dice.Of(true, false)));

    private static Variation Slide(Setup s) => new(
        FormattableString.Invariant(
            $"{s.Count} of density {s.Density} on {s.Partner} of density {s.Other}, pushed by {s.Push}, axis at {s.Axis}, ")
            + $"{(s.HasLimits ? "limits, " : "")}{(s.HasMotor ? "motor, " : "")}iterations {s.Iterations}",
        Limit,
        () => Play(s));

    private static double Play(Setup s)
    {
        var room = new FlashRoom(s.Push == "gravity" ? -10 : 0);
        var axis = new b2Vec2(MathF.Cos(s.Axis), MathF.Sin(s.Axis));
        var sliders = new List<(b2Joint Joint, b2Body Body)>();
        for (int i = 0; i < s.Count; i++)
        {
            // Too far from each other to meet.
            float x = 60 * i;
            b2Body partner = s.Partner switch
            {
                "ground" => room.World.GetGroundBody(),
                "static" => room.Box(x, -3, 1, 1, 0),
                "fixed" => Upright(room, x, -3, s.Other, true),
                _ => Upright(room, x, -3, s.Other, false),
            };
            b2Body body = Upright(room, x, 3, s.Density, true);
            var def = new b2PrismaticJointDef { enableLimit = s.HasLimits, enableMotor = s.HasMotor, maxMotorForce = 1, motorSpeed = 2 };
            def.lowerTranslation = -1;
            def.upperTranslation = 1;
            def.Initialize(partner, body, new b2Vec2(x, 3), axis);
            sliders.Add((room.World.CreateJoint(def), body));
            if (s.Push == "speed")
            {
                body.SetLinearVelocity(new b2Vec2(-3 * axis.y, 3 * axis.x));
            }
        }

        double worst = 0;
        for (int i = 0; i < Steps; i++)
        {
            foreach ((_, b2Body body) in sliders)
            {
                if (s.Push == "force")
                {
                    body.ApplyForce(new b2Vec2(-Force * axis.y, Force * axis.x), body.GetWorldCenter());
                }
            }

            room.Steps(1, s.Iterations);
            foreach ((b2Joint joint, _) in sliders)
            {
                worst = Math.Max(worst, Off(joint, axis));
            }
        }

        return worst;
    }

    /// <summary>The distance of the second anchor from the axis, which turns with the first body.</summary>
    private static double Off(b2Joint joint, b2Vec2 axis)
    {
        (double sin, double cos) = Math.SinCos(joint.GetBody1().GetAngle());
        b2Vec2 from = joint.GetAnchor1();
        b2Vec2 to = joint.GetAnchor2();
        double x = (cos * axis.x) - (sin * axis.y);
        double y = (sin * axis.x) + (cos * axis.y);
        return Math.Abs((x * ((double)to.y - from.y)) - (y * ((double)to.x - from.x)));
    }

    private static b2Body Upright(FlashRoom room, float x, float y, float density, bool isFixed)
    {
        var shape = new b2PolygonDef { density = density };
        shape.SetAsBox(0.5f, 0.5f);
        var def = new b2BodyDef { fixedRotation = isFixed };
        def.position.Set(x, y);
        b2Body body = room.World.CreateBody(def);
        body.CreateShape(shape);
        body.SetMassFromShapes();
        return body;
    }

    private sealed record Setup(
        string Partner, string Push, float Axis, float Density, float Other, int Count, int Iterations, bool HasLimits, bool HasMotor);
}
