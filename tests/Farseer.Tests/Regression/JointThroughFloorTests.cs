using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// A body is put beneath the floor that the other one of its joint stands on. Joint and floor contradict each other, so the pair is
/// displaced for good; impulses of the floor were kept meanwhile, in ways in which the pair gives next to nothing, and threw it off once
/// displacements had turned them: a hinged pair at 33 a second, one on a rail and a rod at 220, and worlds with more joints at 10¹⁴.
/// </summary>
public class JointThroughFloorTests
{
    /// <summary>How far below it is put, and the spring's frequency: what it is stretched by at most it makes a speed of.</summary>
    private const float Depth = 2.2f;
    private const float Frequency = 4;

    [Fact]
    public void HingedPair_OneOfWhichIsPutBeneathTheFloor_IsNotThrown()
    {
        // What gravity makes of a body that is displaced: 1.1.
        Assert.InRange(Fastest((a, b, _) => new Joint[] { new RevoluteJoint(b, a, new Vector2(0.3f, 0.2f)) }), 0, 1.5f);
    }

    /// <summary>The rail's spring, which the displacements stretch by metres, moves it as it should.</summary>
    [Fact]
    public void PairOnARailAndARod_OneOfWhichIsPutBeneathTheFloor_IsNoFasterThanItsSpringMakesIt() =>
        Assert.InRange(
            Fastest((a, b, away) => new Joint[]
            {
                new WheelJoint(b, a, new Vector2(0.3f, 0.2f) + away(0.2f), Vector2.Normalize(away(1))) { Frequency = Frequency },
                new PinJoint(b, away(0.2f), a, away(0.2f)),
            }),
            0,
            Depth * 2 * MathF.PI * Frequency);

    private static float Fastest(Func<Body, Body, Func<float, Vector2>, Joint[]> join)
    {
        float fastest = 0;
        for (int seed = 0; seed < 30; seed++)
        {
            var random = new Random(seed);
            Vector2 Away(float size) => size * 2 * new Vector2(random.NextSingle() - 0.5f, random.NextSingle() - 0.5f);
            var simulator = new PhysicsSimulator(new Vector2(0, -10));
            Body floor = Sandbox.Box(simulator, -Vector2.UnitY, 200, 2).Body;
            floor.IsStatic = true;
            Body box = Sandbox.Box(simulator, new Vector2(0, 0.15f), 0.3f, 0.3f, 4).Body;
            Body ball = Sandbox.Ball(simulator, new Vector2(0.6f, 0.25f), 0.25f, 1.7f).Body;
            foreach (Joint joint in join(box, ball, Away))
            {
                simulator.Add(joint);
            }

            for (int i = 0; i < 30; i++)
            {
                simulator.Update(1 / 60f);
            }

            ball.Position += new Vector2(Away(2).X, -Depth);
            for (int i = 0; i < 300; i++)
            {
                simulator.Update(1 / 60f);
                fastest = MathF.Max(fastest, MathF.Max(box.LinearVelocity.Length(), ball.LinearVelocity.Length()));
            }
        }

        return fastest;
    }
}
