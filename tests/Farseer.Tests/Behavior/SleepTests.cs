using System.Collections.Generic;
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

/// <summary>Sleeping bodies of a simulator; what wakes them in the engine is tested there.</summary>
public class SleepTests
{
    private readonly PhysicsSimulator _simulator = new PhysicsSimulator(new Vector2(0, 100)) { AllowSleep = true };
    private readonly List<Geom> _boxes = new List<Geom>();

    public SleepTests()
    {
        Body floor = BodyFactory.Instance.CreateRectangleBody(_simulator, 400, 20, 1);
        floor.IsStatic = true;
        floor.Position = new Vector2(0, 10);
        GeomFactory.Instance.CreateRectangleGeom(_simulator, floor, 400, 20).FrictionCoefficient = 0.6f;
        for (int i = 0; i < 3; i++)
        {
            _boxes.Add(Box(new Vector2(0, -5 - (10 * i))));
        }
    }

    [Fact]
    public void Simulator_ByDefault_LetsNothingSleep()
    {
        Assert.False(new PhysicsSimulator().AllowSleep);
        Assert.Equal(0.5f, _simulator.TimeToSleep);
        Assert.True(_boxes[0].Body.Awake);
        Assert.True(_boxes[0].Body.SleepingAllowed);
        _simulator.AllowSleep = false;
        Step(600);
        Assert.Equal(0, _simulator.SleepingBodyCount);
    }

    [Fact]
    public void Stack_FallsAsleep_AndSettingAVelocityByReferenceWakesIt()
    {
        Settle();
        Assert.All(_boxes, b => Assert.False(b.Body.Awake));
        Vector2 read = _boxes[2].Body.LinearVelocity;
        Assert.Equal(Vector2.Zero, read);
        Step(2);
        Assert.Equal(3, _simulator.SleepingBodyCount);
        _boxes[2].Body.LinearVelocity.X = 30;
        Step(1);
        Assert.All(_boxes, b => Assert.True(b.Body.Awake));
        Assert.True(_boxes[2].Body.Position.X > 0.2f);
        Settle();
    }

    [Fact]
    public void Stack_IsWokenByForcesImpulsesAndChanges_OfAnyBodyOfIt()
    {
        Body top = _boxes[2].Body;
        foreach (System.Action wake in new System.Action[]
        {
            () => top.ApplyForce(new Vector2(0, -1)),
            () => top.ApplyForceAtLocalPoint(new Vector2(0, -1), Vector2.One),
            () => top.ApplyForceAtWorldPoint(new Vector2(0, -1), top.Position),
            () => top.ApplyTorque(1),
            () => top.ApplyImpulse(new Vector2(0, -1)),
            () => top.ApplyAngularImpulse(1),
            () => top.Awake = true,
            () => top.Mass = 2,
            () => top.Position += new Vector2(0, -0.01f),
            () => _boxes[1].FrictionCoefficient = 0.4f,
            () => _boxes[1].OnCollision += (_, _, _) => true,
        })
        {
            Settle();
            wake();
            Step(1);
            Assert.Equal(0, _simulator.SleepingBodyCount);
        }

        Settle();
        top.ApplyForce(Vector2.Zero);
        Step(1);
        Assert.Equal(3, _simulator.SleepingBodyCount);
    }

    [Fact]
    public void Impulse_OnASleepingBody_ActsInFullInTheNextUpdate()
    {
        Settle();
        Body top = _boxes[2].Body;
        top.ApplyImpulse(new Vector2(0, -20 * top.Mass));
        Step(1);

        // 20 less the fall of a step, 100/100.
        Assert.Equal(-19, top.LinearVelocity.Y, 0.05f);
    }

    [Fact]
    public void Spring_ThatChangesOrGoes_WakesWhatHangsOnIt()
    {
        Body hanging = BodyFactory.Instance.CreateRectangleBody(_simulator, 4, 4, 1);
        hanging.Position = new Vector2(100, -50);
        var spring = new FixedLinearSpring(hanging, Vector2.Zero, new Vector2(100, -70), 50, 20);
        _simulator.Add(spring);
        Settle(4000);
        spring.RestLength += 1;
        Step(1);
        Assert.True(hanging.Awake);
        Settle(4000);
        spring.Enabled = false;
        Step(20);
        Assert.True(hanging.Awake);
        Assert.True(hanging.LinearVelocity.Y > 15);
        spring.Enabled = true;
        Settle(6000);
        _simulator.Remove(spring);
        Step(20);
        Assert.True(hanging.LinearVelocity.Y > 15);
    }

    [Fact]
    public void Body_ThatMayNotSleep_KeepsTheStackAwake()
    {
        _boxes[1].Body.SleepingAllowed = false;
        Step(600);
        Assert.Equal(0, _simulator.SleepingBodyCount);
        _boxes[1].Body.SleepingAllowed = true;
        Settle();
    }

    [Fact]
    public void Body_MadeAsleep_HangsInTheAirUntilItIsWoken()
    {
        Geom crate = Box(new Vector2(50, -100));
        crate.Body.Awake = false;
        Assert.False(crate.Body.Awake);
        Step(100);
        Assert.Equal(-100, crate.Body.Position.Y);
        crate.Body.Awake = true;
        Step(10);
        Assert.True(crate.Body.Position.Y > -100);
    }

    [Fact]
    public void Handlers_OfSleepingGeoms_AreNotCalled_AndQueriesFindThem()
    {
        int touches = 0;
        int parts = 0;
        _boxes[1].OnCollision += (_, _, _) => ++touches > 0;
        _boxes[1].OnSeparation += (_, _) => parts++;
        Settle();
        touches = 0;
        Step(50);
        Assert.Equal(0, touches);
        Assert.Equal(0, parts);
        Assert.Equal(3, _simulator.ArbiterList.Count);
        Assert.True(_simulator.RayCast(new Vector2(-50, -15), new Vector2(50, -15), out RayCastHit hit));
        Assert.Same(_boxes[1], hit.Geom);
        _simulator.Remove(_boxes[2]);
        Step(1);
        Assert.Equal(1, parts);
        Assert.Equal(1, touches);
    }

    [Fact]
    public void Clear_WithSleepingBodies_LeavesThemUsable()
    {
        Settle();
        Body body = _boxes[0].Body;
        _simulator.Clear();
        Assert.Equal(0, _simulator.SleepingBodyCount);
        Assert.True(body.Awake);
        _simulator.Add(body);
        Step(10);
        Assert.True(body.LinearVelocity.Y > 5);
    }

    /// <summary>
    /// In a world without gravity a limit stops what swings against it, up to the rounding of its speed: 8 of these 300 went on at 1e-16
    /// rad/s for ever, and never slept.
    /// </summary>
    [Fact]
    public void Body_StoppedByALimitWithoutGravity_FallsAsleep()
    {
        for (int i = 0; i < 300; i++)
        {
            using var simulator = new PhysicsSimulator { AllowSleep = true };
            Body post = BodyFactory.Instance.CreateBody(simulator, 1, 1);
            post.IsStatic = true;
            Body rod = BodyFactory.Instance.CreateRectangleBody(simulator, 2, 0.4f, 1);
            rod.LinearDragCoefficient = rod.RotationalDragCoefficient = 0;
            RevoluteJoint hinge = JointFactory.Instance.CreateRevoluteJoint(simulator, post, rod, Vector2.Zero);
            hinge.LowerLimit = -1;
            hinge.UpperLimit = 1;
            hinge.AreLimitsEnabled = i % 2 == 0;
            rod.AngularVelocity = -1 - (0.0173f * i);
            for (int step = 0; step < 200 && rod.Awake; step++)
            {
                if (step == 45)
                {
                    hinge.AreLimitsEnabled = true;
                }

                simulator.Update(1 / 60f);
            }

            Assert.False(rod.Awake, $"{i}: {rod.AngularVelocity} rad/s");
        }
    }

    private Geom Box(Vector2 position)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(_simulator, 10, 10, 1);
        body.Position = position;
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(_simulator, body, 10, 10);
        geom.FrictionCoefficient = 0.6f;
        return geom;
    }

    private void Settle(int atMost = 2000)
    {
        for (int i = 0; i < atMost && (i < 2 || _simulator.SleepingBodyCount < _simulator.BodyList.Count - 1); i++)
        {
            Step(1);
        }

        Assert.Equal(_simulator.BodyList.Count - 1, _simulator.SleepingBodyCount);
    }

    private void Step(int count)
    {
        for (int i = 0; i < count; i++)
        {
            _simulator.Update(0.01f);
        }
    }
}
