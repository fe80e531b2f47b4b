namespace Box2D.Common.Math;

/// <summary>A position and a rotation: what turns points of a body into points of the world.</summary>
/// <example>
/// <code>
/// b2XForm pose = body.GetXForm();
/// b2Vec2 inWorld = b2Math.b2MulX(pose, new b2Vec2(0.5f, 0));
/// </code>
/// </example>
public class b2XForm
{
    /// <summary>Makes the identity, or a transform of a position and a rotation, whose numbers are copied.</summary>
    /// <param name="pos">The position, or null.</param>
    /// <param name="r">The rotation, or null.</param>
    public b2XForm(b2Vec2? pos = null, b2Mat22? r = null)
    {
        position = new b2Vec2();
        R = new b2Mat22();
        if (pos is not null && r is not null)
        {
            Initialize(pos, r);
        }
    }

    internal b2XForm(b2Vec2 place, b2Mat22 rotation, bool shared)
    {
        _ = shared;
        position = place;
        R = rotation;
    }

    /// <summary>The position of the origin.</summary>
    public b2Vec2 position { get; set; }

    /// <summary>The rotation.</summary>
    public b2Mat22 R { get; set; }

    /// <summary>Takes over a position and a rotation.</summary>
    /// <param name="pos">The position.</param>
    /// <param name="r">The rotation.</param>
    public void Initialize(b2Vec2 pos, b2Mat22 r)
    {
        position.SetV(pos);
        R.SetM(r);
    }

    /// <summary>Becomes the transform that changes nothing.</summary>
    public void SetIdentity()
    {
        position.SetZero();
        R.SetIdentity();
    }

    /// <summary>Takes over another transform.</summary>
    /// <param name="x">The transform.</param>
    public void Set(b2XForm x) => Initialize(x.position, x.R);
}
