using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>What all parts of the solver of trees on lanes work on: the bundles, and what they see of the step.</summary>
internal sealed unsafe class LaneWork : TreesAside
{
    private JointStep _step;

    /// <summary>The bodies of all bundles.</summary>
    public Column<LaneNode> Nodes { get; } = new Column<LaneNode>();

    /// <summary>What is the same on all lanes, of each of <see cref="Nodes"/>.</summary>
    public Column<LanePlace> Places { get; } = new Column<LanePlace>();

    /// <summary>The anchors of all bundles.</summary>
    public Column<LaneAnchor> Anchors { get; } = new Column<LaneAnchor>();

    /// <summary>What is the same on all lanes, of each of <see cref="Anchors"/>.</summary>
    public Column<LanePlace> AnchorPlaces { get; } = new Column<LanePlace>();

    /// <summary>The trees that are solved side by side.</summary>
    public Column<LaneTrees> Bundles { get; } = new Column<LaneTrees>();

    /// <summary>Trees given back by the last pass.</summary>
    public Column<int> GivenTrees { get; } = new Column<int>();

    /// <summary>The bundles of <see cref="GivenTrees"/>.</summary>
    public Column<int> GivenFrom { get; } = new Column<int>();

    /// <summary>Motors and springs of all bundles.</summary>
    public Column<LaneSoft> Softs { get; } = new Column<LaneSoft>();

    /// <summary>What is the same on all lanes, of each of <see cref="Softs"/>.</summary>
    public Column<LaneSoftPlace> SoftPlaces { get; } = new Column<LaneSoftPlace>();

    /// <summary>What sweeps need of <see cref="Nodes"/>.</summary>
    public Column<LaneWalk> Walks { get; } = new Column<LaneWalk>();

    /// <summary>The trees.</summary>
    [NotState(Why.Elsewhere)]
    public JointForest Forest { get; set; } = null!;

    /// <summary>The joints that act.</summary>
    public ActiveJoint* Active { get; set; }

    /// <summary>The rows of <see cref="Active"/>.</summary>
    public JointRows* Rows { get; set; }

    /// <summary>What the joints see of the step.</summary>
    public ref JointStep Step => ref _step;

    /// <summary>Of <see cref="Bundles"/>.</summary>
    public int Count { get; set; }

    /// <summary>Of <see cref="Nodes"/>.</summary>
    public int NodeCount { get; set; }

    /// <summary>Of <see cref="Anchors"/>.</summary>
    public int AnchorCount { get; set; }

    public override int Given(int index) => GivenTrees[index];

    public override int GivenSoft(int tree, int index)
    {
        LaneTrees* trees = Bundles.Pointer + GivenFrom[tree];
        int lane = 0;
        while (lane < trees->Count - 1 && trees->Tree[lane] != GivenTrees[tree])
        {
            lane++;
        }

        return trees->SweepsSofts && index < trees->Softs ? ActiveOf(trees, SoftPlaces.Pointer + trees->SoftFirst + index, lane) : -1;
    }

    public LaneBundle BundleOf(LaneTrees* trees) => new LaneBundle
    {
        Nodes = Nodes.Pointer + trees->First,
        Places = Places.Pointer + trees->First,
        Count = trees->Nodes,
        Anchors = Anchors.Pointer + trees->AnchorFirst,
        AnchorPlaces = AnchorPlaces.Pointer + trees->AnchorFirst,
        AnchorCount = trees->Anchors,
    };

    public LaneWalks WalksOf(LaneTrees* trees, int lane)
    {
        LaneWalks walks = default;
        walks.Nodes = DoubleLanes.Shift(Nodes.Pointer + trees->First, lane);
        walks.Walks = DoubleLanes.Shift(Walks.Pointer + trees->First, lane);
        walks.Places = Places.Pointer + trees->First;
        walks.Anchors = DoubleLanes.Shift(Anchors.Pointer + trees->AnchorFirst, lane);
        walks.AnchorPlaces = AnchorPlaces.Pointer + trees->AnchorFirst;
        walks.Count = trees->Nodes;
        walks.AnchorCount = trees->Anchors;
        return walks;
    }

    public LaneWalk* WalksOrNone(LaneTrees* trees) => trees->HasRows ? Walks.Pointer + trees->First : null;

    public int ActiveOf(LaneTrees* trees, LaneSoftPlace* soft, int lane) => soft->Joint >= 0
        ? Places[trees->First + soft->Joint].Active[lane]
        : AnchorPlaces[trees->AnchorFirst + ~soft->Joint].Active[lane];

    public static bool IsLive(LaneTrees* trees, int lane) => (trees->Live & (1 << lane)) != 0;

    public static bool IsTouched(LaneTrees* trees) => trees->Touched && trees->Live != 0;

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(Nodes);
        s.Column(Places);
        s.Column(Anchors);
        s.Column(AnchorPlaces);
        s.Column(Bundles);
        s.Column(GivenTrees);
        s.Column(GivenFrom);
        Count = s.Value(Count);
        NodeCount = s.Value(NodeCount);
        AnchorCount = s.Value(AnchorCount);
        s.Column(Softs);
        s.Column(SoftPlaces);
        s.Column(Walks);
    }
}
