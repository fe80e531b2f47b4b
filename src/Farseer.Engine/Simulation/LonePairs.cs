using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Continuous;
using Farseer.Engine.Graph;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Fast pairs of bodies that can both move and that nothing else holds. Their rows are set aside while the others are solved: the two
/// fly free, and are then followed through their impacts by <see cref="PairFlight"/>. Listeners have heard of them as of any row by then,
/// and a handler that refused the contact has taken the row away.
/// </summary>
internal sealed unsafe class LonePairs
{
    /// <summary>Share of their extent by which the two may overlap as the step begins.</summary>
    private const double CoreShare = 0.25;

    /// <summary>Pairs that there is room for from the start, if there are so many bodies: a pair takes two for itself.</summary>
    private const int FewPairs = 64;

    private readonly IndexList _candidates = new IndexList();
    private readonly Column<LonePair> _pairs = new Column<LonePair>();

    public int Count { get; private set; }

    public ref LonePair this[int position] => ref _pairs[position];

    /// <param name="bodies">Bodies that there are: there are seldom more fast pairs.</param>
    public void Begin(int bodies)
    {
        _candidates.Reserve(bodies);
        _pairs.EnsureCapacity(Math.Min(bodies / 2, FewPairs));
        _candidates.Clear();
        Count = 0;
    }

    /// <summary>A fast pair has a row in this step.</summary>
    public void Offer(int contact) => _candidates.Add(contact);

    /// <summary>Takes the rows of the candidates whose bodies have no other hold out of the graph.</summary>
    public void SetAside(WorldStores stores, ContactStore contacts, ConstraintGraph graph, byte* moves)
    {
        for (int i = 0; i < _candidates.Count; i++)
        {
            int contact = _candidates[i];
            ref ContactRecord record = ref contacts.Records[contact];
            if (record.PieceA < 0 || record.Color < 0 || record.Color >= ConstraintGraph.ColorCount
                || graph.Degree(record.BodyA) != 1 || graph.Degree(record.BodyB) != 1
                || !IsLone(stores, record.BodyA, moves) || !IsLone(stores, record.BodyB, moves)
                || !Describe(stores, contact, record, out LonePair pair))
            {
                continue;
            }

            _pairs.EnsureCapacity(Count + 1);
            _pairs[Count++] = pair;
            graph.SetAside(ref record, contacts.Records);
        }

        _candidates.Clear();
    }

    /// <summary>Puts the rows back, as they were.</summary>
    public void PutBack(ContactStore contacts, ConstraintGraph graph)
    {
        // The last one first: it is the last row that was set aside.
        for (int i = Count - 1; i >= 0; i--)
        {
            graph.PutBack(_pairs[i].Contact, ref contacts.Records[_pairs[i].Contact], contacts.Records);
        }
    }

    /// <summary>Writes what a pair gave each other into its row, as of a blow, for readers.</summary>
    public void Write(int position, ContactStore contacts, ConstraintGraph graph, in PairImpulse given)
    {
        _pairs[position].Tangent = (float)given.Tangent;
        ref ContactRecord record = ref contacts.Records[_pairs[position].Contact];
        if (record.PieceA >= 0 && record.Color >= 0)
        {
            ContactLanes.NoteImpacts(graph.BundleOf(record.Row), RowArena.LaneOf(record.Row), (float)given.Normal);
        }
    }

    /// <summary>What a pair of the last step gave each other along the tangent; 0 for any other contact.</summary>
    public float TangentOf(int contact)
    {
        float tangent = 0;
        for (int i = 0; i < Count; i++)
        {
            tangent = _pairs[i].Contact == contact ? _pairs[i].Tangent : tangent;
        }

        return tangent;
    }

    /// <summary>A body of one piece that moves by contacts alone.</summary>
    private static bool IsLone(WorldStores stores, int body, byte* moves)
    {
        int collider = stores.Colliders.First(body);
        return moves[body] != 0
            && (stores.Bodies.Flags[body] & BodyFlags.Discrete) == 0
            && stores.Bodies.Mass[body].InverseMass > 0
            && !stores.IsHeldApart(body)
            && stores.Colliders.Next(collider) < 0
            && stores.Shapes.NextPiece[stores.Shapes.Colliders[collider].FirstPiece] < 0;
    }

    /// <returns>False if they lie in each other: the solver parts them, a flight would not.</returns>
    private static bool Describe(WorldStores stores, int contact, in ContactRecord record, out LonePair pair)
    {
        pair = default;
        pair.Contact = contact;
        pair.A = Start(stores.Bodies, record.BodyA);
        pair.B = Start(stores.Bodies, record.BodyB);
        float extent = FastPairs.Extent(stores.Shapes.Pieces[record.PieceA], stores.Shapes.Pieces[record.PieceB], true, true);
        double tolerance = FastPairs.Tolerance(extent);
        BodyPath a = BodyPath.Resting(stores.Bodies.Pose[record.BodyA]);
        BodyPath b = BodyPath.Resting(stores.Bodies.Pose[record.BodyB]);
        double separation = new TimeOfImpact(stores.Shapes, record.PieceA, a, record.PieceB, b).SeparationAtStart();
        pair.Base = Math.Min(separation, 0);
        pair.Touches = separation <= tolerance;
        return separation >= -CoreShare * extent;
    }

    private static FastMotion Start(BodyStore bodies, int body)
    {
        BodyPose pose = bodies.Pose[body];
        BodyState state = bodies.State[body];
        return new FastMotion
        {
            X = pose.X,
            Y = pose.Y,
            Angle = pose.Angle,
            VelocityX = state.LinearVelocity.X,
            VelocityY = state.LinearVelocity.Y,
            AngularVelocity = state.AngularVelocity,
            Body = body,
            Free = 1,
        };
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _candidates.Visit(s);
        Count = s.Value(Count);
        s.Column(_pairs, Count);
    }
}
