using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes.Performance;

/// <summary>Boxes in a heavy drum that a motor turns: one body touches a great many.</summary>
public sealed class Tumbler : PerformanceScene
{
    private const float WallDensity = 50f;
    private const float Height = 10f;
    private const float Spacing = 0.4f;
    private const float Half = 0.125f;

    public override string Name => "tumbler";

    public override string SizeMeaning => "boxes in a row and in a column";

    public override int DefaultSize => 45;

    public override int LargestSize => 45;

    public override int Steps => 750;

    private protected override void Fill(Bricks bricks, int size)
    {
        // Two upright and two level walls, each 1 by 20, their centres 10 from the drum's.
        const float Wall = WallDensity * 1f * 20f;
        float inertia = 4f * Wall * (((1f + (20f * 20f)) / 12f) + (10f * 10f));
        Body drum = bricks.AddBody(0f, Height, 4f * Wall, inertia);
        bricks.AttachBox(drum, 10f, 0f, 0.5f, 10f);
        bricks.AttachBox(drum, -10f, 0f, 0.5f, 10f);
        bricks.AttachBox(drum, 0f, 10f, 10f, 0.5f);
        bricks.AttachBox(drum, 0f, -10f, 10f, 0.5f);
        FixedRevoluteJoint motor = JointFactory.Instance.CreateFixedRevoluteJoint(bricks.Simulator, drum, new Vector2(0f, Height));
        motor.MotorSpeed = (float)(25.0 * Math.PI / 180.0);
        motor.MaxMotorTorque = 1e8f;
        motor.IsMotorEnabled = true;
        for (int i = 0; i < size; i++)
        {
            for (int j = 0; j < size; j++)
            {
                bricks.Box((j - (0.5f * size)) * Spacing, Height + ((i - (0.5f * size)) * Spacing), Half, Half);
            }
        }
    }
}
