using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Concave outlines collide as they are: not as their hulls, and not as loose parts.</summary>
[ManualRow("F005")]
public class ConcaveOutlineTests
{
    [Fact]
    public void U_ThatFalls_HoldsTheBallInIt()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Geom floor = Sandbox.Floor(simulator);
        Vertices outline = Sandbox.Outline(-30, -40, -20, -40, -20, -10, 20, -10, 20, -40, 30, -40, 30, 0, -30, 0);
        Body body = BodyFactory.Instance.CreatePolygonBody(simulator, outline, 4);
        float toBottom = -body.Position.Y;
        Geom cup = GeomFactory.Instance.CreatePolygonGeom(simulator, body, outline, 0);
        body.Position = new Vector2(0, -50);
        Geom ball = Sandbox.Ball(simulator, new Vector2(3, -65), 8);
        Sandbox.Run(simulator, 400);
        Assert.Equal(-toBottom, body.Position.Y, 0.1f);
        Assert.InRange(Math.Abs(body.TotalRotation), 0, 0.01f);

        // On the inner floor of the U, 10 above its bottom, and between its arms.
        Assert.Equal(-18, ball.Body.Position.Y, 0.15f);
        Assert.InRange(ball.Body.Position.X - body.Position.X, -12.1f, 12.1f);
        Assert.Equal(2, simulator.ArbiterList.Count);
        Assert.Contains(simulator.ArbiterList, arbiter => arbiter.GeomA == floor && arbiter.GeomB == cup);
        Assert.Contains(simulator.ArbiterList, arbiter => arbiter.GeomA == cup && arbiter.GeomB == ball);

        // Carried: the arm that comes takes the ball along.
        body.LinearVelocity = new Vector2(60, 0);
        Sandbox.Run(simulator, 100);
        Assert.InRange(ball.Body.Position.X - body.Position.X, -12.2f, 12.2f);
        Assert.True(ball.Body.Position.X > 15);
    }

    [Theory]
    [InlineData(10, -18)]
    [InlineData(-30, -48)]
    public void L_IsTouchedOnBothItsLevels(float x, float restsAt)
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        var body = new Body { IsStatic = true };
        simulator.Add(body);
        simulator.Add(new Geom(body, Sandbox.Outline(-40, -40, -20, -40, -20, -10, 40, -10, 40, 0, -40, 0), 0));
        Geom ball = Sandbox.Ball(simulator, new Vector2(x, -80), 8);
        Sandbox.Run(simulator, 300);
        Assert.Equal(restsAt, ball.Body.Position.Y, 0.1f);
        Assert.Equal(x, ball.Body.Position.X, 0.1f);
    }

    [Fact]
    public void Star_StandsOnTwoTips_AndABoxRestsBetweenItsUpperOnes()
    {
        const float Outer = 40;
        PhysicsSimulator simulator = Sandbox.Falling();
        Geom floor = Sandbox.Floor(simulator);
        floor.FrictionCoefficient = 1;
        var outline = new Vertices();
        for (int i = 0; i < 10; i++)
        {
            float angle = (-MathF.PI / 2) + (i * MathF.PI / 5);
            outline.Add((i % 2 == 0 ? Outer : Outer / 2) * new Vector2(MathF.Cos(angle), MathF.Sin(angle)));
        }

        Assert.False(outline.IsConvex());
        Body body = BodyFactory.Instance.CreatePolygonBody(simulator, outline, 5);
        Geom star = GeomFactory.Instance.CreatePolygonGeom(simulator, body, outline, 0);
        star.FrictionCoefficient = 1;
        body.Position = new Vector2(0, -45);
        body.Rotation = 0.1f;
        Sandbox.Run(simulator, 400);

        // Two tips are 36 degrees either side of straight down.
        Assert.Equal(-Outer * MathF.Cos(MathF.PI / 5), body.Position.Y, 0.1f);
        Assert.Equal(0, MathF.IEEERemainder(body.TotalRotation, 2 * MathF.PI / 5), 0.01f);
        Arbiter stand = Assert.Single(simulator.ArbiterList);
        Assert.Equal(2, stand.ContactList.Count);

        // Between two tips there is room: a small ball there touches neither the star nor is pushed out.
        Vector2 notch = body.Position + new Vector2(0, 28);
        Geom pebble = Sandbox.Ball(simulator, notch, 3);
        Sandbox.Run(simulator, 30);
        Assert.InRange(pebble.Body.Position.X - notch.X, -0.5f, 0.5f);
        Assert.InRange(pebble.Body.Position.Y, -3.01f, -2.9f);
    }

    [Fact]
    public void Outline_InEitherOrder_CollidesTheSame()
    {
        float[] places = new float[2];
        for (int order = 0; order < 2; order++)
        {
            PhysicsSimulator simulator = Sandbox.Falling();
            Vertices outline = Sandbox.Outline(-40, -40, -20, -40, -20, -10, 40, -10, 40, 0, -40, 0);
            if (order == 1)
            {
                outline.Reverse();
            }

            var body = new Body { IsStatic = true };
            simulator.Add(body);
            simulator.Add(new Geom(body, outline, 0));
            Geom ball = Sandbox.Ball(simulator, new Vector2(0, -40), 8);
            ball.Body.LinearVelocity = new Vector2(-30, 0);
            Sandbox.Run(simulator, 60);
            places[order] = ball.Body.Position.Y;
            Assert.InRange(ball.Body.Position.X, -12.1f, 0);
        }

        Assert.Equal(places[0], places[1], 1e-3f);
    }

    [Fact]
    public void SetVertices_OfAGeomInUse_ChangesWhatItCollidesWith()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        var body = new Body { IsStatic = true };
        simulator.Add(body);
        var geom = new Geom(body, Sandbox.Outline(-40, -20, 40, -20, 40, 0, -40, 0), 0);
        simulator.Add(geom);
        Geom ball = Sandbox.Ball(simulator, new Vector2(0, -28), 8);
        Sandbox.Run(simulator, 50);
        Assert.Equal(-28, ball.Body.Position.Y, 0.1f);
        geom.SetVertices(Sandbox.Outline(-40, -40, -20, -40, -20, -10, 20, -10, 20, -40, 40, -40, 40, 0, -40, 0));
        Sandbox.Run(simulator, 150);
        Assert.Equal(-18, ball.Body.Position.Y, 0.1f);
    }
}
