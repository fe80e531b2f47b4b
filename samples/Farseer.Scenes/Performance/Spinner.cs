using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes.Performance;

/// <summary>A long rod sweeps capsules, discs and boxes round a bin of many edges.</summary>
public sealed class Spinner : PerformanceScene
{
    private const int Links = 360;
    private const float BinRadius = 40f;
    private const float BinHeight = 32f;
    private const float RodHeight = 12f;
    private const int Columns = 92;

    public override string Name => "spinner";

    public override string SizeMeaning => "bodies";

    public override int DefaultSize => 6076;

    public override int LargestSize => 6076;

    public override int Steps => 500;

    private protected override void Fill(Bricks bricks, int size)
    {
        bricks.Friction = 0.1f;
        Body bin = bricks.StaticBody(0f, 0f);
        var points = new Vector2[Links];
        for (int i = 0; i < Links; i++)
        {
            // Against the clock a loop looks outwards; the bodies are inside.
            double angle = -2.0 * Math.PI * i / Links;
            points[i] = new Vector2((float)(BinRadius * Math.Cos(angle)), BinHeight + (float)(BinRadius * Math.Sin(angle)));
        }

        bricks.AttachLoop(bin, points);
        bricks.Friction = 0f;
        Body rod = bricks.RoundedBox(0f, RodHeight, 0.4f, 20f, 0.2f);
        RevoluteJoint motor = JointFactory.Instance.CreateRevoluteJoint(bricks.Simulator, bin, rod, new Vector2(0f, RodHeight));
        motor.CollideConnected = false;
        motor.MotorSpeed = 5f;
        motor.MaxMotorTorque = float.MaxValue;
        motor.IsMotorEnabled = true;
        bricks.Friction = 0.1f;
        bricks.Restitution = 0.1f;
        bricks.Density = 0.25f;
        for (int i = 0; i < size; i++)
        {
            float x = -23f + (0.5f * (i % Columns));
            float y = 2f + (0.5f * (i / Columns));
            switch (i % 3)
            {
                case 0:
                    bricks.Capsule(x, y, 0.25f, 0.25f);
                    break;
                case 1:
                    bricks.Circle(x, y, 0.35f);
                    break;
                default:
                    bricks.Box(x, y, 0.35f, 0.35f);
                    break;
            }
        }
    }
}
