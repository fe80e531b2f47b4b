using System;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>
/// Nothing passes a wall, however fast and thin; nothing is thrown up by the seams of a floor; nothing sleeps in mid-flight.
/// </summary>
public sealed class FastBodyTests
{
    [Theory]
    [InlineData(10, true)]
    [InlineData(10, false)]
    [InlineData(100, true)]
    [InlineData(100, false)]
    [InlineData(1000, true)]
    [InlineData(1000, false)]
    [InlineData(10_000, true)]
    [InlineData(10_000, false)]
    public void Shot_AtAStaticWallOfTwoCentimetres_DoesNotPass_AndGainsNoEnergy(float speed, bool round)
    {
        // As S20 of the accuracy scenes: starts over a whole step's way, so that the wall is met at any moment of it.
        const int Starts = 20;
        float way = speed * Bench.Dt;
        for (int j = 0; j < Starts; j++)
        {
            b2World world = Bench.World(0, 1e6f, false);
            Bench.Static(world, 0, 0, 0.01f, 5);
            float x = -5 - (way * j / Starts);
            b2Body shot = round ? Bench.Ball(world, x, 0, 0.1f) : Bench.Dynamic(world, x, 0, 0.1f, 0.1f);
            shot.SetLinearVelocity(new b2Vec2(speed, 0));
            int steps = (int)MathF.Ceiling((10 + way) / way) + 60;
            for (int i = 0; i < steps; i++)
            {
                Bench.Step(world, 1);
                Assert.True(shot.GetPosition().x < 0.05f, $"start {j}: at {shot.GetPosition().x}");
                Assert.True(shot.GetLinearVelocity().Length() <= speed * 1.000001f);
            }
        }
    }

    [Theory]
    [InlineData(10)]
    [InlineData(1000)]
    [InlineData(10_000)]
    public void FreeFlight_HasNoHiddenLimitOfSpeed(float speed)
    {
        b2World world = Bench.World(0, 1e6f);
        b2Body ball = Bench.Ball(world, -5, 0, 0.1f);
        ball.SetLinearVelocity(new b2Vec2(speed, 0));
        Bench.Step(world, 6);

        Assert.Equal(1, (ball.GetPosition().x + 5) / (6 * speed * Bench.Dt), 1e-5f);
    }

    [Theory]
    [InlineData(100)]
    [InlineData(1000)]
    [InlineData(10_000)]
    public void Bullet_AtAThinWallThatComesTowardsIt_DoesNotPass(float speed)
    {
        const int Starts = 20;
        float way = speed * Bench.Dt;
        for (int j = 0; j < Starts; j++)
        {
            b2World world = Bench.World(0, 1e6f, false);
            b2Body wall = Bench.Body(world, 0, 0, Bench.BoxDef(0.01f, 1, 1000));
            wall.SetLinearVelocity(new b2Vec2(-5, 0));
            b2Body bullet = Bench.Ball(world, -5 - (way * j / Starts), 0, 0.1f);
            bullet.SetBullet(true);
            bullet.SetLinearVelocity(new b2Vec2(speed, 0));
            double before = (bullet.GetMass() * (double)speed) - (wall.GetMass() * 5.0);
            Bench.Step(world, (int)MathF.Ceiling((8 + way) / way) + 2);
            double after =
                (bullet.GetMass() * (double)bullet.GetLinearVelocity().x) + (wall.GetMass() * (double)wall.GetLinearVelocity().x);

            Assert.True(bullet.GetPosition().x < wall.GetPosition().x, $"start {j}");
            Assert.Equal(before, after, 1e-6 * ((bullet.GetMass() * speed) + (wall.GetMass() * 5)));
        }
    }

    [Theory]
    [InlineData(20)]
    [InlineData(60)]
    [InlineData(200)]
    public void Rod_SpinningAtAWall_DoesNotPass_AndGainsNoEnergy(float spin)
    {
        for (int j = 0; j < 8; j++)
        {
            b2World world = Bench.World(0, 100, false);
            Bench.Body(world, 0.1f, 0, Slippery(0.1f, 5, 0));
            b2Body rod = Bench.Body(world, -1.3f, 0, Slippery(0.05f, 1, 1));
            rod.SetXForm(new b2Vec2(-1.3f, 0), MathF.PI * j / 8);
            rod.SetLinearVelocity(new b2Vec2(5, 0));
            rod.SetAngularVelocity(spin);
            double start = Energy(rod);
            for (int i = 0; i < 120; i++)
            {
                Bench.Step(world, 1);
                Assert.True(rod.GetPosition().x < 0.1f);
                Assert.True(Energy(rod) <= start * (1 + 1e-6), $"start {j}: {Energy(rod)} of {start}");
            }
        }
    }

    [Theory]
    [InlineData(true, true)]
    [InlineData(true, false)]
    [InlineData(false, true)]
    [InlineData(false, false)]
    public void Body_SlidingOverTiles_IsNotThrownUp(bool separateBodies, bool round)
    {
        const float Speed = 10;
        b2World world = Bench.World(-10, 1000, false);
        b2Body? floor = null;
        for (int i = -5; i < 120; i++)
        {
            if (separateBodies || floor is null)
            {
                floor = world.CreateBody(new b2BodyDef());
            }

            b2PolygonDef tile = new() { friction = 0 };
            tile.SetAsOrientedBox(0.5f, 0.5f, new b2Vec2(i + 0.5f, -0.5f), 0);
            floor!.CreateShape(tile);
        }

        b2ShapeDef def = round ? new b2CircleDef { radius = 0.5f } : Bench.BoxDef(0.5f, 0.5f, 1);
        def.density = 1;
        def.friction = 0;
        b2Body body = Bench.Body(world, 0, 0.5f, def);
        Bench.Step(world, 60);
        body.SetLinearVelocity(new b2Vec2(Speed, 0));
        float worst = 0;
        for (int i = 0; i < 600; i++)
        {
            Bench.Step(world, 1);
            worst = MathF.Max(worst, MathF.Abs(body.GetLinearVelocity().y));
        }

        Assert.True(body.GetPosition().x > 99, $"came to {body.GetPosition().x}");
        Assert.True(worst < 0.01f * Speed, $"thrown up at {worst}");
    }

    [Theory]
    [InlineData(1e-3f)]
    [InlineData(1)]
    [InlineData(1e3f)]
    public void Body_InFlight_NeverSleeps(float size)
    {
        // Thrown up: at the top it stands still for a moment.
        b2World world = Bench.World(-10, 1e6f);
        b2Body body = Bench.Dynamic(world, 0, 1000, size / 2, size / 2);
        body.SetLinearVelocity(new b2Vec2(0, 5));
        for (int i = 0; i < 120; i++)
        {
            Bench.Step(world, 1);
            Assert.False(body.IsSleeping());
        }
    }

    private static double Energy(b2Body body) =>
        0.5 * ((body.GetMass() * body.GetLinearVelocity().Length() * (double)body.GetLinearVelocity().Length())
        + (body.GetInertia() * body.GetAngularVelocity() * (double)body.GetAngularVelocity()));

    private static b2PolygonDef Slippery(float hx, float hy, float density)
    {
        b2PolygonDef def = Bench.BoxDef(hx, hy, density);
        def.friction = 0;
        return def;
    }
}
