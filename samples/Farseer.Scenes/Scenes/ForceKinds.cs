using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>One of every kind of spring and controller, each with a body of its own, in pixels with y down as waves need it.</summary>
public sealed class ForceKinds : Scene
{
    private const float Weight = 100f;
    private const float WindSpeed = 40f;
    private const float SpeedLimit = 60f;
    private readonly List<Body> _limited = [];
    private Body? _hung;
    private Body? _turned;
    private LinearSpring? _linear;
    private AngleSpring? _angle;
    private Body? _blown;
    private Body? _thrown;
    private Body? _orbiting;
    private Body? _idle;
    private Geom? _floating;
    private ExplosionController? _blast;
    private double _fastestLimited;
    private double _leastRadius;
    private double _mostRadius;

    public override string Name => "force-kinds";

    public override string Title => "Every kind of spring and controller";

    public override string Description =>
        "Four springs pull bodies to their rest; fluid, waves, wind, gravity, a blast, a limit of speed and rest act each on its own.";

    public override SceneView View => new(new Vector2(-60f, -260f), new Vector2(1000f, 140f));

    public override void Build(PhysicsSimulator simulator)
    {
        simulator.Gravity = new Vector2(0f, Weight);
        _limited.Clear();
        _fastestLimited = 0.0;
        _leastRadius = double.PositiveInfinity;
        _mostRadius = 0.0;
        AddSprings(simulator);
        AddFluids(simulator);
        AddOthers(simulator);
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        if (step == 60)
        {
            _blast!.Explode(new Vector2(700f, -195f), 100f, 40f);
        }

        foreach (Body body in _limited)
        {
            _fastestLimited = Math.Max(_fastestLimited, body.LinearVelocity.Length());
        }

        // A body that ignores gravity ignores that of the controller too: the scene's own weight is lifted by hand.
        _orbiting!.ApplyForce(new Vector2(0f, -Weight));
        double radius = (_orbiting.Position - new Vector2(900f, -100f)).Length();
        _leastRadius = Math.Min(_leastRadius, radius);
        _mostRadius = Math.Max(_mostRadius, radius);
    }

    public override IReadOnlyList<SceneOutcome> Check() =>
    [
        // Damped for 10 s at a rate of 1.5/s: what is left of the start is below 1e-5. Sag m g / k = 1 * 100 / 40.
        SceneOutcome.Error("weight on its spring (px)", _hung!.PositionY, -150.0 + (Weight / 40.0), 0.01),
        SceneOutcome.Error("length of the spring between two bodies (px)", _linear!.SpringError, 0.0, 0.01),
        SceneOutcome.Error("angle of the bar on its spring (rad)", Measure.Angle(_turned!), 0.8, 1e-3),
        SceneOutcome.Error("angle between two bars on a spring (rad)", _angle!.SpringError, 0.0, 1e-3),

        // A ball of half the density floats half immersed; the fluid goes by its 24 vertices, which are 5.2 px apart.
        SceneOutcome.Error("depth of the float (px)", _floating!.Body.PositionY, 40.0, 5.2),

        // Its drag in the air is a thousandth of the wind's pull.
        SceneOutcome.Error("speed in the wind (px/s)", _blown!.LinearVelocity.X, WindSpeed, 0.1),

        // 40 px from a blast of 40 that falls to nothing at 100.
        SceneOutcome.Error("speed of what the blast threw (px/s)", _thrown!.LinearVelocity.X, 24.0, 0.1),

        // The limit acts before the weight of the same update does.
        SceneOutcome.AtMost("fastest of those that are limited (px/s)", _fastestLimited, SpeedLimit + (Weight * Dt) + 0.01),

        // A circular orbit, v^2 = strength / r, of one radian a second. The pull is that of each update's middle, held for the update: the
        // radius differs by a share of about (w dt)^2 / 4, and that does not grow.
        SceneOutcome.AtLeast("least radius of the orbit of 60 (px)", _leastRadius, 59.98),
        SceneOutcome.AtMost("greatest radius of the orbit of 60 (px)", _mostRadius, 60.02),
        SceneOutcome.Exactly("boxes put to rest", _idle!.Enabled ? 0 : 1, 1),
    ];

    private void AddSprings(PhysicsSimulator simulator)
    {
        SpringFactory springs = SpringFactory.Instance;
        _hung = Ball(simulator, new Vector2(0f, -150f), 10f, 1f).Body;
        springs.CreateFixedLinearSpring(simulator, _hung, Vector2.Zero, new Vector2(0f, -200f), 40f, 3f);

        Body left = Weightless(Ball(simulator, new Vector2(60f, -150f), 10f, 1f).Body);
        Body right = Weightless(Ball(simulator, new Vector2(120f, -150f), 10f, 2f).Body);
        _linear = springs.CreateLinearSpring(simulator, left, Vector2.Zero, right, new Vector2(0f, 3f), 40f, 3f);
        _linear.RestLength = 50f;

        _turned = Weightless(Bar(simulator, new Vector2(180f, -150f)));
        FixedAngleSpring nailed = springs.CreateFixedAngleSpring(simulator, _turned, 2000f, 300f);
        nailed.TargetAngle = 0.8f;

        Body first = Weightless(Bar(simulator, new Vector2(240f, -150f)));
        Body second = Weightless(Bar(simulator, new Vector2(300f, -150f)));
        _angle = springs.CreateAngleSpring(simulator, first, second, 2000f, 300f);
        _angle.TargetAngle = 0.5f;
        first.AngularVelocity = 1f;
    }

    private void AddFluids(PhysicsSimulator simulator)
    {
        // Still water, its surface at y = 40: a ball of half its density.
        const float density = 0.002f;
        _floating = Ball(simulator, new Vector2(60f, -20f), 20f, 0.5f * density * MathF.PI * 400f);
        var still = new FluidDragController();
        var basin = new AABBFluidContainer(new AABB(new Vector2(0f, 40f), new Vector2(120f, 140f)));
        still.Initialize(basin, density, 30f, 400f, simulator.Gravity);
        still.AddGeom(_floating);
        simulator.Add(still);

        // Water with waves: three balls float on it.
        var wave = new WaveController
        {
            Position = new Vector2(200f, 40f), Width = 300f, Height = 100f, NodeCount = 31, Frequency = 0.05f,
            WaveGeneratorMin = -200f, WaveGeneratorMax = 200f, WaveGeneratorStep = 30f, DampingCoefficient = 0.98f,
        };
        wave.Initialize();
        var rough = new FluidDragController();
        rough.Initialize(wave, density, 30f, 400f, simulator.Gravity);
        for (int i = 0; i < 3; i++)
        {
            rough.AddGeom(Ball(simulator, new Vector2(250f + (80f * i), -20f), 20f, 0.5f * density * MathF.PI * 400f));
        }

        simulator.Add(wave);
        simulator.Add(rough);
    }

    private void AddOthers(PhysicsSimulator simulator)
    {
        Body blown = Weightless(Ball(simulator, new Vector2(400f, -230f), 8f, 1f).Body);
        _blown = blown;
        simulator.Add(new WindController(new Vector2(WindSpeed, 0f), 1f) { Filter = b => ReferenceEquals(b, blown) });

        Body thrown = Weightless(Ball(simulator, new Vector2(740f, -195f), 8f, 1f).Body);
        _thrown = thrown;
        _blast = new ExplosionController { Filter = b => ReferenceEquals(b, thrown) };
        simulator.Add(_blast);

        Body orbiting = Ball(simulator, new Vector2(960f, -100f), 8f, 1f).Body;
        _orbiting = orbiting;
        orbiting.LinearVelocity = new Vector2(0f, 60f);
        simulator.Add(new GravityController(new Vector2(900f, -100f), 60f * 60f * 60f, 5f) { Filter = b => ReferenceEquals(b, orbiting) });

        // Two that fall and bounce, and may not be faster than so.
        Make.Wall(simulator, new Vector2(600f, 60f), 120f, 20f);
        for (int i = 0; i < 2; i++)
        {
            Geom ball = Ball(simulator, new Vector2(580f + (40f * i), -60f - (60f * i)), 10f, 1f);
            ball.RestitutionCoefficient = 0.9f;
            _limited.Add(ball.Body);
        }

        simulator.Add(new VelocityLimitController(SpeedLimit, 5f) { Filter = _limited.Contains });

        // One that comes to rest and is put to sleep.
        Make.Wall(simulator, new Vector2(800f, 60f), 120f, 20f);
        Geom idle = Make.Box(simulator, new Vector2(800f, 30f), 20f, 20f);
        idle.Body.IsAutoIdle = true;
        idle.Body.Mass = 1f;
        _idle = idle.Body;
        simulator.InactivityController.Enabled = true;
    }

    private static Geom Ball(PhysicsSimulator simulator, Vector2 place, float radius, float mass)
    {
        Geom ball = Make.Circle(simulator, place, radius);
        ball.Body.Mass = mass;
        ball.Body.MomentOfInertia = 0.5f * mass * radius * radius;
        return ball;
    }

    private static Body Bar(PhysicsSimulator simulator, Vector2 place)
    {
        Body bar = Make.Box(simulator, place, 40f, 10f).Body;
        bar.Mass = 1f;
        bar.MomentOfInertia = 140f;
        return bar;
    }

    private static Body Weightless(Body body)
    {
        body.IgnoreGravity = true;
        return body;
    }
}
