namespace Box2D.Collision;

/// <summary>Names the features of two shapes that make a contact point; the same from step to step as long as they do.</summary>
/// <example>
/// <code>
/// b2ContactID id = point.id.Copy();
/// bool same = id.key == point.id.key;
/// </code>
/// </example>
public class b2ContactID
{
    /// <summary>Makes an id of 0.</summary>
    public b2ContactID() => features = new Features(this);

    /// <summary>The four parts of the id.</summary>
    public Features features { get; }

    /// <summary>The id as one number.</summary>
    public uint key { get; set; }

    /// <summary>Takes over another id.</summary>
    /// <param name="id">The other one.</param>
    public void Set(b2ContactID id) => key = id.key;

    /// <summary>A new id with the same number.</summary>
    /// <returns>The copy.</returns>
    public b2ContactID Copy() => new b2ContactID { key = key };
}
