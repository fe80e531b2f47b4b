using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Api.SpringTests;

namespace Farseer.Tests.Behavior;

/// <summary>Controllers: fluids, waves, inactivity, the additions, and those that users write.</summary>
public class ControllerTests
{
    [Fact]
    [ManualRow("F295")]
    [ManualRow("F296")]
    public void InactivityController_Enabled_DisablesBodiesThatRestAndWakesThemByOthers()
    {
        var simulator = new PhysicsSimulator();
        InactivityController controller = simulator.InactivityController;
        Assert.False(controller.Enabled);
        Assert.Equal(100, controller.ActivationDistance);
        Assert.Equal(1000, controller.MaxIdleTime);
        controller.Enabled = true;
        controller.MaxIdleTime = 200;
        controller.ActivationDistance = 50;
        Body slow = Free(simulator, 0, 0);
        Body always = Free(simulator, 0, 300);
        Body fast = Free(simulator, -200, 30);
        slow.IsAutoIdle = fast.IsAutoIdle = true;
        slow.LinearVelocity = always.LinearVelocity = new Vector2(1, 0);
        fast.LinearVelocity = new Vector2(100, 0);
        Run(simulator, 40);
        Assert.Same(controller, simulator.ControllerList[0]);
        Assert.False(slow.Enabled);
        Assert.True(always.Enabled);
        Assert.True(fast.Enabled);
        Assert.Equal(2, controller.BodiesEnabled);
        Assert.False(controller.IsInActivationDistance(slow, fast));
        float place = slow.Position.X;
        Run(simulator, 60);
        Assert.Equal(place, slow.Position.X, 3);
        Run(simulator, 100);
        Assert.True(slow.Enabled);
        Assert.True(slow.Position.X > place);
    }

    [Fact]
    [ManualRow("F294")]
    public void Simulator_UpdatedOnAnotherThread_GivesTheSameStatesInEveryFrame()
    {
        // As the sample does it: the physics has a thread of its own that runs while the game draws what it copied, and they meet once a
        // frame, where the game reads places and gives forces.
        const int Frames = 100;
        PhysicsSimulator here = SpringyPile();
        PhysicsSimulator there = SpringyPile();
        using var begun = new System.Threading.SemaphoreSlim(0);
        using var done = new System.Threading.SemaphoreSlim(0);
        int updates = 0;
        int updater = 0;
        var thread = new System.Threading.Thread(() =>
        {
            updater = Environment.CurrentManagedThreadId;
            for (int frame = 0; frame < Frames; frame++)
            {
                begun.Wait();
                there.Update(0.01f);
                updates++;
                done.Release();
            }
        });
        thread.Start();
        var drawn = new List<Vector2>();
        for (int frame = 0; frame < Frames; frame++)
        {
            Body pushedHere = here.BodyList.Count > 0 ? here.BodyList[here.BodyList.Count - 1] : new Body();
            Body pushedThere = there.BodyList.Count > 0 ? there.BodyList[there.BodyList.Count - 1] : new Body();
            pushedHere.ApplyForce(new Vector2(frame, -frame));
            pushedThere.ApplyForce(new Vector2(frame, -frame));
            begun.Release();
            here.Update(0.01f);
            Assert.All(drawn, place => Assert.True(float.IsFinite(place.X) && float.IsFinite(place.Y)));
            Assert.True(done.Wait(TimeSpan.FromMinutes(1)), "The thread of the physics does not answer.");
            drawn.Clear();
            foreach (Body body in there.BodyList)
            {
                drawn.Add(body.Position);
            }

            Assert.Equal(frame + 1, updates);
            Assert.Equal(here.MotionHash(), there.MotionHash());
        }

        thread.Join();
        Assert.NotEmpty(drawn);
        Assert.NotEqual(Environment.CurrentManagedThreadId, updater);
    }

    [Fact]
    public void InactivityController_WithAThousandBodiesThatRest_LeavesNoneEnabled()
    {
        var simulator = new PhysicsSimulator(Vector2.Zero);
        simulator.InactivityController.Enabled = true;
        for (int i = 0; i < 1000; i++)
        {
            Sandbox.Ball(simulator, new Vector2(20 * (i % 40), 20 * (i / 40))).Body.IsAutoIdle = true;
        }

        Run(simulator, 110);
        Assert.Equal(0, simulator.InactivityController.BodiesEnabled);

        // One that is pushed and hits its neighbours wakes those around it.
        Body pushed = simulator.BodyList[500];
        pushed.Enabled = true;
        pushed.LinearVelocity = new Vector2(300, 0);
        Run(simulator, 10);
        Assert.InRange(simulator.InactivityController.BodiesEnabled, 10, 200);
    }

    [Fact]
    public void FluidDragController_LetsLightThingsFloatAndHeavyOnesSink()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        var water = new FluidDragController();
        water.Initialize(new AABBFluidContainer(new AABB(new Vector2(-500, 0), new Vector2(500, 1000))), 0.002f, 50, 1, simulator.Gravity);
        Assert.Equal(0.002f, water.Density);
        Assert.Equal(50, water.LinearDragCoefficient);
        Assert.Equal(1, water.RotationalDragCoefficient);
        simulator.Add(water);
        var entered = new List<Geom>();
        water.Entry += entered.Add;
        Geom light = Sandbox.Ball(simulator, new Vector2(0, -60), 20, 1, 64);
        Geom heavy = Sandbox.Ball(simulator, new Vector2(100, -60), 20, 5, 64);
        Geom dry = Sandbox.Ball(simulator, new Vector2(200, -60), 20, 1, 64);
        water.AddGeom(light);
        water.AddGeom(light);
        water.AddGeom(heavy);
        water.AddGeom(dry);
        water.RemoveGeom(dry);
        Run(simulator, 3000);

        // Mass 1 displaces 1/0.002 = 500 of the circle's 1257, so it floats a bit more than half out.
        Assert.InRange(light.Body.PositionY, -6, -1);
        Assert.InRange(light.Body.LinearVelocity.Length(), 0, 0.5f);
        Assert.True(heavy.Body.PositionY > 500);
        Assert.True(dry.Body.PositionY > heavy.Body.PositionY);
        Assert.Equal([light, heavy], entered);
        water.Reset();
        Run(simulator, 1);
        Assert.Equal([light, heavy, light], entered[..3]);
        heavy.Body.Dispose();
        light.Dispose();
        Run(simulator, 2);
        Assert.False(water.IsDisposed);
    }

    [Fact]
    public void FluidDragController_InThickFluid_StopsABodyAndThrowsItNotBack()
    {
        var simulator = new PhysicsSimulator();
        var tar = new FluidDragController();
        tar.Initialize(new AABBFluidContainer(new AABB(new Vector2(-500, -500), new Vector2(500, 500))), 1, 1e6f, 1e6f, Vector2.Zero);
        simulator.Add(tar);
        Geom ball = Sandbox.Ball(simulator, Vector2.Zero, 20, 1, 32);
        ball.Body.LinearVelocity = new Vector2(100, 0);
        ball.Body.AngularVelocity = 10;
        tar.AddGeom(ball);
        for (int i = 0; i < 50; i++)
        {
            simulator.Update(0.01f);
            Assert.InRange(ball.Body.LinearVelocity.X, -1e-3f, 100);
            Assert.InRange(ball.Body.AngularVelocity, -1e-3f, 10);
        }

        Assert.InRange(ball.Body.PositionX, 0, 1);
    }

    [Fact]
    public void WaveController_IsAContainerWhoseSurfaceRunsFromTheGenerator()
    {
        var simulator = new PhysicsSimulator();
        var wave = new WaveController
        {
            Position = new Vector2(0, 100),
            Width = 200,
            Height = 80,
            NodeCount = 21,
            Frequency = 0.02f,
            WaveGeneratorMin = -500,
            WaveGeneratorMax = 500,
            WaveGeneratorStep = 100,
        };
        Assert.Equal(0.95f, wave.DampingCoefficient);
        Assert.Null(wave.CurrentWave);
        Vector2 point = new(50, 100.5f);
        Assert.False(wave.Contains(ref point));
        wave.Initialize();
        Assert.Equal(21, wave.XPosition!.Length);
        Assert.True(wave.Contains(ref point));
        Assert.Equal(new Vector2(50, 100), wave.VectorNearWaveEdge);
        Assert.Equal(60, wave.VectorFarWaveEdge.X, 4);
        Assert.Equal(point, wave.VectorPoint);
        Vector2 above = new(50, 99);
        Vector2 beside = new(201, 120);
        Vector2 below = new(50, 181);
        Assert.False(wave.Contains(ref above));
        Assert.False(wave.Contains(ref beside));
        Assert.False(wave.Contains(ref below));
        Assert.True(wave.Intersect(new AABB(new Vector2(40, 90), new Vector2(60, 110))));
        Assert.False(wave.Intersect(new AABB(new Vector2(40, 70), new Vector2(60, 90))));
        wave.Disturb(5, -30);
        Assert.True(wave.Contains(ref above));
        Assert.True(wave.Intersect(new AABB(new Vector2(40, 70), new Vector2(60, 90))));
        simulator.Add(wave);
        Run(simulator, 200);
        Assert.NotEqual(0, wave.CurrentWave![1]);
        Assert.Equal(0, wave.CurrentWave[0]);
        Assert.NotEqual(0, wave.PreviousWave![10]);
    }

    [Fact]
    public void GravityController_HoldsABodyInItsOrbit()
    {
        var simulator = new PhysicsSimulator();
        simulator.Add(new GravityController(Vector2.Zero, 1e6f, 1));
        Body planet = Free(simulator, 100, 0);
        planet.LinearVelocity = new Vector2(0, 100);
        Body heedless = Free(simulator, 200, 0);
        heedless.IgnoreGravity = true;
        for (int i = 0; i < 1000; i++)
        {
            simulator.Update(0.002f);
            Assert.InRange(planet.Position.Length(), 98, 102);
        }

        Assert.Equal(new Vector2(200, 0), heedless.Position);
    }

    /// <summary>
    /// An orbit of radius r and speed v takes 2πr/v. A force found at the start of each step would widen it by a share of (2π/n)² · n/2 a
    /// turn, 2 % for a thousand steps; found in the middle, the motion neither gains nor loses, and only the phase is off, by (2π/n)²/24 of
    /// the turn.
    /// </summary>
    [Fact]
    public void GravityController_BringsABodyBackAfterATurn()
    {
        const int Steps = 200;
        const int Turns = 50;
        var simulator = new PhysicsSimulator();
        simulator.Add(new GravityController(Vector2.Zero, 100, 1));
        Body planet = Free(simulator, 4, 0);
        planet.LinearVelocity = new Vector2(0, 5);
        float dt = (float)(2 * Math.PI * 4 / 5 / Steps);
        for (int i = 0; i < Steps * Turns; i++)
        {
            simulator.Update(dt);
            Assert.InRange(planet.Position.Length(), 3.995f, 4.005f);
        }
    }

    [Fact]
    public void WaveController_GivenAnotherNumberOfNodes_KeepsItsSurfaceUntilItIsLaidOutAnew()
    {
        var wave = new WaveController { Width = 200, Height = 80, NodeCount = 21 };
        wave.Initialize();
        Vector2 point = new(150, 10);
        foreach (int count in new[] { 0, 1, 5, int.MaxValue })
        {
            wave.NodeCount = count;
            Assert.True(wave.Contains(ref point));
            Assert.Equal(150, wave.VectorNearWaveEdge.X, 3);
            Assert.Throws<ArgumentException>("XPosition", () => wave.XPosition = new float[5]);
        }

        wave.XPosition = new float[21];
        wave.NodeCount = 5;
        wave.Initialize();
        Assert.Equal(5, wave.CurrentWave!.Length);
        wave.XPosition = new float[5];
    }

    [Fact]
    public void FluidDragController_PassesOverAGeomWithoutABody_UntilItHasOne()
    {
        var simulator = new PhysicsSimulator();
        var water = new FluidDragController();
        water.Initialize(new AABBFluidContainer(new AABB(new Vector2(-500, -500), new Vector2(500, 500))), 1, 1, 1, new Vector2(0, 10));
        simulator.Add(water);
        var geom = new Geom();
        geom.SetVertices(Vertices.CreateRectangle(20, 20));
        water.AddGeom(geom);
        Run(simulator, 2);
        Body body = Free(simulator, 0, 100);
        geom.SetBody(body);
        simulator.Add(geom);
        Run(simulator, 2);
        Assert.NotEqual(0, body.LinearVelocity.Y);
    }

    [Fact]
    public void WindController_CarriesBodiesUpToItsOwnSpeed()
    {
        var simulator = new PhysicsSimulator();
        var wind = new WindController(new Vector2(30, 0), 1e5f)
        {
            Area = new AABB(new Vector2(-100, -50), new Vector2(1e6f, 50)),
            Filter = body => body.Tag is null,
        };
        simulator.Add(wind);
        Body carried = Free(simulator, 0, 0);
        Body outside = Free(simulator, 0, 100);
        Body spared = Free(simulator, 0, 20);
        spared.Tag = "spared";
        Run(simulator, 50);
        Assert.Equal(30, carried.LinearVelocity.X, 3);
        Assert.Equal(Vector2.Zero, outside.LinearVelocity);
        Assert.Equal(Vector2.Zero, spared.LinearVelocity);
    }

    [Fact]
    public void ExplosionController_ThrowsBodiesAwayOnce()
    {
        var simulator = new PhysicsSimulator();
        var explosions = new ExplosionController();
        simulator.Add(explosions);
        Body near = Free(simulator, 10, 0);
        Body far = Free(simulator, 0, -150);
        far.Mass = 2;
        Body beyond = Free(simulator, 0, 250);
        explosions.Explode(Vector2.Zero, 200, 100);
        Run(simulator, 3);
        Assert.Equal(95, near.LinearVelocity.X, 3);
        Assert.Equal(-12.5f, far.LinearVelocity.Y, 3);
        Assert.Equal(Vector2.Zero, beyond.LinearVelocity);
    }

    [Fact]
    public void VelocityLimitController_CutsWhatIsAboveTheLimit()
    {
        var simulator = new PhysicsSimulator();
        simulator.Add(new VelocityLimitController(50, 3));
        Body body = Free(simulator, 0, 0);
        body.LinearVelocity = new Vector2(300, 400);
        body.AngularVelocity = -10;
        Run(simulator, 1);
        Assert.Equal(30, body.LinearVelocity.X, 3);
        Assert.Equal(40, body.LinearVelocity.Y, 3);
        Assert.Equal(-3, body.AngularVelocity, 3);
    }

    [Fact]
    public void ControllersOfTheUsersOwn_ActInOrder_BeforeTheSprings()
    {
        var simulator = new PhysicsSimulator();
        var calls = new List<string>();
        Body body = Free(simulator, 0, 0);
        simulator.Add(new Caller("a", calls));
        var second = new Caller("b", calls) { Tag = 5 };
        simulator.Add(second);
        FixedLinearSpring spring = SpringFactory.Instance.CreateFixedLinearSpring(simulator, body, Vector2.Zero, Vector2.UnitX, 1, 1);
        spring.RestLength = 0;
        spring.Breakpoint = 0.5f;
        spring.Broke += (_, _) => calls.Add("spring");
        Run(simulator, 1);
        Assert.Equal(["a", "b", "spring"], calls);
        second.Enabled = false;
        Run(simulator, 1);
        Assert.Equal("a", calls[^1]);
        int removed = 0;
        simulator.ControllerList.Removed += _ => removed++;
        second.Dispose();
        Run(simulator, 1);
        Assert.Equal(1, removed);
        Assert.Equal(2, simulator.ControllerList.Count);
        simulator.Clear();
        Assert.Empty(simulator.ControllerList);
        Run(simulator, 1);
        Assert.Equal([simulator.InactivityController], simulator.ControllerList);
    }

    [Fact]
    public void ControllerThatDisposesAndRemovesThingsInItsUpdate_LeavesTheStepWhole()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 10));
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 50, 0);
        FixedLinearSpring spring = SpringFactory.Instance.CreateFixedLinearSpring(simulator, a, Vector2.Zero, Vector2.Zero, 1, 1);
        var mischief = new Caller("x", []);
        mischief.Then = () =>
        {
            a.Dispose();
            simulator.Remove(b);
            spring.Dispose();
            simulator.Remove(mischief);
            simulator.Add(new Caller("y", []));
            mischief.Then = null;
        };
        simulator.Add(mischief);
        Run(simulator, 3);
        Assert.Empty(simulator.BodyList);
        Assert.Empty(simulator.SpringList);
        Assert.Equal(2, simulator.ControllerList.Count);
    }

    [Fact]
    public void Update_WithEveryController_AllocatesNothing()
    {
        PhysicsSimulator simulator = SpringyPile();
        simulator.InactivityController.Enabled = true;
        var wave = new WaveController
        {
            Position = new Vector2(-300, 0),
            Width = 600,
            Height = 300,
            NodeCount = 30,
            Frequency = 0.02f,
            WaveGeneratorStep = 5,
        };
        wave.Initialize();
        var water = new FluidDragController();
        water.Initialize(wave, 0.002f, 0.5f, 1, simulator.Gravity);
        foreach (Body body in simulator.BodyList)
        {
            body.IsAutoIdle = true;
        }

        water.AddGeom(Sandbox.Ball(simulator, new Vector2(0, 0)));
        simulator.Add(wave);
        simulator.Add(water);
        simulator.Add(new GravityController(Vector2.Zero, 1e3f, 5));
        simulator.Add(new WindController(Vector2.UnitX, 0.1f));
        simulator.Add(new VelocityLimitController(500, 50));
        var explosions = new ExplosionController();
        simulator.Add(explosions);
        explosions.Explode(Vector2.Zero, 10, 1);
        Run(simulator, 100);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 100; i++)
        {
            explosions.Explode(Vector2.Zero, 10, 1);
            simulator.Update(0.01f);
        }

        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    [Fact]
    public void BadInput_IsRefusedByName()
    {
        var simulator = new PhysicsSimulator();
        Assert.Throws<ArgumentNullException>("physicsSimulator", () => new InactivityController(null!));
        Assert.Throws<ArgumentOutOfRangeException>("MaxIdleTime", () => simulator.InactivityController.MaxIdleTime = -1);
        Assert.Throws<ArgumentOutOfRangeException>(
            "ActivationDistance", () => simulator.InactivityController.ActivationDistance = float.NaN);
        Assert.Throws<ArgumentNullException>(() => simulator.InactivityController.IsInActivationDistance(null!, new Body()));
        var water = new FluidDragController();
        Assert.Throws<ArgumentNullException>("fluidContainer", () => water.Initialize(null!, 1, 1, 1, Vector2.Zero));
        Assert.Throws<ArgumentOutOfRangeException>("density", () => water.Initialize(new AABBFluidContainer(), -1, 1, 1, Vector2.Zero));
        Assert.Throws<ArgumentOutOfRangeException>(
            "gravity", () => water.Initialize(new AABBFluidContainer(), 1, 1, 1, new Vector2(float.NaN)));
        Assert.Throws<ArgumentOutOfRangeException>("Density", () => water.Density = float.NaN);
        Assert.Throws<ArgumentOutOfRangeException>("LinearDragCoefficient", () => water.LinearDragCoefficient = -1);
        Assert.Throws<ArgumentOutOfRangeException>("RotationalDragCoefficient", () => water.RotationalDragCoefficient = -1);
        Assert.Throws<ArgumentNullException>("geom", () => water.AddGeom(null!));
        Assert.Throws<ArgumentNullException>("aabb", () => new AABBFluidContainer(null!));
        var wave = new WaveController();
        Assert.Throws<InvalidOperationException>(wave.Initialize);
        Assert.Throws<ArgumentOutOfRangeException>("DampingCoefficient", () => wave.DampingCoefficient = 1.5f);
        Assert.Throws<ArgumentOutOfRangeException>("NodeCount", () => wave.NodeCount = -1);
        Assert.Throws<ArgumentOutOfRangeException>("Width", () => wave.Width = float.PositiveInfinity);
        Assert.Throws<ArgumentOutOfRangeException>("node", () => wave.Disturb(0, 1));
        Assert.Throws<ArgumentException>("XPosition", () => wave.XPosition = new float[3]);
        Assert.Throws<ArgumentOutOfRangeException>("minRadius", () => new GravityController(Vector2.Zero, 1, 0));
        Assert.Throws<ArgumentOutOfRangeException>("coefficient", () => new WindController(Vector2.Zero, -1));
        Assert.Throws<ArgumentOutOfRangeException>("radius", () => new ExplosionController().Explode(Vector2.Zero, 0, 1));
        Assert.Throws<ArgumentOutOfRangeException>("maxLinearVelocity", () => new VelocityLimitController(-1, 1));
        Assert.Throws<ArgumentNullException>("controller", () => simulator.Add((Controller)null!));
        Assert.Throws<ArgumentException>("controller", () => new PhysicsSimulator().Add(simulator.InactivityController));
    }

    private static PhysicsSimulator SpringyPile()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 50));
        Sandbox.Floor(simulator);
        Body? last = null;
        for (int i = 0; i < 12; i++)
        {
            Body body = Sandbox.Ball(simulator, new Vector2(-60 + (11 * i), -20 - (5 * (i % 3)))).Body;
            if (last is not null)
            {
                SpringFactory.Instance.CreateLinearSpring(simulator, last, Vector2.Zero, body, new Vector2(1, 0), 50, 1);
            }

            last = body;
        }

        return simulator;
    }

    private sealed class Caller(string name, List<string> calls) : Controller
    {
        public Action? Then { get; set; }

        public override void Validate()
        {
        }

        public override void Update(float dt)
        {
            calls.Add(name);
            Then?.Invoke();
        }
    }
}
