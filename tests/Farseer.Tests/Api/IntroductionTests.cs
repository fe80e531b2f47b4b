using System;
using System.Linq;
using System.Numerics;
using System.Reflection;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>The manual's introduction: what the parts are and how a game uses them.</summary>
public class IntroductionTests
{
    [Fact]
    [ManualRow("F001")]
    public void Library_NeedsNothingButTheFramework()
    {
        foreach (Assembly assembly in new[] { typeof(Body).Assembly, Assembly.Load("Farseer.Engine") })
        {
            string[] foreign = assembly.GetReferencedAssemblies()
                .Select(name => name.Name!)
                .Where(name => name != "netstandard" && name != "Farseer.Engine" && !name.StartsWith("System", StringComparison.Ordinal))
                .ToArray();
            Assert.Empty(foreign);
        }
    }

    [Fact]
    [ManualRow("F002")]
    [ManualRow("F007")]
    public void MainLoop_ForceAndTorqueEachFrame_DriveAnEntityAlongTheClosedForm()
    {
        var simulator = new PhysicsSimulator();
        var body = new Body { Mass = 2, MomentOfInertia = 4, LinearDragCoefficient = 0, RotationalDragCoefficient = 0 };
        simulator.Add(body);
        Vector2 entityPosition = default;
        float entityRotation = 0;
        for (int frame = 0; frame < 100; frame++)
        {
            body.ApplyForce(new Vector2(60, 0));
            body.ApplyTorque(8);
            simulator.Update(0.01f);
            entityPosition = body.Position;
            entityRotation = body.Rotation;
        }

        // x = F/m t²/2 and angle = T/I t²/2 with t = 1; the forces act in each of the 100 frames, none is lost or used twice.
        Assert.Equal(15, entityPosition.X, 1e-3f);
        Assert.Equal(0, entityPosition.Y);
        Assert.Equal(1, entityRotation, 1e-4f);
        Assert.Equal(30, body.LinearVelocity.X, 1e-3f);
        Assert.Equal(2, body.AngularVelocity, 1e-4f);
    }

    [Fact]
    [ManualRow("F008")]
    public void Simulator_IsGivenBodiesGeomsJointsAndSprings_AndUpdatesAllOfThem()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        var floor = new Body { IsStatic = true, Position = new Vector2(0, 110) };
        var faller = new Body { LinearDragCoefficient = 0 };
        var hung = new Body { Position = new Vector2(200, 0) };
        var pulled = new Body { Position = new Vector2(400, 0), IgnoreGravity = true, LinearDragCoefficient = 0 };
        simulator.Add(floor);
        simulator.Add(faller);
        simulator.Add(hung);
        simulator.Add(pulled);
        simulator.Add(new Geom(floor, Vertices.CreateRectangle(100, 20), 0));
        simulator.Add(new Geom(faller, Vertices.CreateRectangle(10, 10), 0));
        simulator.Add(new FixedRevoluteJoint(hung, new Vector2(200, 0)));
        simulator.Add(new FixedLinearSpring(pulled, Vector2.Zero, new Vector2(430, 0), 4, 0) { RestLength = 0 });
        Assert.Equal((0, 0, 0, 0), Counts(simulator));
        simulator.Update(0.01f);
        Assert.Equal((4, 2, 1, 1), Counts(simulator));

        // ½·g·t² after half a second; then it lies on the floor, whose surface is at 100.
        Sandbox.Run(simulator, 49);
        Assert.Equal(12.5f, faller.Position.Y, 1e-3f);
        Sandbox.Run(simulator, 450);
        Assert.Equal(95, faller.Position.Y, 0.1f);

        // The joint holds its body, the spring swings its own with ω² = k/m = 4 from 30 away: cos(10) after 5 s.
        Assert.Equal(0, hung.Position.Y, 1e-3f);
        Assert.Equal(430 - (30 * Math.Cos(10)), pulled.Position.X, 0.05);
    }

    private static (int Bodies, int Geoms, int Joints, int Springs) Counts(PhysicsSimulator simulator) =>
        (simulator.BodyList.Count, simulator.GeomList.Count, simulator.JointList.Count, simulator.SpringList.Count);

    [Fact]
    [ManualRow("F003")]
    [ManualRow("F004")]
    public void Bodies_WithoutGeoms_PassThroughEachOther_WithGeomsTheyCollide()
    {
        foreach (bool hasGeoms in new[] { false, true })
        {
            var simulator = new PhysicsSimulator();
            Body left = BodyFactory.Instance.CreateCircleBody(simulator, 5, 1);
            Body right = BodyFactory.Instance.CreateCircleBody(simulator, 5, 1);
            left.Position = new Vector2(-20, 0);
            right.Position = new Vector2(20, 0);
            left.LinearVelocity = new Vector2(50, 0);
            if (hasGeoms)
            {
                Assert.Same(left, GeomFactory.Instance.CreateCircleGeom(simulator, left, 5, 16).Body);
                GeomFactory.Instance.CreateCircleGeom(simulator, right, 5, 16);
            }

            Sandbox.Run(simulator, 200);
            Assert.Equal(hasGeoms, right.LinearVelocity.X > 10);
            Assert.Equal(hasGeoms, left.Position.X < right.Position.X);
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    [ManualRow("F005")]
    public void Polygon_ConcaveOrConvex_IsSolidExactlyWhereItsOutlineIs(bool isConcave)
    {
        // The L lacks the upper right quarter of the square.
        Vertices outline = isConcave
            ? Sandbox.Outline(-20, -20, 0, -20, 0, 0, 20, 0, 20, 20, -20, 20)
            : Sandbox.Outline(-20, -20, 20, -20, 20, 20, -20, 20);
        var simulator = Sandbox.Falling();
        var body = new Body { IsStatic = true };
        simulator.Add(body);
        var geom = new Geom(body, outline, 0);
        simulator.Add(geom);
        Assert.Equal(!isConcave, geom.Collide(new Vector2(10, -10)));
        Assert.True(geom.Collide(new Vector2(-10, -10)));
        Geom ball = Sandbox.Ball(simulator, new Vector2(12, -40));
        Sandbox.Run(simulator, 200);

        // It rests on the upper side of the square or in the notch of the L, sunk in by no more than AllowedPenetration, 0.05.
        Assert.InRange(ball.Body.Position.Y, isConcave ? -5.01f : -25.01f, isConcave ? -4.9f : -24.9f);
    }

    [Fact]
    [ManualRow("F006")]
    public void SeveralGeoms_OnOneBody_MoveAndCollideAsOne()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Geom floor = Sandbox.Floor(simulator);
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 400);
        body.Position = new Vector2(0, -30);
        Geom left = GeomFactory.Instance.CreateCircleGeom(simulator, body, 5, 16, new Vector2(-20, 0), 0);
        Geom right = GeomFactory.Instance.CreateCircleGeom(simulator, body, 5, 16, new Vector2(20, 0), 0);
        Sandbox.Run(simulator, 200);
        Assert.Same(left.Body, right.Body);
        Assert.Equal(new Vector2(40, 0), right.Position - left.Position);
        Assert.InRange(body.Position.Y, -5.01f, -4.9f);
        Assert.Equal(2, simulator.ArbiterList.Count);
        Assert.All(simulator.ArbiterList, arbiter => Assert.Same(floor, arbiter.GeomA));
    }

    [Fact]
    [ManualRow("F009")]
    public void Add_Body_IsWhatMakesItFall()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        var added = new Body();
        var other = new Body();
        simulator.Add(added);
        Sandbox.Run(simulator, 10);
        Assert.Same(added, Assert.Single(simulator.BodyList));
        Assert.True(added.Position.Y > 0);
        Assert.Equal(Vector2.Zero, other.Position);
        Assert.Throws<ArgumentNullException>(() => simulator.Add((Body)null!));
    }

    [Fact]
    [ManualRow("F010")]
    public void Update_TakesSeconds_AndTheRealTimeDoesNotMatterWithoutScaling()
    {
        var first = new PhysicsSimulator();
        var second = new PhysicsSimulator();
        var a = new Body { LinearVelocity = new Vector2(30, 0), LinearDragCoefficient = 0 };
        var b = new Body { LinearVelocity = new Vector2(30, 0), LinearDragCoefficient = 0 };
        first.Add(a);
        second.Add(b);
        for (int i = 0; i < 8; i++)
        {
            first.Update(0.125f);
            second.Update(0.125f, 0.5f);
        }

        // 30 lengths a second for one second; an eighth is exact in binary.
        Assert.Equal(30f, a.Position.X);
        Assert.Equal(a.PositionX, b.PositionX);
        Assert.Throws<ArgumentOutOfRangeException>(() => first.Update(-0.01f));
        Assert.Throws<ArgumentOutOfRangeException>(() => first.Update(float.NaN));
        Assert.Equal(30f, a.Position.X);
    }
}
