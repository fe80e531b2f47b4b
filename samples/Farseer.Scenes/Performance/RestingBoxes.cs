namespace Farseer.Scenes.Performance;

/// <summary>A few boxes at rest on a floor, each by itself: what most games are most of the time.</summary>
public sealed class RestingBoxes : PerformanceScene
{
    public override string Name => "resting_boxes";

    public override string SizeMeaning => "boxes";

    public override int DefaultSize => 10;

    public override int LargestSize => 1000;

    public override int Steps => 5000;

    private protected override void Fill(Bricks bricks, int size)
    {
        bricks.StaticBox(0f, -0.5f, 50f + size, 0.5f);
        for (int i = 0; i < size; i++)
        {
            bricks.Box((2f * i) - size, 0.5f, 0.5f, 0.5f);
        }
    }
}
