using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <summary>All joints, in columns, with the list of joints of each body. A slot keeps its index for the life of the joint.</summary>
internal sealed class JointStore
{
    private readonly ColumnSet _set = new ColumnSet();
    private readonly Column<int> _first = new Column<int>();
    private readonly Column<int> _degree = new Column<int>();
    private readonly Column<int> _ties = new Column<int>();
    private int _bodies;
    private int _order;

    public JointStore()
    {
        Links = _set.Add<JointLink>();
        Settings = _set.Add<JointSettings>();
        Flags = _set.Add<JointFlags>();
        States = _set.Add<JointState>();
        Ranges = _set.Add<JointRange>();
    }

    public IdPool Ids { get; } = new IdPool();

    public Column<JointLink> Links { get; }

    public Column<JointSettings> Settings { get; }

    public Column<JointFlags> Flags { get; }

    public Column<JointState> States { get; }

    /// <summary>Of joints with limits.</summary>
    public Column<JointRange> Ranges { get; }

    public int Count => Ids.Count;

    /// <summary>Joints came, went, or were switched since the solver last looked.</summary>
    public bool Changed { get; set; }

    /// <summary>Counts the edits of joints' settings and flags.</summary>
    public int Edition { get; private set; }

    public void NoteEdit() => Edition++;

    /// <summary>Number of joints at a body, switched off ones included.</summary>
    public int Degree(int body) => body < _bodies ? _degree[body] : 0;

    /// <summary>First joint of a body, times two plus the side; -1: none.</summary>
    public int First(int body) => body < _bodies ? _first[body] : -1;

    public int Next(int entry) => NextOf(entry);

    public Handle Add(JointKind kind, int bodyA, int bodyB, in JointSettings settings, JointFlags flags)
    {
        Handle handle = Ids.Take();
        int joint = handle.Index;
        _set.EnsureCapacity(Ids.End);
        EnsureBodies((bodyA > bodyB ? bodyA : bodyB) + 1);
        Settings[joint] = settings;
        Flags[joint] = flags | JointFlags.Alive;
        States[joint] = default;
        Ranges[joint] = default;
        Links[joint] = new JointLink { BodyA = bodyA, BodyB = bodyB, Order = _order++, Kind = kind };
        Link(bodyA, joint * 2);
        Link(bodyB, (joint * 2) + 1);
        _degree[bodyA]++;
        _degree[bodyB]++;
        NoteTie(joint);
        Changed = true;
        return handle;
    }

    public void Remove(Handle handle)
    {
        int joint = handle.Index;
        ref JointLink link = ref Links[joint];
        Unlink(link.BodyA, joint * 2);
        Unlink(link.BodyB, (joint * 2) + 1);
        _degree[link.BodyA]--;
        _degree[link.BodyB]--;
        Flags[joint] = JointFlags.None;
        NoteTie(joint);
        Ids.Return(handle);
        Changed = true;
    }

    /// <summary>True if an enabled joint between the two bodies keeps them from colliding.</summary>
    public bool KeepsApart(int bodyA, int bodyB)
    {
        int few = Degree(bodyA) <= Degree(bodyB) ? bodyA : bodyB;
        int other = few == bodyA ? bodyB : bodyA;
        for (int entry = First(few); entry >= 0; entry = Next(entry))
        {
            ref JointLink link = ref Links[entry >> 1];
            if ((link.BodyA == other || link.BodyB == other)
                && (Flags[entry >> 1] & (JointFlags.CollideConnected | JointFlags.Enabled)) == JointFlags.Enabled)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>An enabled joint that ties its bodies to each other at a point, by a rod or along a rail, and does not give way.</summary>
    public bool IsTie(int joint) =>
        Links[joint].Kind is JointKind.Revolute or JointKind.Weld or JointKind.Prismatic or JointKind.Pin or JointKind.Distance
        && (Flags[joint] & (JointFlags.Enabled | JointFlags.Spring)) == JointFlags.Enabled
        && !(Settings[joint].Softness > 0);

    /// <summary>True if a body has such a joint.</summary>
    public bool IsTied(int body) => body < _bodies && _ties[body] > 0;

    /// <summary>The flags or settings of a joint have changed: whether it ties its bodies is found out anew.</summary>
    public void NoteTie(int joint)
    {
        ref JointLink link = ref Links[joint];
        bool ties = IsTie(joint);
        if (ties != link.Ties)
        {
            link.Ties = ties;
            _ties[link.BodyA] += ties ? 1 : -1;
            _ties[link.BodyB] += ties ? 1 : -1;
        }
    }

    /// <summary>The other body of an entry of a body's list.</summary>
    public int Other(int entry) => (entry & 1) == 0 ? Links[entry >> 1].BodyB : Links[entry >> 1].BodyA;

    private void EnsureBodies(int end)
    {
        _first.EnsureCapacity(end);
        _degree.EnsureCapacity(end);
        _ties.EnsureCapacity(end);
        for (; _bodies < end; _bodies++)
        {
            _first[_bodies] = -1;
            _degree[_bodies] = 0;
            _ties[_bodies] = 0;
        }
    }

    /// <summary>An entry becomes the first of a body's list.</summary>
    private void Link(int body, int entry)
    {
        int next = _first[body];
        NextOf(entry) = next;
        PreviousOf(entry) = -1;
        if (next >= 0)
        {
            PreviousOf(next) = entry;
        }

        _first[body] = entry;
    }

    /// <summary>
    /// Both ways: the frame of the world has an entry of each joint with a fixed point, and those before one would be walked over.
    /// </summary>
    private void Unlink(int body, int entry)
    {
        int next = NextOf(entry);
        int previous = PreviousOf(entry);
        if (previous < 0)
        {
            _first[body] = next;
        }
        else
        {
            NextOf(previous) = next;
        }

        if (next >= 0)
        {
            PreviousOf(next) = previous;
        }
    }

    private ref int NextOf(int entry)
    {
        ref JointLink link = ref Links[entry >> 1];
        return ref (entry & 1) == 0 ? ref link.NextA : ref link.NextB;
    }

    private ref int PreviousOf(int entry)
    {
        ref JointLink link = ref Links[entry >> 1];
        return ref (entry & 1) == 0 ? ref link.PreviousA : ref link.PreviousB;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_first);
        s.Column(_degree);
        s.Column(_ties);
        s.Value(ref _bodies);
        s.Value(ref _order);
        Ids.Visit(s);
        s.Column(Links);
        s.Column(Settings);
        s.Column(Flags);
        s.Column(States);
        s.Column(Ranges);
        Changed = s.Value(Changed);
        Edition = s.Value(Edition);
    }
}
