using System;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>A mouse joint whose target is behind a wall: the wall holds, whatever the force.</summary>
public class MouseAtWallTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Body_DrawnBeyondAWall_StaysBeforeIt(bool bullet)
    {
        float[] forces = [30, 100, 1000, 1e4f, 1e6f, 1e20f, float.MaxValue];
        for (int seed = 0; seed < 120; seed++)
        {
            Random random = new(seed);
            float force = forces[seed % forces.Length];
            float half = new[] { 0.01f, 0.1f, 0.5f }[random.Next(3)];
            int iterations = new[] { 1, 2, 4, 10, 20 }[random.Next(5)];
            float dt = new[] { 1 / 30f, 1 / 60f, 1 / 120f }[random.Next(3)];
            b2World world = Bench.World(random.Next(3) == 0 ? 0 : -10);
            Bench.Static(world, 0, -0.5f, 40, 0.5f);
            Bench.Static(world, 4 + half, 4, half, 4);
            b2Body body = random.Next(2) == 0 ? Bench.Ball(world, 3.45f, 0.5f) : Bench.Dynamic(world, 3.45f, 0.5f);
            body.SetBullet(bullet);
            b2MouseJointDef def = new() { body1 = world.GetGroundBody(), body2 = body, maxForce = force };
            def.target.SetV(body.GetPosition());
            b2MouseJoint mouse = (b2MouseJoint)world.CreateJoint(def);
            for (int i = 0; i < 200; i++)
            {
                mouse.SetTarget(new b2Vec2(8, 0.6f));
                world.Step(dt, iterations);
                float x = body.GetPosition().x;
                Assert.True(x < 4, $"seed {seed}: {force}, wall {half}, {iterations} at {1 / dt}, step {i}: {x}");
            }

            Assert.False(body.IsFrozen());
            world.DestroyJoint(mouse);
            world.Step(dt, iterations);
            Assert.InRange(body.GetLinearVelocity().Length(), 0, 60);
        }
    }
}
