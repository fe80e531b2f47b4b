using Farseer.Engine.Storage;

namespace Box2D.Collision.Shapes;

/// <summary>Which shapes a shape collides with.</summary>
/// <example>
/// <code>
/// var ghost = new b2CircleDef { radius = 0.5f };
/// ghost.filter.categoryBits = 2;
/// ghost.filter.maskBits = 1;
/// </code>
/// </example>
public class b2FilterData
{
    /// <summary>Categories of the shape, one bit each. Default 1. The original supports 16; here all bits count.</summary>
    public uint categoryBits { get; set; } = 0x0001;

    /// <summary>Categories that the shape collides with. Default 0xFFFF.</summary>
    public uint maskBits { get; set; } = 0xFFFF;

    /// <summary>Shapes of the same group always collide if it is above 0, never if it is below; 0, the default, is no group.</summary>
    public int groupIndex { get; set; }

    /// <summary>A new object with the same values.</summary>
    /// <returns>The copy.</returns>
    public b2FilterData Copy() => new b2FilterData { categoryBits = categoryBits, maskBits = maskBits, groupIndex = groupIndex };

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    internal void Visit(StateStream s)
    {
        categoryBits = s.Value(categoryBits);
        maskBits = s.Value(maskBits);
        groupIndex = s.Value(groupIndex);
    }
}
