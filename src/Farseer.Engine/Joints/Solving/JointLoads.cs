using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>
/// How heavy a load the bodies of a tree pass on, in terms of their own mass, where contacts have a share in it. The depth to which
/// a load sinks grows with that ratio and with h², so the substeps needed grow with its square root.
/// </summary>
internal sealed unsafe class JointLoads : JointPart
{
    /// <summary>Ratio up to which the substeps of the step do.</summary>
    private const double LightLoad = 64;

    /// <summary>
    /// Ratio of the heaviest body to the lightest from which on a tree takes twice the substeps although nothing touches it: a rope that
    /// swings with a weight of a million links opened by 10 %.
    /// </summary>
    private const double HeavyTree = 3e4;

    /// <summary>Doublings of the substeps at most.</summary>
    public const int MostDoublings = 4;

    private readonly Column<TreeLoad> _own = new Column<TreeLoad>();
    private readonly Column<TreeLoad> _below = new Column<TreeLoad>();
    private readonly Column<TreeLoad> _above = new Column<TreeLoad>();
    private readonly Column<TreeLoad> _sum = new Column<TreeLoad>();

    public JointLoads(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>Makes ready to count the contacts at the trees.</summary>
    public void ClearLoads()
    {
        _own.EnsureCapacity(_forest.NodeRoom);
        _below.EnsureCapacity(_forest.NodeRoom);
        _above.EnsureCapacity(_forest.NodeRoom);
        _sum.EnsureCapacity(_forest.NodeRoom);
        for (int i = 0; i < _forest.Count; i++)
        {
            _own[i] = default;
        }

        for (int i = 0; i < _forest.TreeCount; i++)
        {
            _forest.Trees[i].Class = 0;
        }
    }

    /// <summary>Counts the contacts of a colour.</summary>
    public void AddLoads(ContactBundle* bundle)
    {
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            int a = bundle->BodyA[lane];
            int b = bundle->BodyB[lane];
            if (a != b && TreeContacts.Exists(&bundle->Point0, lane))
            {
                AddLoad(a, b);
                AddLoad(b, a);
            }
        }
    }

    /// <summary>How often the substeps must be doubled for the tree of a body that has joints.</summary>
    public int DoublingsOf(int body)
    {
        int node = _forest.NodeOf(body);
        return node < 0 ? 0 : _forest.Trees[_forest.Nodes[node].Tree].Class;
    }

    /// <summary>Finds for every tree how often the substeps must be doubled.</summary>
    /// <returns>True if any needs it.</returns>
    public bool FindLoads()
    {
        bool any = false;
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            JointTree* tree = _forest.Trees + i;
            if (tree->Eliminates)
            {
                tree->Class = Doublings(Ratio(tree));
                any |= tree->Class > 0;
            }
        }

        return any;
    }

    /// <summary>Solves a body's tree in a class of its island's.</summary>
    public void SetClass(int body, int index)
    {
        int node = _forest.NodeOf(body);
        if (node >= 0)
        {
            _forest.Trees[_forest.Nodes[node].Tree].Class = index;
        }
    }

    /// <summary>The bodies of a joint that acts.</summary>
    public void GetBodies(int index, out int bodyA, out int bodyB)
    {
        int joint = index < _work.Count ? _active[index].Joint : _nets.Member(index - _work.Count);
        bodyA = _store.Links[joint].BodyA;
        bodyB = _store.Links[joint].BodyB;
    }

    /// <summary>Joints that act.</summary>
    public int Count => _work.Count + _nets.Count;

    private static int Doublings(double ratio)
    {
        int doublings = 0;
        for (double carried = LightLoad; carried < ratio && doublings < MostDoublings; carried *= 4)
        {
            doublings++;
        }

        return doublings;
    }

    private void AddLoad(int body, int other)
    {
        int node = _forest.NodeOf(body);
        if (node >= 0 && _work.Step.Moves[body] != 0)
        {
            bool held = _work.Step.Moves[other] == 0;
            _own[node].ContactHeld |= held;
            _own[node].ContactMass = Math.Max(_own[node].ContactMass, held ? 0 : _work.Step.Bodies.Mass[other].Mass);
        }
    }

    /// <summary>The heaviest load that a body of the tree passes on, in terms of the body's own mass.</summary>
    private double Ratio(JointTree* tree)
    {
        bool touched = false;
        for (int i = tree->First; i < tree->End; i++)
        {
            touched |= _own[i].ContactHeld || _own[i].ContactMass > 0;
        }

        if (!touched)
        {
            return Contrast(tree) < HeavyTree ? 0 : 2 * LightLoad;
        }

        // Its contacts, its anchors and its subtrees are parts of a body; each two of them are asked.
        double largest = 0;
        for (int i = tree->First; i < tree->End; i++)
        {
            _below[i] = _own[i];
        }

        TreeLoad anchored = default;
        anchored.JointHeld = true;
        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            int node = _forest.Anchors[i].Node;
            largest = Math.Max(largest, TreeLoad.Between(_below[node], anchored) / MassOf(node));
            _below[node].Add(anchored);
            _own[node].Add(anchored);
        }

        for (int i = tree->End - 1; i > tree->First; i--)
        {
            int parent = _forest.Nodes[i].Parent;
            TreeLoad part = Part(i);
            largest = Math.Max(largest, TreeLoad.Between(_below[parent], part) / MassOf(parent));
            _below[parent].Add(part);
        }

        FindRest(tree);
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            largest = Math.Max(largest, TreeLoad.Between(_below[i], _above[i]) / MassOf(i));
        }

        return largest;
    }

    private double Contrast(JointTree* tree)
    {
        double lightest = double.MaxValue;
        double heaviest = 0;
        for (int i = tree->First; i < tree->End; i++)
        {
            double mass = MassOf(i);
            lightest = Math.Min(lightest, mass);
            heaviest = Math.Max(heaviest, mass);
        }

        return heaviest / lightest;
    }

    /// <summary>For each body, what is in the tree apart from its subtree: the parent, the subtrees before and after, the rest.</summary>
    private void FindRest(JointTree* tree)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            _above[i] = default;
            _sum[i] = _own[i];
        }

        for (int i = tree->First + 1; i < tree->End; i++)
        {
            int parent = _forest.Nodes[i].Parent;
            _above[i].Add(_sum[parent]);
            _sum[parent].Add(Part(i));
        }

        for (int i = tree->First; i < tree->End; i++)
        {
            _sum[i] = default;
        }

        for (int i = tree->End - 1; i > tree->First; i--)
        {
            int parent = _forest.Nodes[i].Parent;
            _above[i].Add(_sum[parent]);
            _sum[parent].Add(Part(i));
        }

        for (int i = tree->First + 1; i < tree->End; i++)
        {
            int parent = _forest.Nodes[i].Parent;
            _above[i].Add(_above[parent]);
            _above[i].JointMass = Math.Max(_above[i].JointMass, MassOf(parent));
        }
    }

    /// <summary>A subtree with the body at its top.</summary>
    private TreeLoad Part(int node)
    {
        TreeLoad part = _below[node];
        part.JointMass = Math.Max(part.JointMass, MassOf(node));
        return part;
    }

    private double MassOf(int node)
    {
        ref BodyMass mass = ref _work.Step.Bodies.Mass[_forest.Nodes[node].Body];
        return mass.Mass > 0 ? mass.Mass : double.Epsilon;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_own);
        s.Column(_below);
        s.Column(_above);
        s.Column(_sum);
    }
}
