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

    public Column<BodySize> Size { get; }

    /// <summary>Of bodies that have flown freely: see <see cref="EnsureResiduals"/>. Those of others, and what lies beyond its end, are 0.</summary>
    public Column<BodyResidual> Residual { get; } = new Column<BodyResidual>();

    /// <summary>Makes room for the residuals of all bodies, before one flies: in a pile none does.</summary>
    public void EnsureResiduals() => Residual.EnsureCapacity(State.Capacity);

    /// <summary>A body begins anew, or was stopped.</summary>
    public void ClearResidual(int body)
    {
        if (body < Residual.Capacity)
        {
            Residual[body] = default;
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        Ids.Visit(s);
        Visited.Visit(s);
        s.Column(State);
        s.Column(Pose);
        s.Column(Mass);
        s.Column(Force);
        s.Column(Drag);
        s.Column(Flags);
        s.Column(UserIndex);
        s.Column(Motion);
        s.Column(Drive);
        s.Column(Size);
        s.Column(Residual);
    }
}
