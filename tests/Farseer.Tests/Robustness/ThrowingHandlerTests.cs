using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Reflection;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Robustness;

/// <summary>
/// Every handler and every member of a user's own class that an update calls throws, each time it is called. The update is completed: the
/// world is the same, bit for bit, as one whose handlers return, everybody else is called as often, and the first exception comes out.
/// </summary>
public class ThrowingHandlerTests
{
    private const int Steps = 90;

    /// <summary>What an update calls, and how something is done in it.</summary>
    private static readonly Dictionary<string, Action<Stage, Action>> _places = new(StringComparer.Ordinal)
    {
        ["Geom.OnCollision"] = (s, act) => s.Ball.OnCollision += (_, _, _) => Then(act),
        ["Geom.OnSeparation"] = (s, act) => s.Ball.OnSeparation += (_, _) => act(),
        ["LibraryCollider.OnBroadPhaseCollision"] = (s, act) => s.Simulator.BroadPhaseCollider.OnBroadPhaseCollision += (_, _) => Then(act),
        ["PhysicsSimulator.BodyQuarantined"] = (s, act) => s.Simulator.BodyQuarantined += (_, _) => act(),
        ["PhysicsSimulator.MixMaterials"] = (s, act) => s.Simulator.MixMaterials = (Geom _, Geom _, ref SurfaceMaterial _) => act(),
        ["Body.Updated"] = (s, act) => s.Ball.Body.Updated += (ref Vector2 _, ref float _) => act(),
        ["BodyList.Added"] = (s, act) => s.Simulator.BodyList.Added += _ => act(),
        ["BodyList.Removed"] = (s, act) => s.Simulator.BodyList.Removed += _ => act(),
        ["GeomList.Added"] = (s, act) => s.Simulator.GeomList.Added += _ => act(),
        ["GeomList.Removed"] = (s, act) => s.Simulator.GeomList.Removed += _ => act(),
        ["JointList.Added"] = (s, act) => s.Simulator.JointList.Added += _ => act(),
        ["JointList.Removed"] = (s, act) => s.Simulator.JointList.Removed += _ => act(),
        ["SpringList.Added"] = (s, act) => s.Simulator.SpringList.Added += _ => act(),
        ["SpringList.Removed"] = (s, act) => s.Simulator.SpringList.Removed += _ => act(),
        ["ControllerList.Added"] = (s, act) => s.Simulator.ControllerList.Added += _ => act(),
        ["ControllerList.Removed"] = (s, act) => s.Simulator.ControllerList.Removed += _ => act(),
        ["Joint.Broke"] = (s, act) => s.Pin.Broke += (_, _) => act(),
        ["Spring.Broke"] = (s, act) => s.Coil.Broke += (_, _) => act(),
        ["FluidDragController.Entry"] = (s, act) => s.Fluid.Entry += _ => act(),
        ["IFluidContainer.Intersect"] = (s, act) => (s.Pool.IsOutside, s.Pool.InIntersect) = (true, s.Pool.InIntersect + act),
        ["IFluidContainer.Contains"] = (s, act) => (s.Pool.IsEmpty, s.Pool.InContains) = (true, s.Pool.InContains + act),
        ["Joint.Validate"] = (s, act) => s.Joint.InValidate += act,
        ["Joint.PreStep"] = (s, act) => s.Joint.InPreStep += act,
        ["Joint.Update"] = (s, act) => s.Joint.InUpdate += act,
        ["Spring.Validate"] = (s, act) => s.Spring.InValidate += act,
        ["Spring.Update"] = (s, act) => s.Spring.InUpdate += act,
        ["Controller.Validate"] = (s, act) => s.Controller.InValidate += act,
        ["Controller.Update"] = (s, act) => s.Controller.InUpdate += act,
        ["BodyController.Filter"] = (s, act) => s.BodyController.Filter = _ =>
        {
            act();
            return false;
        },
        ["BodyController.Act"] = (s, act) => s.BodyController.InAct += act,
    };

    /// <summary>Those whose answer changes what others hear: they are tried alone.</summary>
    private static readonly HashSet<string> _answers =
    [
        "PhysicsSimulator.MixMaterials", "IFluidContainer.Intersect", "IFluidContainer.Contains", "BodyController.Filter",
    ];

    /// <summary>What is heard elsewhere than in an update, and where its exceptions are looked at.</summary>
    private static readonly Dictionary<string, string> _elsewhere = new(StringComparer.Ordinal)
    {
        ["Body.Disposed"] = nameof(DisposedHandler_Throws_TheBodyIsDisposedAndLeaves),
        ["FixedStepDriver.BeforeStep"] = nameof(HandlerOfADriver_Throws_TheDriverGoesOn),
        ["FixedStepDriver.AfterStep"] = nameof(HandlerOfADriver_Throws_TheDriverGoesOn),
        ["QueryFilter.Accept"] = nameof(QueryFilter_Throws_ComesOutOfTheQuery_AndTheNextOneWorks),
        ["SelectiveSweepCollider.OnBroadPhaseCollision"] = "that of LibraryCollider",
    };

    public static TheoryData<string> Places => new(_places.Keys);

    /// <summary>Events, and delegates that a property takes.</summary>
    [Fact]
    public void Places_AreAllHandlersThereAre()
    {
        const BindingFlags Declared = BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly;
        IEnumerable<string> handlers = typeof(PhysicsSimulator).Assembly.GetExportedTypes().Where(t => t.IsClass).SelectMany(t =>
            t.GetEvents(Declared).Select(e => t.Name + "." + e.Name).Concat(
                t.GetProperties(Declared).Where(p => p.PropertyType.IsSubclassOf(typeof(Delegate))).Select(p => t.Name + "." + p.Name)));

        Assert.DoesNotContain(handlers, h => !_places.ContainsKey(h) && !_elsewhere.ContainsKey(h));
    }

    [Theory]
    [MemberData(nameof(Places))]
    public void Handler_ThrowsEachTime_TheUpdateIsCompleted(string place)
    {
        var calm = new Stage();
        var wild = new Stage();
        int calls = 0;
        int thrown = 0;
        bool throws = false;
        _places[place](calm, () => calls++);
        _places[place](wild, () =>
        {
            thrown++;
            throws = true;
            throw new FormatException(place);
        });
        foreach (string other in _places.Keys.Where(k => k != place && !_answers.Contains(k)))
        {
            // A handler beside it, which is called as often in both worlds.
            _places[other](calm, () => calm.Told(other));
            _places[other](wild, () => wild.Told(other));
        }

        for (int step = 0; step < Steps; step++)
        {
            calm.Act(step);
            wild.Act(step);
            calm.Simulator.Update(Step);
            throws = false;
            Exception? caught = Record.Exception(() => wild.Simulator.Update(Step));

            Assert.Equal(throws, caught is FormatException && caught.Message == place);
            Assert.Equal(throws, caught is not null);

            // Of a geom that is asked for twenty points, the first exception is the answer.
            Assert.True(place == "IFluidContainer.Contains" ? thrown <= calls : thrown == calls, $"{thrown} of {calls} calls");
            Assert.Equal(calm.Tally, wild.Tally);
            Assert.Equal(calm.Simulator.StateHash(), wild.Simulator.StateHash());
            Assert.Equal(calm.Simulator.BodyList.Count, wild.Simulator.BodyList.Count);
        }

        Assert.True(calls > 0, place + " was not called");
    }

    [Fact]
    public void SecondGeomOfAPair_HearsOfTheContact_ThoughTheHandlerOfTheFirstThrows()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        Geom ball = Ball(simulator, new Vector2(0, -6));
        ball.RestitutionCoefficient = floor.RestitutionCoefficient = 1;
        int begun = 0;
        int ended = 0;
        floor.OnCollision += (_, _, _) => throw new FormatException("floor");
        floor.OnSeparation += (_, _) => throw new FormatException("floor");
        ball.OnCollision += (_, _, _) => ++begun > 0;
        ball.OnSeparation += (_, _) => ended++;
        for (int i = 0; i < 60; i++)
        {
            Record.Exception(() => simulator.Update(Step));
        }

        Assert.True(begun > 0);
        Assert.True(ended > 0);
    }

    [Fact]
    public void DisposedHandler_Throws_TheBodyIsDisposedAndLeaves()
    {
        var stage = new Stage();
        stage.Simulator.Update(Step);
        Body body = stage.Ball.Body;
        body.Disposed += (_, _) => throw new FormatException("mine");

        Assert.Throws<FormatException>(body.Dispose);

        Assert.True(body.IsDisposed);
        Assert.True(stage.Ball.IsDisposed);
        stage.Simulator.Update(Step);
        Assert.DoesNotContain(body, stage.Simulator.BodyList);
        Assert.DoesNotContain(stage.Ball, stage.Simulator.GeomList);
        body.Dispose();
    }

    [Fact]
    public void RemovedHandler_Throws_InClear_EverythingIsGone()
    {
        var stage = new Stage();
        stage.Simulator.Update(Step);
        int told = 0;
        int bodies = stage.Simulator.BodyList.Count;
        stage.Simulator.BodyList.Removed += _ =>
        {
            told++;
            throw new FormatException("mine");
        };

        Assert.Throws<FormatException>(stage.Simulator.Clear);

        Assert.Equal(bodies, told);
        Assert.Empty(stage.Simulator.BodyList);
        Assert.Empty(stage.Simulator.GeomList);
        stage.Simulator.Update(Step);
        Assert.Equal(bodies, told);
    }

    [Fact]
    public void QueryFilter_Throws_ComesOutOfTheQuery_AndTheNextOneWorks()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        simulator.Update(Step);
        var filter = new QueryFilter { Accept = _ => throw new FormatException("mine") };
        var found = new List<Geom>();

        Assert.Throws<FormatException>(() => simulator.QueryPoint(new Vector2(0, 5), found, filter));
        Assert.Throws<FormatException>(() => simulator.RayCast(new Vector2(0, -5), new Vector2(0, 5), out _, filter));
        Assert.Throws<FormatException>(() => simulator.Query(new AABB(new Vector2(-1, -1), new Vector2(1, 1)), found, filter));
        Assert.Throws<FormatException>(() => simulator.QueryCircle(Vector2.Zero, 1, found, filter));
        Assert.Throws<FormatException>(() => simulator.CircleCast(new Vector2(0, -5), 1, new Vector2(0, 10), out _, filter));
        Assert.Throws<FormatException>(() => simulator.ClosestPoint(new Vector2(0, -5), 10, out _, filter));

        Assert.Equal(1, simulator.QueryPoint(new Vector2(0, 5), found));
        Assert.Same(floor, Assert.Single(found));
    }

    /// <summary>
    /// Before a step its exception is instead of the step, after it the step is made; either way what is due later is made later.
    /// </summary>
    [Theory]
    [InlineData(true, 0)]
    [InlineData(false, 1)]
    public void HandlerOfADriver_Throws_TheDriverGoesOn(bool isBefore, int made)
    {
        var driver = new FixedStepDriver(Falling(), 0.125);
        Action<float> handler = _ => throw new FormatException("mine");
        driver.BeforeStep = isBefore ? handler : null;
        driver.AfterStep = isBefore ? null : handler;

        Assert.Throws<FormatException>(() => driver.Advance(0.375));

        Assert.Equal(made, driver.StepCount);
        driver.BeforeStep = driver.AfterStep = null;
        Assert.Equal(2, driver.Advance(0));
        Assert.Equal(made + 2, driver.StepCount);
    }

    private static bool Then(Action act)
    {
        act();
        return true;
    }

    /// <summary>Something of everything that calls a handler, and a run in which each is called.</summary>
    private sealed class Stage
    {
        private readonly Body _mate;
        private readonly Body _stray;
        private readonly SortedDictionary<string, int> _tally = new(StringComparer.Ordinal);

        public Stage()
        {
            Simulator = WithFloor(out Geom floor);
            floor.RestitutionCoefficient = 0.8f;
            Ball = Sandbox.Ball(Simulator, new Vector2(0, -12));
            Ball.RestitutionCoefficient = 1;
            _stray = Box(Simulator, new Vector2(-120, -40)).Body;
            Body weight = Box(Simulator, new Vector2(90, -60)).Body;
            _mate = Box(Simulator, new Vector2(120, -60)).Body;
            Pin = JointFactory.Instance.CreatePinJoint(Simulator, weight, Vector2.Zero, _mate, Vector2.Zero);
            Coil = SpringFactory.Instance.CreateFixedLinearSpring(Simulator, _mate, Vector2.Zero, new Vector2(120, -80), 1, 0);
            Pool = new Container();
            Fluid = new FluidDragController();
            Fluid.Initialize(Pool, 0.001f, 1, 1, new Vector2(0, 100));
            Fluid.AddGeom(_mate.GeomAt(0));
            Joint = new QuietJoint();
            Spring = new QuietSpring();
            Controller = new QuietController();
            BodyController = new QuietBodyController();
            Simulator.Add(Fluid);
            Simulator.Add(Joint);
            Simulator.Add(Spring);
            Simulator.Add(Controller);
            Simulator.Add(BodyController);
        }

        public PhysicsSimulator Simulator { get; }

        public Geom Ball { get; }

        public PinJoint Pin { get; }

        public FixedLinearSpring Coil { get; }

        public FluidDragController Fluid { get; }

        public Container Pool { get; }

        public QuietJoint Joint { get; }

        public QuietSpring Spring { get; }

        public QuietController Controller { get; }

        public QuietBodyController BodyController { get; }

        public IReadOnlyDictionary<string, int> Tally => _tally;

        public void Told(string place) => _tally[place] = _tally.GetValueOrDefault(place) + 1;

        public void Act(int step)
        {
            switch (step)
            {
                case 20:
                    Pin.BreakForce = 0;
                    Coil.Breakpoint = 0;
                    break;
                case 30:
                    _stray.LinearVelocity.X = float.NaN;
                    break;
                case 40:
                    Box(Simulator, new Vector2(-60, -12));
                    Simulator.Add(new QuietJoint());
                    Simulator.Add(new QuietSpring());
                    Simulator.Add(new QuietController());
                    break;
                case 50:
                    Simulator.Remove(_mate);
                    Simulator.Remove(Joint);
                    Simulator.Remove(Spring);
                    Simulator.Remove(Controller);
                    break;
                case 60:
                    Ball.Body.Dispose();
                    break;
            }
        }
    }

    /// <summary>Everything below a height.</summary>
    private sealed class Container : IFluidContainer
    {
        private const float Surface = -40;

        /// <summary>Whoever throws has not said that something is in the fluid; his twin says that it is not.</summary>
        public bool IsOutside { get; set; }

        public bool IsEmpty { get; set; }

        public Action? InIntersect { get; set; }

        public Action? InContains { get; set; }

        public bool Intersect(AABB aabb)
        {
            InIntersect?.Invoke();
            return aabb.Max.Y > Surface && !IsOutside;
        }

        public bool Contains(ref Vector2 vector)
        {
            InContains?.Invoke();
            return vector.Y > Surface && !IsEmpty;
        }
    }

    private sealed class QuietJoint : Joint
    {
        public event Action? InValidate;

        public event Action? InPreStep;

        public event Action? InUpdate;

        public override void Validate() => InValidate?.Invoke();

        public override void PreStep(float inverseDt) => InPreStep?.Invoke();

        public override void Update() => InUpdate?.Invoke();
    }

    private sealed class QuietSpring : Spring
    {
        public event Action? InValidate;

        public event Action? InUpdate;

        public override void Validate() => InValidate?.Invoke();

        public override void Update(float dt) => InUpdate?.Invoke();
    }

    private sealed class QuietController : Controller
    {
        public event Action? InValidate;

        public event Action? InUpdate;

        public override void Validate() => InValidate?.Invoke();

        public override void Update(float dt) => InUpdate?.Invoke();
    }

    private sealed class QuietBodyController : BodyController
    {
        public event Action? InAct;

        protected override void Act(Body body, float dt) => InAct?.Invoke();
    }
}
