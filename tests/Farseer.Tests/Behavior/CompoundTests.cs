using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Several geoms on one body, with offsets.</summary>
[ManualRow("F006")]
public class CompoundTests
{
    [Fact]
    public void RotationOffset_StandsTheGeomUp_OnABodyThatIsNotTurned()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Sandbox.Floor(simulator);
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 40, 1);
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, body, 40, 10, Vector2.Zero, MathF.PI / 2);
        body.Position = new Vector2(0, -30);
        Sandbox.Run(simulator, 200);
        Assert.Equal(-20, body.Position.Y, 0.1f);
        Assert.InRange(Math.Abs(body.TotalRotation), 0, 0.01f);
        Assert.Equal(MathF.PI / 2, geom.Rotation, 0.01f);
        Assert.Equal(10, geom.AABB.Width, 0.1f);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Offset_IsTurnedByTheBodyAlone_UnlessTheQuirkIsOn(bool quirk)
    {
        var simulator = Sandbox.Falling();
        simulator.Quirks = quirk ? Farseer201Quirks.OffsetTurnedByRotationOffset : Farseer201Quirks.None;
        var body = new Body { IsStatic = true, Position = new Vector2(100, 0) };
        simulator.Add(body);
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, body, 40, 10, new Vector2(60, 0), MathF.PI / 2);
        Vector2 place = quirk ? new Vector2(100, 60) : new Vector2(160, 0);
        Assert.Equal(place.X, geom.Position.X, 1e-3f);
        Assert.Equal(place.Y, geom.Position.Y, 1e-3f);

        // What the queries say is where things collide: the upright rectangle's top is 20 above its place.
        Geom ball = Sandbox.Ball(simulator, place + new Vector2(0, -40));
        Sandbox.Run(simulator, 100);
        Assert.Equal(place.Y - 25, ball.Body.Position.Y, 0.1f);
    }

    [Fact]
    public void Geom_FarFromItsBody_TurnsItWhenHit()
    {
        var simulator = new PhysicsSimulator();
        Body body = BodyFactory.Instance.CreateBody(simulator, 2, 800);
        Sandbox.WithoutDrag(body);
        GeomFactory.Instance.CreateCircleGeom(simulator, body, 5, 16, new Vector2(30, 0), 0);
        GeomFactory.Instance.CreateCircleGeom(simulator, body, 5, 16, new Vector2(-30, 0), 0);
        Geom ball = Sandbox.Ball(simulator, new Vector2(30, -20));
        ball.Body.LinearVelocity = new Vector2(0, 50);
        Sandbox.Run(simulator, 30);

        // Inelastic: j = v / (1/m1 + 1/m2 + r²/I) = 50 / (1 + 1/2 + 900/800) at the moment of impact.
        float j = 50 / 2.625f;
        Assert.Equal(j / 2, body.LinearVelocity.Y, 0.3f);
        Assert.Equal(j * 30 / 800, body.AngularVelocity, 0.02f);

        // Momentum and angular momentum about the origin are kept whatever the details.
        Assert.Equal(50, ball.Body.LinearVelocity.Y + (2 * body.LinearVelocity.Y), 1e-3f);
        Assert.Equal(0, ball.Body.LinearVelocity.X + (2 * body.LinearVelocity.X), 1e-3f);
    }

    [Fact]
    public void Geoms_OfOneBody_DoNotCollideWithEachOther()
    {
        var simulator = new PhysicsSimulator();
        var body = new Body();
        simulator.Add(body);
        int heard = 0;
        for (int i = 0; i < 4; i++)
        {
            GeomFactory.Instance.CreateCircleGeom(simulator, body, 10, 16, new Vector2(5 * i, 0), 0).OnCollision +=
                (_, _, _) => ++heard > 0;
        }

        Sandbox.Run(simulator, 20);
        Assert.Equal(0, heard);
        Assert.Empty(simulator.ArbiterList);
        Assert.Equal(Vector2.Zero, body.LinearVelocity);
        Assert.Equal(4, simulator.CollideAll(7, 0).Count);
    }
}
