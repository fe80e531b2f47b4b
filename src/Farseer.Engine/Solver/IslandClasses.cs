using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Numerics;
using Farseer.Engine.Springs;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// Islands (bodies joined by joints or contacts) by how many substeps they need: class k takes 2ᵏ times those of the step. Which
/// class an island belongs to follows from its state alone, from the loads that its trees pass on and the sag of its contacts, unless the
/// user chose for one of its bodies. Islands of class 0 stay where they are; the rows of the others are borrowed from the graph while they
/// are solved, unless all rows are of one class: then they stay, and only count in its substeps meanwhile.
/// </summary>
internal sealed unsafe partial class IslandClasses
{
    public const int Count = JointLoads.MostDoublings + 1;

    /// <summary>In <see cref="_listed"/>: the island of this root has joints.</summary>
    private const byte Jointed = 0x80;

    private readonly Column<int> _parent = new Column<int>();
    private readonly Column<byte> _class = new Column<byte>();
    private readonly Column<byte> _listed = new Column<byte>();
    private readonly Column<byte> _chosen = new Column<byte>();
    [NotState(Why.OfOneStep)]
    private readonly Column<Loan> _loans = new Column<Loan>();
    [NotState(Why.OfOneStep)]
    private readonly Column<int>[] _lists = new Column<int>[Count];
    [NotState(Why.OfOneStep)]
    private readonly int[] _counts = new int[Count];
    [NotState(Why.OfOneStep)]
    private readonly int[] _padded = new int[Count];
    [NotState(Why.OfOneStep)]
    private readonly GraphColor[][] _borrowed = new GraphColor[Count][];

    // Colours for the rows of any class; so many are in use.
    [NotState(Why.Room)]
    private GraphColor[] _pool = Array.Empty<GraphColor>();
    [NotState(Why.OfOneStep)]
    private int _taken;
    [NotState(Why.OfOneStep)]
    private readonly int[] _used = new int[Count];
    [NotState(Why.OfOneStep)]
    private readonly int[] _rowCounts = new int[Count];
    private readonly TieAction _unite;
    private readonly TieAction _handOn;
    private readonly TieAction _addKinematic;
    [NotState(Why.Elsewhere)]
    private ConstraintGraph _graph = null!;
    [NotState(Why.OfOneStep)]
    private int _loanCount;
    private float _substep;
    private bool _adapts;
    private bool _anyChosen;

    /// <summary>The class of all rows, which then are not borrowed; 0: there are several.</summary>
    private int _only;

    private delegate void TieAction(int a, int b, BodyStore bodies, byte* moves);

    public IslandClasses()
    {
        _unite = Unite;
        _handOn = HandOn;
        _addKinematic = AddKinematic;
        for (int i = 0; i < Count; i++)
        {
            _lists[i] = new Column<int>();
            _borrowed[i] = Array.Empty<GraphColor>();
        }
    }

    /// <summary>The rows of a class, by colour in the order of solving, while they are borrowed.</summary>
    public ReadOnlySpan<GraphColor> Colors(int index) => new ReadOnlySpan<GraphColor>(_borrowed[index], 0, _used[index]);

    public int RowCount(int index) => _rowCounts[index];

    public int* List(int index) => _lists[index].Pointer;

    public int BodyCount(int index) => _counts[index];

    /// <summary>Count of <see cref="List"/> filled up to whole bundles with body 0.</summary>
    public int PaddedCount(int index) => _padded[index];

    /// <summary>
    /// Asks for what the user chose and, unless nothing is to adapt by itself, for the loads of trees and the islands that sink too far.
    /// </summary>
    /// <returns>True if an island needs more substeps.</returns>
    public bool Find(
        in IslandClassInput input, bool adapts, FeedForwardSettings feedForward, in ContactCoefficients c, Scratch scratch)
    {
        JointSolver? joints = input.Joints;
        ConstraintGraph graph = input.Graph;
        if (graph.RowCount == 0 && joints == null)
        {
            return false;
        }

        _adapts = adapts;
        _anyChosen = IsAnyChosen(input);
        bool any = _anyChosen;
        any |= adapts && graph.RowCount > 0
            && input.Forecast.Find(input.Islands, feedForward, graph, input.Bodies, input.List, input.Count, c, scratch);
        if (joints != null)
        {
            joints.Loads.ClearLoads();
        }

        if (adapts && joints != null)
        {
            foreach (GraphColor color in graph.Used)
            {
                foreach (ContactBundle* bundle in color.Bundles)
                {
                    joints.Loads.AddLoads(bundle);
                }
            }

            any |= joints.Loads.FindLoads();
        }

        if (!any)
        {
            return false;
        }

        _graph = graph;
        FindIslands(input);
        return true;
    }

    /// <summary>Sorts the bodies of the solver's list into the classes, and the trees with them.</summary>
    public void Split(in IslandClassInput input, SpringStore springs)
    {
        JointSolver? joints = input.Joints;
        BodyStore bodies = input.Bodies;
        byte* moves = input.Moves;
        int* list = input.List;
        int count = input.Count;
        int end = bodies.Ids.End;
        _class.EnsureCapacity(end);
        _listed.EnsureCapacity(end);
        for (int i = 0; i < end; i++)
        {
            _class[i] = 0;
            _listed[i] = 0;
        }

        // A body that cannot move, a kinematic one, is of no island: it stays of class 0, so that a row is of the class of those of its
        // bodies that move.
        for (int i = 0; i < count && joints != null; i++)
        {
            int root = Root(list[i]);
            _class[root] = moves[list[i]] != 0 ? (byte)Math.Max(_class[root], joints.Loads.DoublingsOf(list[i])) : (byte)0;
        }

        MarkJointed(joints);

        // Joints carry loads past the contacts: the sag of their islands is not foreseen.
        for (int i = 0; _adapts && i < count; i++)
        {
            int root = Root(list[i]);
            if ((_listed[root] & Jointed) == 0 && moves[list[i]] != 0 && input.Graph.Degree(list[i]) > 0)
            {
                _class[root] = (byte)Math.Max(_class[root], input.Forecast.DoublingsOf(input.Islands.Of(list[i])));
            }
        }

        if (_anyChosen)
        {
            Choose(input);
        }

        // Springs are fixed for the step's own substep: what they pull at keeps to it, and so do nets.
        for (int i = 0; i < count; i++)
        {
            if (springs.Touches(list[i]) || (joints != null && joints.Nets.Holds(list[i])))
            {
                _class[Root(list[i])] = 0;
            }
        }

        for (int i = 0; i < Count; i++)
        {
            _lists[i].EnsureCapacity(bodies.State.Capacity + WideLanes.BundleLanes);
            _counts[i] = 0;
        }

        for (int i = 0; i < count; i++)
        {
            int index = moves[list[i]] != 0 ? _class[Root(list[i])] : 0;
            if (moves[list[i]] != 0)
            {
                joints?.Loads.SetClass(list[i], index);
            }

            Enlist(list[i], index);
        }

        ForEachTie(_addKinematic, input);
        for (int i = 0; i < Count; i++)
        {
            _padded[i] = _counts[i];
            while (_padded[i] % WideLanes.BundleLanes != 0)
            {
                _lists[i][_padded[i]++] = 0;
            }
        }
    }

    /// <summary>
    /// Kinematic bodies were moved with class 0; for those of this class they start again, and come out at the same place.
    /// </summary>
    public void RewindKinematic(int index, BodyStore bodies, float dt)
    {
        for (int i = 0; i < _counts[index]; i++)
        {
            int body = _lists[index][i];
            if ((bodies.Flags[body] & BodyFlags.Kinematic) != 0)
            {
                bodies.State[body].DeltaPosition = System.Numerics.Vector2.Zero;
                Foresight.Begin(bodies, _lists[index].Pointer + i, 1, dt);
            }
        }
    }

    /// <summary>Takes the rows of the upper classes out of the graph; impulses are those of their own substeps meanwhile.</summary>
    /// <param name="substep">That of class 0, seconds.</param>
    public void Borrow(float substep)
    {
        MakeRoom();
        _substep = substep;
        _loanCount = 0;
        _taken = 0;
        for (int index = 1; index < Count; index++)
        {
            _used[index] = 0;
            _rowCounts[index] = 0;
        }

        _only = FindOnly();
        if (_only > 0)
        {
            Stay();
            return;
        }

        foreach (GraphColor source in _graph.Solved)
        {
            foreach (ContactBundle* bundle in source.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    int index = ClassOf(bundle->BodyA[lane], bundle->BodyB[lane]);
                    if (index > 0)
                    {
                        Lend(source, bundle, lane, index);
                    }
                }
            }
        }
    }

    /// <summary>Gives all rows back.</summary>
    public void GiveBack()
    {
        if (_only > 0)
        {
            ScaleAll(1 << _only);
            return;
        }

        for (int i = 0; i < _loanCount; i++)
        {
            ref Loan loan = ref _loans[i];
            ContactBundle* bundle = _graph.BundleOf(loan.Place);
            int lane = RowArena.LaneOf(loan.Place);
            ContactLanes.Scale(bundle, lane, 1 << loan.Class);
            ContactLanes.MoveLane(bundle, lane, loan.Home, loan.Lane);
        }

        for (int index = 1; index < Count; index++)
        {
            for (int i = 0; i < _used[index]; i++)
            {
                _borrowed[index][i].Clear();
            }
        }
    }

    private void Lend(GraphColor source, ContactBundle* bundle, int lane, int index)
    {
        GraphColor? target = _used[index] > 0 ? _borrowed[index][_used[index] - 1] : null;
        if (target == null || target.Place != source.Place)
        {
            target = _pool[_taken++];
            target.Follow(source);
            AddColor(index, target);
        }

        float share = 1f / (1 << index);
        int place = target.AddRow();
        ContactBundle* copy = _graph.BundleOf(place);
        int to = RowArena.LaneOf(place);
        ContactLanes.MoveLane(bundle, lane, copy, to);
        ContactLanes.Mute(bundle, lane);
        ContactLanes.Scale(copy, to, share);

        ShortenPace(copy, to, share);
        _rowCounts[index]++;
        _loans[_loanCount++] = new Loan { Home = bundle, Lane = lane, Class = index, Place = place };
    }

    /// <summary>
    /// A pace is slow against the slowest mode, and a stiffer island has faster modes; that of trees is not known so well.
    /// </summary>
    private void ShortenPace(ContactBundle* bundle, int lane, float share)
    {
        bool jointed = ((_listed[Root(bundle->BodyA[lane])] | _listed[Root(bundle->BodyB[lane])]) & Jointed) != 0;
        float fastest = _substep * share / FeedForwardSettings.ShortestTime;
        bundle->FeedRate[lane] = jointed ? bundle->FeedRate[lane] * share : Math.Min(bundle->FeedRate[lane], fastest);
    }

    private void MarkJointed(JointSolver? joints)
    {
        for (int i = 0; joints != null && i < joints.Loads.Count; i++)
        {
            joints.Loads.GetBodies(i, out int a, out int b);
            _listed[Root(a)] |= Jointed;
            _listed[Root(b)] |= Jointed;
        }
    }

    private void FindIslands(in IslandClassInput input)
    {
        int bodyEnd = input.Bodies.Ids.End;
        _parent.EnsureCapacity(bodyEnd);
        for (int i = 0; i < bodyEnd; i++)
        {
            _parent[i] = i;
        }

        ForEachTie(_unite, input);
    }

    /// <summary>Calls it with the two bodies of each joint and of each row.</summary>
    private static void ForEachTie(TieAction act, in IslandClassInput input)
    {
        JointSolver? joints = input.Joints;
        for (int i = 0; joints != null && i < joints.Loads.Count; i++)
        {
            joints.Loads.GetBodies(i, out int a, out int b);
            act(a, b, input.Bodies, input.Moves);
        }

        foreach (GraphColor color in input.Graph.Solved)
        {
            foreach (ContactBundle* bundle in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    act(bundle->BodyA[lane], bundle->BodyB[lane], input.Bodies, input.Moves);
                }
            }
        }
    }

    private void Unite(int a, int b, BodyStore bodies, byte* moves)
    {
        if (moves[a] != 0 && moves[b] != 0)
        {
            a = Root(a);
            b = Root(b);
            _parent[Math.Max(a, b)] = Math.Min(a, b);
        }
    }

    // Parents have lower numbers.
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

    // A body that cannot move is its own island of class 0.
    private int ClassOf(int a, int b) => Math.Max(_class[Root(a)], _class[Root(b)]);

    private void AddKinematic(int a, int b, BodyStore bodies, byte* moves)
    {
        int index = ClassOf(a, b);
        int still = moves[a] == 0 ? a : moves[b] == 0 ? b : -1;
        if (index > 0 && still >= 0 && (bodies.Flags[still] & BodyFlags.Kinematic) != 0 && (_listed[still] & (1 << index)) == 0)
        {
            _listed[still] |= (byte)(1 << index);
            Enlist(still, index);
        }
    }

    private void Enlist(int body, int index)
    {
        _lists[index].EnsureCapacity(_counts[index] + 1 + WideLanes.BundleLanes);
        _lists[index][_counts[index]++] = body;
    }

    /// <summary>
    /// Room for all that may be lent, once anything is: which islands need how many substeps, and which colours their rows have, differs
    /// from step to step. Each colour that is lent has a row.
    /// </summary>
    private void MakeRoom()
    {
        for (int index = 1; index < Count && _borrowed[index].Length < _graph.ColorRoom; index++)
        {
            _borrowed[index] = new GraphColor[_graph.ColorRoom];
        }

        int rows = _graph.RowCount;
        _loans.EnsureCapacity(rows);
        int colors = Math.Min(rows, _graph.ColorRoom * (Count - 1));
        if (_pool.Length < colors)
        {
            int made = _pool.Length;
            Array.Resize(ref _pool, Math.Min(Math.Max(colors, 2 * made), _graph.ColorRoom * (Count - 1)));
            for (; made < _pool.Length; made++)
            {
                _pool[made] = new GraphColor(_graph.Arena);
            }
        }
    }

    private void AddColor(int index, GraphColor color) => _borrowed[index][_used[index]++] = color;

    private struct Loan
    {
        public ContactBundle* Home;
        public int Lane;
        public int Class;

        /// <summary>Its row in the class's copy.</summary>
        public int Place;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_parent);
        s.Column(_class);
        s.Column(_listed);
        s.Column(_chosen);
        s.Value(ref _substep);
        s.Value(ref _adapts);
        s.Value(ref _anyChosen);
        s.Value(ref _only);
    }
}
