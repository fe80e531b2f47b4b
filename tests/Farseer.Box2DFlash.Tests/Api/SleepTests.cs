using Box2D.Common.Math;
using Box2D.Dynamics;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

public sealed class SleepTests
{
    [Fact]
    [ManualRow("B021", "B083-B087", "B107", "B108", "B057", "B120")]
    public void Sleep_ComesWithRest_AndGoesWithForces()
    {
        b2World world = Bench.World();
        Bench.Static(world, 0, -0.5f, 10, 0.5f);
        b2Body box = Bench.Dynamic(world, 0, 0.4975f);
        b2Body never = world.CreateBody(new b2BodyDef { allowSleep = false, position = new b2Vec2(3, 0.4975f) });
        never.CreateShape(Bench.BoxDef(0.5f, 0.5f, 1));
        never.SetMassFromShapes();
        b2Body hung = world.CreateBody(new b2BodyDef { isSleeping = true, position = new b2Vec2(-3, 5) });
        hung.CreateShape(Bench.BoxDef(0.5f, 0.5f, 1));
        hung.SetMassFromShapes();
        Assert.True(hung.IsSleeping());
        Bench.Step(world, 60);

        Assert.True(box.IsSleeping());
        Assert.False(never.IsSleeping());
        Assert.Equal(5, hung.GetPosition().y);
        box.ApplyForce(new b2Vec2(1, 0), box.GetWorldCenter());
        Assert.False(box.IsSleeping());
        hung.WakeUp();
        Bench.Step(world, 10);
        Assert.True(hung.GetPosition().y < 5);
        hung.PutToSleep();
        Assert.True(hung.IsSleeping());
        hung.AllowSleeping(false);
        Assert.False(hung.IsSleeping());
        b2World awake = Bench.World(-10, 100, false);
        Bench.Static(awake, 0, -0.5f, 10, 0.5f);
        b2Body restless = Bench.Dynamic(awake, 0, 0.4975f);
        Bench.Step(awake, 90);
        Assert.False(restless.IsSleeping());
    }
}
