using System;
using System.Collections.Generic;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>
/// Restitution above 1 in a closed room of the other facade: bodies get fast, but none leaves the room and every number
/// stays one.
/// </summary>
internal sealed class GrowingBounceSurvey : Survey
{
    private const float Half = 10;

    public override string Name => "F12";

    public override string What =>
        "restitution above 1 in a closed room: metres that the middle of a body is outside of it at the farthest; at most 0";

    public override int Draws => 120;

    public override IEnumerable<Variation> Grid()
    {
        yield return Room(5, 1.4f, "boxes", 10, -10, 10, false);
        foreach (float bounce in (float[])[1.05f, 1.2f, 1.4f, 2])
        {
            foreach (int count in (int[])[1, 4, 10])
            {
                foreach (string shape in (string[])["boxes", "balls"])
                {
                    yield return Room(count, bounce, shape, 5, -10, 10, false);
                    yield return Room(count, bounce, shape, 20, 0, 10, false);
                    yield return Room(count, bounce, shape, 5, -10, 10, true);
                    yield return Room(count, bounce, shape, 5, -10, 5, false);
                }
            }
        }
    }

    public override Variation Draw(Dice dice) => Room(
        dice.Whole(1, 12), dice.Between(1.01, 2), dice.Of("boxes", "balls"), dice.Wide(1, 50), dice.Of(0, -10), dice.Whole(2, 20),
        dice.Of(true, false));

    private static Variation Room(int count, float bounce, string shape, float speed, float gravity, int iterations, bool bullets) => new(
        FormattableString.Invariant(
            $"{count} {shape}{(bullets ? " that are bullets" : "")}, restitution {bounce}, ")
            + FormattableString.Invariant($"{speed} m/s at first, gravity {gravity}, iterations {iterations}"),
        0,
        () => Play(count, bounce, shape, speed, gravity, iterations, bullets));

    private static double Play(int count, float bounce, string shape, float speed, float gravity, int iterations, bool bullets)
    {
        var room = new FlashRoom(gravity, 100);
        room.Box(0, -Half - 1, (2 * Half) + 4, 2, 0, bounce);
        room.Box(0, Half + 1, (2 * Half) + 4, 2, 0, bounce);
        room.Box(-Half - 1, 0, 2, 2 * Half, 0, bounce);
        room.Box(Half + 1, 0, 2, 2 * Half, 0, bounce);
        var bodies = new List<b2Body>();
        for (int i = 0; i < count; i++)
        {
            float x = ((i % 5) - 2) * 3.5f;
            float y = ((i / 5) - 1) * 3.5f;
            b2Body body = shape == "balls" ? room.Ball(x, y, 0.5f, 1, bounce, bullets) : room.Box(x, y, 1, 1, 1, bounce, bullets);
            body.SetLinearVelocity(new b2Vec2(speed * MathF.Cos(i + 0.3f), speed * MathF.Sin(i + 0.3f)));
            bodies.Add(body);
        }

        double farthest = double.NegativeInfinity;
        room.Steps(400, iterations, () =>
        {
            foreach (b2Body body in bodies)
            {
                b2Vec2 place = body.GetPosition();
                b2Vec2 velocity = body.GetLinearVelocity();
                bool sound = float.IsFinite(velocity.x) && float.IsFinite(velocity.y) && float.IsFinite(body.GetAngularVelocity());
                double outside = Math.Max(Math.Abs((double)place.x), Math.Abs((double)place.y)) - Half;
                farthest = sound ? Math.Max(farthest, outside) : double.NaN;
            }
        });
        return farthest;
    }
}
