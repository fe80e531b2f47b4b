using System.Numerics;
using System.Runtime.InteropServices;

namespace Farseer.Engine.NarrowPhase;

/// <summary>One point of a manifold, in world axes about the centre of body A.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct ManifoldPoint
{
    /// <summary>Midway between the two surfaces, relative to the centre of body A.</summary>
    public Vector2 Anchor;

    /// <summary>Distance of the surfaces along the normal; negative when they overlap.</summary>
    public float Separation;

    /// <summary>
    /// Names the two features that make the point. It does not depend on which shape was the reference, nor on whether a clip
    /// just touches an edge, so a resting contact keeps its ids and with them its impulses.
    /// </summary>
    public uint Id;
}

/// <summary>Up to two contact points with one unit normal, from shape A to shape B.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct Manifold
{
    public Vector2 Normal;
    public int Count;
    public ManifoldPoint Point0;
    public ManifoldPoint Point1;
}
