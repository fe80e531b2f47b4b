using Box2D.Bridge;
using Box2D.Common.Math;

namespace Box2D.Dynamics.Joints;

/// <summary>The definition of a mouse joint.</summary>
/// <example>
/// <code>
/// var def = new b2MouseJointDef { body1 = world.GetGroundBody(), body2 = body, maxForce = 1000 };
/// def.target.SetV(body.GetWorldCenter());
/// world.CreateJoint(def);
/// </code>
/// </example>
public class b2MouseJointDef : b2JointDef
{
    /// <summary>Makes a definition of a spring of 5 Hz without force.</summary>
    public b2MouseJointDef()
        : base(b2Joint.e_mouseJoint)
    {
    }

    /// <summary>
    /// Where the second body is to be drawn, and at first the point of it that is held; in the world, metres. Default (0, 0).
    /// </summary>
    public b2Vec2 target { get; set; } = new b2Vec2();

    /// <summary>Largest force, newtons; finite and 0 or more. Default 0.</summary>
    public float maxForce { get; set; }

    /// <summary>Frequency of the spring, Hz; finite and above 0. Default 5.</summary>
    public float frequencyHz { get; set; } = 5.0f;

    /// <summary>Damping of the spring: 0 none, 1 critical. Default 0.7.</summary>
    public float dampingRatio { get; set; } = 0.7f;

    /// <summary>
    /// Time step, seconds; finite. Used only with <see cref="Box2DFlash202Quirks.MouseJointStiffness"/>. Default 1/60.
    /// </summary>
    public float timeStep { get; set; } = 1.0f / 60.0f;

    internal override b2Joint Make(b2World world)
    {
        Require.Vector(target, nameof(target));
        Require.NotNegative(maxForce, nameof(maxForce));
        Require.Positive(frequencyHz, nameof(frequencyHz));
        Require.Finite(timeStep, nameof(timeStep));
        Require.NotNegative(dampingRatio, nameof(dampingRatio));
        return new b2MouseJoint(this, world);
    }
}
