using System;
using System.ComponentModel;
using Box2D.Bridge;
using Box2D.Common.Math;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics.Joints;

/// <summary>Draws a point of the second body towards a target, by a spring with a largest force.</summary>
/// <example>
/// <code>
/// var def = new b2MouseJointDef { body1 = world.GetGroundBody(), body2 = body, maxForce = 1000 };
/// def.target.SetV(body.GetWorldCenter());
/// var grip = (b2MouseJoint)world.CreateJoint(def);
/// grip.SetTarget(new b2Vec2(3, -2));
/// </code>
/// </example>
public class b2MouseJoint : b2Joint
{
    private readonly b2Vec2 _local;
    private readonly b2Vec2 _target;

    internal b2MouseJoint(b2MouseJointDef def, b2World world)
        : base(def, world, JointKind.Target, def.body1!, def.body2!)
    {
        _target = def.target.Copy();
        _local = def.body2!.GetLocalPoint(_target);
        Link.Settings.AnchorAX = _target.x;
        Link.Settings.AnchorAY = _target.y;
        Link.Settings.AnchorBX = _local.x - def.body2.Link.CenterX;
        Link.Settings.AnchorBY = _local.y - def.body2.Link.CenterY;
        Link.Settings.MotorLimit = def.maxForce;
        bool stiff = (world.Quirks & Box2DFlash202Quirks.MouseJointStiffness) != 0 && def.timeStep > 0;
        double scale = stiff ? System.Math.Sqrt(1 / (double)def.timeStep) : 1;
        Link.Settings.Frequency = def.frequencyHz * scale;
        Link.Settings.DampingRatio = def.dampingRatio * scale;
        Link.Settings.Ratio = def.body2.GetMass();
    }

    internal b2Vec2 Local => _local;

    /// <summary>The target, in the world, metres.</summary>
    /// <returns>A new vector.</returns>
    public override b2Vec2 GetAnchor1() => _target.Copy();

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor2() => GetBody2().GetWorldPoint(_local);

    /// <summary>Always 0: the joint pulls at a point.</summary>
    /// <returns>0.</returns>
    public override float GetReactionTorque() => 0;

    /// <summary>Moves the target; it wakes the body.</summary>
    /// <param name="target">The new target, in the world, metres; it is copied.</param>
    /// <exception cref="System.ArgumentException"><paramref name="target"/> is null or not finite.</exception>
    public void SetTarget(b2Vec2 target)
    {
        _target.SetV(Require.Vector(target, nameof(target)));
        Link.Settings.AnchorAX = _target.x;
        Link.Settings.AnchorAY = _target.y;
        Link.Push(true, withAnchorA: true);
        GetBody2().WakeUp();
    }

    /// <summary>Says from where to where it pulls, without waking anybody.</summary>
    internal void Place(double x, double y, System.Numerics.Vector2 local)
    {
        _target.Set((float)x, (float)y);
        _local.Set(local.X, local.Y);
    }

    internal override void Attach() => Link.Attach(null, GetBody2().Link);

    /// <summary>A field of the original. Use <see cref="GetAnchor1"/> and <see cref="SetTarget"/> instead. It returns a copy.</summary>
    /// <exception cref="ArgumentException">The value is null or not finite.</exception>
    [Obsolete("Use GetAnchor1() and SetTarget.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2 m_target
    {
        get => _target.Copy();
        set => SetTarget(value);
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        _local.Visit(s);
        _target.Visit(s);
    }
}
