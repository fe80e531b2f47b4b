using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>Two walls of bricks, held together by joints with a breakpoint: a slow ball and a fast one.</summary>
public sealed class BreakableWall : Scene
{
    private const int Columns = 3;
    private const int Rows = 6;
    private const float Brick = 0.8f;

    /// <summary>
    /// The error of a joint, here in metres, at which it breaks. What to set is best found by watching JointError in play: the slow ball
    /// makes 2e-5 here, the fast one 7e-4.
    /// </summary>
    private const float Breakpoint = 2e-4f;
    private readonly List<Geom> _bricks = [];
    private readonly List<Joint> _joints = [];
    private readonly int[] _broken = new int[2];
    
    public override string Name => "breakable-wall";

    public override string Title => "Breakable walls";

    public override string Description =>
        "Bricks are joined by joints that break: a slow ball bounces off its wall, a fast one goes through.";

    public override int Steps => 900;

    public override SceneView View => new(new Vector2(-12f, -1f), new Vector2(16f, 9f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 100f);
        _bricks.Clear();
        _joints.Clear();
        AddWall(simulator, -5f, 0);
        AddWall(simulator, 5f, 1);
        Throw(simulator, -9f, 3f);
        Throw(simulator, 1f, 25f);
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double lowest = double.MaxValue;
        foreach (Geom brick in _bricks)
        {
            lowest = Math.Min(lowest, brick.AABB.Min.Y);
        }

        int enabled = 0;
        foreach (Joint joint in _joints)
        {
            enabled += joint.Enabled ? 1 : 0;
        }

        return
        [
            SceneOutcome.Exactly("joints broken in the first wall", _broken[0], 0),

            // One in each column at least: the ball goes through them all.
            SceneOutcome.AtLeast("joints broken in the second wall", _broken[1], Columns),

            // A broken joint tells it once, by its event, and is disabled; the others hold on.
            SceneOutcome.Exactly("joints that still hold", enabled, _joints.Count - _broken[0] - _broken[1]),

            // Bricks that lie on the floor rest 1 mm deep on one face; on one corner, or under others, they may be a few deep.
            SceneOutcome.AtLeast("lowest corner of a brick (m)", lowest, -5.0 * Make.Tolerance),
        ];
    }

    private void AddWall(PhysicsSimulator simulator, float x, int wall)
    {
        _broken[wall] = 0;
        for (int column = 0; column < Columns; column++)
        {
            Body? below = null;
            for (int row = 0; row < Rows; row++)
            {
                Vector2 place = new(x + (Brick * column), Brick * (row + 0.5f));
                Geom brick = Make.Box(simulator, place, Brick, Brick, 0.6f);
                _bricks.Add(brick);
                if (below is not null)
                {
                    Join(simulator, below, brick.Body, wall);
                }

                below = brick.Body;
            }
        }
    }

    /// <summary>
    /// Welds a brick to the one below it. Side by side the columns only touch: joints all round would hold every brick several
    /// times over, and a wall does not need it.
    /// </summary>
    private void Join(PhysicsSimulator simulator, Body first, Body second, int wall)
    {
        WeldJoint joint =
            new(first, second, 0.5f * (first.Position + second.Position)) { Breakpoint = Breakpoint, CollideConnected = false };
        joint.Broke += (_, _) => _broken[wall]++;
        simulator.Add(joint);
        _joints.Add(joint);
    }

    private static void Throw(PhysicsSimulator simulator, float x, float speed)
    {
        Geom ball = Make.Circle(simulator, new Vector2(x, 3f), 0.5f);
        ball.Body.Mass = 3f;
        ball.Body.LinearVelocity = new Vector2(speed, 2f);
    }
}
