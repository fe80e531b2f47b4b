using System;
using System.ComponentModel;
using Box2D.Bridge;
using Box2D.Common.Math;

namespace Box2D.Dynamics.Joints;

/// <summary>The definition of a hinge.</summary>
/// <example>
/// <code>
/// var def = new b2RevoluteJointDef { enableLimit = true, lowerAngle = -1, upperAngle = 1 };
/// def.Initialize(body, second, body.GetWorldCenter());
/// world.CreateJoint(def);
/// </code>
/// </example>
public class b2RevoluteJointDef : b2JointDef
{
    /// <summary>Makes a definition of a hinge at the origins of two bodies.</summary>
    public b2RevoluteJointDef()
        : base(b2Joint.e_revoluteJoint)
    {
    }

    /// <summary>The hinge in the first body, metres. Default (0, 0).</summary>
    public b2Vec2 localAnchor1 { get; set; } = new b2Vec2();

    /// <summary>The hinge in the second body, metres. Default (0, 0).</summary>
    public b2Vec2 localAnchor2 { get; set; } = new b2Vec2();

    /// <summary>Angle of the second body less that of the first where the joint angle is 0, radians. Default 0.</summary>
    public float referenceAngle { get; set; }

    /// <summary>Whether the limits hold. Default false.</summary>
    public bool enableLimit { get; set; }

    /// <summary>Smallest joint angle, radians; not above <see cref="upperAngle"/>. Default 0.</summary>
    public float lowerAngle { get; set; }

    /// <summary>Largest joint angle, radians. Default 0.</summary>
    public float upperAngle { get; set; }

    /// <summary>Whether the motor drives. Default false.</summary>
    public bool enableMotor { get; set; }

    /// <summary>Wanted joint speed, rad/s; finite. Default 0.</summary>
    public float motorSpeed { get; set; }

    /// <summary>Largest torque of the motor, N·m; finite and 0 or more. Default 0.</summary>
    public float maxMotorTorque { get; set; }

    /// <summary>Takes the bodies, and hinge and reference angle as they are now.</summary>
    /// <param name="b1">First body.</param>
    /// <param name="b2">Second body.</param>
    /// <param name="anchor">The hinge, in the world.</param>
    /// <exception cref="ArgumentException">An argument is null or not finite.</exception>
    public void Initialize(b2Body b1, b2Body b2, b2Vec2 anchor)
    {
        Check(b1, b2);
        Require.Vector(anchor, nameof(anchor));
        body1 = b1;
        body2 = b2;
        localAnchor1 = b1.GetLocalPoint(anchor);
        localAnchor2 = b2.GetLocalPoint(anchor);
        referenceAngle = b2.GetAngle() - b1.GetAngle();
    }

    /// <summary>
    /// A name of one example of the manual: the hinge in the world, metres. Setting it after the bodies is the same as
    /// <see cref="Initialize"/>.
    /// </summary>
    /// <exception cref="ArgumentException">The value is null or not finite, or the bodies are not set.</exception>
    [Obsolete("Use Initialize.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2 anchorPoint
    {
        get => body1 is null ? localAnchor1.Copy() : body1.GetWorldPoint(localAnchor1);
        set => Initialize(body1!, body2!, value);
    }

    internal override b2Joint Make(b2World world)
    {
        Require.Vector(localAnchor1, nameof(localAnchor1));
        Require.Vector(localAnchor2, nameof(localAnchor2));
        Require.Finite(referenceAngle, nameof(referenceAngle));
        LimitCheck.Ordered(lowerAngle, upperAngle, nameof(lowerAngle), nameof(upperAngle), enableLimit);
        Require.Finite(motorSpeed, nameof(motorSpeed));
        Require.NotNegative(maxMotorTorque, nameof(maxMotorTorque));
        return new b2RevoluteJoint(this, world);
    }
}
