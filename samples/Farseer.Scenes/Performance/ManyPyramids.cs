namespace Farseer.Scenes.Performance;

/// <summary>Small pyramids in rows, each row on a segment: many islands, the same work in each.</summary>
public sealed class ManyPyramids : PerformanceScene
{
    private const int Base = 10;
    private const int Columns = 20;
    private const float Pitch = Base + 1;
    private const float Width = Columns * Pitch;

    public override string Name => "many_pyramids";

    public override string SizeMeaning => "rows of 20 pyramids";

    public override int DefaultSize => 20;

    public override int LargestSize => 200;

    public override int Steps => 200;

    private protected override void Fill(Bricks bricks, int size)
    {
        for (int row = 0; row < size; row++)
        {
            bricks.StaticSegment(row * Pitch, Width);
        }

        for (int row = 0; row < size; row++)
        {
            for (int column = 0; column < Columns; column++)
            {
                AddPyramid(bricks, (-0.5f * Width) + (column * Pitch) + 1f, row * Pitch);
            }
        }
    }

    private static void AddPyramid(Bricks bricks, float centreX, float baseY)
    {
        for (int i = 0; i < Base; i++)
        {
            for (int j = i; j < Base; j++)
            {
                bricks.Box(((i + 1) * 0.5f) + (j - i) + centreX - 0.5f, baseY + (((2 * i) + 1) * 0.5f), 0.5f, 0.5f);
            }
        }
    }
}
