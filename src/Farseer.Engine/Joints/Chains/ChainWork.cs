using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Chains;

/// <summary>What all parts of the solver of chains work on: the chains with their numbers, and what they see of the step.</summary>
internal sealed unsafe class ChainWork : TreesAside
{
    /// <summary>Room before the first column, so that columns are well aligned.</summary>
    public const int Lead = 8;

    private JointStep _step;

    public ChainWork(JointStore store) => Store = store;

    /// <summary>The numbers of all chains: see <see cref="ChainView"/>.</summary>
    public Column<double> Numbers { get; } = new Column<double>();

    /// <summary>The chains.</summary>
    public Column<Chain> Chains { get; } = new Column<Chain>();

    /// <summary>The bodies and joints of the chains, along each.</summary>
    public Column<ChainPlace> Places { get; } = new Column<ChainPlace>();

    /// <summary>Trees given back by the last pass.</summary>
    public Column<int> GivenTrees { get; } = new Column<int>();

    /// <summary>All joints.</summary>
    public JointStore Store { get; }

    /// <summary>The trees.</summary>
    [NotState(Why.Elsewhere)]
    public JointForest Forest { get; set; } = null!;

    /// <summary>The joints that act.</summary>
    public ActiveJoint* Active { get; set; }

    /// <summary>What the joints see of the step.</summary>
    public ref JointStep Step => ref _step;

    /// <summary>Of <see cref="Chains"/>.</summary>
    public int Count { get; set; }

    /// <summary>Chains are solved here in the present passes.</summary>
    public bool Any { get; set; }

    /// <summary>None has been given back in the step.</summary>
    public bool AllStay { get; set; }

    /// <summary>Bodies of the chains that are solved here in the present passes.</summary>
    public int LiveBodies { get; set; }

    /// <summary>Joints of quiet chains in this step.</summary>
    public int QuietJoints { get; set; }

    /// <summary>Chains that contacts press on are solved here in the present passes.</summary>
    public bool AnyPressed { get; set; }

    public override int Given(int index) => GivenTrees[index];

    public override int GivenSoft(int tree, int index) => -1;

    public ChainView ViewOf(Chain* chain) => new ChainView
    {
        First = Numbers.Pointer + chain->First,
        Stride = StrideOf(chain->Bodies),
        Bodies = chain->Bodies,
        Joints = chain->Joints,
        Middle = chain->IsPressed ? chain->Middle : chain->Joints / 2,
        IsPressed = chain->IsPressed,
        Low = chain->Low,
        High = chain->High,
        Arms = chain->Swapped ? ChainColumn.OtherArms : ChainColumn.Arms,
        NewArms = chain->Swapped ? ChainColumn.Arms : ChainColumn.OtherArms,
    };

    public static int RoomOf(int bodies) => ((Lead + ((int)ChainColumn.Count * StrideOf(bodies))) | (Lead - 1)) + 1;

    /// <summary>An odd number of times 32 bytes, so that columns share no places of the cache.</summary>
    public static int StrideOf(int bodies)
    {
        int blocks = ((bodies + DoubleLanes.BundleLanes) / DoubleLanes.BundleLanes) + (ChainView.Margin / DoubleLanes.BundleLanes);
        return (blocks | 1) * DoubleLanes.BundleLanes;
    }

    public static void Clear(double* numbers, int count)
    {
        for (int i = 0; i < count; i += WideDouble.Count)
        {
            WideDouble.Zero.Store(numbers + i);
        }
    }

    public void ClearNumbers(Chain* chain)
    {
        Clear(Numbers.Pointer + chain->First - Lead, RoomOf(chain->Bodies));
        long* exists = (long*)ViewOf(chain)[ChainColumn.Exists];
        for (int i = 0; i < chain->Joints; i++)
        {
            exists[i] = -1;
        }

        chain->Edition = Store.Edition - 1;
        chain->StillAngle = double.NaN;
        chain->FrontAngle = double.NaN;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Local(Numbers);
        s.Column(Chains);
        s.Column(Places);
        s.Column(GivenTrees);
        Count = s.Value(Count);
        Any = s.Value(Any);
        AllStay = s.Value(AllStay);
        LiveBodies = s.Value(LiveBodies);
        QuietJoints = s.Value(QuietJoints);
        AnyPressed = s.Value(AnyPressed);
    }
}
