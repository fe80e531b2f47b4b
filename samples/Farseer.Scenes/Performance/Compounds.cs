using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes.Performance;

/// <summary>Bodies of two crossed triangles fall into a bin.</summary>
public sealed class Compounds : PerformanceScene
{
    private const int Rows = 150;

    public override string Name => "compounds";

    public override string SizeMeaning => "columns of 150 bodies";

    public override int DefaultSize => 20;

    public override int LargestSize => 20;

    public override int Steps => 500;

    private protected override void Fill(Bricks bricks, int size)
    {
        Body ground = bricks.StaticBody(0f, 0f);
        for (int i = 0; i < 81; i++)
        {
            bricks.AttachBox(ground, i - 40f, 0f, 0.55f, 0.5f);
        }

        for (int i = 1; i <= 100; i++)
        {
            bricks.AttachBox(ground, -40f, i, 0.5f, 0.55f);
            bricks.AttachBox(ground, 40f, i, 0.5f, 0.55f);
        }

        bricks.Friction = 0.5f;
        Vector2[] left = [new(-1f, 0f), new(0.5f, 1f), new(0f, 2f)];
        Vector2[] right = [new(1f, 0f), new(-0.5f, 1f), new(0f, 2f)];
        float side = -0.25f;
        for (int i = 0; i < size; i++)
        {
            for (int j = 0; j < Rows; j++)
            {
                bricks.Compound((2f * i) - size + 1f + side, (2.25f * j) + 5.575f, left, right);
                side = -side;
            }
        }
    }
}
