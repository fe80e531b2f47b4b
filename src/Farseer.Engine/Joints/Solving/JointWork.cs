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
    private int _agendaCount;
    private bool _anyLimits;
    private bool _anyWheels;
    private bool _anyWishes;
    private int _armed;
    private int _class;
    private int _contactCount;
    private int _count;
    private double _fineness = 1;
    private int _jointCount;
    private int _nodeCount;
    private int _overruns;
    private bool _posed;
    private double _pushRate;
    private JointStep _step;
    private int _treeCount;
    private int _wheelContactCount;
    private bool _wishing;

    public JointWork(JointStore store)
    {
        Store = store;
        Loops = new TreeLoops(Forest, Active, Rows);
        Nets = new NetSolver(store);
        Chains = new ChainSolver(store);
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
    public TreeLanes Lanes { get; } = new TreeLanes();

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

    public RadixSort Sort { get; } = new RadixSort();

    /// <summary>All joints.</summary>
    public JointStore Store { get; }

    /// <summary>Trees of the present passes.</summary>
    public Column<int> Trees { get; } = new Column<int>();

    /// <summary>Of <see cref="Agenda"/>.</summary>
    public int AgendaCount
    {
        get => _agendaCount;
        set => _agendaCount = value;
    }

    /// <summary>The present class has joints with limits.</summary>
    public bool AnyLimits
    {
        get => _anyLimits;
        set => _anyLimits = value;
    }

    /// <summary>A tree is a wheel with its axle.</summary>
    public bool AnyWheels
    {
        get => _anyWheels;
        set => _anyWheels = value;
    }

    /// <summary>Single bodies have rows of wishes that are not solved side by side; and these rows are being solved.</summary>
    public bool AnyWishes
    {
        get => _anyWishes;
        set => _anyWishes = value;
    }

    /// <summary>Joints of the list of which errors and arms are those of the poses, if the nodes are.</summary>
    public int Armed
    {
        get => _armed;
        set => _armed = value;
    }

    /// <summary>The class of islands that the present passes are of.</summary>
    public int Class
    {
        get => _class;
        set => _class = value;
    }

    /// <summary>Of <see cref="Contacts"/>.</summary>
    public int ContactCount
    {
        get => _contactCount;
        set => _contactCount = value;
    }

    /// <summary>Of <see cref="Active"/>.</summary>
    public int Count
    {
        get => _count;
        set => _count = value;
    }

    /// <summary>Substeps of the class in one of the step.</summary>
    public double Fineness
    {
        get => _fineness;
        set => _fineness = value;
    }

    /// <summary>Of <see cref="Joints"/>.</summary>
    public int JointCount
    {
        get => _jointCount;
        set => _jointCount = value;
    }

    /// <summary>Of <see cref="Nodes"/>.</summary>
    public int NodeCount
    {
        get => _nodeCount;
        set => _nodeCount = value;
    }

    /// <summary>Joints of the present class of which a limit stands aside.</summary>
    public int Overruns
    {
        get => _overruns;
        set => _overruns = value;
    }

    /// <summary>The poses of the nodes are those of their displacements.</summary>
    public bool Posed
    {
        get => _posed;
        set => _posed = value;
    }

    /// <summary>Rate at which depths are pushed out, 1/s.</summary>
    public double PushRate
    {
        get => _pushRate;
        set => _pushRate = value;
    }

    /// <summary>What the joints see of the step.</summary>
    public ref JointStep Step => ref _step;

    /// <summary>Of <see cref="Trees"/>.</summary>
    public int TreeCount
    {
        get => _treeCount;
        set => _treeCount = value;
    }

    /// <summary>Contacts of wheels.</summary>
    public int WheelContactCount
    {
        get => _wheelContactCount;
        set => _wheelContactCount = value;
    }

    /// <summary>The sweep under way is that of wishes.</summary>
    public bool Wishing
    {
        get => _wishing;
        set => _wishing = value;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Value(ref _posed);
        s.Value(ref _armed);
        Chains.Visit(s);
        s.Column(Trees);
        s.Column(Nodes);
        s.Column(Joints);
        s.Value(ref _treeCount);
        s.Value(ref _nodeCount);
        s.Value(ref _jointCount);
        s.Value(ref _fineness);
        s.Value(ref _class);
        s.Column(Agenda);
        s.Value(ref _contactCount);
        s.Value(ref _agendaCount);
        Forest.Visit(s);
        Loops.Visit(s);
        s.Column(Active);
        s.Column(Rows);
        Nets.Visit(s);
        s.Value(ref _count);
        s.Value(ref _pushRate);
        Lanes.Visit(s);
        Loose.Visit(s);
        s.Value(ref _overruns);
        s.Value(ref _anyLimits);
        s.Value(ref _wheelContactCount);
        s.Value(ref _anyWheels);
        s.Value(ref _anyWishes);
        s.Value(ref _wishing);
    }
}
