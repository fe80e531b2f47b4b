using System;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>Two states that differ in one field are told apart by it.</summary>
public sealed class StateComparisonTests
{
    private const float Dt = 1f / 60;

    [Fact]
    public void Worlds_MadeByTheSameProgram_AreTheSame()
    {
        b2World one = Made();
        b2World other = Made();

        b2StateComparison comparison = one.Compare(other);

        Assert.True(comparison.IsSame, comparison.ToString());
        Assert.Null(comparison.First);
        Assert.Equal(one.StateHash(), other.StateHash());
    }

    [Fact]
    public void Spin_OfOneBody_IsNamed()
    {
        b2World one = Made();
        b2World other = Made();
        other.GetBodyList()!.SetAngularVelocity(2);

        b2StateComparison comparison = one.Compare(other);

        b2StateDifference difference = Assert.Single(
            comparison.Differences, d => d.Section == "Bodies" && d.Field.EndsWith(".AngularVelocity", StringComparison.Ordinal));
        Assert.Equal("body 0", difference.Item);
        Assert.Equal("40000000", difference.SecondBits);
        Assert.NotEqual(one.StateHash(), other.StateHash());
    }

    [Fact]
    public void Friction_OfOneShape_IsNamed()
    {
        b2World one = Made();
        b2World other = Made();
        other.GetBodyList()!.GetShapeList()!.SetFriction(0.75f);

        b2StateComparison comparison = one.Compare(other);

        Assert.Contains(comparison.Differences, d => d.Item == "shape 0" && d.SecondBits == "3f400000");
    }

    [Fact]
    public void States_OfOneWorldAtTwoTimes_DifferAndTheWorldStaysAsItIs()
    {
        b2World world = Made();
        b2WorldState first = world.Capture();
        world.GetBodyList()!.SetLinearVelocity(new b2Vec2(3, 0));
        b2WorldState second = world.Capture();
        world.Step(Dt, 10);
        ulong hash = world.StateHash();

        b2StateComparison comparison = first.Compare(second);

        Assert.Equal("body 0", comparison.First!.Item);
        Assert.Contains("LinearVelocity.X", comparison.ToString(), StringComparison.Ordinal);
        Assert.Equal(hash, world.StateHash());
        Assert.Single(first.Compare(second, 1).Differences);
    }

    [Fact]
    public void Compare_WithBadArguments_NamesThem()
    {
        b2World world = Made();

        Assert.Equal("other", Assert.Throws<ArgumentNullException>(() => world.Compare(null!)).ParamName);
        Assert.Equal("most", Assert.Throws<ArgumentOutOfRangeException>(() => world.Compare(world, 0)).ParamName);
        Assert.Equal("other", Assert.Throws<ArgumentException>(() => world.Capture().Compare(new b2WorldState())).ParamName);
        Assert.Throws<InvalidOperationException>(() => new b2WorldState().Compare(world.Capture()));
    }

    private static b2World Made()
    {
        var bounds = new b2AABB();
        bounds.lowerBound.Set(-100, -100);
        bounds.upperBound.Set(100, 100);
        var world = new b2World(bounds, new b2Vec2(0, -10), true);
        for (int i = 0; i < 3; i++)
        {
            var at = new b2BodyDef();
            at.position.Set(3 * i, i == 0 ? -1 : 1);
            var box = new b2PolygonDef { density = i == 0 ? 0 : 1 };
            box.SetAsBox(i == 0 ? 50 : 0.5f, 0.5f);
            b2Body body = world.CreateBody(at)!;
            body.CreateShape(box);
            body.SetMassFromShapes();
        }

        for (int i = 0; i < 10; i++)
        {
            world.Step(Dt, 10);
        }

        return world;
    }
}
