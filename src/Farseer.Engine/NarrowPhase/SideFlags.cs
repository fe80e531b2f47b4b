using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>What a side of a pair is and may do.</summary>
[System.Flags]
internal enum SideFlags : int
{
    None = 0,

    /// <summary>Not set in the side that empty lanes point at.</summary>
    Exists = 1,

    /// <summary>The collider takes part in the response.</summary>
    Responds = 2,

    /// <summary>The solver may move the body.</summary>
    Moves = 4,

    /// <summary>Gravity acts on the body.</summary>
    Pulled = 8,

    /// <summary>A listener wants to hear of the collider.</summary>
    Heard = 16,

    /// <summary>A box that the box kernel can do.</summary>
    Box = (int)PieceTraits.Box,

    /// <summary>A circle.</summary>
    Circle = (int)PieceTraits.Circle,

    /// <summary>The fat box is new in this step.</summary>
    NewBox = 128,

    /// <summary>The body turns with its spin; a static one with a spin only drags along what it touches.</summary>
    Turns = 256,

    /// <summary>The body is foreseen to move by more than its own size in this step.</summary>
    Fast = 512,

    /// <summary>A hull without seams, of two to <see cref="HullLanes.MostCorners"/> corners: the kernels of hulls can do it.</summary>
    Hull = (int)PieceTraits.Hull,

    /// <summary>A box whose own axes are not those of its body.</summary>
    Tilted = (int)PieceTraits.Tilted,
}
