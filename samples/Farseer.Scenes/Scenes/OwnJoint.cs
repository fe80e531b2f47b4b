using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.InteropServices;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;

namespace Farseer.Scenes;

/// <summary>A joint that the library does not have, written by deriving from <see cref="Joint"/>: a rack on a pinion.</summary>
public sealed class OwnJoint : Scene
{
    private const float Radius = 1f;
    private const float RackHeight = 4f;
    private const float StartHeight = 6f;

    /// <summary>The rack has fallen for a second then; it lands later.</summary>
    private const int MeasuredStep = 60;
    private Body? _rack;
    private Body? _pinion;
    private RackAndPinionJoint? _joint;
    private double _fallen;
    private double _turned;
    private double _slip;

    public override string Name => "own-joint";

    public override string Title => "A joint of your own";

    public override string Description =>
        "A rack falls and turns a pinion through a joint that the scene itself brings, until it stands on the floor.";

    public override int Steps => 300;

    public override SceneView View => new(new Vector2(-5f, -1f), new Vector2(5f, 9f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 20f);
        _slip = 0.0;

        // The rack slides on a vertical rail, the pinion turns on a nail; they would touch, so they are of one group.
        Geom rack = Make.Box(simulator, new Vector2(Radius + 0.25f, StartHeight), 0.5f, RackHeight);
        rack.CollisionGroup = 1;
        _rack = rack.Body;
        simulator.Add(new FixedPrismaticJoint(_rack, _rack.Position, Vector2.UnitY));
        Geom pinion = Make.Circle(simulator, new Vector2(0f, 5f), Radius);
        pinion.CollisionGroup = 1;
        _pinion = pinion.Body;
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, _pinion, _pinion.Position);

        _joint = new RackAndPinionJoint(_rack, _pinion, Vector2.UnitY, Radius);
        simulator.Add(_joint);
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        _slip = Math.Max(_slip, Math.Abs(_rack!.PositionY - StartHeight - (Radius * _pinion!.TotalRotation)));
        if (step == MeasuredStep)
        {
            _fallen = StartHeight - _rack.PositionY;
            _turned = _pinion.TotalRotation;
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        // The rack has to set the pinion turning too, which weighs I / r² at its rim.
        double mass = _rack!.Mass;
        double rim = _pinion!.MomentOfInertia / (Radius * (double)Radius);
        double time = MeasuredStep * (double)Dt;
        double due = 0.5 * Make.Gravity * mass / (mass + rim) * time * time;
        return
        [
            // Two joints share the rack and are solved one after the other, each step: a hundredth is left between them.
            SceneOutcome.Error("way fallen in the first second (m)", _fallen, due, 0.01 * due),
            SceneOutcome.Error("turn of the pinion by then (rad)", _turned, -due / Radius, 0.01 * due),
            SceneOutcome.AtMost("largest slip (m)", _slip, 0.01),
            SceneOutcome.Error("height of the rack on the floor (m)", _rack.PositionY, 0.5 * RackHeight, 2.0 * Make.Tolerance),
            SceneOutcome.AtMost("speed of the pinion at the end (rad/s)", Math.Abs(_pinion.AngularVelocity), 0.01),
        ];
    }
}

/// <summary>
/// Couples the way of a rack along its axis to the turn of a pinion, without teeth.
/// <para>
/// How such a joint is found: write what shall be 0, here C = s - r θ, with s the way of the rack along its unit axis d, and θ the
/// turn of the pinion of radius r. Its rate is C' = d·v - r ω. An impulse P on the rack along d, and -r P as spin on the
/// pinion, changes C' by K P, with K = 1/m + r²/I. So P = -(C' + bias) / K brings the rate to -bias, and a bias of a share of
/// C / dt takes away that share of an error that is left from before.
/// </para>
/// </summary>
public sealed class RackAndPinionJoint : Joint, ISavedState
{
    private readonly Body _rack;
    private readonly Body _pinion;
    private readonly Vector2 _axis;
    private readonly float _radius;
    private readonly double _start;
    private float _inverseK;
    private float _bias;
    private float _impulse;

    public RackAndPinionJoint(Body rack, Body pinion, Vector2 axis, float radius)
    {
        _rack = rack;
        _pinion = pinion;
        _axis = Vector2.Normalize(axis);
        _radius = radius;
        _start = Way();
    }

    /// <summary>
    /// The impulse that the next update starts from is all that the joint remembers: the rest is made anew in each iteration.
    /// </summary>
    public int StateSize => sizeof(float);

    /// <summary>Called when the simulator is captured.</summary>
    public void SaveState(Span<byte> destination) => MemoryMarshal.Write(destination, in _impulse);

    /// <summary>Called when the simulator goes back to a state.</summary>
    public void RestoreState(ReadOnlySpan<byte> source) => _impulse = MemoryMarshal.Read<float>(source);

    /// <summary>Called at the start of an update: a joint without its bodies must go.</summary>
    public override void Validate()
    {
        if (_rack.IsDisposed || _pinion.IsDisposed)
        {
            Dispose();
        }
    }

    /// <summary>Called once in each iteration, before <see cref="Update"/>: everything that stays the same through it.</summary>
    public override void PreStep(float inverseDt)
    {
        _inverseK = 1f / (_rack.InverseMass + (_radius * _radius * _pinion.InverseMomentOfInertia));

        // The simulator shows the error, and breaks the joint when it is above Breakpoint.
        JointError = (float)(Way() - _start);
        _bias = BiasFactor * inverseDt * JointError;

        // The impulse of the last iteration is a good guess for this one: warm start.
        Apply(_impulse);
    }

    /// <summary>Called several times in each iteration, in turn with the other joints and the contacts.</summary>
    public override void Update()
    {
        // The base class breaks the joint when its error is above Breakpoint.
        base.Update();
        float rate = Vector2.Dot(_axis, _rack.LinearVelocity) - (_radius * _pinion.AngularVelocity);
        float impulse = -(rate + _bias) * _inverseK;
        _impulse += impulse;
        Apply(impulse);
    }

    private void Apply(float impulse)
    {
        _rack.LinearVelocity += impulse * _rack.InverseMass * _axis;
        _pinion.AngularVelocity -= _radius * impulse * _pinion.InverseMomentOfInertia;
    }

    /// <summary>In double precision, as far from the origin a float would not tell small errors.</summary>
    private double Way() => (_rack.PositionX * _axis.X) + (_rack.PositionY * _axis.Y) - (_radius * (double)_pinion.TotalRotation);
}
