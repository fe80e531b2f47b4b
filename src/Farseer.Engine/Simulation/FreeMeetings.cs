using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Continuous;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Where free bodies meet. A row is made from where two pieces are when the step begins; by the time they meet, another corner or side may
/// be the nearest, and the row's normal that of neither: a box that came at another's corner while both turned was thrown aside, and lost
/// up to a quarter of its energy against Newton's rule. A body of which all contacts are still open flies by a known law, so its rows are
/// made again where its ways lead: with the normal and the arms of the impact.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class FreeMeetings : IStageWork
{
    /// <summary>Pairs that are worth another worker's while, some 2 µs.</summary>
    private const int LeastPairs = 4;

    /// <summary>Of the tolerance of other times of impact: the moment is the row's, and what is off turns into energy.</summary>
    private const double ToleranceShare = 0.01;

    private ScratchList<Pair> _pairs;

    /// <summary>By body: how many of its rows are open.</summary>
    private readonly Column<int> _open = new Column<int>();
    private ForeseenImpact* _found;
    private byte* _meets;
    private ContactUpdateInput _input;
    private ConstraintGraph _graph = null!;
    private JointStore _joints = null!;
    private ContactBundle* _bundle;

    /// <param name="bodies">There is room for so many.</param>
    /// <param name="scratch">Where pairs are listed.</param>
    public void Begin(int bodies, Scratch scratch)
    {
        _open.EnsureCapacity(bodies);
        _pairs = new ScratchList<Pair>(scratch);
        _bundle = &scratch.Lasting<WorkerLanes>(1)->Fast;
    }

    /// <summary>Lets go of the world.</summary>
    public void Forget()
    {
        _input.Forget();
        _graph = null!;
        _joints = null!;
    }

    /// <summary>Notes a pair that is open and may meet in this step.</summary>
    public void Note(ContactStore contacts, int contact)
    {
        ref ContactRecord record = ref contacts.Records[contact];
        _pairs.Add(new Pair { Contact = contact, BodyA = record.BodyA, BodyB = record.BodyB });
    }

    /// <summary>Looks along the ways of those that are free.</summary>
    public void Find(StageRunner runner, in ContactUpdateInput input, ConstraintGraph graph, JointStore joints)
    {
        if (_pairs.Count == 0)
        {
            return;
        }

        _graph = graph;
        _joints = joints;
        _input = input;
        KeepFree(input);
        if (_pairs.Count > 0)
        {
            _found = input.Scratch.Take<ForeseenImpact>(_pairs.Count);
            _meets = input.Scratch.Take<byte>(_pairs.Count);
            runner.Run(this, _pairs.Count, LeastPairs);
        }
    }

    /// <summary>Makes their rows again, as they are where these ways lead.</summary>
    public void Write(ContactUpdateInput input)
    {
        // They hold no impulses, or those of this step's substeps already.
        input.ImpulseScale = 1;
        for (int i = 0; i < _pairs.Count; i++)
        {
            if (_meets[i] != 0)
            {
                Rewrite(input, input.Contacts.Records[_pairs[i].Contact], _found[i]);
            }
        }
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        for (int i = from; i < to; i++)
        {
            _meets[i] = Foresee(_pairs[i], ref _found[i]) ? (byte)1 : (byte)0;
        }
    }

    /// <summary>Keeps the pairs with a row of which a body is free: it has no other rows than open ones.</summary>
    private void KeepFree(in ContactUpdateInput input)
    {
        for (int i = 0; i < _pairs.Count; i++)
        {
            _open[_pairs[i].BodyA] = 0;
            _open[_pairs[i].BodyB] = 0;
        }

        for (int i = 0; i < _pairs.Count; i++)
        {
            _open[_pairs[i].BodyA]++;
            _open[_pairs[i].BodyB]++;
        }

        int kept = 0;
        for (int i = 0; i < _pairs.Count; i++)
        {
            Pair pair = _pairs[i];
            if ((IsFree(pair.BodyA) || IsFree(pair.BodyB)) && HasOpenRow(input.Contacts.Records[pair.Contact]))
            {
                _pairs[kept++] = pair;
            }
        }

        _pairs.SetCount(kept);
    }

    private bool HasOpenRow(in ContactRecord record)
    {
        if (record.PieceA < 0 || record.Color < 0)
        {
            return false;
        }

        ContactBundle* row = _graph.BundleOf(record.Row);
        int lane = RowArena.LaneOf(record.Row);
        return !(row->Point0.Normal[lane] > 0) && !(row->Point1.Normal[lane] > 0);
    }

    private bool IsFree(int body) => _input.Moves[body] != 0 && _graph.Degree(body) == _open[body] && _joints.Degree(body) == 0;

    /// <summary>
    /// Finds the share of their ways at which two pieces meet; if they do not, they are nearest, or have passed, at the end.
    /// </summary>
    private bool Meet(in ContactRecord record, in BodyPath a, in BodyPath b, double tolerance, ref double time)
    {
        if (ClearWay.HoldsForEither(_input.Shapes, record, a, b, 0))
        {
            return false;
        }

        ImpactQuery query;
        query.Tolerance = tolerance;
        query.Target = 0;
        query.From = 0;
        query.Until = 1;
        var search = new TimeOfImpact(_input.Shapes, record.PieceA, a, record.PieceB, b);
        bool meets = search.Find(query, out double found, out _);
        time = meets ? found : 1;
        return meets;
    }

    /// <summary>The way of a body is known to the end of the step.</summary>
    private bool IsKnown(int body) => _input.Moves[body] == 0 || IsFree(body);

    private bool Foresee(in Pair noted, ref ForeseenImpact found)
    {
        ref ContactRecord record = ref _input.Contacts.Records[noted.Contact];
        BodyPath a = WaysAhead.Path(_input, record.BodyA, IsFree(record.BodyA));
        BodyPath b = WaysAhead.Path(_input, record.BodyB, IsFree(record.BodyB));
        ref Piece pieceA = ref _input.Shapes.Pieces[record.PieceA];
        ref Piece pieceB = ref _input.Shapes.Pieces[record.PieceB];
        float extent = FastPairs.Extent(pieceA, pieceB, _input.Moves[record.BodyA] != 0, _input.Moves[record.BodyB] != 0);
        double time = 1;
        double tolerance = ToleranceShare * FastPairs.Tolerance(extent);
        if (!Meet(record, a, b, tolerance, ref time) && !(IsKnown(record.BodyA) && IsKnown(record.BodyB)))
        {
            return false;
        }

        // What else may meet in the rest of the step belongs to it, or, at its end, what may meet if a force drives them on.
        double rest = time < 1 ? 1 - time : 1;
        double motion = Math.Abs(b.VelocityX - a.VelocityX) + Math.Abs(b.VelocityY - a.VelocityY)
            + (Math.Abs(a.Spin) * pieceA.Reach) + (Math.Abs(b.Spin) * pieceB.Reach);
        float margin = (float)((4 * tolerance) + (rest * motion));
        PairInput pair = ImpactPose.Pair(_input.Shapes, record.PieceA, record.PieceB, a, b, time, margin);
        Collision.Collide(pair, out Manifold manifold);
        return manifold.Count > 0
            && !(record.Mover >= 0
                && WaysAhead.IsHidden(_input, noted.Contact, manifold, record.Mover == record.PieceA ? a : b, time))
            && found.Set(manifold, a, b, time, pieceA.Radius, pieceB.Radius);
    }

    private void Rewrite(in ContactUpdateInput input, in ContactRecord record, in ForeseenImpact impact)
    {
        ContactBundle* row = _graph.BundleOf(record.Row);
        int lane = RowArena.LaneOf(record.Row);
        ContactLanes.ClearForWrite(_bundle);
        ContactLanes.MoveLane(row, lane, _bundle, 0);
        ContactUpdate.FillImpact(input, _bundle, impact);
        ContactLanes.MoveLane(_bundle, 0, row, lane);
    }

    private struct Pair
    {
        public int Contact;
        public int BodyA;
        public int BodyB;
    }
}
