using System;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>Vectors that ActionScript hands on by reference: see docs/decisions/008-vectors-by-reference.md.</summary>
public sealed class ReferenceTests
{
    [Fact]
    public void LinearVelocity_WrittenTo_IsThatOfTheBody()
    {
        b2World world = Bench.World(0);
        b2Body player = Bench.Ball(world, 0, 0);

        player.GetLinearVelocity().x = 5;
        world.Step(Bench.Dt, 10);

        Assert.Equal(5 * Bench.Dt, player.GetPosition().x, 1e-6);
        player.GetLinearVelocity().Multiply(2);
        Assert.Equal(10, player.GetLinearVelocity().x);
        player.GetLinearVelocity().SetZero();
        Assert.Equal(0, player.GetLinearVelocity().Length());
    }

    [Fact]
    public void Position_Kept_FollowsTheBody_AndACopyDoesNot()
    {
        b2World world = Bench.World();
        b2Body ball = Bench.Ball(world, 0, 0);
        b2Vec2 position = ball.GetPosition();
        b2Vec2 copy = ball.GetPosition().Copy();
        Bench.Step(world, 60);

        Assert.Equal(-5, position.y, 1e-3);
        Assert.Equal(0, copy.y);
        Assert.Same(position, ball.GetXForm().position);
    }

    [Fact]
    public void Position_WrittenTo_IsRefusedWithAWayOut()
    {
        b2World world = Bench.World();
        b2Body ball = Bench.Ball(world, 0, 0);

        InvalidOperationException error = Assert.Throws<InvalidOperationException>(() => ball.GetPosition().x = 3);

        Assert.Contains("SetXForm", error.Message, StringComparison.Ordinal);
        Assert.Throws<InvalidOperationException>(() => ball.GetXForm().R.Set(1));
        Assert.Equal(0, ball.GetPosition().x);
    }

    [Fact]
    public void Definition_KeepsItsOwnVectors()
    {
        b2World world = Bench.World();
        b2BodyDef def = new();
        def.position.Set(1, 2);
        b2Body body = world.CreateBody(def);
        def.position.Set(9, 9);

        Assert.Equal(1, body.GetPosition().x);
    }

    [Fact]
    public void DestroyedBody_ShowsWhereItWas()
    {
        b2World world = Bench.World();
        b2Body ball = Bench.Ball(world, 3, 4);
        b2Vec2 position = ball.GetPosition();
        world.DestroyBody(ball);
        Bench.Ball(world, 7, 7);
        Bench.Step(world, 2);

        Assert.Equal((3f, 4f), (position.x, position.y));
        Assert.Throws<InvalidOperationException>(() => ball.SetMassFromShapes());
    }
}
