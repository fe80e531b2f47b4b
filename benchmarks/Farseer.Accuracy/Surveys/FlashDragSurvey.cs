using System;
using System.Collections.Generic;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;

namespace Farseer.Accuracy.Surveys;

/// <summary>The same as <see cref="DragSurvey"/> with the mouse joint of the other facade.</summary>
internal sealed class FlashDragSurvey : Survey
{
    private const float WallFace = 4.5f;

    /// <summary>The linear slop of the original, to which its contacts may sink in, and a millimetre.</summary>
    private const double Limit = 0.006;

    public override string Name => "K1b";

    public override string What => "drawn at a static wall by a b2MouseJoint: metres beyond its face in the last 2 of 10 s; at most 0.006";

    public override int Draws => 100;

    public override IEnumerable<Variation> Grid()
    {
        foreach (float thick in (float[])[0.02f, 0.2f, 1])
        {
            foreach (float force in (float[])[15, 100, 1000, 1e4f, 1e6f, float.MaxValue])
            {
                foreach (int iterations in (int[])[1, 5, 10, 20])
                {
                    yield return Drag("box", thick, 1, force, iterations, false);
                }

                yield return Drag("box", thick, 1, force, 10, true);
                yield return Drag("ball", thick, 1, force, 10, false);
            }
        }
    }

    public override Variation Draw(Dice dice) => Drag(
        dice.Of("box", "ball"), dice.Wide(0.02, 1), dice.Wide(0.2, 20), dice.Wide(15, 1e6), dice.Whole(1, 20), dice.Of(true, false));

    private static Variation Drag(string shape, float thick, float density, float force, int iterations, bool bullet) => new(
        FormattableString.Invariant($"{force} N on a {(bullet ? "bullet, " : "")}{shape} of density {density}, ")
            + FormattableString.Invariant($"wall of {thick} m, iterations {iterations}"),
        Limit,
        () =>
        {
            var room = new FlashRoom(-10);
            room.Box(0, -0.5f, 40, 1, 0);
            room.Box(WallFace + (thick / 2), 2, thick, 6, 0);
            b2Body body = shape == "ball"
                ? room.Ball(0, 0.5f, 0.5f, density, bullet: bullet)
                : room.Box(0, 0.5f, 1, 1, density, bullet: bullet);
            room.Steps(1, iterations);
            b2Vec2 start = body.GetPosition();
            var def = new b2MouseJointDef { body1 = room.World.GetGroundBody(), body2 = body, maxForce = force };
            def.target.Set(start.x, start.y);
            ((b2MouseJoint)room.World.CreateJoint(def)).SetTarget(new b2Vec2(9, 0.6f));
            double farthest = 0;
            room.Steps(480, iterations);
            room.Steps(120, iterations, () => farthest = Math.Max(farthest, Math.Abs(body.GetPosition().x)));
            return farthest + 0.5 - WallFace;
        });
}
