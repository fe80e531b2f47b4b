using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Chains;
using Farseer.Engine.Joints.Lanes;
using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Nets;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>
/// What all parts of the joint solver work on: the trees, the joints that act, and which of them take part in the present passes.
/// </summary>
internal sealed unsafe class JointWork
{
    private JointStep _step;

    public JointWork(JointStore store)
    {
        Store = store;
        Loops = new TreeLoops(Forest, Active, Rows);
        Nets = new NetSolver(store);
        Chains = new ChainSolver(new ChainWork(store));
    }

    /// <summary>The joints that act, in their order.</summary>
    public Column<ActiveJoint> Active { get; } = new Column<ActiveJoint>();

    /// <summary>Rows to iterate, in their order: a joint, or the complement of a contact.</summary>
    public Column<int> Agenda { get; } = new Column<int>();

    /// <summary>Solves chains of hinges.</summary>
    public ChainSolver Chains { get; }

    /// <summary>Rows of contacts.</summary>
    public TreeContactPass ContactPass { get; } = new TreeContactPass();

    /// <summary>Contacts with bodies of trees.</summary>
    [NotState(Why.OfOneStep)]
    public Column<TreeContact> Contacts { get; } = new Column<TreeContact>();

    /// <summary>The trees.</summary>
    public JointForest Forest { get; } = new JointForest();

    /// <summary>Active joints of the present passes.</summary>
    public Column<int> Joints { get; } = new Column<int>();

    /// <summary>Writes the rows of each kind.</summary>
    public JointKinds Kinds { get; } = new JointKinds();

    /// <summary>Solves trees of equal form.</summary>
    public TreeLanes Lanes { get; } = new TreeLanes(new LaneWork());

    /// <summary>Joints that close loops.</summary>
    public TreeLoops Loops { get; }

    /// <summary>Solves joints between single bodies.</summary>
    public LooseSolver Loose { get; } = new LooseSolver();

    /// <summary>Solves nets of joints.</summary>
    public NetSolver Nets { get; }

    /// <summary>Nodes of the present passes.</summary>
    public Column<int> Nodes { get; } = new Column<int>();

    /// <summary>Rows of joints.</summary>
    public JointPass Pass { get; } = new JointPass();

    /// <summary>The rows of the active joints.</summary>
    public Column<JointRows> Rows { get; } = new Column<JointRows>();

    /// <summary>Sorts joints, and rows to iterate.</summary>
    public RadixSort Sort { get; } = new RadixSort();

    /// <summary>All joints.</summary>
    public JointStore Store { get; }

    /// <summary>Trees of the present passes.</summary>
    public Column<int> Trees { get; } = new Column<int>();

    /// <summary>Of <see cref="Agenda"/>.</summary>
    public int AgendaCount { get; set; }

    /// <summary>The present class has joints with limits.</summary>
    public bool AnyLimits { get; set; }

    /// <summary>A tree is a wheel with its axle.</summary>
    public bool AnyWheels { get; set; }

    /// <summary>Single bodies have rows of wishes that are not solved side by side.</summary>
    public bool AnyWishes { get; set; }

    /// <summary>Joints of the list of which errors and arms are those of the poses, if the nodes are.</summary>
    public int Armed { get; set; }

    /// <summary>The class of islands that the present passes are of.</summary>
    public int Class { get; set; }

    /// <summary>Of <see cref="Contacts"/>.</summary>
    public int ContactCount { get; set; }

    /// <summary>Of <see cref="Active"/>.</summary>
    public int Count { get; set; }

    /// <summary>Substeps of the class in one of the step.</summary>
    public double Fineness { get; set; } = 1;

    /// <summary>Of <see cref="Joints"/>.</summary>
    public int JointCount { get; set; }

    /// <summary>Of <see cref="Nodes"/>.</summary>
    public int NodeCount { get; set; }

    /// <summary>Joints of the present class of which a limit stands aside.</summary>
    public int Overruns { get; set; }

    /// <summary>The poses of the nodes are those of their displacements.</summary>
    public bool Posed { get; set; }

    /// <summary>Rate at which depths are pushed out, 1/s.</summary>
    public double PushRate { get; set; }

    /// <summary>What the joints see of the step.</summary>
    public ref JointStep Step => ref _step;

    /// <summary>Of <see cref="Trees"/>.</summary>
    public int TreeCount { get; set; }

    /// <summary>Contacts of wheels.</summary>
    public int WheelContactCount { get; set; }

    /// <summary>The sweep under way is that of wishes.</summary>
    public bool Wishing { get; set; }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        Posed = s.Value(Posed);
        Armed = s.Value(Armed);
        Chains.Visit(s);
        s.Column(Trees);
        s.Column(Nodes);
        s.Column(Joints);
        TreeCount = s.Value(TreeCount);
        NodeCount = s.Value(NodeCount);
        JointCount = s.Value(JointCount);
        Fineness = s.Value(Fineness);
        Class = s.Value(Class);
        s.Column(Agenda);
        ContactCount = s.Value(ContactCount);
        AgendaCount = s.Value(AgendaCount);
        Forest.Visit(s);
        Loops.Visit(s);
        s.Filled(Active, Count);
        s.Filled(Rows, Count);
        Nets.Visit(s);
        Count = s.Value(Count);
        PushRate = s.Value(PushRate);
        Lanes.Visit(s);
        Loose.Visit(s);
        Overruns = s.Value(Overruns);
        AnyLimits = s.Value(AnyLimits);
        WheelContactCount = s.Value(WheelContactCount);
        AnyWheels = s.Value(AnyWheels);
        AnyWishes = s.Value(AnyWishes);
        Wishing = s.Value(Wishing);
    }
}
