using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Tests.Robustness;

/// <summary>
/// A world that follows from a seed: 3 to 44 bodies over a floor, some within each other and some static, joints of all kinds between any
/// two of them, springs, motors, handlers that veto; while it runs joints are removed, switched off and on, bodies are put elsewhere and
/// gravity changes. Joints begin within their errors. It keeps an account of what moved its bodies.
/// </summary>
internal sealed partial class RandomWorld
{
    private const int Steps = 400;
    private const int Paces = 3;

    /// <summary>
    /// Its parts are numbered in the order in which they are made; one that is not kept is left out, and all others stay as they are.
    /// </summary>
    private readonly Func<int, bool> _keeps;
    private readonly Random _random;
    private readonly List<Body> _bodies = new List<Body>();
    private readonly List<Joint> _joints = new List<Joint>();

    /// <summary>What was left out, and joints that are gone.</summary>
    private readonly HashSet<Body> _absent = new HashSet<Body>();
    private readonly HashSet<Joint> _out = new HashSet<Joint>();
    private readonly List<(int Step, Action Act)> _events = new List<(int Step, Action Act)>();
    private readonly PhysicsSimulator _simulator;
    private readonly int _pace;
    private double _given;
    private bool _turnsGravity;
    private bool _putsDown;

    public RandomWorld(int seed, Func<int, bool>? keeps = null)
    {
        _keeps = keeps ?? (_ => true);
        _random = new Random(seed);
        _pace = seed % Paces;
        Vector2 gravity = _random.Next(8) == 0 ? 10 * Around() : new Vector2(0, -10);
        _simulator = new PhysicsSimulator(gravity) { EnableReport = true };
        _simulator.BodyQuarantined += (_, _) => Quarantined++;
        AddFloor();
        int bodies = _random.Next(3, 45);
        float room = MathF.Sqrt(bodies) * Next(0.6f, 1.6f);
        for (int i = 0; i < bodies; i++)
        {
            AddBody(room);
        }

        for (int i = _random.Next(2 * bodies); i > 0; i--)
        {
            AddJoint();
        }

        for (int i = _random.Next(4); i > 0; i--)
        {
            AddSpring();
        }

        for (int i = _random.Next(16); i > 0; i--)
        {
            AddEvent();
        }

        _given = Kinetic();
    }

    /// <summary>Number of parts that were made or left out.</summary>
    public int Parts { get; private set; }

    public int Quarantined { get; private set; }

    public float Fastest { get; private set; }

    /// <summary>The largest share that the kinetic energy had of what was given to it until then.</summary>
    public double WorstShare { get; private set; }

    /// <summary>Bodies that lie under the floor although nothing was put there and all always fell towards it.</summary>
    public int BelowFloor
    {
        get
        {
            int below = 0;
            foreach (Body body in _bodies)
            {
                below += !_turnsGravity && !_putsDown && !_absent.Contains(body) && body.Position.Y < -1 && MathF.Abs(body.Position.X) < 900
                    ? 1
                    : 0;
            }

            return below;
        }
    }

    /// <summary>The parts that were made, by their numbers: what a reduction is read from.</summary>
    public List<string> Log { get; } = new List<string>();

    public void Run()
    {
        var pace = new Random(_pace);
        for (int i = 0; i < Steps; i++)
        {
            foreach ((int step, Action act) in _events)
            {
                if (step == i)
                {
                    act();
                }
            }

            Step(_pace switch
            {
                1 => 1 / (30 + (210 * pace.NextSingle())),
                2 when i % 20 == 0 => 0.1f,
                _ => 1 / 60f,
            });
        }
    }

    private void Step(float dt)
    {
        _simulator.Update(dt);
        StepReport report = _simulator.Report;
        _given += Math.Max(0, report.GravityWork) + Math.Max(0, report.SpringWork) + Math.Max(0, report.MotorWork);
        double share = report.KineticEnergy / (_given + Least());
        WorstShare = Math.Max(WorstShare, share);

        foreach (Body body in _bodies)
        {
            Fastest = MathF.Max(Fastest, body.LinearVelocity.Length());
        }
    }

    /// <summary>
    /// What would lift all of them by 5 cm: overlaps that the world begins with and slacks of limits are no more than that.
    /// </summary>
    private double Least()
    {
        double mass = 0;
        foreach (Body body in _bodies)
        {
            mass += body.IsStatic || _absent.Contains(body) ? 0 : body.Mass;
        }

        return mass * 10 * 0.05;
    }

    private double Kinetic() => _bodies.Where(body => !body.IsStatic && !_absent.Contains(body)).Sum(Energies.Kinetic);

    private bool Keeps(string what)
    {
        bool keeps = _keeps(Parts++);
        if (keeps)
        {
            Log.Add($"{Parts - 1}: {what}");
        }

        return keeps;
    }

    private float Next(float least, float most) => least + ((most - least) * _random.NextSingle());

    private Vector2 Around() => new Vector2(Next(-1, 1), Next(-1, 1));

    private Body Any() => _bodies[_random.Next(_bodies.Count)];

    private void AddFloor()
    {
        Body floor = BodyFactory.Instance.CreateRectangleBody(_simulator, 2000, 2, 1);
        floor.Position = new Vector2(0, -1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(_simulator, floor, 2000, 2);
    }

    private void AddBody(float room)
    {
        float size = Next(0.2f, 1);
        float mass = MathF.Exp(Next(-2.3f, 2.3f));
        int shape = _random.Next(3);
        Body body = shape == 0
            ? BodyFactory.Instance.CreateCircleBody(size / 2, mass)
            : BodyFactory.Instance.CreateRectangleBody(size, shape == 1 ? size : size / 3, mass);
        body.Position = new Vector2(Next(-room, room), 0.6f + Next(0, room));
        body.Rotation = Next(-1, 1);
        Vector2 velocity = 2 * Around();
        float spin = Next(-2, 2);
        Geom geom = shape == 0
            ? GeomFactory.Instance.CreateCircleGeom(body, size / 2, 16)
            : GeomFactory.Instance.CreateRectangleGeom(body, size, shape == 1 ? size : size / 3);
        geom.FrictionCoefficient = Next(0, 1);
        geom.RestitutionCoefficient = _random.Next(3) == 0 ? Next(0, 0.8f) : 0;
        if (_random.Next(10) == 0)
        {
            int seen = 0;
            geom.OnCollision = (_, _, _) => seen++ % 3 != 0;
        }

        body.IsStatic = _random.Next(12) == 0;
        if (!body.IsStatic)
        {
            body.LinearVelocity = velocity;
            body.AngularVelocity = spin;
        }

        _bodies.Add(body);
        if (Keeps($"body {_bodies.Count - 1} shape {shape} size {size} mass {mass} at {body.Position} static {body.IsStatic}"))
        {
            _simulator.Add(body);
            _simulator.Add(geom);
        }
        else
        {
            _absent.Add(body);
        }
    }

    private void AddSpring()
    {
        Body one = Any();
        Body other = Any();
        float stiffness = Next(1, 100);
        float damping = Next(0, 5);
        bool keeps = Keeps($"spring of {_bodies.IndexOf(one)} and {_bodies.IndexOf(other)}");
        if (one != other && keeps && !_absent.Contains(one) && !_absent.Contains(other))
        {
            _simulator.Add(new LinearSpring(one, Vector2.Zero, other, 0.1f * Vector2.One, stiffness, damping));
        }
    }

    private void AddEvent()
    {
        int step = _random.Next(Steps);
        int what = _random.Next(5);
        Vector2 way = 3 * Around();
        Body body = Any();
        Joint? joint = _joints.Count > 0 ? _joints[_random.Next(_joints.Count)] : null;
        Vector2 gravity = 10 * Around();
        bool keeps =
            Keeps($"event {what} at {step}: body {_bodies.IndexOf(body)} by {way}, joint {joint?.GetType().Name}, gravity {gravity}");
        bool acts = joint is not null && !_out.Contains(joint);

        // A servo that is switched on late would go for its angle with a speed, as it should.
        bool late = joint is not (AngleJoint or FixedAngleJoint);
        switch (what)
        {
            case 0 when keeps && acts && _out.Add(joint!):
                _events.Add((step, () => _simulator.Remove(joint!)));
                break;
            case 1 when keeps && acts && late:
                _events.Add((step, () => joint!.Enabled = false));
                _events.Add((step + 40, () => joint!.Enabled = true));
                break;
            case 2:
            case 3:
                if (keeps && !_absent.Contains(body))
                {
                    _putsDown |= way.Y < 0;
                    _events.Add((step, () => body.Position += way));
                }

                break;
            case 4 when keeps:
                _turnsGravity = true;
                _events.Add((step, () => _simulator.Gravity = gravity));
                break;
        }
    }
}
