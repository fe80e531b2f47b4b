using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes.Performance;

/// <summary>Pentagons fall into a bin in which a block goes to and fro.</summary>
public sealed class Junkyard : PerformanceScene
{
    private const int Rows = 40;
    private const float Radius = 0.25f;
    private const float Reach = 60f;
    private const double Pace = 0.2;
    private Body? _pusher;

    public override string Name => "junkyard";

    public override string SizeMeaning => "columns of 40 pentagons";

    public override int DefaultSize => 200;

    public override int LargestSize => 200;

    public override int Steps => 800;

    public override void Drive(int step)
    {
        // The speed that takes the block to the next place of its swing in one step.
        double now = Pace * step * Dt;
        double next = Pace * (step + 1) * Dt;
        _pusher!.LinearVelocity = new Vector2((float)(Reach * (Math.Sin(next) - Math.Sin(now)) / Dt), 0f);
    }

    private protected override void Fill(Bricks bricks, int size)
    {
        Body ground = bricks.StaticBody(0f, 0f);
        for (int i = 0; i < 161; i++)
        {
            bricks.AttachBox(ground, i - 80f, 0f, 0.55f, 0.5f);
        }

        for (int i = 1; i <= 50; i++)
        {
            bricks.AttachBox(ground, -80f, i, 0.5f, 0.55f);
            bricks.AttachBox(ground, 80f, i, 0.5f, 0.55f);
        }

        var pentagon = new Vector2[5];
        for (int i = 0; i < pentagon.Length; i++)
        {
            double angle = 2.0 * Math.PI * i / pentagon.Length;
            pentagon[i] = new Vector2((float)(Radius * Math.Cos(angle)), (float)(Radius * Math.Sin(angle)));
        }

        float side = -0.1f;
        for (int i = 0; i < size; i++)
        {
            for (int j = 0; j < Rows; j++)
            {
                bricks.Compound((1.5f * Radius * ((2f * i) - size)) + side, 15f + (4f * Radius * j), pentagon);
                side = -side;
            }
        }

        _pusher = bricks.AddBody(0f, 0f, 1f, 1f);
        _pusher.IsKinematic = true;
        bricks.AttachBox(_pusher, 0f, 4f, 2f, 4f);
    }
}
