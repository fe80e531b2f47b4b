namespace Farseer.Scenes.Performance;

/// <summary>Equal circles in a bin of about 100 columns: one-point contacts, and bodies that move for a while.</summary>
public sealed class CirclePile : PerformanceScene
{
    private const int Columns = 100;
    private const float Radius = 0.5f;
    private const float Spacing = 1.05f;
    private const float Shift = 0.1f;

    public override string Name => "circle_pile";

    public override string SizeMeaning => "circles";

    public override int DefaultSize => 10_000;

    public override int LargestSize => 1_000_000;

    public override int Steps => 300;

    private protected override void Fill(Bricks bricks, int size)
    {
        int rows = (size + Columns - 1) / Columns;
        float halfHeight = (0.5f * Spacing * rows) + 5f;

        // Walls half a metre clear of the outermost circles.
        float innerX = (0.5f * Spacing * (Columns - 1)) + Radius + Shift + 0.5f;
        bricks.StaticBox(0f, -0.5f, innerX + 1f, 0.5f);
        bricks.StaticBox(-innerX - 0.5f, halfHeight, 0.5f, halfHeight);
        bricks.StaticBox(innerX + 0.5f, halfHeight, 0.5f, halfHeight);
        for (int i = 0; i < size; i++)
        {
            int row = i / Columns;
            float x = ((i % Columns) - (0.5f * (Columns - 1))) * Spacing;
            bricks.Circle(x + ((row & 1) == 0 ? 0f : Shift), Radius + (row * Spacing), Radius);
        }
    }
}
