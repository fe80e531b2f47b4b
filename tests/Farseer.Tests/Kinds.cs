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

namespace Farseer.Tests;

/// <summary>
/// One of every kind of joint, spring and controller, all of them with what they have switched on, for tests that must hold for
/// every kind. What a user writes is a kind as well.
/// </summary>
internal static class Kinds
{
    private static readonly Dictionary<string, Func<Pair, object>> _makers = new(StringComparer.Ordinal)
    {
        [nameof(AngleJoint)] = p => new AngleJoint(p.A, p.B, 0.3f),
        [nameof(AngleLimitJoint)] = p => new AngleLimitJoint(p.A, p.B, -0.1f, 0.1f),
        [nameof(DistanceJoint)] = p => new DistanceJoint(p.A, Vector2.Zero, p.B, new Vector2(3, 0))
        {
            Frequency = 3, AreLimitsEnabled = true, LowerLimit = 20, UpperLimit = 40,
        },
        [nameof(FixedAngleJoint)] = p => new FixedAngleJoint(p.A, 0.2f),
        [nameof(FixedAngleLimitJoint)] = p => new FixedAngleLimitJoint(p.A, -0.1f, 0.1f),
        [nameof(FixedPrismaticJoint)] = p => new FixedPrismaticJoint(p.A, p.A.Position, Vector2.UnitX)
        {
            AreLimitsEnabled = true, LowerLimit = -5, UpperLimit = 5, IsMotorEnabled = true, MotorSpeed = 10, MaxMotorForce = 500,
        },
        [nameof(FixedRevoluteJoint)] = p => new FixedRevoluteJoint(p.A, p.A.Position + new Vector2(-10, 0))
        {
            AreLimitsEnabled = true, LowerLimit = -1, UpperLimit = 1, IsMotorEnabled = true, MotorSpeed = 2, MaxMotorTorque = 500,
        },
        [nameof(GearJoint)] = p => new GearJoint(p.A, p.B, 2),
        [nameof(MotorJoint)] = p => new MotorJoint(p.A, p.B) { Offset = new Vector2(25, 0), MaxForce = 500, MaxTorque = 500 },
        [nameof(PinJoint)] = p => new PinJoint(p.A, new Vector2(0, 5), p.B, new Vector2(0, -5)),
        [nameof(PrismaticJoint)] = p => new PrismaticJoint(p.A, p.B, p.A.Position, Vector2.UnitX)
        {
            AreLimitsEnabled = true, LowerLimit = -5, UpperLimit = 5, IsMotorEnabled = true, MotorSpeed = 10, MaxMotorForce = 500,
        },
        [nameof(PulleyJoint)] = p => new PulleyJoint(
            p.A, p.A.Position - new Vector2(0, 40), Vector2.Zero, p.B, p.B.Position - new Vector2(0, 40), Vector2.Zero, 1.5f),
        [nameof(RevoluteJoint)] = p => new RevoluteJoint(p.A, p.B, (p.A.Position + p.B.Position) / 2)
        {
            AreLimitsEnabled = true, LowerLimit = -1, UpperLimit = 1, IsMotorEnabled = true, MotorSpeed = 2, MaxMotorTorque = 500,
        },
        [nameof(RopeJoint)] = p => new RopeJoint(p.A, Vector2.Zero, p.B, Vector2.Zero, 30),
        [nameof(SliderJoint)] = p => new SliderJoint(p.A, Vector2.Zero, p.B, Vector2.Zero, 28, 32),
        [nameof(TargetJoint)] = p => new TargetJoint(p.A, p.A.Position + new Vector2(0, 8)),
        [nameof(WeldJoint)] = p => new WeldJoint(p.A, p.B, (p.A.Position + p.B.Position) / 2) { Frequency = 4 },
        [nameof(WheelJoint)] = p => new WheelJoint(p.A, p.B, p.B.Position, Vector2.UnitY)
        {
            AreLimitsEnabled = true, LowerLimit = -5, UpperLimit = 5, IsMotorEnabled = true, MotorSpeed = 2, MaxMotorTorque = 500,
        },
        [nameof(OwnJoint)] = p => new OwnJoint(p.A, p.B),
        [nameof(LinearSpring)] = p => new LinearSpring(p.A, Vector2.Zero, p.B, new Vector2(3, 0), 300, 3) { RestLength = 28 },
        [nameof(FixedLinearSpring)] = p => new FixedLinearSpring(p.A, new Vector2(3, 0), p.A.Position - new Vector2(0, 20), 300, 3),
        [nameof(AngleSpring)] = p => new AngleSpring(p.A, p.B, 20_000, 200) { TargetAngle = 0.2f, MaxTorque = 50_000 },
        [nameof(FixedAngleSpring)] = p => new FixedAngleSpring(p.A, 20_000, 200) { TargetAngle = 0.2f, MaxTorque = 50_000 },
        [nameof(OwnSpring)] = p => new OwnSpring(p.A),
        [nameof(FluidDragController)] = Pool,
        [nameof(WaveController)] = Sea,
        [nameof(GravityController)] = p => new GravityController(p.B.Position - new Vector2(0, 100), 20_000, 10) { Filter = p.Has },
        [nameof(WindController)] = p => new WindController(new Vector2(30, 0), 0.5f) { Filter = p.Has },
        [nameof(ExplosionController)] = Charge,
        [nameof(VelocityLimitController)] = p => new VelocityLimitController(60, 3) { Filter = p.Has },
        [nameof(InactivityController)] = p =>
            new InactivityController(p.Simulator) { Enabled = true, MaxIdleTime = 200, ActivationDistance = 60 },
        [nameof(OwnController)] = p => new OwnController(p.A, p.B),
    };

    public static IEnumerable<string> Joints => _makers.Keys.Where(k => k.EndsWith("Joint", StringComparison.Ordinal));

    public static IEnumerable<string> Springs => _makers.Keys.Where(k => k.EndsWith("Spring", StringComparison.Ordinal));

    public static IEnumerable<string> Controllers => _makers.Keys.Where(k => k.EndsWith("Controller", StringComparison.Ordinal));

    public static IEnumerable<string> All => _makers.Keys;

    /// <summary>A joint, spring or controller that acts on a pair; it is not added yet.</summary>
    public static object Make(string kind, Pair pair) => _makers[kind](pair);

    public static void Add(PhysicsSimulator simulator, object item)
    {
        switch (item)
        {
            case Joint joint: simulator.Add(joint); break;
            case Spring spring: simulator.Add(spring); break;
            default: simulator.Add((Controller)item); break;
        }
    }

    public static void Remove(PhysicsSimulator simulator, object item)
    {
        switch (item)
        {
            case Joint joint: simulator.Remove(joint); break;
            case Spring spring: simulator.Remove(spring); break;
            default: simulator.Remove((Controller)item); break;
        }
    }

    public static bool Holds(PhysicsSimulator simulator, object item) => item switch
    {
        Joint joint => simulator.JointList.Contains(joint),
        Spring spring => simulator.SpringList.Contains(spring),
        _ => simulator.ControllerList.Contains((Controller)item),
    };

    public static bool IsDisposed(object item) => item switch
    {
        Joint joint => joint.IsDisposed,
        Spring spring => spring.IsDisposed,
        _ => ((Controller)item).IsDisposed,
    };

    public static void Enable(object item, bool enabled)
    {
        switch (item)
        {
            case Joint joint: joint.Enabled = enabled; break;
            case Spring spring: spring.Enabled = enabled; break;
            default: ((Controller)item).Enabled = enabled; break;
        }
    }

    /// <summary>Breaks what can break at its next error, however small. A controller cannot: it is switched off.</summary>
    public static void Break(object item)
    {
        switch (item)
        {
            case Joint joint:
                joint.Breakpoint = 0;
                joint.BreakForce = 0;
                break;
            case Spring spring: spring.Breakpoint = 0; break;
            default: Enable(item, false); break;
        }
    }

    public static void OnBroke(object item, EventHandler<EventArgs> handler)
    {
        switch (item)
        {
            case Joint joint: joint.Broke += handler; break;
            case Spring spring: spring.Broke += handler; break;
        }
    }

    private static FluidDragController Pool(Pair pair)
    {
        var fluid = new FluidDragController();
        Vector2 place = pair.A.Position;
        fluid.Initialize(
            new AABBFluidContainer(new AABB(place - new Vector2(20, 5), place + new Vector2(60, 100))), 0.002f, 2, 1, new Vector2(0, 100));
        fluid.AddGeom(pair.GeomA);
        fluid.AddGeom(pair.GeomB);
        return fluid;
    }

    private static WaveController Sea(Pair pair)
    {
        var wave = new WaveController
        {
            NodeCount = 20, Width = 100, Height = 60, Position = pair.A.Position - new Vector2(20, 0), Frequency = 0.02f,
            WaveGeneratorMin = -100, WaveGeneratorMax = 100, WaveGeneratorStep = 10, DampingCoefficient = 0.95f,
        };
        wave.Initialize();
        var fluid = new FluidDragController();
        fluid.Initialize(wave, 0.002f, 2, 1, new Vector2(0, 100));
        fluid.AddGeom(pair.GeomA);
        pair.Simulator.Add(fluid);
        return wave;
    }

    private static ExplosionController Charge(Pair pair)
    {
        var blast = new ExplosionController { Filter = pair.Has };
        blast.Explode(pair.A.Position + new Vector2(0, 20), 100, 50);
        return blast;
    }

    /// <summary>Two boxes side by side, 30 apart, that fall on a floor.</summary>
    public sealed class Pair
    {
        public Pair(PhysicsSimulator simulator, Vector2 place)
        {
            Simulator = simulator;
            GeomA = Sandbox.Box(simulator, place);
            GeomB = Sandbox.Box(simulator, place + new Vector2(30, 0));
            B.LinearVelocity = new Vector2(10, 0);
            B.AngularVelocity = 1;
        }

        public PhysicsSimulator Simulator { get; }

        public Geom GeomA { get; }

        public Geom GeomB { get; }

        public Body A => GeomA.Body;

        public Body B => GeomB.Body;

        public bool Has(Body body) => ReferenceEquals(body, A) || ReferenceEquals(body, B);
    }

    /// <summary>Keeps the second body at the height of the first, by impulses.</summary>
    public sealed class OwnJoint : Joint
    {
        private readonly Body _a;
        private readonly Body _b;
        private float _inverseDt;

        public OwnJoint(Body a, Body b)
        {
            _a = a;
            _b = b;
        }

        public Action? InPreStep { get; set; }

        public Action? InUpdate { get; set; }

        public override void Validate()
        {
            if (_a.IsDisposed || _b.IsDisposed)
            {
                Dispose();
            }
        }

        public override void PreStep(float inverseDt)
        {
            _inverseDt = inverseDt;
            JointError = _b.Position.Y - _a.Position.Y;
            InPreStep?.Invoke();
        }

        public override void Update()
        {
            base.Update();
            InUpdate?.Invoke();
            float masses = _a.InverseMass + _b.InverseMass;
            if (Enabled && masses > 0)
            {
                float impulse = -(_b.LinearVelocity.Y - _a.LinearVelocity.Y + (BiasFactor * JointError * _inverseDt)) / masses;
                _a.LinearVelocity.Y -= impulse * _a.InverseMass;
                _b.LinearVelocity.Y += impulse * _b.InverseMass;
            }
        }
    }

    /// <summary>Pulls a body back to where it stood.</summary>
    public sealed class OwnSpring : Spring
    {
        private readonly Body _body;
        private readonly float _x;

        public OwnSpring(Body body)
        {
            _body = body;
            _x = body.Position.X;
        }

        public Action? InUpdate { get; set; }

        public override void Validate()
        {
            if (_body.IsDisposed)
            {
                Dispose();
            }
        }

        public override void Update(float dt)
        {
            SpringError = _body.Position.X - _x;
            base.Update(dt);
            InUpdate?.Invoke();
            if (Enabled && !_body.IsDisposed)
            {
                _body.ApplyForce(new Vector2(-10 * SpringError, 0));
            }
        }
    }

    /// <summary>Turns two bodies a little.</summary>
    public sealed class OwnController : Controller
    {
        private readonly Body _a;
        private readonly Body _b;

        public OwnController(Body a, Body b)
        {
            _a = a;
            _b = b;
        }

        public Action? InUpdate { get; set; }

        public override void Validate()
        {
            if (_a.IsDisposed || _b.IsDisposed)
            {
                Dispose();
            }
        }

        public override void Update(float dt)
        {
            InUpdate?.Invoke();
            if (!_a.IsDisposed && !_b.IsDisposed)
            {
                _a.ApplyTorque(100);
                _b.ApplyTorque(-100);
            }
        }
    }
}
