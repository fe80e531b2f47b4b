using System;
using System.Collections.Generic;
using System.Globalization;
using System.Numerics;
using System.Text;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Games;

public sealed class StepEventTests
{
    [Fact]
    public void Contact_BeginsOnceAndEndsOnce()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        simulator.RecordedEvents = StepEventKinds.Contacts;
        Geom box = Box(simulator, new Vector2(0, -30));
        int begun = 0;
        int ended = 0;
        for (int i = 0; i < 200; i++)
        {
            simulator.Update(Step);
            foreach (ContactEvent e in simulator.Events.ContactsBegun)
            {
                Assert.Same(floor, e.GeomA);
                Assert.Same(box, e.GeomB);
                begun++;
            }

            ended += simulator.Events.ContactsEnded.Length;
        }

        Assert.Equal((1, 0), (begun, ended));
        box.Body.Position = new Vector2(0, -300);
        simulator.Update(Step);
        Assert.Equal(0, simulator.Events.ContactsBegun.Length);
        Assert.Equal(1, simulator.Events.ContactsEnded.Length);
        simulator.Update(Step);
        Assert.Equal(0, simulator.Events.ContactsEnded.Length);
    }

    [Fact]
    public void Contact_OfAGeomThatIsRemoved_Ends()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        simulator.RecordedEvents = StepEventKinds.Contacts;
        Geom box = Box(simulator, new Vector2(0, -9.9f));
        simulator.Update(Step);
        Assert.Equal(1, simulator.Events.ContactsBegun.Length);
        simulator.Remove(box);
        simulator.Update(Step);
        ContactEvent ended = Assert.Single(simulator.Events.ContactsEnded.ToArray());
        Assert.Same(floor, ended.GeomA);
        Assert.Same(box, ended.GeomB);
    }

    /// <summary>
    /// A drop of 20 at 100 length/s²: √(2·100·20) = 63.2, less the gravity of one substep, 0.2, and a push of mass times that, and weight
    /// for what is left of the step.
    /// </summary>
    [Fact]
    public void Hit_OfABoxThatFalls_TellsHowHard()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        simulator.RecordedEvents = StepEventKinds.Hits;
        Geom box = Box(simulator, new Vector2(3, -30), mass: 2);
        var hits = new List<HitEvent>();
        for (int i = 0; i < 200; i++)
        {
            simulator.Update(Step);
            hits.AddRange(simulator.Events.Hits.ToArray());
        }

        HitEvent hit = Assert.Single(hits);
        Assert.Same(floor, hit.GeomA);
        Assert.Same(box, hit.GeomB);
        Assert.InRange(hit.ApproachSpeed, 62.5f, 63.3f);
        Assert.InRange(hit.NormalImpulse, 2 * 62.5f, 2 * 65);
        Assert.Equal(new Vector2(0, -1), hit.Normal);
        Assert.Equal(0, hit.Point.Y, 0.05);
        Assert.InRange(hit.Point.X, -7.1f, 13.1f);
    }

    [Fact]
    public void Hit_SlowerThanHitSpeed_IsNone()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        simulator.RecordedEvents = StepEventKinds.Hits;
        simulator.HitSpeed = 70;
        Box(simulator, new Vector2(3, -30));
        for (int i = 0; i < 200; i++)
        {
            simulator.Update(Step);
            Assert.Equal(0, simulator.Events.Hits.Length);
        }
    }

    [Fact]
    public void Hit_OfABulletOnAWall_IsExact()
    {
        PhysicsSimulator simulator = Falling(0);
        simulator.RecordedEvents = StepEventKinds.Hits;
        Geom ball = Ball(simulator, new Vector2(-100, 0), 1, 3);
        Geom wall = Box(simulator, new Vector2(101, 0), 2, 100);
        wall.Body.IsStatic = true;
        ball.Body.LinearVelocity = new Vector2(30000, 0);
        simulator.Update(Step);
        HitEvent hit = Assert.Single(simulator.Events.Hits.ToArray());
        Assert.Equal(30000, hit.ApproachSpeed, 0.1);
        Assert.Equal(90000, hit.NormalImpulse, 0.9);
        Assert.Equal(100, hit.Point.X, 0.02);
        Assert.Equal(new Vector2(1, 0), hit.Normal);
    }

    [Fact]
    public void Sensor_TellsWhoComesAndGoes()
    {
        PhysicsSimulator simulator = Falling();
        simulator.RecordedEvents = StepEventKinds.Sensors;
        Geom gate = Box(simulator, new Vector2(0, 50), 100, 20);
        gate.IsSensor = true;
        gate.Body.IsStatic = true;
        Geom ball = Ball(simulator, Vector2.Zero);
        var told = new StringBuilder();
        for (int i = 0; i < 150; i++)
        {
            simulator.Update(Step);
            foreach (SensorEvent e in simulator.Events.SensorsEntered)
            {
                Assert.Same(gate, e.Sensor);
                Assert.Same(ball, e.Visitor);
                told.Append('+');
            }

            foreach (SensorEvent e in simulator.Events.SensorsLeft)
            {
                Assert.Same(ball, e.Visitor);
                told.Append('-');
            }

            Assert.Equal(0, simulator.Events.ContactsBegun.Length);
        }

        Assert.Equal("+-", told.ToString());
    }

    [Fact]
    public void JointAndSpring_ThatBreak_AreTold()
    {
        PhysicsSimulator simulator = Falling();
        simulator.RecordedEvents = StepEventKinds.Breaks;
        Body bob = Ball(simulator, new Vector2(0, 50)).Body;
        Body other = Ball(simulator, new Vector2(100, 50)).Body;
        FixedRevoluteJoint joint = JointFactory.Instance.CreateFixedRevoluteJoint(simulator, bob, Vector2.Zero);
        joint.BreakForce = 50;
        FixedLinearSpring spring =
            SpringFactory.Instance.CreateFixedLinearSpring(simulator, other, Vector2.Zero, new Vector2(100, 0), 1, 0);
        spring.Breakpoint = 20;
        var joints = new List<Joint>();
        var springs = new List<Spring>();
        for (int i = 0; i < 200; i++)
        {
            simulator.Update(Step);
            joints.AddRange(simulator.Events.BrokenJoints.ToArray());
            springs.AddRange(simulator.Events.BrokenSprings.ToArray());
        }

        Assert.Same(joint, Assert.Single(joints));
        Assert.Same(spring, Assert.Single(springs));
    }

    [Fact]
    public void Body_ThatFallsAsleepAndWakes_IsTold()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        simulator.AllowSleep = true;
        simulator.RecordedEvents = StepEventKinds.Sleep;
        Body box = Box(simulator, new Vector2(0, -10)).Body;
        var told = new StringBuilder();
        for (int i = 0; i < 200; i++)
        {
            simulator.Update(Step);
            told.Append('s', simulator.Events.FellAsleep.Length).Append('w', simulator.Events.Woke.Length);
            if (i == 150)
            {
                Assert.False(box.Awake);
                box.ApplyImpulse(new Vector2(0, -100));
            }
        }

        Assert.Equal("sw", told.ToString());
    }

    [Fact]
    public void Body_ThatMoves_IsTold_AndOneAtRestIsNot()
    {
        PhysicsSimulator simulator = Falling(0);
        simulator.RecordedEvents = StepEventKinds.Moves;
        Body still = Box(simulator, Vector2.Zero).Body;
        Body moving = Box(simulator, new Vector2(100, 0)).Body;
        moving.LinearVelocity = new Vector2(1, 0);
        simulator.Update(Step);
        Assert.Same(moving, Assert.Single(simulator.Events.Moved.ToArray()));
        moving.LinearVelocity = Vector2.Zero;
        simulator.Update(Step);
        Assert.Equal(0, simulator.Events.Moved.Length);
        still.Position = new Vector2(0, 5);
        simulator.Update(Step);
        Assert.Same(still, Assert.Single(simulator.Events.Moved.ToArray()));
    }

    [Fact]
    public void Handler_GetsNormalsFromItsFirstArgumentToItsSecond()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        Geom box = Box(simulator, new Vector2(0, -9.9f));
        var ofFloor = new List<float>();
        var ofBox = new List<float>();
        floor.OnCollision += (_, _, contacts) => Note(contacts, ofFloor);
        box.OnCollision += (_, _, contacts) => Note(contacts, ofBox);
        Run(simulator, 5);
        Assert.NotEmpty(ofFloor);
        Assert.All(ofFloor, y => Assert.Equal(-1, y, 1e-6f));
        Assert.Equal(ofFloor.Count, ofBox.Count);
        Assert.All(ofBox, y => Assert.Equal(1, y, 1e-6f));
    }

    [Fact]
    public void Events_AreTheSame_WithAnyNumberOfWorkers()
    {
        string one = RunHeap(1);
        Assert.Equal(one, RunHeap(4));
        Assert.Contains("begin", one, StringComparison.Ordinal);
        Assert.Contains("hit", one, StringComparison.Ordinal);
        Assert.Contains("sleep", one, StringComparison.Ordinal);
    }

    [Fact]
    public void Events_ReadEachUpdate_AllocateNothing()
    {
        PhysicsSimulator simulator = Heap(1);
        int seen = 0;

        // Until all that flies about has met what it will, and the lists are as long as they get.
        for (int i = 0; i < 600; i++)
        {
            simulator.Update(Step);
            seen += Count(simulator.Events);
        }

        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 100; i++)
        {
            simulator.Update(Step);
            seen += Count(simulator.Events);
        }

        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
        Assert.True(seen > 0);
    }

    [Fact]
    public void Kind_ThatIsNotRecorded_StaysEmpty()
    {
        PhysicsSimulator simulator = Heap(1);
        simulator.RecordedEvents = StepEventKinds.None;
        for (int i = 0; i < 60; i++)
        {
            simulator.Update(Step);
            Assert.Equal(0, Count(simulator.Events));
        }
    }

    private static bool Note(ContactList contacts, List<float> normals)
    {
        foreach (Contact contact in contacts)
        {
            normals.Add(contact.Normal.Y);
        }

        return true;
    }

    private static PhysicsSimulator Heap(int workers)
    {
        PhysicsSimulator simulator = WithFloor(out _);
        simulator.WorkerCount = workers;
        simulator.AllowSleep = true;
        simulator.RecordedEvents = StepEventKinds.All;
        for (int i = 0; i < 80; i++)
        {
            Box(simulator, new Vector2(((i % 8) * 21) - 80 + (i % 3), -20 - (i / 8 * 22)), 20, 16).FrictionCoefficient = 0.4f;
        }

        Ball(simulator, new Vector2(-180, -50)).Body.LinearVelocity = new Vector2(4000, 0);

        // One that nothing disturbs, and that falls asleep.
        Box(simulator, new Vector2(0, 500), 20, 16).Body.IsStatic = true;
        Box(simulator, new Vector2(0, 484), 20, 16);
        return simulator;
    }

    private static int Count(StepEvents events) =>
        events.ContactsBegun.Length + events.ContactsEnded.Length + events.Hits.Length + events.Pushes.Length + events.Moved.Length
        + events.FellAsleep.Length;

    private static string RunHeap(int workers)
    {
        using PhysicsSimulator simulator = Heap(workers);
        var number = new Dictionary<Geom, int>();
        var text = new StringBuilder();
        for (int i = 0; i < 200; i++)
        {
            simulator.Update(Step);
            for (int k = 0; k < simulator.GeomList.Count; k++)
            {
                number[simulator.GeomList[k]] = k;
            }

            foreach (ContactEvent e in simulator.Events.ContactsBegun)
            {
                text.Append(CultureInfo.InvariantCulture, $"begin {number[e.GeomA]} {number[e.GeomB]};");
            }

            foreach (ContactEvent e in simulator.Events.ContactsEnded)
            {
                text.Append(CultureInfo.InvariantCulture, $"end {number[e.GeomA]} {number[e.GeomB]};");
            }

            foreach (HitEvent e in simulator.Events.Hits)
            {
                text.Append(
                    CultureInfo.InvariantCulture,
                    $"hit {number[e.GeomA]} {number[e.GeomB]} {e.ApproachSpeed:R} {e.NormalImpulse:R} {e.Point.X:R};");
            }

            foreach (PushEvent e in simulator.Events.Pushes)
            {
                text.Append(CultureInfo.InvariantCulture, $"push {number[e.GeomA]} {number[e.GeomB]} {e.Impulse.X:R};");
            }

            foreach (Body body in simulator.Events.FellAsleep)
            {
                text.Append(CultureInfo.InvariantCulture, $"sleep {simulator.BodyList.IndexOf(body)};");
            }
        }

        return text.ToString();
    }
}
