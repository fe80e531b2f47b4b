using Farseer.Engine.Storage;

namespace Box2D.Bridge;

/// <summary>A shape's collider in the engine.</summary>
internal sealed class ShapeLink
{
    public Handle Collider { get; set; }

    /// <summary>False while the body is frozen or the shape is gone.</summary>
    public bool IsAttached { get; set; }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        Collider = s.Value(Collider);
        IsAttached = s.Value(IsAttached);
    }
}
