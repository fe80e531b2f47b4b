namespace Box2D.Collision;

/// <summary>
/// The parts of a contact id, a byte each. The engine numbers features its own way, so the parts tell ids apart but do not count
/// edges as those of the original do.
/// </summary>
/// <example>
/// <code>
/// Features sides = point.id.features;
/// int edge = sides.referenceEdge;
/// </code>
/// </example>
public class Features
{
    private readonly b2ContactID _id;

    internal Features(b2ContactID id) => _id = id;

    /// <summary>Lowest byte of the id, 0 to 255; of a larger number that is set, the lowest byte. Default 0.</summary>
    public int referenceEdge
    {
        get => Get(0);
        set => Set(0, value);
    }

    /// <summary>Second byte, as <see cref="referenceEdge"/>.</summary>
    public int incidentEdge
    {
        get => Get(8);
        set => Set(8, value);
    }

    /// <summary>Third byte, as <see cref="referenceEdge"/>.</summary>
    public int incidentVertex
    {
        get => Get(16);
        set => Set(16, value);
    }

    /// <summary>Highest byte, as <see cref="referenceEdge"/>.</summary>
    public int flip
    {
        get => Get(24);
        set => Set(24, value);
    }

    private int Get(int shift) => (int)((_id.key >> shift) & 0xFF);

    private void Set(int shift, int value) => _id.key = (_id.key & ~(0xFFu << shift)) | (((uint)value & 0xFF) << shift);
}
