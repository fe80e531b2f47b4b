using System;
using Box2D.Bridge;

namespace Box2D.Dynamics.Joints;

/// <summary>The definition of a gear.</summary>
/// <example>
/// <code>
/// var def = new b2GearJointDef { body1 = body, body2 = second, joint1 = hinge, joint2 = slide, ratio = 2 };
/// </code>
/// </example>
public class b2GearJointDef : b2JointDef
{
    /// <summary>Makes a definition of a gear of ratio 1.</summary>
    public b2GearJointDef()
        : base(b2Joint.e_gearJoint)
    {
    }

    /// <summary>First joint: a hinge or slider whose first body is static, as the ground body. Default null: it must be set.</summary>
    public b2Joint? joint1 { get; set; }

    /// <summary>Second joint, of the same kinds. Default null: it must be set.</summary>
    public b2Joint? joint2 { get; set; }

    /// <summary>coordinate1 + ratio·coordinate2 is constant. Finite and not 0; may be negative. Default 1.</summary>
    public float ratio { get; set; } = 1.0f;

    /// <summary>A gear turns the second bodies of its joints, whatever <see cref="b2JointDef.body1"/> and body2 are.</summary>
    internal override void CheckBodies(b2World world)
    {
        CheckJoint(joint1, nameof(joint1), world);
        CheckJoint(joint2, nameof(joint2), world);
        if (ReferenceEquals(joint1!.GetBody2(), joint2!.GetBody2()))
        {
            throw new ArgumentException("The joints of a gear must have different second bodies.", nameof(joint2));
        }
    }

    internal override b2Joint Make(b2World world)
    {
        Require.Finite(ratio, nameof(ratio));
        if (ratio == 0)
        {
            throw new ArgumentOutOfRangeException(nameof(ratio), ratio, "The ratio of a gear must not be 0.");
        }

        return new b2GearJoint(this, world);
    }

    private static void CheckJoint(b2Joint? joint, string name, b2World world)
    {
        Require.NotNull(joint, name);
        if (joint is not (b2RevoluteJoint or b2PrismaticJoint))
        {
            throw new ArgumentException("A gear ties hinges and sliders only.", name);
        }

        if (!world.Holds(joint))
        {
            throw new ArgumentException("The joint is destroyed or belongs to another world.", name);
        }

        if (!joint.GetBody1().IsStatic())
        {
            throw new ArgumentException("The first body of a joint that a gear ties must be static.", name);
        }
    }
}
