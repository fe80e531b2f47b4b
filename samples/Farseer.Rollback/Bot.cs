using System;
using System.Numerics;

namespace Farseer.Rollback;

/// <summary>A player that runs behind the ball and kicks it. It sees the game as its own side does, predictions included.</summary>
internal sealed class Bot
{
    private const float Near = 0.25f;
    private readonly Random _random;
    private readonly int _number;
    private PlayerInput _whim;
    private int _whimLeft;

    public Bot(int number, int seed)
    {
        _number = number;
        _random = new Random((seed * 2) + number);
    }

    public PlayerInput Choose(BallGame game)
    {
        // Now and then it does something nobody can predict.
        if (_whimLeft > 0)
        {
            _whimLeft--;
            return _whim;
        }

        if (_random.Next(25) == 0)
        {
            _whim = (PlayerInput)_random.Next(32);
            _whimLeft = _random.Next(4, 14);
        }

        Vector2 me = game.Player(_number);
        Vector2 toBall = Unit(game.Ball - me);
        Vector2 aim = Unit(new Vector2(_number == 0 ? BallGame.HalfLength : -BallGame.HalfLength, 0) - game.Ball);
        float lead = Vector2.Dot(toBall, aim);

        // Behind the ball, as seen from the goal; from before it by way of its side.
        Vector2 side = new Vector2(-aim.Y, aim.X) * (aim.Y * me.X > aim.X * me.Y ? -1 : 1);
        Vector2 place = lead > 0 ? game.Ball - (aim * 0.7f) : game.Ball - (aim * 1.5f) + (side * 1.3f);
        PlayerInput input = PlayerInput.None;
        input |= place.X > me.X + Near ? PlayerInput.Right : place.X < me.X - Near ? PlayerInput.Left : 0;
        input |= place.Y > me.Y + Near ? PlayerInput.Up : place.Y < me.Y - Near ? PlayerInput.Down : 0;
        return lead > 0.75f ? input | PlayerInput.Kick : input;
    }

    private static Vector2 Unit(Vector2 way) => way.LengthSquared() > 0 ? Vector2.Normalize(way) : Vector2.UnitX;
}
