using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>How many substeps islands take: by themselves, for all, or for one body's island.</summary>
public sealed class IterationChoiceTests : IDisposable
{
    /// <summary>Enough for a tall stack to be at rest and to ask for more substeps.</summary>
    private const int Steps = 30;

    private readonly PhysicsSimulator _simulator =
        new PhysicsSimulator(new Vector2(0, -10)) { EnableReport = true, AllowedPenetration = 0 };

    public IterationChoiceTests()
    {
        Body ground = BodyFactory.Instance.CreateRectangleBody(_simulator, 1000, 2, 1);
        ground.IsStatic = true;
        ground.Position = new Vector2(0, -1);
        GeomFactory.Instance.CreateRectangleGeom(_simulator, ground, 1000, 2);
    }

    public void Dispose() => _simulator.Dispose();

    [Fact]
    public void Stack_ByDefault_TakesMoreIterationsThanAreSet()
    {
        Stack(0, 20);

        Assert.True(_simulator.AdaptIterations);
        Assert.True(Run() > _simulator.Iterations);
    }

    [Fact]
    public void AdaptIterations_SwitchedOff_KeepsStacksAndLoadsToThoseSet()
    {
        Stack(0, 20);
        Hang(new Vector2(50, 40));
        _simulator.AdaptIterations = false;

        Assert.Equal(_simulator.Iterations, Run());
    }

    [Fact]
    public void AdaptIterations_SwitchedOffAndOn_TakesThemAgain()
    {
        Stack(0, 20);
        Run();
        _simulator.AdaptIterations = false;
        Run();
        _simulator.AdaptIterations = true;

        Assert.True(Run() > _simulator.Iterations);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(8)]
    [InlineData(16)]
    public void IterationFactor_OfABodyInAStack_IsThatOfTheStack(int factor)
    {
        Body[] stack = Stack(0, 20);
        stack[13].IterationFactor = factor;

        Assert.Equal(factor, stack[13].IterationFactor);
        Assert.Equal(factor * _simulator.Iterations, Run());
    }

    [Fact]
    public void IterationFactor_OfSeveralBodiesInAStack_IsTheLargest()
    {
        Body[] stack = Stack(0, 5);
        stack[1].IterationFactor = 8;
        stack[2].IterationFactor = 2;
        stack[4].IterationFactor = 1;

        Assert.Equal(8 * _simulator.Iterations, Run());
    }

    [Fact]
    public void IterationFactor_OfALinkOfARope_IsThatOfTheRope()
    {
        Body[] rope = Hang(new Vector2(50, 40));
        int before = Run();
        rope[3].IterationFactor = 4;
        int chosen = Run();
        rope[3].IterationFactor = 0;

        Assert.Equal(_simulator.Iterations, before);
        Assert.Equal(4 * _simulator.Iterations, chosen);
        Assert.Equal(_simulator.Iterations, Run());
    }

    /// <summary>
    /// A kinematic body is of no island, yet in the list of those that are solved: with a factor on board nothing may be asked of its
    /// island.
    /// </summary>
    [Theory]
    [InlineData(1, false)]
    [InlineData(4, false)]
    [InlineData(16, false)]
    [InlineData(1, true)]
    [InlineData(4, true)]
    [InlineData(16, true)]
    public void IterationFactor_OnAKinematicLift_IsThatOfItsLoad(int factor, bool ofLift)
    {
        for (int count = 1; count < 10; count++)
        {
            using var test = new IterationChoiceTests();
            Body lift = test.Lift(count);
            Body[] load = test.Stack(200, count, 4.5f);
            (ofLift ? lift : load[count / 2]).IterationFactor = factor;

            Assert.Equal(factor * test._simulator.Iterations, test.Run());
            for (int i = 0; i < count; i++)
            {
                // At rest on it, which has gone up by 1 m/s for half a second.
                Assert.Equal(5 + i, load[i].Position.Y, 0.05f);
                Assert.Equal(1, load[i].LinearVelocity.Y, 0.1f);
            }
        }
    }

    [Theory]
    [InlineData(2, false)]
    [InlineData(8, false)]
    [InlineData(2, true)]
    [InlineData(8, true)]
    public void IterationFactor_OfWhatHangsOnAKinematicBody_IsThatOfTheRope(int factor, bool ofHook)
    {
        Body hook = BodyFactory.Instance.CreateRectangleBody(_simulator, 1, 1, 1);
        hook.Position = new Vector2(50, 40);
        hook.IsKinematic = true;
        hook.LinearVelocity = new Vector2(0, 0.5f);
        Body[] rope = Hang(new Vector2(50, 40), hook);
        (ofHook ? hook : rope[2]).IterationFactor = factor;

        Assert.Equal(factor * _simulator.Iterations, Run());
        Assert.Equal(hook.Position.Y - 5.5f, rope[5].Position.Y, 0.05f);
    }

    [Fact]
    public void IterationFactor_OfAKinematicBodyAlone_ConcernsNobody()
    {
        Lift(3).IterationFactor = 16;
        Stack(0, 3);

        Assert.Equal(_simulator.Iterations, Run());
    }

    [Fact]
    public void IterationFactor_WithoutAdapting_StillCounts()
    {
        Body[] stack = Stack(0, 20);
        stack[0].IterationFactor = 2;
        _simulator.AdaptIterations = false;

        Assert.Equal(2 * _simulator.Iterations, Run());
    }

    [Fact]
    public void IterationFactor_OfAnotherStack_LeavesAStackAsItIs()
    {
        using var other = new IterationChoiceTests();
        Body[] stack = Stack(0, 6);
        Stack(100, 6);
        Body[] same = other.Stack(0, 6);
        other.Stack(100, 6)[2].IterationFactor = 16;

        Run();
        other.Run();

        for (int i = 0; i < stack.Length; i++)
        {
            Assert.Equal(stack[i].Position, same[i].Position);
            Assert.Equal(stack[i].Rotation, same[i].Rotation);
        }
    }

    [Fact]
    public void IterationFactor_OfABodyOutsideOfASimulator_IsKeptWhenItIsAdded()
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(1, 1, 1);
        body.IterationFactor = 16;
        body.Position = new Vector2(0, 0.5f);
        _simulator.Add(body);
        GeomFactory.Instance.CreateRectangleGeom(_simulator, body, 1, 1);

        Assert.Equal(16 * _simulator.Iterations, Run());
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(3)]
    [InlineData(32)]
    [InlineData(int.MaxValue)]
    [InlineData(int.MinValue)]
    public void IterationFactor_ThatIsNoChoice_IsRefusedAndChangesNothing(int factor)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(_simulator, 1, 1, 1);
        body.IterationFactor = 2;

        var refusal = Assert.Throws<ArgumentOutOfRangeException>(() => body.IterationFactor = factor);

        Assert.Equal(nameof(Body.IterationFactor), refusal.ParamName);
        Assert.Equal(2, body.IterationFactor);
    }

    /// <returns>The most iterations of the last update.</returns>
    private int Run()
    {
        for (int i = 0; i < Steps; i++)
        {
            _simulator.Update(1 / 60f);
        }

        return _simulator.Report.MostIterations;
    }

    /// <summary>A platform at (200, 3.5), which goes up by 1 m/s.</summary>
    private Body Lift(int width)
    {
        Body lift = BodyFactory.Instance.CreateRectangleBody(_simulator, 2 + width, 1, 1);
        lift.Position = new Vector2(200, 3.5f);
        lift.IsKinematic = true;
        lift.LinearVelocity = new Vector2(0, 1);
        GeomFactory.Instance.CreateRectangleGeom(_simulator, lift, 2 + width, 1);
        return lift;
    }

    private Body[] Stack(float x, int count, float bottom = 0.5f)
    {
        var boxes = new Body[count];
        for (int i = 0; i < count; i++)
        {
            boxes[i] = BodyFactory.Instance.CreateRectangleBody(_simulator, 1, 1, 1);
            boxes[i].Position = new Vector2(x, i + bottom);
            GeomFactory.Instance.CreateRectangleGeom(_simulator, boxes[i], 1, 1);
        }

        return boxes;
    }

    private Body[] Hang(Vector2 from, Body? hook = null)
    {
        var links = new Body[6];
        for (int i = 0; i < links.Length; i++)
        {
            links[i] = BodyFactory.Instance.CreateRectangleBody(_simulator, 0.2f, 1, 1);
            links[i].Position = from - new Vector2(0, i + 0.5f);
            Vector2 top = from - new Vector2(0, i);
            if (i == 0 && hook is not null)
            {
                JointFactory.Instance.CreateRevoluteJoint(_simulator, hook, links[i], top);
            }
            else if (i == 0)
            {
                JointFactory.Instance.CreateFixedRevoluteJoint(_simulator, links[i], top);
            }
            else
            {
                JointFactory.Instance.CreateRevoluteJoint(_simulator, links[i - 1], links[i], top);
            }
        }

        return links;
    }
}
