using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Serialization;

namespace Farseer.Rooms;

/// <summary>Four walls, ten boxes on the floor, a ball and two players. It knows nothing of servers.</summary>
internal sealed class RoomWorld
{
    public const int Players = 2;
    private const float HalfWidth = 8;
    private const float HalfHeight = 5;
    private const float Thickness = 1;
    private const int Boxes = 10;
    private const string Ball = "ball";
    private static readonly SceneFileOptions _exact = new() { Format = SceneFormat.Binary, ExactState = true };

    private readonly PhysicsSimulator _simulator;
    private readonly FixedStepDriver _driver;
    private readonly Body[] _players;
    private readonly Body _ball;

    // A loaded world has the bodies of the saved one, in its order and with its names.
    private RoomWorld(PhysicsSimulator simulator, long steps)
    {
        _simulator = simulator;
        _driver = new FixedStepDriver(simulator) { AfterStep = _ => Steps++ };
        _players = [.. Enumerable.Range(0, Players).Select(i => Find(PlayerName(i)))];
        _ball = Find(Ball);
        Steps = steps;
    }

    public long Steps { get; private set; }

    public ulong Hash => _simulator.MotionHash();

    public Vector2 BallPosition => _ball.Position;

    /// <summary>The room of a number, as new: another number is another room.</summary>
    public static RoomWorld Build(long number)
    {
        PhysicsSimulator simulator = new(new Vector2(0, -10));
        for (int sign = -1; sign <= 1; sign += 2)
        {
            Wall(simulator, new Vector2(0, sign * (HalfHeight + (Thickness / 2))), 2 * (HalfWidth + Thickness), Thickness);
            Wall(simulator, new Vector2(sign * (HalfWidth + (Thickness / 2)), 0), Thickness, 2 * HalfHeight);
        }

        Random random = new(number.GetHashCode());
        for (int i = 0; i < Boxes; i++)
        {
            Body box = BodyFactory.Instance.CreateRectangleBody(simulator, 0.6f, 0.6f, 0.5f);
            box.Position = new Vector2(((i % 5) * 1.2f) - 2.4f + (0.4f * random.NextSingle()), (0.8f * (i / 5)) + 0.4f - HalfHeight);
            GeomFactory.Instance.CreateRectangleGeom(simulator, box, 0.6f, 0.6f).FrictionCoefficient = 0.4f;
        }

        Disc(simulator, Ball, 0.4f, 0.3f, new Vector2((2 * random.NextSingle()) - 1, 3));
        for (int i = 0; i < Players; i++)
        {
            Disc(simulator, PlayerName(i), 0.5f, 2, new Vector2(i == 0 ? -6 : 6, 0.5f - HalfHeight));
        }

        // Takes the bodies in without letting time pass.
        simulator.Update(0);
        return new RoomWorld(simulator, 0);
    }

    /// <summary>The room that <see cref="Save"/> saved; it goes on with the same bits.</summary>
    public static RoomWorld Load(byte[] file, long steps) => new(SceneFile.LoadSimulator(file, _exact), steps);

    /// <summary>All of it, also what players did that no step has seen yet.</summary>
    public byte[] Save() => SceneFile.Save(_simulator, _exact);

    public void Push(int player, Vector2 impulse)
    {
        if (player is < 0 or >= Players)
        {
            throw new ArgumentOutOfRangeException(nameof(player), player, $"A room has the players 0 to {Players - 1}.");
        }

        _players[player].ApplyImpulse(impulse);
    }

    public void Step(int count)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        for (int i = 0; i < count; i++)
        {
            _simulator.Update((float)_driver.Step);
            Steps++;
        }
    }

    /// <summary>Makes the steps that are due.</summary>
    /// <param name="elapsed">Seconds since the last call.</param>
    public void Advance(double elapsed) => _driver.Advance(elapsed);

    private static string PlayerName(int number) => $"player {number}";

    private Body Find(string name) => _simulator.BodyList.First(b => b.Name == name);

    private static void Disc(PhysicsSimulator simulator, string name, float radius, float mass, Vector2 place)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, radius, mass);
        body.Name = name;
        body.Position = place;
        Geom geom = GeomFactory.Instance.CreateCircleGeom(simulator, body, radius, 16);
        geom.RestitutionCoefficient = 0.6f;
        geom.FrictionCoefficient = 0.3f;
    }

    private static void Wall(PhysicsSimulator simulator, Vector2 middle, float width, float height)
    {
        Body wall = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, 1);
        wall.Position = middle;
        wall.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, wall, width, height).FrictionCoefficient = 0.4f;
    }
}
