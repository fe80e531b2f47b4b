using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes.Performance;

/// <summary>A cloth of discs that hangs from the middle of its upper edge: joints that close loops everywhere.</summary>
public sealed class JointGrid : PerformanceScene
{
    private const float Radius = 0.4f;

    public override string Name => "joint_grid";

    public override string SizeMeaning => "discs in a row and in a column";

    public override int DefaultSize => 100;

    public override int LargestSize => 1000;

    public override int Steps => 500;

    private protected override void Fill(Bricks bricks, int size)
    {
        var grid = new Body[size, size];
        bricks.CollisionGroup = 1;
        for (int k = 0; k < size; k++)
        {
            for (int i = 0; i < size; i++)
            {
                Body body = bricks.Circle(k, -i, Radius);
                body.IsStatic = i == 0 && Math.Abs(k - (size / 2)) <= 3;
                grid[k, i] = body;
                if (i > 0)
                {
                    Hinge(bricks.Simulator, grid[k, i - 1], body, new Vector2(k, 0.5f - i));
                }

                if (k > 0)
                {
                    Hinge(bricks.Simulator, grid[k - 1, i], body, new Vector2(k - 0.5f, -i));
                }
            }
        }
    }

    // Two fixed discs cannot be jointed.
    private static void Hinge(PhysicsSimulator simulator, Body body1, Body body2, Vector2 anchor)
    {
        if (!body1.IsStatic || !body2.IsStatic)
        {
            JointFactory.Instance.CreateRevoluteJoint(simulator, body1, body2, anchor);
        }
    }
}
