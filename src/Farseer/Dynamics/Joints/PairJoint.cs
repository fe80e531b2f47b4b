using System;
using System.Numerics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>Base class of the joints between two bodies.</summary>
/// <example>
/// <code>
/// PairJoint weld = new WeldJoint(body, second, body.Position);
/// simulator.Add(weld);
/// Console.WriteLine($"{weld.Body1} holds {weld.Body2}");
/// </code>
/// </example>
public abstract class PairJoint : Joint
{
    private Body? _body1;
    private Body? _body2;

    private protected PairJoint()
    {
    }

    private protected PairJoint(Body body1, Body body2)
    {
        _body1 = Require.NotNull(body1, nameof(body1));
        _body2 = Require.NotNull(body2, nameof(body2));
        if (ReferenceEquals(body1, body2))
        {
            throw new ArgumentException("A joint needs two different bodies.", nameof(body2));
        }
    }

    /// <summary>The first body. It may be exchanged; distances and anchors stay as they are, so set them anew if need be.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    /// <exception cref="ArgumentException">The value is the second body, or in another simulator than the joint.</exception>
    public Body Body1
    {
        get => _body1!;
        set
        {
            _body1 = Other(value, _body2, nameof(Body1));
            BodiesChanged(value);
            BodiesSet();
        }
    }

    /// <summary>The second body. It may be exchanged; distances and anchors stay as they are, so set them anew if need be.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    /// <exception cref="ArgumentException">The value is the first body, or in another simulator than the joint.</exception>
    public Body Body2
    {
        get => _body2!;
        set
        {
            _body2 = Other(value, _body1, nameof(Body2));
            BodiesChanged(value);
            BodiesSet();
        }
    }

    internal sealed override Body? FirstBody => _body1;

    internal sealed override Body? SecondBody => _body2;

    /// <inheritdoc/>
    public override void Validate()
    {
        if ((_body1 is not null && _body1.IsDisposed) || (_body2 is not null && _body2.IsDisposed))
        {
            Dispose();
        }
    }

    /// <summary>The engine prepares this joint by itself; calling this does nothing.</summary>
    /// <param name="inverseDt">Not used; finite and above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="inverseDt"/> is not finite or not above 0.</exception>
    public override void PreStep(float inverseDt) => Require.Positive(inverseDt, nameof(inverseDt));

    /// <summary>The engine solves this joint by itself; calling this only breaks it if its error is above its breakpoint.</summary>
    public override void Update() => base.Update();

    /// <summary>Both bodies may be known from now on.</summary>
    private protected virtual void BodiesSet()
    {
    }

    private protected bool HasBodies => _body1 is not null && _body2 is not null;

    private protected Vector2 World1(Vector2 anchor) => JointAttachment.ToWorld(_body1, anchor);

    private protected Vector2 World2(Vector2 anchor) => JointAttachment.ToWorld(_body2, anchor);

    private protected float AnchorDistance(Vector2 anchor1, Vector2 anchor2)
    {
        JointAttachment.ToWorld(_body1!, anchor1.X, anchor1.Y, out double x1, out double y1);
        JointAttachment.ToWorld(_body2!, anchor2.X, anchor2.Y, out double x2, out double y2);
        return (float)Math.Sqrt(((x2 - x1) * (x2 - x1)) + ((y2 - y1) * (y2 - y1)));
    }

    private Body Other(Body value, Body? other, string name)
    {
        Free(value, name);
        if (ReferenceEquals(value, other))
        {
            throw new ArgumentException("A joint needs two different bodies.", name);
        }

        return value;
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Reference(ref _body1);
        s.Reference(ref _body2);
    }
}
