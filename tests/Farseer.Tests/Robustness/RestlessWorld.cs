using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Tests.Robustness;

/// <summary>
/// A world that follows from a seed: bodies of all shapes close together, static and kinematic ones among them, joints and springs of all
/// kinds between any two, controllers, steps of all lengths. Every handler that an update calls adds, removes, disposes, moves, disables,
/// reshapes and ties at random, and sometimes throws.
/// </summary>
internal sealed partial class RestlessWorld
{
    private const int FewBodies = 8;
    private const int MostBodies = 48;

    private readonly Random _random;
    private readonly int _seed;
    private readonly float _haste;
    private readonly bool _ties;
    private readonly List<Body> _bodies = new List<Body>();
    private readonly List<Geom> _geoms = new List<Geom>();
    private readonly List<Joint> _joints = new List<Joint>();
    private readonly List<Spring> _springs = new List<Spring>();
    private readonly List<Controller> _controllers = new List<Controller>();
    private readonly PhysicsSimulator _simulator;
    private bool _calm;
    private int _depth;

    /// <param name="seed">What the world follows from.</param>
    /// <param name="workers">Threads of an update.</param>
    /// <param name="ties">With joints and springs.</param>
    public RestlessWorld(int seed, int workers = 1, bool ties = true)
    {
        _seed = seed;
        _ties = ties;
        _random = new Random(seed);
        _haste = Next(0.02f, 0.3f);
        _simulator = new PhysicsSimulator(_random.Next(6) == 0 ? 10 * Around() : new Vector2(0, -10))
        {
            WorkerCount = workers,
            AllowSleep = Often(),
            EnableReport = _random.Next(3) == 0,
            Iterations = _random.Next(1, 9),
        };
        ChooseCollider();
        _simulator.BodyQuarantined += (_, e) =>
        {
            Quarantined.Add(Where + ": " + e);
            Act("BodyQuarantined", e.Body, null);
        };
        _simulator.BodyList.Added += body => Act("BodyList.Added", body, null);
        _simulator.BodyList.Removed += _ => Act("BodyList.Removed", null, null);
        _simulator.GeomList.Added += geom => Act("GeomList.Added", null, geom);
        _simulator.GeomList.Removed += _ => Act("GeomList.Removed", null, null);
        _simulator.JointList.Added += _ => Act("JointList.Added", null, null);
        _simulator.JointList.Removed += _ => Act("JointList.Removed", null, null);
        _simulator.SpringList.Removed += _ => Act("SpringList.Removed", null, null);
        AddFloor();
        for (int i = _random.Next(FewBodies, MostBodies); i > 0; i--)
        {
            AddBody();
        }

        for (int i = _random.Next(2 * _bodies.Count); i > 0; i--)
        {
            AddJoint();
        }

        for (int i = _random.Next(4); i > 0; i--)
        {
            AddSpring();
        }
    }

    /// <summary>What was said of bodies that were taken out.</summary>
    public List<string> Quarantined { get; } = new List<string>();

    /// <summary>How often each kind of handler changed something.</summary>
    public SortedDictionary<string, int> Changes { get; } = new SortedDictionary<string, int>(StringComparer.Ordinal);

    /// <summary>Where it is, for whoever waits for an update to end.</summary>
    public string Where { get; private set; } = "";

    public ulong StateHash() => _simulator.StateHash();

    public void Run(int updates)
    {
        for (int i = 0; i < updates; i++)
        {
            Where = string.Create(CultureInfo.InvariantCulture, $"seed {_seed}, update {i}");
            if (_simulator.BodyList.Count < FewBodies)
            {
                AddBody();
            }

            if (_random.NextSingle() < _haste)
            {
                Guard(() => Try("between updates", null, null));
            }

            Update(Pace());
            AssertSound();
        }

        // Without handlers a plain body in a new place falls as it should, whatever has been done to the others.
        Where = string.Create(CultureInfo.InvariantCulture, $"seed {_seed}, calm");
        _calm = true;
        _simulator.Gravity = new Vector2(0, -10);
        _simulator.Enabled = true;
        foreach (Controller controller in _controllers)
        {
            _simulator.Remove(controller);
        }

        Body late = BodyFactory.Instance.CreateCircleBody(_simulator, 1, 1);
        late.Position = new Vector2(5000, 3000);
        for (int i = 0; i < 4; i++)
        {
            Update(0.01f);
        }

        AssertSound();
        foreach (Geom geom in _simulator.GeomList)
        {
            Require(geom.Body is { IsDisposed: false }, "a geom has no body");
        }

        bool falls = !late.IsQuarantined && late.LinearVelocity.Y < -0.25f && late.LinearVelocity.Y > -0.45f;
        Require(falls, $"a new body falls with {late.LinearVelocity}");
    }

    private void Update(float dt) => Guard(() => _simulator.Update(dt));

    private static void Guard(Action act)
    {
        try
        {
            act();
        }
        catch (FormatException)
        {
            // Thrown by a handler on purpose; the step is complete.
        }
    }

    private float Pace() => _random.Next(10) switch
    {
        0 => MathF.Exp(Next(-12, -4)),
        1 => 0.1f,
        2 => Next(0.03f, 0.4f),
        3 => 1 / 30f,
        _ => 1 / 60f,
    };

    private void ChooseCollider()
    {
        switch (_random.Next(4))
        {
            case 0: _simulator.BroadPhaseCollider = new SweepAndPruneCollider(_simulator); break;
            case 1: _simulator.BroadPhaseCollider = new BruteForceCollider(_simulator); break;
            case 2: _simulator.BroadPhaseCollider = new GridCollider(_simulator); break;
        }

        _simulator.BroadPhaseCollider.OnBroadPhaseCollision += (one, _) =>
        {
            Act("OnBroadPhaseCollision", null, one);
            return _calm || _random.Next(16) != 0;
        };
    }

    private void Act(string handler, Body? body, Geom? geom)
    {
        if (!_calm && _depth == 0 && _random.NextSingle() < _haste)
        {
            Try(handler, body, geom);
        }
    }

    /// <summary>Changes something. A refusal is one; anything else comes out.</summary>
    private void Try(string handler, Body? body, Geom? geom)
    {
        Changes.TryGetValue(handler, out int count);
        Changes[handler] = count + 1;
        _depth++;
        try
        {
            Body? meant = body is { IsDisposed: false } ? body : Pick(_bodies, b => b.IsDisposed);
            Change(meant, geom is { IsDisposed: false } ? geom : Pick(_geoms, g => g.IsDisposed));
        }
        catch (ArgumentException)
        {
        }
        catch (InvalidOperationException)
        {
            // ObjectDisposedException among them.
        }
        finally
        {
            _depth--;
        }
    }

    private void AssertSound()
    {
        foreach (Body body in _simulator.BodyList)
        {
            float place = body.Position.X + body.Position.Y + body.Rotation + body.TotalRotation;
            float speed = body.Enabled ? body.LinearVelocity.X + body.LinearVelocity.Y + body.AngularVelocity : 0;
            Require(
                float.IsFinite(place) && float.IsFinite(speed),
                $"a body is at {body.Position}, {body.TotalRotation} with {body.LinearVelocity}, {body.AngularVelocity}");
        }

        foreach (Joint joint in _simulator.JointList)
        {
            if (joint is Kinds.OwnJoint)
            {
                // What it makes of what it reads is its own.
                continue;
            }

            Vector2 force = joint.ReactionForce;
            Require(
                float.IsFinite(joint.JointError) && float.IsFinite(force.X + force.Y + joint.ReactionTorque),
                $"{joint} answers with {force}, {joint.ReactionTorque}, error {joint.JointError}");
        }

        if (_simulator.EnableReport)
        {
            StepReport report = _simulator.Report;
            Require(
                double.IsFinite(report.KineticEnergy) && double.IsFinite(report.EnergyError),
                $"energy {report.KineticEnergy}, error {report.EnergyError}");
            Require(
                double.IsFinite(report.JointWork) && double.IsFinite(report.LargestSeparation),
                $"work of joints {report.JointWork}, opened by {report.LargestSeparation}");
        }

        Require(!float.IsNaN(_simulator.LargestPenetration), "the largest penetration is no number");
    }

    private void Require(bool holds, string what)
    {
        if (!holds)
        {
            throw new UnsoundException(Where + ": " + what);
        }
    }

    private float Next(float least, float most) => least + ((most - least) * _random.NextSingle());

    private Vector2 Around() => new Vector2(Next(-1, 1), Next(-1, 1));

    private bool Often() => _random.Next(2) == 0;

    private T? Pick<T>(List<T> items, Func<T, bool> isGone)
        where T : class
    {
        items.RemoveAll(item => isGone(item));
        return items.Count == 0 ? null : items[_random.Next(items.Count)];
    }

    /// <summary>Something about the world is not as it must always be.</summary>
    internal sealed class UnsoundException : Exception
    {
        public UnsoundException(string message)
            : base(message)
        {
        }
    }
}
