using System;

namespace Farseer.Scenes.Performance;

/// <summary>One pyramid of unit boxes: the scene of long chains of contacts.</summary>
public sealed class LargePyramid : PerformanceScene
{
    public override string Name => "large_pyramid";

    public override string SizeMeaning => "boxes in the lowest row";

    public override int DefaultSize => 100;

    public override int LargestSize => 1000;

    public override int Steps => 500;

    private protected override void Fill(Bricks bricks, int size)
    {
        // The published ground reaches 100 to each side; wider pyramids need more.
        bricks.StaticBox(0f, -1f, Math.Max(100f, size), 1f);
        for (int i = 0; i < size; i++)
        {
            for (int j = i; j < size; j++)
            {
                bricks.Box(((i + 1) * 0.5f) + (j - i) - (0.5f * size), ((2 * i) + 1) * 0.5f, 0.5f, 0.5f);
            }
        }
    }
}
