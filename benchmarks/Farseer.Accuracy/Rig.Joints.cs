using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Accuracy;

/// <summary>A joint with the anchors of its two bodies, to measure by.</summary>
internal sealed record Hinge(Actor A, Actor B, Vec LocalA, Vec LocalB)
{
    /// <summary>Distance of the two anchors in the world.</summary>
    public double Error => (A.Position + LocalA.Turned(A.Angle) - B.Position - LocalB.Turned(B.Angle)).Length;

    /// <summary>Angle of B less that of A, radians.</summary>
    public double Angle => B.Angle - A.Angle;
}

/// <content>Bodies without geoms, and joints.</content>
internal sealed partial class Rig
{
    private readonly List<Hinge> _hinges = [];

    public IReadOnlyList<Hinge> Hinges => _hinges;

    /// <summary>"anchor": static, collides with nothing.</summary>
    public Actor AddAnchor(double x, double y) => Add(new Vec(x, y), 0, 1, 1, [], isStatic: true, out _);

    /// <summary>A body that collides with nothing, with the inertia of a box.</summary>
    public Actor AddLooseBox(Vec position, double width, double height, double angle, double mass) =>
        Add(position, angle, mass, mass * ((width * width) + (height * height)) / 12, [], isStatic: false, out _);

    /// <summary>A body that collides with nothing.</summary>
    public Actor AddLoose(Vec position, double mass, double inertia) => Add(position, 0, mass, inertia, [], isStatic: false, out _);

    /// <summary>Bodies of one group other than 0 do not collide with each other.</summary>
    public void SetGroup(Actor actor, int group)
    {
        foreach (Geom geom in _made)
        {
            if (ReferenceEquals(geom.Body, actor.Body))
            {
                geom.CollisionGroup = group;
            }
        }
    }

    public RevoluteJoint AddHinge(Actor a, Actor b, Vec anchor)
    {
        var point = new Vector2((float)anchor.X, (float)anchor.Y);
        var rounded = new Vec(point.X, point.Y);
        _hinges.Add(new Hinge(a, b, (rounded - a.Position).Turned(-a.Angle), (rounded - b.Position).Turned(-b.Angle)));
        return JointFactory.Instance.CreateRevoluteJoint(_simulator, a.Body, b.Body, point);
    }

    public void AddSlide(Actor a, Actor b, Vec anchor, Vec axis) => _simulator.Add(new PrismaticJoint(
        a.Body,
        b.Body,
        new Vector2((float)anchor.X, (float)anchor.Y),
        new Vector2((float)axis.X, (float)axis.Y)));

    public void AddGear(Actor a, Actor b, double ratio) =>
        JointFactory.Instance.CreateGearJoint(_simulator, a.Body, b.Body, (float)ratio);

    public void AddSpring(Actor a, Actor b, double length, double frequency, double dampingRatio) =>
        _simulator.Add(new DistanceJoint(a.Body, Vector2.Zero, b.Body, Vector2.Zero)
        {
            TargetDistance = (float)length,
            Frequency = (float)frequency,
            DampingRatio = (float)dampingRatio,
        });

    /// <summary>A rod between the centres of two bodies, which turn on its ends.</summary>
    public void AddRod(Actor a, Actor b, double length) =>
        _simulator.Add(new DistanceJoint(a.Body, Vector2.Zero, b.Body, Vector2.Zero) { TargetDistance = (float)length });

    /// <summary>Holds the centres of two bodies no further apart than a length.</summary>
    public void AddTether(Actor a, Actor b, double length) =>
        _simulator.Add(new RopeJoint(a.Body, Vector2.Zero, b.Body, Vector2.Zero, (float)length));

    public double LargestHingeError()
    {
        double largest = 0;
        foreach (Hinge hinge in _hinges)
        {
            largest = Math.Max(largest, hinge.Error);
        }

        return largest;
    }

    public double TotalHingeError()
    {
        double sum = 0;
        foreach (Hinge hinge in _hinges)
        {
            sum += hinge.Error;
        }

        return sum;
    }
}
