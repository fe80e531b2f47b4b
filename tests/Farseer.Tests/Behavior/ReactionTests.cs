using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Reaction forces of joints that hold a structure at rest, against statics.</summary>
public class ReactionTests
{
    private const float Weight = 100;
    private const float Width = 20;

    /// <summary>
    /// Exactly as long as its gap: the pull along it is without bound and depends on its last micrometre of sag, but the nails carry half
    /// of the weight each all the same.
    /// </summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(5)]
    [InlineData(20)]
    public void NailsOfATautBridge_CarryHalfItsWeightEach(int planks)
    {
        PhysicsSimulator simulator = Bridge(planks, 0, out FixedRevoluteJoint left, out FixedRevoluteJoint right);
        Mean(simulator, left, right, out Vector2 atLeft, out Vector2 atRight);

        // It trembles, by what a pull of thousands of weights makes of rounding: 1 % of the weight is left of that in the mean.
        Assert.Equal(-planks * Weight / 2, atLeft.Y, 0.01f * planks * Weight);
        Assert.Equal(-planks * Weight / 2, atRight.Y, 0.01f * planks * Weight);
        Assert.Equal(-atLeft.X, atRight.X, 1e-5f * Math.Abs(atLeft.X));
    }

    /// <summary>Two planks that meet in the middle at a slope: H = w·cot(slope)/2 along, half of the weight at each nail.</summary>
    [Theory]
    [InlineData(0.05f)]
    [InlineData(0.2f)]
    [InlineData(0.8f)]
    public void NailsOfTwoSlopingPlanks_PullByTheSlope(float slope)
    {
        PhysicsSimulator simulator = Bridge(2, slope, out FixedRevoluteJoint left, out FixedRevoluteJoint right);
        Mean(simulator, left, right, out Vector2 atLeft, out Vector2 atRight);
        float along = Weight / (2 * (float)Math.Tan(slope));

        // 2e-3: the drag that brings it to rest takes a six-hundredth off the weight.
        Assert.Equal(-Weight, atLeft.Y, 2e-3f * Weight);
        Assert.Equal(-Weight, atRight.Y, 2e-3f * Weight);
        Assert.Equal(-along, atLeft.X, 2e-3f * along);
        Assert.Equal(along, atRight.X, 2e-3f * along);
    }

    /// <summary>Three equal bars in a triangle that hangs from one corner: a loop. Its upper bars press on the lower one.</summary>
    [Fact]
    public void HingesOfAHungTriangle_HoldItsLowerBar()
    {
        PhysicsSimulator simulator = new PhysicsSimulator(new Vector2(0, Weight));
        var corners = new[] { new Vector2(0, -50), new Vector2(43.30127f, 25), new Vector2(-43.30127f, 25) };
        var bars = new Body[3];
        for (int i = 0; i < 3; i++)
        {
            bars[i] = Bar(simulator, corners[i], corners[(i + 1) % 3]);
        }

        var hinges = new RevoluteJoint[3];
        for (int i = 0; i < 3; i++)
        {
            hinges[i] = JointFactory.Instance.CreateRevoluteJoint(simulator, bars[i], bars[(i + 1) % 3], corners[(i + 1) % 3]);
        }

        FixedRevoluteJoint nail = JointFactory.Instance.CreateFixedRevoluteJoint(simulator, bars[0], corners[0]);
        Sandbox.Run(simulator, 3000);

        // An upper bar about the top corner: its weight at 21.65 and half of the lower bar's at 43.3 to the side, against the push of the
        // lower bar 75 below: H = w·43.3/75 = w·tan 30°.
        float push = Weight * (float)Math.Tan(Math.PI / 6);
        Assert.Equal(-3 * Weight, nail.ReactionForce.Y, 0.6f);
        Assert.Equal(0, nail.ReactionForce.X, 0.01f);
        Assert.Equal(-push, hinges[0].ReactionForce.X, 0.2f);
        Assert.Equal(-push, hinges[1].ReactionForce.X, 0.2f);
        Assert.Equal(-Weight / 2, hinges[0].ReactionForce.Y, 0.2f);
        Assert.Equal(Weight / 2, hinges[1].ReactionForce.Y, 0.2f);
    }

    private static PhysicsSimulator Bridge(int planks, float slope, out FixedRevoluteJoint left, out FixedRevoluteJoint right)
    {
        PhysicsSimulator simulator = new PhysicsSimulator(new Vector2(0, Weight));
        Vector2 from = Vector2.Zero;
        Body? before = null;
        Body? first = null;
        for (int i = 0; i < planks; i++)
        {
            float angle = i < planks / 2 ? slope : -slope;
            Vector2 to = from + (Width * new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle)));
            Body plank = Bar(simulator, from, to);
            if (before is not null)
            {
                JointFactory.Instance.CreateRevoluteJoint(simulator, before, plank, from);
            }

            first ??= plank;
            before = plank;
            from = to;
        }

        left = JointFactory.Instance.CreateFixedRevoluteJoint(simulator, first!, Vector2.Zero);
        right = JointFactory.Instance.CreateFixedRevoluteJoint(simulator, before!, from);
        return simulator;
    }

    private static Body Bar(PhysicsSimulator simulator, Vector2 from, Vector2 to)
    {
        Vector2 way = to - from;
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, way.Length(), 6, 1);
        body.Position = 0.5f * (from + to);
        body.Rotation = (float)Math.Atan2(way.Y, way.X);
        body.LinearDragCoefficient = 1;
        body.RotationalDragCoefficient = 500;
        return body;
    }

    /// <summary>Means over the three seconds after the bridge has come to rest.</summary>
    private static void Mean(
        PhysicsSimulator simulator, FixedRevoluteJoint left, FixedRevoluteJoint right, out Vector2 atLeft, out Vector2 atRight)
    {
        const int Updates = 300;
        Sandbox.Run(simulator, 2000);
        atLeft = Vector2.Zero;
        atRight = Vector2.Zero;
        for (int i = 0; i < Updates; i++)
        {
            Sandbox.Run(simulator, 1);
            atLeft += left.ReactionForce / Updates;
            atRight += right.ReactionForce / Updates;
        }
    }
}
