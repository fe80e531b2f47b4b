using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Robustness;

/// <summary>
/// Every kind of joint, spring and controller is removed, disposed, broken and robbed of its bodies in every handler that an update
/// calls. The update ends, the item is gone or at rest as it should be, and the world goes on whole.
/// </summary>
public class KindsInHandlersTests
{
    private const int Steps = 60;

    private static readonly Dictionary<string, Action<Stage, Action>> _places = new(StringComparer.Ordinal)
    {
        ["Geom.OnCollision"] = (s, act) => s.Pair.GeomA.OnCollision += (_, _, _) => Then(act),
        ["Geom.OnSeparation"] = (s, act) => s.Pair.GeomA.OnSeparation += (_, _) => act(),
        ["OnBroadPhaseCollision"] = (s, act) => s.Simulator.BroadPhaseCollider.OnBroadPhaseCollision += (_, _) => Then(act),
        ["Body.Updated"] = (s, act) => s.Pair.A.Updated += (ref Vector2 _, ref float _) => act(),
        ["Body.Disposed"] = (s, act) => s.Bystander.Disposed += (_, _) => act(),
        ["BodyList.Removed"] = (s, act) => s.Simulator.BodyList.Removed += _ => act(),
        ["GeomList.Added"] = (s, act) => s.Simulator.GeomList.Added += _ => act(),
        ["JointList.Added"] = (s, act) => s.Simulator.JointList.Added += _ => act(),
        ["JointList.Removed"] = (s, act) => s.Simulator.JointList.Removed += _ => act(),
        ["SpringList.Removed"] = (s, act) => s.Simulator.SpringList.Removed += _ => act(),
        ["ControllerList.Removed"] = (s, act) => s.Simulator.ControllerList.Removed += _ => act(),
        ["Broke of another joint"] = (s, act) => s.Pin.Broke += (_, _) => act(),
        ["Broke of another spring"] = (s, act) => s.Coil.Broke += (_, _) => act(),
        ["Joint.PreStep"] = (s, act) => s.OwnJoint.InPreStep += act,
        ["Joint.Update"] = (s, act) => s.OwnJoint.InUpdate += act,
        ["Spring.Update"] = (s, act) => s.OwnSpring.InUpdate += act,
        ["Controller.Update"] = (s, act) => s.OwnController.InUpdate += act,
        ["FluidDragController.Entry"] = (s, act) => s.Fluid.Entry += _ => act(),
    };

    /// <summary>What is done, and whether the item has left the simulator afterwards (null: either).</summary>
    private static readonly Dictionary<string, (Action<Stage> Do, Func<Stage, bool?> IsGone)> _deeds = new(StringComparer.Ordinal)
    {
        ["remove"] = (s => Kinds.Remove(s.Simulator, s.Item), _ => true),
        ["dispose"] = (s => ((IDisposable)s.Item).Dispose(), _ => true),
        ["dispose a body"] = (s => s.Pair.A.Dispose(), s => s.NeedsItsBodies ? true : null),
        ["dispose both bodies"] = (s => DisposeBoth(s), s => s.NeedsItsBodies ? true : null),
        ["remove a body"] = (s => s.Simulator.Remove(s.Pair.A), _ => false),
        ["remove and add again"] = (s => RemoveAndAdd(s), _ => false),
        ["dispose after removing"] = (s => RemoveAndDispose(s), _ => true),
        ["break"] = (s => Kinds.Break(s.Item), _ => false),
        ["switch off"] = (s => Kinds.Enable(s.Item, false), _ => false),
        ["clear"] = (s => s.Simulator.Clear(), _ => true),
    };

    public static TheoryData<string> AllKinds => new(Kinds.All);

    public static TheoryData<string> BreakableKinds => new(Kinds.Joints.Concat(Kinds.Springs));

    /// <summary>Those that are off again at once when they are switched on: the rope of a pulley stays slack here.</summary>
    public static TheoryData<string> TautKinds => new(Kinds.Joints.Concat(Kinds.Springs).Where(k => k != nameof(PulleyJoint)));

    [Fact]
    public void Kinds_AreAllThereAre()
    {
        IEnumerable<string> library = typeof(Joint).Assembly.GetTypes()
            .Where(t => t.IsPublic
                && !t.IsAbstract
                && (t.IsSubclassOf(typeof(Joint)) || t.IsSubclassOf(typeof(Spring)) || t.IsSubclassOf(typeof(Controller))))
            .Select(t => t.Name);

        Assert.Equal(
            library.Order(StringComparer.Ordinal),
            Kinds.All.Where(k => !k.StartsWith("Own", StringComparison.Ordinal)).Order(StringComparer.Ordinal));
    }

    [Theory]
    [MemberData(nameof(AllKinds))]
    public void Kind_TreatedInAnyWay_InAnyHandler_LeavesAWholeWorld(string kind)
    {
        foreach ((string place, Action<Stage, Action> hook) in _places)
        {
            foreach ((string deed, (Action<Stage> act, Func<Stage, bool?> isGone)) in _deeds)
            {
                string which = $"{deed} {kind} in {place}";
                var stage = new Stage(kind);
                bool done = false;
                hook(stage, () =>
                {
                    if (!done && stage.IsRunning)
                    {
                        done = true;
                        act(stage);
                    }
                });
                stage.RunThrough(which);

                Assert.True(done, which + ": the handler was not called");
                Assert.True(
                    isGone(stage) is not { } gone || gone != Kinds.Holds(stage.Simulator, stage.Item),
                    which + ": it is not where it should be");
                stage.CheckWhole(which);
            }
        }
    }

    /// <summary>In the handler of its own breaking, where the solver has just let go of it.</summary>
    [Theory]
    [MemberData(nameof(BreakableKinds))]
    public void Kind_TreatedInAnyWay_InItsOwnBroke_LeavesAWholeWorld(string kind)
    {
        foreach ((string deed, (Action<Stage> act, Func<Stage, bool?> isGone)) in _deeds)
        {
            string which = $"{deed} {kind} in its Broke";
            var stage = new Stage(kind);
            int broken = 0;
            Kinds.OnBroke(stage.Item, (sender, _) =>
            {
                Assert.Same(stage.Item, sender);
                if (broken++ == 0)
                {
                    act(stage);
                }
            });
            stage.At(12, () => Kinds.Break(stage.Item));
            stage.At(14, stage.Disturb);
            stage.RunThrough(which);

            Assert.True(broken > 0, which + ": it did not break");
            Assert.True(
                isGone(stage) is not { } gone || gone != Kinds.Holds(stage.Simulator, stage.Item),
                which + ": it is not where it should be");
            stage.CheckWhole(which);
        }
    }

    /// <summary>A joint that is switched on again in its Broke goes on, and breaks again in the next update.</summary>
    [Theory]
    [MemberData(nameof(TautKinds))]
    public void Kind_SwitchedOnInItsBroke_BreaksAgain(string kind)
    {
        var stage = new Stage(kind);
        int broken = 0;
        Kinds.OnBroke(stage.Item, (sender, _) =>
        {
            broken++;
            Kinds.Enable(sender!, true);
        });
        stage.At(12, () => Kinds.Break(stage.Item));
        stage.At(14, stage.Disturb);
        stage.RunThrough(kind);

        Assert.True(broken > 1, kind + " broke " + broken + " times");
        stage.CheckWhole(kind);
    }

    private static bool Then(Action act)
    {
        act();
        return true;
    }

    private static void DisposeBoth(Stage stage)
    {
        stage.Pair.A.Dispose();
        stage.Pair.B.Dispose();
    }

    private static void RemoveAndAdd(Stage stage)
    {
        Kinds.Remove(stage.Simulator, stage.Item);
        Kinds.Add(stage.Simulator, stage.Item);
    }

    private static void RemoveAndDispose(Stage stage)
    {
        Kinds.Remove(stage.Simulator, stage.Item);
        ((IDisposable)stage.Item).Dispose();
    }

    /// <summary>An item on its pair of boxes, a ball that falls on them, and one of everything that calls a handler.</summary>
    private sealed class Stage
    {
        private readonly List<(int Step, Action Act)> _events = [];

        public Stage(string kind)
        {
            Simulator = Falling();
            Floor(Simulator).RestitutionCoefficient = 0.8f;
            Pair = new Kinds.Pair(Simulator, new Vector2(0, -12));
            Pair.GeomA.RestitutionCoefficient = 0.8f;
            Pair.B.IsAutoIdle = true;
            Geom ball = Ball(Simulator, new Vector2(1, -29));
            ball.RestitutionCoefficient = 1;
            ball.Body.LinearVelocity = new Vector2(0, 30);
            Body spare = Box(Simulator, new Vector2(-60, -40)).Body;

            // The others act on bodies of their own, so that what becomes of the item shows.
            Bystander = Box(Simulator, new Vector2(90, -40)).Body;
            Body other = Box(Simulator, new Vector2(120, -40)).Body;
            Pin = JointFactory.Instance.CreatePinJoint(Simulator, Bystander, Vector2.Zero, other, Vector2.Zero);
            Coil = SpringFactory.Instance.CreateFixedLinearSpring(Simulator, other, Vector2.Zero, new Vector2(120, -60), 1, 0);
            Fluid = new FluidDragController();
            Fluid.Initialize(
                new AABBFluidContainer(new AABB(new Vector2(80, -34), new Vector2(140, 0))), 0.001f, 1, 1, new Vector2(0, 100));
            Fluid.AddGeom(other.GeomAt(0));
            OwnJoint = new Kinds.OwnJoint(Bystander, other);
            OwnSpring = new Kinds.OwnSpring(other);
            OwnController = new Kinds.OwnController(Bystander, other);
            Item = Kinds.Make(kind, Pair);
            Simulator.Add(Fluid);
            Simulator.Add(OwnController);
            Simulator.Add(OwnJoint);
            Kinds.Add(Simulator, Item);
            Simulator.Add(OwnSpring);
            At(6, () => Pin.Breakpoint = 0);
            At(7, () => Pin.BreakForce = 0);
            At(8, () => Coil.Breakpoint = 0);
            At(20, () => Simulator.Remove(Coil));
            At(22, () => Simulator.Remove(OwnController));
            At(24, () => Simulator.Remove(OwnJoint));
            At(26, () => JointFactory.Instance.CreateRevoluteJoint(Simulator, other, spare, Vector2.Zero));
            At(28, () => Simulator.Remove(other));
            At(30, Bystander.Dispose);
            At(32, () => Box(Simulator, new Vector2(-100, -12)));
        }

        public PhysicsSimulator Simulator { get; }

        public Kinds.Pair Pair { get; }

        public object Item { get; }

        public Body Bystander { get; }

        public PinJoint Pin { get; }

        public FixedLinearSpring Coil { get; }

        public FluidDragController Fluid { get; }

        public Kinds.OwnJoint OwnJoint { get; }

        public Kinds.OwnSpring OwnSpring { get; }

        public Kinds.OwnController OwnController { get; }

        /// <summary>Everything has been taken in.</summary>
        public bool IsRunning => Simulator.BodyList.Contains(Pair.A) && Kinds.Holds(Simulator, Item);

        /// <summary>The simulator disposes it together with a body.</summary>
        public bool NeedsItsBodies => Item is Joint or Spring or Kinds.OwnController;

        public void At(int step, Action act) => _events.Add((step, act));

        /// <summary>Moves the bodies apart, so that there is an error to break by.</summary>
        public void Disturb()
        {
            if (!Pair.A.IsDisposed)
            {
                Pair.A.Position += new Vector2(-2, -3);
                Pair.A.Rotation += 0.4f;
                Pair.A.ApplyForce(new Vector2(100, -100));
            }
        }

        public void RunThrough(string which)
        {
            for (int step = 0; step < Steps; step++)
            {
                foreach ((int when, Action act) in _events)
                {
                    if (when == step)
                    {
                        act();
                    }
                }

                try
                {
                    Simulator.Update(Step);
                }
                catch (Exception exception)
                {
                    Assert.Fail($"{which}, update {step}: {exception}");
                }
            }
        }

        public void CheckWhole(string which)
        {
            Assert.All(Simulator.BodyList, body =>
            {
                Assert.False(body.IsDisposed || body.IsQuarantined, which);
                Assert.True(float.IsFinite(body.Position.Length()) && float.IsFinite(body.TotalRotation), which);
                Assert.True(float.IsFinite(body.LinearVelocity.Length()) && float.IsFinite(body.AngularVelocity), which);

                // Far more than falls, motors and the ball give.
                Assert.True(body.LinearVelocity.Length() < 500, which + ": " + body.LinearVelocity);
            });
            Assert.Equal(Simulator.JointList.Count, Simulator.JointList.Distinct().Count(j => !j.IsDisposed));
            Assert.Equal(Simulator.SpringList.Count, Simulator.SpringList.Distinct().Count(s => !s.IsDisposed));
            Assert.Equal(Simulator.ControllerList.Count, Simulator.ControllerList.Distinct().Count(c => !c.IsDisposed));
            Assert.All(Simulator.JointList.OfType<PairJoint>(), j => Assert.False(j.Body1.IsDisposed || j.Body2.IsDisposed, which));

            // An item that only left can come back, and a fresh pair with the same kind on it works.
            if (!Kinds.IsDisposed(Item) && !Kinds.Holds(Simulator, Item) && !Pair.A.IsDisposed && !Pair.B.IsDisposed)
            {
                Kinds.Add(Simulator, Item);
                Simulator.Update(Step);
                Assert.True(Kinds.Holds(Simulator, Item), which);
            }

            Geom late = Box(Simulator, new Vector2(300, -40));
            Simulator.Update(Step);
            Simulator.Update(Step);
            Assert.InRange(late.Body.LinearVelocity.Y, 1, 3);
        }
    }
}
