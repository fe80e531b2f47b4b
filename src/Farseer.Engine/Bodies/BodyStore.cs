using Farseer.Engine.Storage;

namespace Farseer.Engine.Bodies;

/// <summary>All bodies, in columns grouped by who reads them together. A slot keeps its index for the life of the body.</summary>
internal sealed class BodyStore
{
    private readonly ColumnSet _set = new ColumnSet();

    public BodyStore()
    {
        State = _set.Add<BodyState>();
        Pose = _set.Add<BodyPose>();
        Mass = _set.Add<BodyMass>();
        Force = _set.Add<BodyForce>();
        Drag = _set.Add<BodyDrag>();
        Flags = _set.Add<BodyFlags>();
        UserIndex = _set.Add<int>();
        Motion = _set.Add<BodyMotion>();
        Drive = _set.Add<BodyDrive>();
        Residual = _set.Add<BodyResidual>();
        Size = _set.Add<BodySize>();
    }

    public IdPool Ids { get; } = new IdPool();

    /// <summary>The bodies that a step looks at: all but those asleep. It skips whole words of them.</summary>
    public BitSet Visited { get; } = new BitSet();

    public ColumnSet Set => _set;

    public Column<BodyState> State { get; }

    public Column<BodyPose> Pose { get; }

    public Column<BodyMass> Mass { get; }

    public Column<BodyForce> Force { get; }

    public Column<BodyDrag> Drag { get; }

    public Column<BodyFlags> Flags { get; }

    public Column<int> UserIndex { get; }

    public Column<BodyMotion> Motion { get; }

    public Column<BodyDrive> Drive { get; }

    public Column<BodyResidual> Residual { get; }

    public Column<BodySize> Size { get; }
}
