using System.Numerics;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Viewer;

namespace Farseer.Viewer.Tests;

/// <summary>Small worlds to record, the same each time.</summary>
internal static class Worlds
{
    public const float Dt = 1f / 60;

    /// <summary>A floor, a named ball that falls, a box that slides, and two boxes on a hinge; all with events.</summary>
    public static PhysicsSimulator Mixed(float push = 0)
    {
        PhysicsSimulator simulator = new(new Vector2(0, -10)) { AllowSleep = true };
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 30, 1, 1);
        floor.IsStatic = true;
        floor.Name = "floor";
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 30, 1);

        Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 0.5f, 1);
        ball.Name = "ball </script><b>";
        ball.Position = new Vector2(-3, 4);
        Geom round = GeomFactory.Instance.CreateCircleGeom(simulator, ball, 0.5f, 16);
        round.RestitutionCoefficient = 0.5f;

        Body slider = Box(simulator, 0, 1);
        slider.LinearVelocity = new Vector2(3 + push, 0);

        Body left = Box(simulator, 5, 3);
        Body right = Box(simulator, 6.2f, 3);
        JointFactory.Instance.CreateRevoluteJoint(simulator, left, right, new Vector2(5.6f, 3)).Tag = "hinge";
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, left, new Vector2(4.4f, 3));
        return simulator;
    }

    public static RunRecorder Recorded(PhysicsSimulator simulator, int updates, RunRecorderOptions? options = null)
    {
        RunRecorder recorder = new(simulator, options);
        for (int i = 0; i < updates; i++)
        {
            simulator.Update(Dt);
            recorder.Record(Dt);
        }

        return recorder;
    }

    /// <summary>Boxes in a pyramid with so many in its lowest row.</summary>
    public static PhysicsSimulator Pyramid(int row)
    {
        PhysicsSimulator simulator = new();
        new LargePyramid().Build(simulator, row);
        return simulator;
    }

    private static Body Box(PhysicsSimulator simulator, float x, float y)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        body.Position = new Vector2(x, y);
        GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1);
        return body;
    }
}
