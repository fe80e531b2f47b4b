using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Rollback;

/// <summary>
/// Two players on a pitch, seen from above, a ball, and crates in the way. Who brings the ball behind the other's line scores.
/// </summary>
internal sealed class BallGame : IRollbackGame
{
    public const float Dt = 1f / 60;
    public const int Players = 2;

    /// <summary>From the middle to a goal line.</summary>
    public const float HalfLength = 10;

    private const float HalfWidth = 6;
    private const float HalfGoal = 2.8f;
    private const float GoalDepth = 2;
    private const float WallThickness = 1;
    private const float PlayerForce = 26;
    private const float KickReach = 1.6f;
    private const float KickImpulse = 5;
    private const int KickPause = 20;
    private const float StillSpeed = 0.5f;
    private const int MostStill = 150;

    private readonly PhysicsSimulator _simulator = new();
    private readonly RollbackBuffer _buffer;
    private readonly Body[] _players = new Body[Players];
    private readonly Body _ball;

    // What the simulator does not know is kept beside its states, by frame.
    private readonly Score[] _scores;
    private Score _score;

    /// <param name="framesHeld">How far back <see cref="Load"/> may go.</param>
    public BallGame(int framesHeld)
    {
        _buffer = new RollbackBuffer(_simulator, framesHeld);
        _scores = new Score[framesHeld];
        BuildWalls();
        for (int i = 0; i < Players; i++)
        {
            _players[i] = Disc(0.6f, 2);
            _players[i].LinearDragCoefficient = 6;
        }

        _ball = Disc(0.4f, 0.6f);
        _ball.LinearDragCoefficient = 0.15f;
        for (int i = 0; i < 6; i++)
        {
            Body crate = BodyFactory.Instance.CreateRectangleBody(_simulator, 0.7f, 0.7f, 0.8f);
            crate.Position = new Vector2(((i % 3) - 1) * 3.4f, i < 3 ? -3 : 3);
            crate.LinearDragCoefficient = 1.5f;
            crate.RotationalDragCoefficient = 0.3f;
            GeomFactory.Instance.CreateRectangleGeom(_simulator, crate, 0.7f, 0.7f);
        }

        KickOff();
    }

    public int LeftGoals => _score.Left;

    public int RightGoals => _score.Right;

    public ulong Checksum => _simulator.StateHash() ^ ((ulong)(uint)_score.Left << 48) ^ ((ulong)(uint)_score.Right << 32)
        ^ (uint)_score.PauseLeft
        ^ ((ulong)(uint)_score.PauseRight << 8) ^ ((ulong)(uint)_score.Still << 16);

    public Vector2 Ball => _ball.Position;

    public Vector2 Player(int number) => _players[number].Position;

    public void Save(int frame)
    {
        long pushed = _buffer.Push();
        if (pushed != frame)
        {
            throw new InvalidOperationException($"Frame {frame} was saved after frame {pushed - 1}.");
        }

        _scores[frame % _scores.Length] = _score;
    }

    public void Load(int frame)
    {
        _buffer.Rewind(frame);
        _score = _scores[frame % _scores.Length];
    }

    public void Advance(ReadOnlySpan<PlayerInput> inputs)
    {
        Act(_players[0], inputs[0], ref _score.PauseLeft);
        Act(_players[1], inputs[1], ref _score.PauseRight);
        _simulator.Update(Dt);
        float x = _ball.Position.X;
        if (MathF.Abs(x) > HalfLength + 0.4f)
        {
            _score.Left += x > 0 ? 1 : 0;
            _score.Right += x > 0 ? 0 : 1;
            KickOff();
        }

        // A ball that is stuck between two who push is put back into the middle.
        _score.Still = _ball.LinearVelocity.Length() < StillSpeed ? _score.Still + 1 : 0;
        if (_score.Still > MostStill)
        {
            KickOff();
            _score.Still = 0;
        }
    }

    private void Act(Body player, PlayerInput input, ref int pause)
    {
        Vector2 way = new(
            ((input & PlayerInput.Right) != 0 ? 1 : 0) - ((input & PlayerInput.Left) != 0 ? 1 : 0),
            ((input & PlayerInput.Up) != 0 ? 1 : 0) - ((input & PlayerInput.Down) != 0 ? 1 : 0));
        player.ApplyForce(way * PlayerForce);
        pause = Math.Max(0, pause - 1);
        Vector2 toBall = _ball.Position - player.Position;
        if ((input & PlayerInput.Kick) != 0 && pause == 0 && toBall.LengthSquared() < KickReach * KickReach)
        {
            _ball.ApplyImpulse(toBall / MathF.Max(toBall.Length(), 0.1f) * KickImpulse);
            pause = KickPause;
        }
    }

    private void KickOff()
    {
        Put(_ball, Vector2.Zero);
        Put(_players[0], new Vector2(-5, 0));
        Put(_players[1], new Vector2(5, 0));
    }

    private static void Put(Body body, Vector2 place)
    {
        body.SetPose(new Pose(place.X, place.Y, 0));
        body.LinearVelocity = Vector2.Zero;
        body.AngularVelocity = 0;
    }

    private Body Disc(float radius, float mass)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(_simulator, radius, mass);
        Geom geom = GeomFactory.Instance.CreateCircleGeom(_simulator, body, radius, 16);
        geom.RestitutionCoefficient = 0.7f;
        geom.FrictionCoefficient = 0.2f;
        return body;
    }

    private void BuildWalls()
    {
        float side = HalfWidth + (WallThickness / 2);
        float end = HalfLength + (WallThickness / 2);
        float cheek = HalfWidth - HalfGoal;
        for (int sign = -1; sign <= 1; sign += 2)
        {
            Wall(new Vector2(0, sign * side), 2 * (HalfLength + GoalDepth + WallThickness), WallThickness);
            Wall(new Vector2(sign * (HalfLength + GoalDepth + (WallThickness / 2)), 0), WallThickness, 2 * HalfWidth);
            Wall(new Vector2(end, sign * (HalfGoal + (cheek / 2))), WallThickness, cheek);
            Wall(new Vector2(-end, sign * (HalfGoal + (cheek / 2))), WallThickness, cheek);
        }
    }

    private void Wall(Vector2 middle, float width, float height)
    {
        Body wall = BodyFactory.Instance.CreateRectangleBody(_simulator, width, height, 1);
        wall.Position = middle;
        wall.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(_simulator, wall, width, height).RestitutionCoefficient = 0.7f;
    }

    /// <summary>What belongs to the game and not to its bodies.</summary>
    private struct Score
    {
        public int Left;
        public int Right;
        public int PauseLeft;
        public int PauseRight;
        public int Still;
    }
}
