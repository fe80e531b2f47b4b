using System.Numerics;
using Farseer.Samples.Terminal;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Samples.Tests;

/// <summary>What mouse and keys do to a scene that is watched.</summary>
public sealed class HandTests
{
    private const float Dt = 1f / 60;

    private readonly PhysicsSimulator _simulator = new(new Vector2(0, -10));
    private readonly Hand _hand;

    public HandTests() => _hand = new Hand(_simulator);

    [Fact]
    public void Hand_DragsABody_WhichFollowsAndIsLetGo()
    {
        Body box = Box(new Vector2(0, 0));
        _hand.Grab(new Vector2(0.2f, 0.1f), 0.1f);
        _hand.Lead(new Vector2(3, 2));
        Run(120);

        Assert.Same(box, _hand.Chosen);
        Assert.True(_hand.HasTouched);

        // At rest the spring stretches by weight / stiffness, 10 / 25² m; a swing about the point adds as much again and a little.
        Vector2 grabbed = box.GetWorldPosition(new Vector2(0.2f, 0.1f));
        Assert.InRange(grabbed.X, 2.9f, 3.1f);
        Assert.InRange(grabbed.Y, 1.9f, 2f);

        _hand.Release();
        Run(60);
        Assert.True(box.Position.Y < 0, "It does not fall after it was let go.");
        Assert.Empty(_simulator.SpringList);
    }

    [Fact]
    public void Hand_OutOfReach_TakesNothing()
    {
        Box(new Vector2(0, 0));

        _hand.Grab(new Vector2(2, 0), 0.5f);

        Assert.Null(_hand.Chosen);
        Assert.False(_hand.HasTouched);
    }

    [Fact]
    public void Hand_ChoosesAndThrows_OnlyWhatCanMove()
    {
        Box(new Vector2(-5, 0)).IsStatic = true;
        Body first = Box(new Vector2(0, 0));
        Body second = Box(new Vector2(5, 0));
        _simulator.Update(0);
        _hand.Throw(Vector2.UnitX);
        _hand.ChooseNext();
        Assert.Same(first, _hand.Chosen);
        _hand.ChooseNext();
        Assert.Same(second, _hand.Chosen);

        _hand.Throw(new Vector2(3, 4));

        Assert.Equal(new Vector2(3, 4), second.LinearVelocity);
        Assert.Equal(Vector2.Zero, first.LinearVelocity);
        _hand.ChooseNext();
        Assert.Same(first, _hand.Chosen);
    }

    private Body Box(Vector2 position)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(_simulator, 1, 1, 1);
        body.Position = position;
        GeomFactory.Instance.CreateRectangleGeom(_simulator, body, 1, 1);
        return body;
    }

    private void Run(int steps)
    {
        for (int i = 0; i < steps; i++)
        {
            _simulator.Update(Dt);
        }
    }
}
