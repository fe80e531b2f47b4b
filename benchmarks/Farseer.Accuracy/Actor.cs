using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy;

/// <summary>A body of a scene with its true outline; reads the state through the public API, in double precision.</summary>
internal sealed class Actor
{
    private readonly Body _body;

    public Actor(Body body, Vec position, double angle, double mass, double inertia, IReadOnlyList<Vec[]> pieces)
    {
        _body = body;
        Mass = mass;
        Inertia = inertia;
        Pieces = pieces;
        StartPosition = position;
        StartAngle = angle;
    }

    public Body Body => _body;

    public double Mass { get; }

    public double Inertia { get; }

    /// <summary>Convex pieces about the centre of mass; empty for circles, which no penetration metric asks for.</summary>
    public IReadOnlyList<Vec[]> Pieces { get; }

    public Vec StartPosition { get; }

    public double StartAngle { get; }

    public bool IsStatic => _body.IsStatic;

    public bool Enabled => _body.Enabled;

    public Vec Position
    {
        get
        {
            _body.GetPosition(out double x, out double y);
            return new Vec(x, y);
        }
    }

    public Vec Displacement => Position - StartPosition;

    /// <summary>Angle with whole turns.</summary>
    public double Angle
    {
        get
        {
            _body.GetTotalRotation(out double angle);
            return angle;
        }
    }

    /// <summary>Turn since the start, taken to the nearest: right as long as the body turned less than half a turn.</summary>
    public double Turn => Math.IEEERemainder(Angle - StartAngle, 2.0 * Math.PI);

    public Vec Velocity
    {
        get => new(_body.LinearVelocity.X, _body.LinearVelocity.Y);
        set => _body.LinearVelocity = new System.Numerics.Vector2((float)value.X, (float)value.Y);
    }

    public double Spin
    {
        get => _body.AngularVelocity;
        set => _body.AngularVelocity = (float)value;
    }

    public double KineticEnergy => 0.5 * ((Mass * Vec.Dot(Velocity, Velocity)) + (Inertia * Spin * Spin));

    /// <summary>A drag force -coefficient·v.</summary>
    public void SetLinearDrag(double coefficient) => _body.LinearDragCoefficient = (float)coefficient;
}
