using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// A ball whose hinge lies within it, and which collides with the last link of its rope, as joined bodies do unless told otherwise: no turn
/// undoes that overlap. It was pushed apart all the same, the links spun at hundreds of radians a second, and the ball was thrown as high
/// as twenty metres.
/// </summary>
public class WreckingBallTests
{
    private const float Gravity = 10;
    private const int Links = 20;
    private const float Length = 0.4f;

    public enum Scene
    {
        Free,
        Wall,
        Floor,
    }

    // Rises of energy before, as a height of all bodies: 20.3, 7.0, 22.4, 7.0, 1.2 and 36.5 m.
    [Theory]
    [InlineData(Scene.Free, false)]
    [InlineData(Scene.Free, true)]
    [InlineData(Scene.Wall, false)]
    [InlineData(Scene.Wall, true)]
    [InlineData(Scene.Floor, false)]
    [InlineData(Scene.Floor, true)]
    public void Ball_HingedWithinItself_GainsNoEnergy(Scene scene, bool changingSteps)
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -Gravity)) { AllowedPenetration = 0 };
        Body? before = null;
        for (int i = 0; i < Links; i++)
        {
            Geom link = Sandbox.Box(simulator, new Vector2((i + 0.5f) * Length, 0), Length, 0.1f, 0.2f);
            link.CollisionGroup = 1;
            Prepare(link);
            if (before is null)
            {
                JointFactory.Instance.CreateFixedRevoluteJoint(simulator, link.Body, Vector2.Zero);
            }
            else
            {
                JointFactory.Instance.CreateRevoluteJoint(simulator, before, link.Body, new Vector2(i * Length, 0));
            }

            before = link.Body;
        }

        Geom ball = Sandbox.Ball(simulator, new Vector2((Links * Length) + 0.2f, 0), 0.5f, 8, 24);
        Prepare(ball);
        JointFactory.Instance.CreateRevoluteJoint(simulator, before!, ball.Body, new Vector2(Links * Length, 0));
        if (scene != Scene.Free)
        {
            Geom obstacle = scene == Scene.Wall
                ? Sandbox.Box(simulator, new Vector2(-3, -5), 1, 10)
                : Sandbox.Box(simulator, new Vector2(0, -4.5f), 100, 1);
            obstacle.Body.IsStatic = true;
            Prepare(obstacle);
        }

        var random = new Random(3);
        double least = double.PositiveInfinity;
        double rise = 0;
        for (double time = 0; time < 10;)
        {
            double dt = changingSteps ? 1 / (30 + (210 * random.NextDouble())) : 1 / 60.0;
            simulator.Update((float)dt);
            time += dt;
            double height = Energies.AsHeight(simulator.BodyList, Gravity);
            least = Math.Min(least, height);
            rise = Math.Max(rise, height - least);
        }

        // 0.09 m measured, of a fall of eight.
        Assert.InRange(rise, 0, 0.3);
        Assert.All(simulator.JointList, joint => Assert.InRange(joint.JointError, 0, 1e-3f));
    }

    private static void Prepare(Geom geom)
    {
        geom.FrictionCoefficient = 0.6f;
        geom.RestitutionCoefficient = 0;
    }
}
