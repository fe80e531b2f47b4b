using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Paths of each kind of link hang, swing and lie as their links say. y points down, gravity is 100.</summary>
public sealed class PathMotionTests
{
    private const float Dt = 0.01f;
    private const int Links = 6;
    private const float Stiffness = 2000f;

    [Fact]
    public void Hinges_HoldAHangingPathAtItsLength()
    {
        Path path = Hung(LinkType.RevoluteJoint, out PhysicsSimulator simulator);
        double before = Length(path);
        Settle(simulator);

        Assert.All(path.Joints, j => Assert.InRange(j.JointError, 0, 1e-3));
        Assert.Equal(before, Length(path), 1e-2);
        AssertHangs(path);
    }

    [Fact]
    public void Pins_KeepTheDistanceOfTheEnds()
    {
        Path path = Hung(LinkType.PinJoint, out PhysicsSimulator simulator);
        Settle(simulator);

        Assert.All(path.Joints.OfType<PinJoint>(), p =>
            Assert.InRange(Vector2.Distance(p.WorldAnchor1, p.WorldAnchor2), p.TargetDistance - 0.01f, p.TargetDistance + 0.01f));
        AssertHangs(path);
    }

    [Fact]
    public void Sliders_HangAtTheirLongest()
    {
        Path path = Hung(LinkType.SliderJoint, out PhysicsSimulator simulator);
        Settle(simulator);

        // The limit may be passed by its slop, 0.01, and held there.
        Assert.All(path.Joints.OfType<SliderJoint>(), s => Assert.InRange(Vector2.Distance(s.WorldAnchor1, s.WorldAnchor2), 3.98f, 4.02f));
        AssertHangs(path);
    }

    [Fact]
    public void Springs_StretchByTheWeightBelowThem()
    {
        Path path = Hung(LinkType.LinearSpring, out PhysicsSimulator simulator);
        Settle(simulator);
        for (int i = 0; i < path.Springs.Count; i++)
        {
            var spring = (LinearSpring)path.Springs[i];
            float stretch = Vector2.Distance(
                spring.Body1!.GetWorldPosition(spring.AttachPoint1),
                spring.Body2!.GetWorldPosition(spring.AttachPoint2)) - spring.RestLength;
            float wanted = (Links - 1 - i) * 100f / Stiffness;
            Assert.InRange(stretch, wanted * 0.98f, wanted * 1.02f);
        }

        AssertHangs(path);
    }

    [Fact]
    public void SoftAndStiffLinks_CanBeHadTogether()
    {
        Path path = Hung(LinkType.RevoluteJoint, out PhysicsSimulator simulator);
        path.LinkBodies(LinkType.LinearSpring, 0, 0, Stiffness, 50);
        path.AddToPhysicsSimulator(simulator);
        Settle(simulator);

        Assert.All(path.Joints, j => Assert.InRange(j.JointError, 0, 1e-3));
        Assert.Equal(Links - 1, simulator.SpringList.Count);
    }

    [Fact]
    public void LinksOfAGroup_LieFoldedOnTheFloor_AndOnNothingElse()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 400, 20, 1);
        floor.IsStatic = true;
        floor.Position = new Vector2(0, 110);
        Geom ground = GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 400, 20);
        Path path =
            ComplexFactory.Instance.CreateChain(simulator, Vector2.Zero, new Vector2(60, 60), 12, 4f, 1f, 5, LinkType.RevoluteJoint);
        var met = new System.Collections.Generic.HashSet<Geom>();
        foreach (Geom geom in path.Geoms)
        {
            geom.OnCollision += (_, other, _) =>
            {
                met.Add(other);
                return true;
            };
        }

        Settle(simulator);
        Assert.Same(ground, Assert.Single(met));
        Assert.All(path.Bodies, b => Assert.InRange(b.Position.Y, 0, 101));
    }

    [Fact]
    public void EndlessTrack_SpunAsAWhole_StaysClosed()
    {
        var simulator = new PhysicsSimulator();
        var points = new Vertices();
        for (int i = 0; i <= 12; i++)
        {
            points.Add(new Vector2((float)(50 * Math.Cos(i * Math.PI / 6)), (float)(50 * Math.Sin(i * Math.PI / 6))));
        }

        Path track = ComplexFactory.Instance.CreateTrack(simulator, points, 15.5f, 4, 1, true, 1, LinkType.RevoluteJoint);
        foreach (Body body in track.Bodies)
        {
            body.LinearVelocity = 2 * new Vector2(-body.Position.Y, body.Position.X);
            body.AngularVelocity = 2;
        }

        double radius = track.Bodies.Average(b => b.Position.Length());
        for (int i = 0; i < 200; i++)
        {
            simulator.Update(Dt);
        }

        // The links' softness lets the hinges give way to the pull of the spin: m v²/r on 20 links in all, 200 each.
        Assert.All(track.Joints, j => Assert.InRange(j.JointError, 0, 0.5));
        Assert.Equal(radius, track.Bodies.Average(b => b.Position.Length()), 1.0);
        Assert.All(track.Bodies, b => Assert.InRange(b.AngularVelocity, 1.5f, 2.5f));
    }

    /// <summary>Six links of 20, nailed at the top of the first.</summary>
    private static Path Hung(LinkType type, out PhysicsSimulator simulator)
    {
        simulator = new PhysicsSimulator(new Vector2(0, 100));
        var path = new Path(20, 4, 1, false);
        path.Add(new Vector2(5, 5));
        path.Add(new Vector2(5, 65));
        path.Add(new Vector2(5, 125));
        path.Update();
        path.CreateGeoms(1);
        path.LinkBodies(type, 1, 4, Stiffness, 50);
        path.Add(new FixedRevoluteJoint(path.Bodies[0], new Vector2(5, 5)));
        foreach (Joint joint in path.Joints)
        {
            joint.Softness = 0;
        }

        foreach (Body body in path.Bodies)
        {
            body.LinearDragCoefficient = 1;
            body.RotationalDragCoefficient = 200;
        }

        path.AddToPhysicsSimulator(simulator);
        return path;
    }

    private static void Settle(PhysicsSimulator simulator)
    {
        for (int i = 0; i < 1500; i++)
        {
            simulator.Update(Dt);
        }
    }

    private static double Length(Path path) => Vector2.Distance(path.Bodies[0].Position, path.Bodies[^1].Position);

    /// <summary>All bodies below the nail, one under the other and at rest.</summary>
    private static void AssertHangs(Path path)
    {
        Assert.Equal(Links, path.Bodies.Count);
        Assert.All(path.Bodies, b => Assert.InRange(b.Position.X, 4f, 6f));
        Assert.All(path.Bodies, b => Assert.InRange(b.LinearVelocity.Length(), 0, 0.5f));
        Assert.Equal(path.Bodies.OrderBy(b => b.Position.Y), path.Bodies);
    }
}
