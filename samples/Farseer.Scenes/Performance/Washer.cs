using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes.Performance;

/// <summary>A ring with four blades turns at a steady rate and stirs small boxes.</summary>
public sealed class Washer : PerformanceScene
{
    private const int Segments = 36;
    private const float BladeRadius = 14f;
    private const float InnerRadius = 16f;
    private const float OuterRadius = 18f;
    private const float Height = 10f;
    private const float Half = 0.1f;

    public override string Name => "washer";

    public override string SizeMeaning => "boxes in a row and in a column";

    public override int DefaultSize => 90;

    public override int LargestSize => 90;

    public override int Steps => 500;

    private protected override void Fill(Bricks bricks, int size)
    {
        Body ring = bricks.AddBody(0f, Height, 1f, 1f);
        ring.IsKinematic = true;
        ring.LinearVelocity = new Vector2(0.001f, -0.002f);
        ring.AngularVelocity = (float)(25.0 * Math.PI / 180.0);
        for (int i = 0; i < Segments; i++)
        {
            float from = 10f * i;
            bricks.Attach(ring, Sector(from - 1f, from + 11f, InnerRadius, OuterRadius));
            if (i % 9 == 0)
            {
                bricks.Attach(ring, Sector(from, from + 10f, BladeRadius, InnerRadius));
            }
        }

        for (int i = 0; i < size; i++)
        {
            for (int j = 0; j < size; j++)
            {
                bricks.Box((j * 2.1f * Half) - (1.1f * Half * size), Height + (i * 2.1f * Half) - (1.1f * Half * size), Half, Half);
            }
        }
    }

    private static FarseerGames.FarseerPhysics.Collisions.Vertices Sector(float fromDegrees, float toDegrees, float inner, float outer) =>
        [At(fromDegrees, inner), At(fromDegrees, outer), At(toDegrees, outer), At(toDegrees, inner)];

    private static Vector2 At(float degrees, float radius)
    {
        double angle = degrees * Math.PI / 180.0;
        return new Vector2((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle)));
    }
}
