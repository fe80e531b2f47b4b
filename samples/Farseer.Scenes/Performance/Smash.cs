using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes.Performance;

/// <summary>A heavy box flies into a wall of small ones that sleep: what it hits wakes.</summary>
public sealed class Smash : PerformanceScene
{
    private const float Half = 0.2f;
    private const float Spacing = 0.4f;

    public override string Name => "smash";

    public override string SizeMeaning => "rows of the wall; it has 3/2 as many columns";

    public override int DefaultSize => 80;

    public override int LargestSize => 800;

    public override int Steps => 300;

    private protected override void Fill(Bricks bricks, int size)
    {
        bricks.Simulator.Gravity = Vector2.Zero;
        bricks.Simulator.AllowSleep = true;
        bricks.Density = 8f;
        Body box = bricks.Box(-20f, 0f, 4f, 4f);
        box.LinearVelocity = new Vector2(40f, 0f);
        bricks.Density = 1f;
        for (int i = 0; i < size * 3 / 2; i++)
        {
            for (int j = 0; j < size; j++)
            {
                bricks.Box(30f + (Spacing * i), Spacing * (j - (size / 2)), Half, Half).Awake = false;
            }
        }
    }
}
