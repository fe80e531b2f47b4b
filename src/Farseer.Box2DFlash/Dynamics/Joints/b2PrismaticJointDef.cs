using System;
using Box2D.Bridge;
using Box2D.Common.Math;

namespace Box2D.Dynamics.Joints;

/// <summary>The definition of a slider.</summary>
/// <example>
/// <code>
/// var def = new b2PrismaticJointDef { enableLimit = true, lowerTranslation = 0, upperTranslation = 3 };
/// def.Initialize(world.GetGroundBody(), body, body.GetWorldCenter(), new b2Vec2(1, 0));
/// world.CreateJoint(def);
/// </code>
/// </example>
public class b2PrismaticJointDef : b2JointDef
{
    /// <summary>Makes a definition of a slider along the x axis of the first body.</summary>
    public b2PrismaticJointDef()
        : base(b2Joint.e_prismaticJoint)
    {
    }

    /// <summary>A point of the axis in the first body, metres. Default (0, 0).</summary>
    public b2Vec2 localAnchor1 { get; set; } = new b2Vec2();

    /// <summary>The point of the second body that slides on the axis, metres. Default (0, 0).</summary>
    public b2Vec2 localAnchor2 { get; set; } = new b2Vec2();

    /// <summary>The axis in the first body; any length above 0. Default (1, 0).</summary>
    public b2Vec2 localAxis1 { get; set; } = new b2Vec2(1, 0);

    /// <summary>Angle of the second body less that of the first, which is kept, radians. Default 0.</summary>
    public float referenceAngle { get; set; }

    /// <summary>Whether the limits hold. Default false.</summary>
    public bool enableLimit { get; set; }

    /// <summary>Smallest translation, metres; not above <see cref="upperTranslation"/>. Default 0.</summary>
    public float lowerTranslation { get; set; }

    /// <summary>Largest translation, metres. Default 0.</summary>
    public float upperTranslation { get; set; }

    /// <summary>Whether the motor drives. Default false.</summary>
    public bool enableMotor { get; set; }

    /// <summary>Largest force of the motor, newtons; finite and 0 or more. Default 0.</summary>
    public float maxMotorForce { get; set; }

    /// <summary>Wanted speed, m/s; finite. Default 0.</summary>
    public float motorSpeed { get; set; }

    /// <summary>Takes the bodies, and anchor, axis and reference angle as they are now.</summary>
    /// <param name="b1">First body.</param>
    /// <param name="b2">Second body.</param>
    /// <param name="anchor">A point of the axis, in the world.</param>
    /// <param name="axis">The axis, in the world; not zero.</param>
    /// <exception cref="ArgumentException">An argument is null or not finite.</exception>
    public void Initialize(b2Body b1, b2Body b2, b2Vec2 anchor, b2Vec2 axis)
    {
        Check(b1, b2);
        Require.Vector(anchor, nameof(anchor));
        Require.Vector(axis, nameof(axis));
        body1 = b1;
        body2 = b2;
        localAnchor1 = b1.GetLocalPoint(anchor);
        localAnchor2 = b2.GetLocalPoint(anchor);
        localAxis1 = b1.GetLocalVector(axis);
        referenceAngle = b2.GetAngle() - b1.GetAngle();
    }

    internal override b2Joint Make(b2World world)
    {
        Require.Vector(localAnchor1, nameof(localAnchor1));
        Require.Vector(localAnchor2, nameof(localAnchor2));
        Require.Vector(localAxis1, nameof(localAxis1));
        if (localAxis1.x == 0 && localAxis1.y == 0)
        {
            throw new ArgumentException("The axis must have a direction.", nameof(localAxis1));
        }

        Require.Finite(referenceAngle, nameof(referenceAngle));
        LimitCheck.Ordered(lowerTranslation, upperTranslation, nameof(lowerTranslation), nameof(upperTranslation), enableLimit);
        Require.Finite(motorSpeed, nameof(motorSpeed));
        Require.NotNegative(maxMotorForce, nameof(maxMotorForce));
        return new b2PrismaticJoint(this, world);
    }
}
