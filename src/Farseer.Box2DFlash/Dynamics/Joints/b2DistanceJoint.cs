using System;
using System.ComponentModel;
using Box2D.Bridge;
using Box2D.Common.Math;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics.Joints;

/// <summary>Keeps two points of two bodies at one distance, as a rod or as a spring.</summary>
/// <example>
/// <code>
/// var def = new b2DistanceJointDef { frequencyHz = 4, dampingRatio = 0.5f };
/// def.Initialize(body, second, body.GetWorldCenter(), second.GetWorldCenter());
/// var spring = (b2DistanceJoint)world.CreateJoint(def);
/// </code>
/// </example>
public class b2DistanceJoint : b2Joint
{
    private readonly b2Vec2 _local1;
    private readonly b2Vec2 _local2;

    internal b2DistanceJoint(b2DistanceJointDef def, b2World world)
        : base(def, world, JointKind.Distance, def.body1!, def.body2!)
    {
        _local1 = def.localAnchor1.Copy();
        _local2 = def.localAnchor2.Copy();
        Link.SetAnchors(def.body1!.Link, _local1.x, _local1.y, def.body2!.Link, _local2.x, _local2.y);
        Link.Settings.Target = def.length;
        Link.Settings.Frequency = def.frequencyHz;
        Link.Settings.DampingRatio = def.dampingRatio;
        Link.Spring = def.frequencyHz > 0;
    }

    internal b2Vec2 Local1 => _local1;

    internal b2Vec2 Local2 => _local2;

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor1() => GetBody1().GetWorldPoint(_local1);

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor2() => GetBody2().GetWorldPoint(_local2);

    /// <summary>Always 0: a rod transmits no torque.</summary>
    /// <returns>0.</returns>
    public override float GetReactionTorque() => 0;

    /// <summary>The wanted distance of the anchors, metres. (An addition to the original.)</summary>
    /// <returns>0 or more.</returns>
    public float GetLength() => (float)Link.Settings.Target;

    /// <summary>Sets the wanted distance of the anchors. (An addition to the original, whose field was written to.)</summary>
    /// <param name="length">Metres; finite and 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="length"/> is negative or not finite.</exception>
    public void SetLength(float length)
    {
        Link.Settings.Target = Require.NotNegative(length, nameof(length));
        Changed();
    }

    /// <summary>The frequency of the spring, Hz; 0 for a rod. (An addition to the original.)</summary>
    /// <returns>0 or more.</returns>
    public float GetFrequency() => (float)Link.Settings.Frequency;

    /// <summary>Sets the frequency of the spring. (An addition to the original, whose field was written to.)</summary>
    /// <param name="hz">Hz; finite and 0 or more. 0 makes a rigid rod.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="hz"/> is negative or not finite.</exception>
    public void SetFrequency(float hz)
    {
        Link.Settings.Frequency = Require.NotNegative(hz, nameof(hz));
        Link.Spring = hz > 0;
        Changed();
    }

    /// <summary>The damping of the spring: 0 none, 1 critical. (An addition to the original.)</summary>
    /// <returns>0 or more.</returns>
    public float GetDampingRatio() => (float)Link.Settings.DampingRatio;

    /// <summary>Sets the damping of the spring. (An addition to the original, whose field was written to.)</summary>
    /// <param name="ratio">0 none, 1 critical; finite and 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="ratio"/> is negative or not finite.</exception>
    public void SetDampingRatio(float ratio)
    {
        Link.Settings.DampingRatio = Require.NotNegative(ratio, nameof(ratio));
        Changed();
    }

    /// <summary>A field of the original: the anchor in the first body. It returns a copy.</summary>
    [Obsolete("Use GetAnchor1() and GetLocalPoint of the body.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2 m_localAnchor1 => _local1.Copy();

    /// <summary>A field of the original: the anchor in the second body. It returns a copy.</summary>
    [Obsolete("Use GetAnchor2() and GetLocalPoint of the body.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2 m_localAnchor2 => _local2.Copy();

    /// <summary>A field of the original. Use <see cref="GetLength"/> and <see cref="SetLength"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    [Obsolete("Use GetLength() and SetLength.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_length
    {
        get => GetLength();
        set => SetLength(value);
    }

    /// <summary>A field of the original. Use <see cref="GetFrequency"/> and <see cref="SetFrequency"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    [Obsolete("Use GetFrequency() and SetFrequency.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_frequencyHz
    {
        get => GetFrequency();
        set => SetFrequency(value);
    }

    /// <summary>A field of the original. Use <see cref="GetDampingRatio"/> and <see cref="SetDampingRatio"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    [Obsolete("Use GetDampingRatio() and SetDampingRatio.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_dampingRatio
    {
        get => GetDampingRatio();
        set => SetDampingRatio(value);
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        _local1.Visit(s);
        _local2.Visit(s);
    }
}
