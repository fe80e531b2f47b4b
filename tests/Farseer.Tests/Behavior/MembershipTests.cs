using System;
using System.Collections.Generic;
using System.Diagnostics;
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

/// <summary>What comes and goes, and when.</summary>
public class MembershipTests
{
    [Fact]
    public void Added_AppearsAtTheNextUpdate_GeomsAndBodiesTellTheLists()
    {
        var simulator = new PhysicsSimulator();
        int added = 0;
        int removed = 0;
        simulator.BodyList.Added += _ => added++;
        simulator.GeomList.Removed += _ => removed++;
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, 5, 1);
        Geom geom = GeomFactory.Instance.CreateCircleGeom(simulator, body, 5, 16);
        Assert.Empty(simulator.BodyList);
        simulator.Update(0);
        Assert.Single(simulator.BodyList);
        simulator.Update(0.01f);
        Assert.Single(simulator.BodyList);
        Assert.Equal(1, added);
        Assert.Same(geom, simulator.Collide(1, 1));
        simulator.Remove(geom);
        simulator.Update(0.01f);
        Assert.Equal(1, removed);
        Assert.Empty(simulator.GeomList);
        simulator.BroadPhaseCollider = new GridCollider(simulator);
        Assert.IsType<GridCollider>(simulator.BroadPhaseCollider);
    }

    [Fact]
    public void AddThenRemove_BeforeTheUpdate_CancelsOut()
    {
        var simulator = new PhysicsSimulator();
        var other = new PhysicsSimulator();
        var body = new Body();
        simulator.Add(body);
        simulator.Remove(body);
        simulator.Update(0.01f);
        Assert.Empty(simulator.BodyList);
        other.Add(body);
        other.Update(0.01f);
        Assert.Single(other.BodyList);
        other.Remove(body);
        other.Add(body);
        other.Update(0.01f);
        Assert.Single(other.BodyList);
    }

    [Fact]
    public void Clear_GivesEverythingBack_ForUseInAnotherSimulator()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 10));
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, 5, 1);
        Geom geom = GeomFactory.Instance.CreateCircleGeom(simulator, body, 5, 16);
        body.ApplyImpulse(new Vector2(3, 0));
        simulator.Update(0.1f);
        simulator.Clear();
        Assert.Empty(simulator.BodyList);
        Assert.Empty(simulator.GeomList);
        Assert.Equal(new Vector2(0, 10), simulator.Gravity);
        Assert.InRange(body.LinearVelocity.Y, 0.9f, 1.1f);
        var other = new PhysicsSimulator();
        other.Add(body);
        other.Add(geom);
        other.Update(0.1f);
        Assert.Single(other.GeomList);
    }

    [Fact]
    public void Clear_TellsTheListsOfEachItem_OnceAllAreOut()
    {
        var simulator = new PhysicsSimulator();
        var bodies = new List<Body>();
        var geoms = new List<Geom>();
        for (int i = 0; i < 5; i++)
        {
            Body body = BodyFactory.Instance.CreateCircleBody(simulator, 5, 1);
            bodies.Add(body);
            geoms.Add(GeomFactory.Instance.CreateCircleGeom(simulator, body, 5, 16));
        }

        simulator.Update(0.1f);
        var bodiesTold = new List<Body>();
        var geomsTold = new List<Geom>();
        int left = 0;
        simulator.BodyList.Removed += body =>
        {
            bodiesTold.Add(body);
            left += simulator.BodyList.Count;
        };
        simulator.GeomList.Removed += geomsTold.Add;
        simulator.Clear();
        Assert.Equal(bodies, bodiesTold);
        Assert.Equal(geoms, geomsTold);
        Assert.Equal(0, left);
    }

    [Fact]
    public void Clear_OfAQuarterOfAMillionBodies_TakesNoLongerThanTheyAreMany()
    {
        const int Count = 250_000;
        var simulator = new PhysicsSimulator();
        for (int i = 0; i < Count; i++)
        {
            simulator.Add(new Body { Mass = 1, MomentOfInertia = 1 });
        }

        simulator.Update(0.01f);
        Assert.Equal(Count, simulator.BodyList.Count);
        var clock = Stopwatch.StartNew();
        simulator.Clear();

        // Some 0.05 s. One after the other, each moving all behind it, they took 20 s.
        Assert.InRange(clock.Elapsed.TotalSeconds, 0, 5);
        Assert.Empty(simulator.BodyList);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Remove_OfManyBodiesLastFirst_TakesNoLongerThanTheyAreMany(bool disposed)
    {
        const int Count = 100_000;
        var simulator = new PhysicsSimulator();
        for (int i = 0; i < Count; i++)
        {
            simulator.Add(new Body { Mass = 1, MomentOfInertia = 1 });
        }

        simulator.Update(0.01f);
        Body first = simulator.BodyList[0];
        for (int i = Count - 1; i > 0; i--)
        {
            Body body = simulator.BodyList[i];
            if (disposed)
            {
                body.Dispose();
            }
            else
            {
                simulator.Remove(body);
            }
        }

        var clock = Stopwatch.StartNew();
        simulator.Update(0.01f);

        // Some 0.05 s. One after the other, each looked for from the start, they took over 10 s.
        Assert.InRange(clock.Elapsed.TotalSeconds, 0, 5);
        Assert.Equal([first], simulator.BodyList);
    }

    [Theory]
    [InlineData(false, false)]
    [InlineData(false, true)]
    [InlineData(true, false)]
    [InlineData(true, true)]
    public void Remove_OfManyJointsOrSpringsLastFirst_TakesNoLongerThanTheyAreMany(bool springs, bool disposed)
    {
        const int Count = 100_000;
        var simulator = new PhysicsSimulator();
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, 1, 1);
        for (int i = 0; i < Count; i++)
        {
            if (springs)
            {
                simulator.Add(new FixedLinearSpring(body, Vector2.Zero, Vector2.UnitX, 0, 0));
            }
            else
            {
                simulator.Add(new FixedAngleJoint(body) { Enabled = false });
            }
        }

        simulator.Update(0.01f);
        object first = springs ? simulator.SpringList[0] : simulator.JointList[0];
        for (int i = Count - 1; i > 0; i--)
        {
            if (springs && disposed)
            {
                simulator.SpringList[i].Dispose();
            }
            else if (springs)
            {
                simulator.Remove(simulator.SpringList[i]);
            }
            else if (disposed)
            {
                simulator.JointList[i].Dispose();
            }
            else
            {
                simulator.Remove(simulator.JointList[i]);
            }
        }

        var clock = Stopwatch.StartNew();
        simulator.Update(0.01f);

        // Some 0.05 s. One after the other, each looked for from the start, they took over 5 s.
        Assert.InRange(clock.Elapsed.TotalSeconds, 0, 2.5);
        Assert.Equal<object>([first], springs ? simulator.SpringList : simulator.JointList);
    }

    [Theory]
    [InlineData(false, false)]
    [InlineData(false, true)]
    [InlineData(true, false)]
    [InlineData(true, true)]
    public void Remove_OfEveryOtherJoint_LeavesTheOthersInOrder_WhetherSomebodyListensOrNot(bool heard, bool disposed)
    {
        var simulator = new PhysicsSimulator();
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, 1, 1);
        var joints = new List<FixedAngleJoint>();
        var told = new List<int>();
        for (int i = 0; i < 40; i++)
        {
            joints.Add(new FixedAngleJoint(body));
            simulator.Add(joints[i]);
        }

        simulator.Update(0.01f);
        if (heard)
        {
            simulator.JointList.Removed += joint =>
            {
                Assert.DoesNotContain(joint, simulator.JointList);
                told.Add(joints.IndexOf((FixedAngleJoint)joint));
            };
        }

        for (int i = 0; i < 40; i += 2)
        {
            if (disposed)
            {
                joints[i].Dispose();
            }
            else
            {
                simulator.Remove(joints[i]);
            }
        }

        simulator.Update(0.01f);
        Assert.Equal(joints.Where((_, i) => i % 2 == 1), simulator.JointList);
        Assert.Equal(heard ? Enumerable.Range(0, 20).Select(i => 2 * i) : [], told);

        // What left can come back, and leave again.
        if (!disposed)
        {
            simulator.Add(joints[0]);
            simulator.Update(0.01f);
            Assert.Same(joints[0], simulator.JointList[20]);
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Remove_OfEveryOther_LeavesTheOthersInOrder_WhetherSomebodyListensOrNot(bool heard)
    {
        var simulator = new PhysicsSimulator();
        var told = new List<int>();
        for (int i = 0; i < 40; i++)
        {
            Body body = BodyFactory.Instance.CreateCircleBody(simulator, 1, 1);
            body.Position = new Vector2(i * 1.5f, 0);
            GeomFactory.Instance.CreateCircleGeom(simulator, body, 1, 16);
        }

        simulator.Update(0.01f);
        Body[] bodies = [.. simulator.BodyList];
        Geom[] geoms = [.. simulator.GeomList];
        if (heard)
        {
            simulator.BodyList.Removed += _ => told.Add(simulator.BodyList.Count);
            simulator.GeomList.Removed += _ => told.Add(simulator.GeomList.Count);
        }

        for (int i = 38; i >= 0; i -= 2)
        {
            if (i % 4 == 0)
            {
                simulator.Remove(geoms[i]);
                simulator.Remove(bodies[i]);
            }
            else
            {
                bodies[i].Dispose();
            }
        }

        simulator.Update(0.01f);
        Assert.Equal(bodies.Where((_, i) => i % 2 == 1), simulator.BodyList);
        Assert.Equal(geoms.Where((_, i) => i % 2 == 1), simulator.GeomList);

        // Told of each once it is out: 10 geoms and bodies removed, then as many disposed.
        IEnumerable<int> removed = Enumerable.Range(30, 10).Reverse();
        IEnumerable<int> disposed = Enumerable.Range(20, 10).Reverse();
        Assert.Equal(heard ? removed.Concat(removed).Concat(disposed).Concat(disposed) : [], told);
    }

    [Fact]
    public void GeomOfABodyThatIsNotAdded_IsAnObstacle()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        var ground = new Body { Position = new Vector2(0, 20), LinearVelocity = new Vector2(7, 0) };
        GeomFactory.Instance.CreateRectangleGeom(simulator, ground, 100, 20);
        Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 5, 1);
        GeomFactory.Instance.CreateCircleGeom(simulator, ball, 5, 16);
        for (int i = 0; i < 200; i++)
        {
            simulator.Update(0.01f);
        }

        Assert.InRange(ball.Position.Y, 4.9f, 5.1f);
        Assert.Equal(new Vector2(0, 20), ground.Position);

        // Added, it takes its velocity up and falls.
        simulator.Add(ground);
        simulator.Update(0.01f);
        Assert.True(ground.Position.X > 0);
        Assert.True(ground.Position.Y > 20);
    }

    [Fact]
    public void SetBody_MovesTheGeomAtTheNextUpdate()
    {
        var simulator = new PhysicsSimulator();
        Body a = BodyFactory.Instance.CreateCircleBody(simulator, 5, 1);
        Body b = BodyFactory.Instance.CreateCircleBody(simulator, 5, 1);
        b.Position = new Vector2(100, 0);
        Geom geom = GeomFactory.Instance.CreateCircleGeom(simulator, a, 5, 16);
        simulator.Update(0.01f);
        geom.SetBody(b);
        simulator.Update(0.01f);
        Assert.Equal(new Vector2(100, 0), geom.Position);
        Assert.Same(geom, simulator.Collide(100, 0));
        a.Dispose();
        simulator.Update(0.01f);
        Assert.Single(simulator.GeomList);
        b.Dispose();
        simulator.Update(0.01f);
        Assert.Empty(simulator.GeomList);
        Assert.Empty(simulator.BodyList);
    }

    [Fact]
    public void Additions_CapsuleSegmentChain_CarryABall()
    {
        Action<PhysicsSimulator, Body>[] grounds =
        {
            (s, b) => GeomFactory.Instance.CreateCapsuleGeom(s, b, new Vector2(-50, 5), new Vector2(50, 5), 5),
            (s, b) => GeomFactory.Instance.CreateSegmentGeom(s, b, new Vector2(-50, 0), new Vector2(50, 0)),
            (s, b) => GeomFactory.Instance.CreateChainGeom(
                s, b, new Vertices { new Vector2(-50, 0), new Vector2(0, 0), new Vector2(50, 0) }, false),
        };
        foreach (Action<PhysicsSimulator, Body> make in grounds)
        {
            var simulator = new PhysicsSimulator(new Vector2(0, 100));
            Body ground = BodyFactory.Instance.CreateBody(simulator, 1, 1);
            ground.IsStatic = true;
            make(simulator, ground);
            Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 5, 1);
            ball.Position = new Vector2(1, -10);
            GeomFactory.Instance.CreateCircleGeom(simulator, ball, 5, 16);
            for (int i = 0; i < 200; i++)
            {
                simulator.Update(0.01f);
            }

            Assert.InRange(ball.Position.Y, -5.01f, -4.9f);
        }
    }

    [Fact]
    public void Kinematic_MovesWithItsVelocity_AndCarriesWhatRests()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        Body lift = BodyFactory.Instance.CreateRectangleBody(simulator, 100, 20, 1);
        lift.IsKinematic = true;
        lift.LinearVelocity = new Vector2(0, -10);
        GeomFactory.Instance.CreateRectangleGeom(simulator, lift, 100, 20);
        Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 5, 1);
        ball.Position = new Vector2(0, -15);
        GeomFactory.Instance.CreateCircleGeom(simulator, ball, 5, 16);
        for (int i = 0; i < 100; i++)
        {
            simulator.Update(0.01f);
        }

        Assert.Equal(-10, lift.Position.Y, 3);
        Assert.InRange(ball.Position.Y, -25.1f, -24.8f);
    }

    [Fact]
    public void Diagnostics_AreMeasuredOnlyWhenAskedFor()
    {
        var simulator = new PhysicsSimulator();
        simulator.Update(0.01f);
        Assert.Equal(-1, simulator.UpdateTime);
        Assert.Equal(-1, simulator.NarrowPhaseCollisionTime);
        simulator.EnableDiagnostics = true;
        simulator.Update(0.01f);
        Assert.True(simulator.UpdateTime >= 0);
        Assert.True(simulator.ApplyImpulsesTime >= 0);
    }

    [Fact]
    public void Clear_WithAHandlerThatThrows_TakesEverythingOutAndThrowsThen()
    {
        var simulator = new PhysicsSimulator();
        Body[] bodies = [.. Enumerable.Range(0, 3).Select(i => BodyFactory.Instance.CreateBody(simulator, 1, 1))];
        Geom[] geoms = [.. bodies.Select(b => GeomFactory.Instance.CreateCircleGeom(simulator, b, 1, 8))];
        simulator.Update(0.01f);
        int told = 0;
        GeomList.ContentsChangedEventHandler bad = _ =>
        {
            told++;
            Assert.Empty(simulator.BodyList);
            throw new FormatException();
        };
        simulator.GeomList.Removed += bad;
        simulator.BodyList.Removed += _ => told++;
        Assert.Throws<FormatException>(simulator.Clear);
        Assert.Equal(6, told);
        Assert.Empty(simulator.BodyList);
        Assert.Empty(simulator.GeomList);
        simulator.Update(0.01f);

        // And so does the end of a simulator.
        Array.ForEach(geoms, simulator.Add);
        Array.ForEach(bodies, simulator.Add);
        simulator.Update(0.01f);
        Assert.Throws<FormatException>(simulator.Dispose);
        Assert.Throws<ObjectDisposedException>(() => simulator.Update(0.01f));
        Assert.Empty(simulator.BodyList);
        simulator.Dispose();
    }
}
