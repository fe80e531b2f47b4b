using System;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>Base class of the joints between a body and the world, the fixed versions of others.</summary>
/// <example>
/// <code>
/// WorldJoint nail = new FixedRevoluteJoint(body, body.Position);
/// simulator.Add(nail);
/// Console.WriteLine(nail.Body + " turns about " + body.Position);
/// </code>
/// </example>
public abstract class WorldJoint : Joint
{
    private Body? _body;

    private protected WorldJoint()
    {
    }

    private protected WorldJoint(Body body) => _body = Require.NotNull(body, nameof(body));

    /// <summary>The body. It may be exchanged; anchors stay as they are, so set them anew if need be.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    /// <exception cref="ArgumentException">The value is in another simulator than the joint.</exception>
    public Body Body
    {
        get => _body!;
        set
        {
            _body = Free(value, nameof(Body));
            BodiesChanged(value);
            BodySet();
        }
    }

    internal sealed override Body? SecondBody => _body;

    private protected bool HasBody => _body is not null;

    /// <inheritdoc/>
    public override void Validate()
    {
        if (_body is not null && _body.IsDisposed)
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

    /// <summary>The body may be known from now on.</summary>
    private protected virtual void BodySet()
    {
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Reference(ref _body);
    }
}
