using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// Two welded bodies, one of which is pinned to a point and the other kept at its angle: nothing can move. Of the weld's three directions
/// two had no response, and the determinant of the block was less than the rounding of its own terms: in the first step under gravity the
/// joints were 959 m apart.
/// </summary>
public class PinnedGroupTests
{
    [Theory]
    [InlineData(false, 1)]
    [InlineData(true, 1)]
    [InlineData(false, 9)]
    [InlineData(true, 9)]
    public void WeldedBodies_PinnedAndKeptAtTheirAngle_StayWhereTheyAre(bool thrown, int copies)
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { EnableReport = true };
        for (int i = 0; i < copies; i++)
        {
            // Several go side by side on lanes, one of them with legs of another length.
            AddPair(simulator, new Vector2(20 * i, 0), i == 3 ? 2 : 1, thrown);
        }

        for (int step = 0; step < 60; step++)
        {
            simulator.Update(1 / 60f);

            // 2·10⁻¹¹ measured.
            Assert.InRange(simulator.Report.LargestSeparation, 0, 1e-8);
            Assert.InRange(simulator.Report.LargestTurn, 0, 1e-8);
            Assert.InRange(simulator.Report.KineticEnergy, 0, 1e-9);
        }
    }

    private static void AddPair(PhysicsSimulator simulator, Vector2 place, float scale, bool thrown)
    {
        Body far = Sandbox.Box(simulator, place + (scale * new Vector2(4.49f, 5.6f)), 0.84f, 0.41f, 4.47f).Body;
        Body near = Sandbox.Box(simulator, place + (scale * new Vector2(0.74f, 2.24f)), 1.33f, 0.865f, 1.07f).Body;
        if (thrown)
        {
            far.LinearVelocity = new Vector2(-0.43f, -4.1f);
            far.AngularVelocity = 1.89f;
        }

        simulator.Add(new FixedRevoluteJoint(near, near.Position + new Vector2(0.19f, -0.04f)));
        simulator.Add(new FixedAngleJoint(far));
        simulator.Add(new WeldJoint(near, far, (near.Position + far.Position) / 2));
    }
}
