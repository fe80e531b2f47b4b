using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// A joint that is given a body from afar pulls the two together at the rate of its bias. Taken as speeds, such pulls pressed on surfaces
/// with impulses that were not taken back, and shot bodies off at up to 4,000 a second.
/// </summary>
public class ExchangedBodyTests
{
    private const float Size = 20;

    [Theory]
    [InlineData(30, 0, 0)]
    [InlineData(100, 0, 0)]
    [InlineData(300, 0, -10)]
    [InlineData(30, 3, 0)]
    [InlineData(100, 3, 0)]
    [InlineData(100, 3, -10)]
    [InlineData(300, 3, -10)]
    public void PartnerFromAfar_ComesWithoutAShot(float distance, int boxesBetween, float anchorHeight)
    {
        PhysicsSimulator simulator = new PhysicsSimulator(new Vector2(0, 100));
        Body floor = Sandbox.Box(simulator, new Vector2(0, 10), 4000).Body;
        floor.IsStatic = true;
        Body first = Sandbox.Box(simulator, new Vector2(0, -10)).Body;
        Body second = Sandbox.Box(simulator, new Vector2(22, -10)).Body;
        Body third = Sandbox.Box(simulator, new Vector2(distance, -10)).Body;
        for (int i = 0; i < boxesBetween; i++)
        {
            Sandbox.Box(simulator, new Vector2((distance / 2) + 10, -10 - (Size * i)));
        }

        RevoluteJoint joint = JointFactory.Instance.CreateRevoluteJoint(simulator, first, second, new Vector2(11, anchorHeight - 10));
        Sandbox.Run(simulator, 100);
        joint.Body2 = third;
        float fastest = 0;
        for (int i = 0; i < 500; i++)
        {
            Sandbox.Run(simulator, 1);
            foreach (Body body in simulator.BodyList)
            {
                fastest = Math.Max(fastest, body.LinearVelocity.Length());
            }
        }

        // A fall from the top of the three boxes ends at 110 a second.
        Assert.InRange(fastest, 0, 110);
        Assert.InRange(joint.JointError, 0, 0.01f);
    }
}
