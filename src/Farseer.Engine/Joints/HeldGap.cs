namespace Farseer.Engine.Joints;

/// <summary>The gaps with which the points of a contact with a tree ended a step, and the names of the points.</summary>
internal struct HeldGap
{
    public uint Id0;
    public uint Id1;
    public double Gap0;
    public double Gap1;
}
