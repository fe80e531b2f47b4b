namespace Farseer.Engine.Joints.Lanes;

/// <summary>The trees of a bundle as the kernels walk them: bodies in pre-order with the joints to their parents, and anchors.</summary>
internal unsafe struct LaneBundle
{
    public LaneNode* Nodes;
    public LanePlace* Places;

    /// <summary>Number of bodies.</summary>
    public int Count;
    public LaneAnchor* Anchors;
    public LanePlace* AnchorPlaces;
    public int AnchorCount;
}
