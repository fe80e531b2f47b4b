using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Solver;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Solver;

/// <summary>Passes over the rows of some islands alone.</summary>
public sealed unsafe class ContactPassesTests
{
    private const int Pairs = 4000;
    private const int OfFirstIsland = 2500;

    private readonly ConstraintGraph _graph = new ConstraintGraph();
    private readonly BodyStore _bodies = new BodyStore();
    private readonly Column<ContactRecord> _records = new Column<ContactRecord>(Pairs);
    private readonly ContactPasses _passes = new ContactPasses();
    private readonly int[] _islandOfSlot = [0, 1];

    public ContactPassesTests()
    {
        const int Bodies = (2 * Pairs) + 1;
        _bodies.Mass.EnsureCapacity(Bodies);
        _bodies.Size.EnsureCapacity(Bodies);
        _bodies.State.EnsureCapacity(Bodies);
        _graph.EnsureBodies(Bodies);
        _graph.Weigh(_bodies);
        _bodies.State[0] = new BodyState { DeltaCos = 1 };
        for (int i = 0; i < Pairs; i++)
        {
            AddPair(i);
        }

        _passes.Begin(
            new StageRunner(1, null),
            _bodies,
            new ContactCoefficients(1f / 240, 10, 1),
            _graph.Solved,
            _graph.Arena.Capacity,
            areHalves: false);
    }

    [Fact]
    public void RelaxChosen_OfOneIsland_StopsItsBodiesAndLeavesTheRecordsOfTheOther()
    {
        bool some = Choose(0, 1);

        _passes.RelaxChosen();

        Assert.True(some);
        int touched = 0;
        for (int i = 0; i < Pairs; i++)
        {
            bool stops = Approach(i) == 0;
            Assert.True(stops || i < OfFirstIsland, $"pair {i} of the island that was chosen still approaches");
            touched += stops && i < OfFirstIsland ? 1 : 0;
        }

        // Records are relaxed as a whole, so a colour has at most one of which not all rows but one are of the other island.
        Assert.InRange(touched, 0, _graph.Used.Length * (ContactBundle.LineLanes - 1));
        Assert.True(touched < OfFirstIsland);
    }

    [Fact]
    public void Choose_OfMoreThanHalf_IsRefused() => Assert.False(Choose(1, 0));

    [Fact]
    public void RelaxChosen_OfNoIsland_ChangesNothing()
    {
        Assert.True(Choose(0, 0));

        _passes.RelaxChosen();

        for (int i = 0; i < Pairs; i++)
        {
            Assert.Equal(2, Approach(i));
        }
    }

    private bool Choose(byte first, byte second)
    {
        byte* wanted = stackalloc byte[] { first, second };
        fixed (int* islands = _islandOfSlot)
        {
            return _passes.Choose(wanted, islands);
        }
    }

    private float Approach(int pair) =>
        _bodies.State[1 + (2 * pair)].LinearVelocity.X - _bodies.State[2 + (2 * pair)].LinearVelocity.X;

    /// <summary>Two bodies of mass 1 that touch and approach at 2 m/s, those of the first island first.</summary>
    private void AddPair(int pair)
    {
        int a = 1 + (2 * pair);
        int b = a + 1;
        foreach (int body in new[] { a, b })
        {
            _bodies.Size[body].Reach = 1;
            _bodies.Mass[body] = new BodyMass { Mass = 1, Inertia = 1, InverseMass = 1, InverseInertia = 1 };
            _bodies.State[body] = new BodyState { LinearVelocity = new Vector2(body == a ? 1 : -1, 0), DeltaCos = 1 };
        }

        _records[pair] = new ContactRecord { BodyA = a, BodyB = b, PieceA = a, PieceB = b };
        _graph.Add(pair, ref _records[pair], movesA: true, movesB: true);
        ContactBundle* row = _graph.BundleOf(_records[pair].Row);
        int lane = RowArena.LaneOf(_records[pair].Row);
        row->NormalX[lane] = 1;
        row->MassA[lane] = row->MassB[lane] = 1;
        row->InertiaA[lane] = row->InertiaB[lane] = 1;
        row->K11[lane] = row->K22[lane] = 2;
        row->Flags[lane] |= ContactBundle.SingleMark;
        row->Point0.Base[lane] = 0;
        row->Slot[lane] = pair < OfFirstIsland ? 0 : 1;
    }
}
