using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Nets;

/// <summary>
/// Which bodies belong to a net: a component of bodies tied by hard rows with so many loops that the walks between the ends of its
/// loops would cost more than they gain. Those are left to the iteration; all others become trees.
/// </summary>
internal sealed unsafe class NetSearch
{
    /// <summary>A component is a net if it has more loops than this and more than one for each <see cref="NetShare"/> bodies.</summary>
    private const int FewLoops = 4;
    private const int NetShare = 8;

    private readonly Column<int> _parent = new Column<int>();
    private readonly Column<int> _bodies = new Column<int>();
    private readonly Column<int> _edges = new Column<int>();
    private readonly Column<byte> _marks = new Column<byte>();
    private readonly Column<byte> _anchored = new Column<byte>();
    private int _end;

    /// <summary>A body of a net was found.</summary>
    public bool Any { get; private set; }

    public bool IsNet(int body) => body < _end && _marks[body] != 0;

    /// <summary>The body that stands for a body's net.</summary>
    public int RootOf(int body) => _parent[body];

    /// <summary>A joint ties the body's net to something that cannot move.</summary>
    public bool IsAnchored(int body) => _anchored[_parent[body]] != 0;

    /// <summary>Forgets all ties.</summary>
    public void Begin(int bodyEnd)
    {
        _parent.EnsureCapacity(bodyEnd);
        _bodies.EnsureCapacity(bodyEnd);
        _edges.EnsureCapacity(bodyEnd);
        _marks.EnsureCapacity(bodyEnd);
        _anchored.EnsureCapacity(bodyEnd);
        _end = bodyEnd;
        Any = false;
        for (int i = 0; i < bodyEnd; i++)
        {
            _parent[i] = i;
            _bodies[i] = 1;
            _edges[i] = 0;
            _anchored[i] = 0;
        }
    }

    /// <summary>A joint with hard rows ties two bodies that move.</summary>
    public void Tie(int a, int b)
    {
        a = Root(a);
        b = Root(b);
        int root = a < b ? a : b;
        int other = a < b ? b : a;
        _edges[root]++;
        if (root != other)
        {
            _parent[other] = root;
            _bodies[root] += _bodies[other];
            _edges[root] += _edges[other];
        }
    }

    /// <summary>A joint ties a body that moves to something that cannot.</summary>
    public void Anchor(int body) => _anchored[body] = 1;

    /// <summary>All ties are known.</summary>
    public void End()
    {
        for (int i = 0; i < _end; i++)
        {
            int root = Root(i);
            _parent[i] = root;
            _anchored[root] |= _anchored[i];
            int loops = _edges[root] - (_bodies[root] - 1);
            bool net = loops > FewLoops && loops * NetShare > _bodies[root];
            _marks[i] = net ? (byte)1 : (byte)0;
            Any |= net;
        }
    }

    private int Root(int body)
    {
        int* parent = _parent.Pointer;
        while (parent[body] != body)
        {
            parent[body] = parent[parent[body]];
            body = parent[body];
        }

        return body;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_parent);
        s.Column(_bodies);
        s.Column(_edges);
        s.Column(_marks);
        s.Column(_anchored);
        s.Value(ref _end);
        Any = s.Value(Any);
    }
}
