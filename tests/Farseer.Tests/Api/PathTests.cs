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

namespace Farseer.Tests.Api;

/// <summary>Paths: what is made, where, and how it is held together.</summary>
public sealed class PathTests
{
    /// <summary>The curve's parameter has single precision: 6e-8 of a path of 200 units or less, twice a link.</summary>
    private const float Rounding = 1e-4f;

    private static Path Straight(float width = 10)
    {
        var path = new Path(width, 4, 2, false);
        path.Add(new Vector2(0, 0));
        path.Add(new Vector2(50, 0));
        path.Add(new Vector2(100, 0));
        return path;
    }

    [Fact]
    public void Update_MakesAsManyLinksAsFit_InARowWithTheirMassAndInertia()
    {
        Path path = Straight();
        path.Update();

        Assert.Equal(10, path.Bodies.Count);
        Assert.All(path.Bodies, b => Assert.Equal(2, b.Mass));
        Assert.All(path.Bodies, b => Assert.Equal(2 * (100 + 16) / 12f, b.MomentOfInertia, 4));
        Assert.All(path.Bodies, b => Assert.Equal(0, b.Rotation));
        for (int i = 1; i < 10; i++)
        {
            // At most two strides of a two-thousandth of the curve's parameter, of which the points span 2/3, too far.
            Assert.InRange(path.Bodies[i].Position.X - path.Bodies[i - 1].Position.X, 10f, 10f + (2 * 1.5f * 100 / 2000) + Rounding);
        }

        Assert.InRange(path.Bodies[0].Position.X, 5f, 5f + (1.5f * 100 / 2000) + Rounding);
        Assert.Empty(path.Geoms);
        Assert.Empty(path.Joints);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(20)]
    [InlineData(40)]
    [InlineData(100)]
    [InlineData(1000)]
    public void CreateChain_OfSoManyLinks_HasSoMany(int links)
    {
        Path chain = ComplexFactory.Instance.CreateChain(new Vector2(-30, 10), new Vector2(170, -80), links, 1, 1, LinkType.RevoluteJoint);

        Assert.Equal(links, chain.Bodies.Count);
        Assert.Equal(links, chain.Geoms.Count);
        Assert.Equal(links - 1, chain.Joints.Count);
    }

    [Fact]
    public void LongPath_IsSpacedExactly_WhereWholeStridesWouldLoseLinks()
    {
        Path rope = ComplexFactory.Instance.CreateRope(Vector2.Zero, new Vector2(200, 0), 2, 1, 1, false, false, 1, LinkType.RevoluteJoint);

        Assert.Equal(100, rope.Bodies.Count);
        for (int i = 0; i < 100; i++)
        {
            Assert.InRange(rope.Bodies[i].Position.X, (2 * i) + 1 - (10 * Rounding), (2 * i) + 1 + (10 * Rounding));
        }
    }

    [Fact]
    public void Update_WithoutAChange_ChangesNothing_AndAfterAMoveStartsOver()
    {
        Path path = Straight();
        path.Update();
        path.CreateGeoms(3);
        path.LinkBodies(LinkType.RevoluteJoint, 0, 0, 0, 0);
        var nail = new FixedRevoluteJoint(new Body(), Vector2.Zero);
        path.Add(nail);
        Body first = path.Bodies[0];

        path.Update();
        Assert.Same(first, path.Bodies[0]);
        Assert.Equal(10, path.Geoms.Count);

        path.MoveControlPoint(new Vector2(0, 100), 2);
        path.MoveControlPoint(new Vector2(0, 50), 1);
        path.Update();
        Assert.Equal(10, path.Bodies.Count);
        Assert.DoesNotContain(first, path.Bodies);

        // Nine times a width and up to two strides, from half a width on.
        Assert.InRange(path.Bodies[9].Position.Y, 95f, 95f + (9.5f * 0.15f) + Rounding);
        Assert.Empty(path.Geoms);
        Assert.Same(nail, Assert.Single(path.Joints));
    }

    [Fact]
    public void Update_OfAPathInASimulator_IsRefused()
    {
        var simulator = new PhysicsSimulator();
        Path path = Straight();
        path.Update();
        path.AddToPhysicsSimulator(simulator);
        path.Add(new Vector2(150, 0));

        Assert.Throws<InvalidOperationException>(path.Update);
        Assert.Equal(10, path.Bodies.Count);

        path.RemoveFromPhysicsSimulator(simulator);
        path.Update();
        Assert.Equal(15, path.Bodies.Count);
    }

    [Theory]
    [InlineData(0, 10f)]
    [InlineData(1, 10f)]
    [InlineData(3, 300f)]
    public void Update_OfAPathThatHasNoRoomForALink_IsRefused(int points, float width)
    {
        var path = new Path(width, 1, 1, false);
        for (int i = 0; i < points; i++)
        {
            path.Add(new Vector2(50 * i, 0));
        }

        Assert.Throws<InvalidOperationException>(path.Update);
        Assert.Empty(path.Bodies);
    }

    [Fact]
    public void Update_OfAPathOfTooManyLinks_IsRefused()
    {
        Path path = Straight(0.001f);
        Assert.Throws<InvalidOperationException>(path.Update);
        Assert.Empty(path.Bodies);
    }

    [Fact]
    public void Update_WithAControlPointThatIsNoPlace_IsRefused()
    {
        Path path = Straight();
        path.ControlPoints[1] = new Vector2(float.NaN, 0);
        Assert.Contains("NaN", Assert.Throws<InvalidOperationException>(path.Update).Message, StringComparison.Ordinal);
        Assert.Empty(path.Bodies);
    }

    [Fact]
    public void ControlPoints_AreFoundMovedAndRemoved()
    {
        Path path = Straight();
        Assert.Equal(1, path.PointInControlPoint(new Vector2(53, -3)));
        Assert.Equal(-1, path.PointInControlPoint(new Vector2(53.1f, 0)));
        path.MoveControlPoint(new Vector2(60, 5), 1);
        Assert.Equal(new Vector2(60, 5), path.ControlPoints[1]);
        path.Remove(0);
        path.Remove(new Vector2(100, 0));
        path.Remove(new Vector2(100, 0));
        Assert.Equal(new Vector2(60, 5), Assert.Single(path.ControlPoints));
        Assert.Throws<ArgumentOutOfRangeException>(() => path.Remove(1));
        Assert.Equal(new Vector2(2, 3), Path.FindMidpoint(new Vector2(1, 5), new Vector2(3, 1)));
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(-1, 0)]
    [InlineData(0, 1)]
    [InlineData(0, -1)]
    [InlineData(-3, 4)]
    public void Pins_JoinTheEndsThatFaceEachOther_WhereverThePathGoes(int x, int y)
    {
        Vector2 end = 100 * Vector2.Normalize(new Vector2(x, y));
        Path chain = ComplexFactory.Instance.CreateChain(Vector2.Zero, end, 10, 2f, 1f, 1, LinkType.PinJoint);
        foreach (Joint joint in chain.Joints)
        {
            var pin = (PinJoint)joint;

            // The gap that the strides leave, 0.15 at most.
            Assert.InRange(pin.TargetDistance, 0f, 0.2f);
            Assert.InRange(
                Vector2.Distance(pin.WorldAnchor1, pin.WorldAnchor2), pin.TargetDistance - Rounding, pin.TargetDistance + Rounding);
            Assert.Equal(0.01f, pin.BiasFactor);
            Assert.Equal(0.05f, pin.Softness);
        }
    }

    [Fact]
    public void Quirk_OfTheFarEnds_LinksAsVersion201Did()
    {
        var simulator = new PhysicsSimulator { Quirks = Farseer201Quirks.PathLinkedAtFarEnds };
        Path chain = ComplexFactory.Instance.CreateChain(simulator, Vector2.Zero, new Vector2(100, 0), 10, 2f, 1f, 1, LinkType.PinJoint);
        float[] lengths = chain.Joints.Select(j => ((PinJoint)j).TargetDistance).ToArray();
        Assert.InRange(lengths[0], 20f, 20.2f);
        Assert.All(lengths.Skip(1), l => Assert.Equal(10, l));
        Assert.All(chain.Joints, j => Assert.Equal(new Vector2(-5, 0), ((PinJoint)j).Anchor1));
    }

    [Fact]
    public void LinkBodies_MakesTheKindThatWasAsked_WithItsConstants()
    {
        Path sliders = Straight();
        sliders.Update();
        sliders.LinkBodies(LinkType.SliderJoint, 1, 3, 0, 0);
        Assert.All(
            sliders.Joints,
            j => Assert.Equal((1f, 3f, 0.2f, 0.01f), (((SliderJoint)j).Min, ((SliderJoint)j).Max, j.BiasFactor, j.Softness)));
        Assert.Equal(9, sliders.Joints.Count);

        Path springs = Straight();
        springs.Update();
        springs.LinkBodies(LinkType.LinearSpring, 0, 0, 70, 5);
        Assert.Equal(9, springs.Springs.Count);
        Assert.Empty(springs.Joints);
        Assert.All(springs.Springs, s => Assert.Equal((70f, 5f), (((LinearSpring)s).SpringConstant, ((LinearSpring)s).DampingConstant)));
        Assert.All(springs.Springs, s => Assert.InRange(((LinearSpring)s).RestLength, 0f, 0.2f));

        Path hinges = Straight();
        hinges.Update();
        hinges.LinkBodies(LinkType.RevoluteJoint, 0, 0, 0, 0);
        for (int i = 0; i < 9; i++)
        {
            Vector2 middle = (hinges.Bodies[i].Position + hinges.Bodies[i + 1].Position) / 2;
            Assert.InRange(Vector2.Distance(middle, ((RevoluteJoint)hinges.Joints[i]).Anchor), 0, Rounding);
        }

        Assert.Throws<ArgumentOutOfRangeException>(() => hinges.LinkBodies(LinkType.SliderJoint, 3, 1, 0, 0));
        Assert.Equal(9, hinges.Joints.Count);
    }

    [Fact]
    public void EndlessPath_LinksTheLastBodyWithTheFirst()
    {
        var points = new Vertices { new(0, -50), new(50, 0), new(0, 50), new(-50, 0), new(-12, -48) };
        Path open = ComplexFactory.Instance.CreateTrack(points, 12, 4, 1, false, 1, LinkType.PinJoint);
        Path closed = ComplexFactory.Instance.CreateTrack(points, 12, 4, 1, true, 1, LinkType.PinJoint);
        Assert.Equal(open.Bodies.Count - 1, open.Joints.Count);
        Assert.Equal(closed.Bodies.Count, closed.Joints.Count);
        var last = (PinJoint)closed.Joints[^1];
        Assert.Same(closed.Bodies[0], last.Body1);
        Assert.Same(closed.Bodies[^1], last.Body2);

        // Half a link of the curve is left at either end.
        Assert.InRange(last.TargetDistance, 0, 12);
        Assert.All(closed.Joints, j => Assert.Equal((0.2f, 0.01f), (j.BiasFactor, j.Softness)));
        Assert.Equal(points[0], closed.ControlPoints[0]);
    }

    [Fact]
    public void CreateGeoms_GivesEachBodyOneRectangle_InTheGroup()
    {
        Path path = Straight();
        path.Update();
        path.CreateGeoms();
        path.CreateGeoms(7);
        Assert.Equal(10, path.Geoms.Count);
        Assert.All(path.Geoms, g => Assert.Equal(0, g.CollisionGroup));
        Assert.Equal(path.Bodies, path.Geoms.Select(g => g.Body));
        Assert.Equal((10f, 4f), (path.Geoms[3].AABB.Width, path.Geoms[3].AABB.Height));

        Path chain = ComplexFactory.Instance.CreateChain(Vector2.Zero, new Vector2(90, 0), 3, 1f, 5, LinkType.RevoluteJoint);
        Assert.All(chain.Geoms, g => Assert.Equal(5, g.CollisionGroup));
        Assert.Equal((30f, 10f), (chain.Geoms[0].AABB.Width, chain.Geoms[0].AABB.Height));
    }

    [Fact]
    public void PinnedEnds_GetFixedHinges()
    {
        Path rope =
            ComplexFactory.Instance.CreateRope(new Vector2(5, 5), new Vector2(105, 5), 10, 2, 1, true, true, 1, LinkType.RevoluteJoint);
        var start = (FixedRevoluteJoint)rope.Joints[^2];
        var end = (FixedRevoluteJoint)rope.Joints[^1];
        Assert.Equal(new Vector2(5, 5), start.Anchor);
        Assert.Same(rope.Bodies[0], start.Body);
        Assert.Equal(rope.ControlPoints[2], end.Anchor);
        Assert.Same(rope.Bodies[^1], end.Body);
        Assert.Equal(11, rope.Joints.Count);
    }

    [Fact]
    public void AddToPhysicsSimulator_AddsEachPartOnce_AndRemoveTakesAllOut()
    {
        var simulator = new PhysicsSimulator();
        ComplexFactory.Instance.SpringConstant = 10;
        Path path = ComplexFactory.Instance.CreateChain(simulator, Vector2.Zero, new Vector2(100, 0), 10, 2f, 1f, 1, LinkType.LinearSpring);
        ComplexFactory.Instance.SpringConstant = 0;
        path.LinkBodies(LinkType.RevoluteJoint, 0, 0, 0, 0);
        path.AddToPhysicsSimulator(simulator);
        path.AddToPhysicsSimulator(simulator);
        simulator.Update(0.01f);
        Assert.Equal(
            (10, 10, 9, 9), (simulator.BodyList.Count, simulator.GeomList.Count, simulator.JointList.Count, simulator.SpringList.Count));

        path.RemoveFromPhysicsSimulator(simulator);
        simulator.Update(0.01f);
        Assert.Equal(
            (0, 0, 0, 0), (simulator.BodyList.Count, simulator.GeomList.Count, simulator.JointList.Count, simulator.SpringList.Count));
    }

    [Fact]
    public void AddToPhysicsSimulator_OfAPathWithAForeignPart_AddsNothing()
    {
        var simulator = new PhysicsSimulator();
        var other = new PhysicsSimulator();
        Path path = ComplexFactory.Instance.CreateChain(Vector2.Zero, new Vector2(100, 0), 10, 2f, 1f, 1, LinkType.RevoluteJoint);
        var joint = new AngleJoint(new Body(), new Body());
        other.Add(joint);
        path.Add(joint);

        Assert.Throws<ArgumentException>(() => path.AddToPhysicsSimulator(simulator));
        Assert.Throws<ArgumentException>(() => path.RemoveFromPhysicsSimulator(simulator));
        simulator.Update(0.01f);
        Assert.Equal((0, 0, 0), (simulator.BodyList.Count, simulator.GeomList.Count, simulator.JointList.Count));
    }

    [Fact]
    public void Factory_GivesSlidersAndSpringsItsConstants()
    {
        ComplexFactory factory = ComplexFactory.Instance;
        try
        {
            (factory.Min, factory.Max, factory.SpringConstant, factory.DampingConstant) = (1, 4, 150, 10);
            Path sliders = factory.CreateChain(Vector2.Zero, new Vector2(100, 0), 10f, 2f, 1f, 1, LinkType.SliderJoint);
            Path springs = factory.CreateChain(Vector2.Zero, new Vector2(100, 0), 10f, 2f, 1f, 1, LinkType.LinearSpring);
            Assert.All(sliders.Joints, j => Assert.Equal((1f, 4f), (((SliderJoint)j).Min, ((SliderJoint)j).Max)));
            Assert.All(
                springs.Springs, s => Assert.Equal((150f, 10f), (((LinearSpring)s).SpringConstant, ((LinearSpring)s).DampingConstant)));
        }
        finally
        {
            (factory.Min, factory.Max, factory.SpringConstant, factory.DampingConstant) = (0, 0, 0, 0);
        }
    }

    [Fact]
    public void Factory_NamesWhatDoesNotFit()
    {
        ComplexFactory factory = ComplexFactory.Instance;
        Assert.Equal("links", Assert.Throws<ArgumentOutOfRangeException>(
            () => factory.CreateChain(Vector2.Zero, Vector2.One, 0, 1f, 1, LinkType.RevoluteJoint)).ParamName);
        Assert.Equal("end", Assert.Throws<ArgumentException>(
            () => factory.CreateChain(Vector2.One, Vector2.One, 3, 1f, 1, LinkType.RevoluteJoint)).ParamName);
        Assert.Equal("width", Assert.Throws<ArgumentException>(
            () => factory.CreateChain(Vector2.Zero, Vector2.One, 10f, 1f, 1f, 1, LinkType.RevoluteJoint)).ParamName);
        Assert.Equal("width", Assert.Throws<ArgumentException>(
            () => factory.CreateRope(Vector2.Zero, new Vector2(100, 0), 0.001f, 1f, 1f, true, true, 1, LinkType.RevoluteJoint)).ParamName);
        Assert.Equal("points", Assert.Throws<ArgumentException>(
            () => factory.CreateTrack(new Vertices { Vector2.One }, 1, 1, 1, true, 1, LinkType.RevoluteJoint)).ParamName);
        Assert.Equal("type", Assert.Throws<ArgumentOutOfRangeException>(
            () => factory.CreateChain(Vector2.Zero, new Vector2(100, 0), 10f, 1f, 1f, 1, (LinkType)4)).ParamName);
    }
}
