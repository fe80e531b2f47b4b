using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;

namespace Farseer.Engine.Contacts;

/// <summary>
/// Pairs of which a body moves by more than its own size in the step. Where they are at its start says little of where they will
/// meet: a row made from that lets a corner deflect a body that would miss it. Only pairs that touch already keep such a row; for
/// the others the impact is looked for along the way.
/// </summary>
internal static unsafe class FastPairs
{
    /// <summary>
    /// A shape that is not round and turns by more than this in a step, radians, meets its neighbour now with one corner, now
    /// with another: it has no lasting contact.
    /// </summary>
    private const float LargestTurn = 0.5f;

    /// <summary>Share of the extent that a circle's centre may be off its body's: beyond, it is not round as it turns.</summary>
    private const float RoundShare = 0.05f;

    /// <summary>
    /// Share of the smaller extent by which a fast pair may overlap on its way without an impact, and by which a piece may stand higher
    /// than the one beside it and is run over. Nothing but a size: whatever depth bodies rest at, what is thin or small is met.
    /// </summary>
    private const float GlanceShare = 0.01f;

    /// <summary>Share of the extent to which a time of impact is found.</summary>
    private const float ToleranceShare = 1e-3f;

    /// <summary>
    /// Share of the extent up to which surfaces that touched count as touching: what met within the tolerance of an impact stays in touch,
    /// and the tremor after it is not a row of separations.
    /// </summary>
    public const float TouchShare = 2 * ToleranceShare;

    /// <summary>
    /// Share of a way up to which a search looks beyond the time of an impact that is known already: the way of what is fast is longer than
    /// its extent, and this much of it longer than the tolerance.
    /// </summary>
    public const double MomentShare = ToleranceShare;

    /// <summary>Looks where the pairs go in the step, and gives those with a fast body other margins.</summary>
    public static SweepBits Look(in ContactUpdateInput input)
    {
        float pull = (Math.Abs(input.Settings.Gravity.X) + Math.Abs(input.Settings.Gravity.Y)) * input.Dt;
        return WideSweep.Look(input.Pairs, input.Dt, pull, PairStage.SkinShare);
    }

    /// <summary>Takes the points of the fast lanes that have no lasting contact, and says which of them to look after.</summary>
    /// <param name="input">Columns and numbers of this step.</param>
    /// <param name="row">Names the pairs.</param>
    /// <param name="lanes">Those to look at.</param>
    /// <param name="sweep">Where they go.</param>
    /// <param name="touch">Which touch.</param>
    /// <param name="racing">Those that keep their points though one body moves fast past the other; both can move.</param>
    public static int Defer(
        in ContactUpdateInput input, ContactBundle* row, int lanes, in SweepBits sweep, ref TouchBits touch, out int racing)
    {
        int deferred = 0;
        racing = 0;
        PairLanes* pairs = input.Pairs;
        lanes &= sweep.Fast;
        for (int lane = 0; lanes != 0; lane++, lanes >>= 1)
        {
            if ((lanes & 1) == 0)
            {
                continue;
            }

            int bit = 1 << lane;
            bool bothMove = (sweep.BothMove & bit) != 0;
            bool discrete = !input.Settings.Continuous
                || (IsDiscrete(input.Bodies, row->BodyA[lane]) && IsDiscrete(input.Bodies, row->BodyB[lane]));
            float deepest = Deepest(pairs, lane);
            float size = Math.Min(pairs->A.Extent[lane], pairs->B.Extent[lane]);

            // Of two that tumble in each other, each needs to be held by the other; one alone goes on to the sweep.
            bool tumbles = Tumbles(input, row->BodyA[lane], &pairs->A, lane) || Tumbles(input, row->BodyB[lane], &pairs->B, lane);
            if (deepest <= PairStage.SkinShare * size && (discrete || (bothMove && deepest < 0) || !tumbles))
            {
                racing |= bothMove && !discrete ? bit : 0;
                continue;
            }

            touch.Touching &= ~bit;
            touch.Hit &= ~bit;
            touch.Same &= ~bit;
            deferred |= discrete ? 0 : bit & sweep.Meets;
        }

        return deferred;
    }

    /// <summary>The extent by which a pair is measured on its way.</summary>
    public static float Extent(in Shapes.Piece a, in Shapes.Piece b, bool movesA, bool movesB) =>
        Extent(a.Extent, b.Extent, movesA, movesB);

    /// <summary>The same of the extents of its pieces: that of the one that moves, the smaller one if both do.</summary>
    public static float Extent(float a, float b, bool movesA, bool movesB) => !movesA ? b : !movesB ? a : Math.Min(a, b);

    public static double Tolerance(float extent) => (double)ToleranceShare * extent;

    /// <summary>
    /// How deep two pieces may overlap on their way without an impact, and how much higher a piece may stand than the one before it to be
    /// run over.
    /// </summary>
    public static float Glance(in Shapes.Piece a, in Shapes.Piece b) => GlanceShare * (a.Extent < b.Extent ? a.Extent : b.Extent);

    public static bool IsTied(in ContactUpdateInput input, int body) => (input.Bodies.Flags[body] & BodyFlags.Tied) != 0;

    /// <summary>The solver does not move it fast, or it is not to be looked after.</summary>
    private static bool IsDiscrete(BodyStore bodies, int body) =>
        (bodies.Flags[body] & (BodyFlags.Fast | BodyFlags.Discrete)) != BodyFlags.Fast;

    /// <summary>The least separation of the points; the largest number if there are none.</summary>
    private static float Deepest(PairLanes* pairs, int lane)
    {
        float first = pairs->Count[lane] > 0 ? pairs->Point0.Separation[lane] : float.MaxValue;
        return pairs->Count[lane] > 1 ? Math.Min(first, pairs->Point1.Separation[lane]) : first;
    }

    /// <summary>
    /// It has no lasting contact. A limb has: its joint may stop its turn within the step, and the sweep would stop it alone, away from its
    /// hinge.
    /// </summary>
    private static bool Tumbles(in ContactUpdateInput input, int body, SideLanes* side, int lane)
    {
        float turn = side->AngularVelocity[lane] * input.Dt;
        if ((side->Flags[lane] & (int)SideFlags.Turns) == 0 || (turn <= LargestTurn && turn >= -LargestTurn)
            || IsTied(input, body))
        {
            return false;
        }

        // The first half side of what is no box is its rounding radius.
        float radius = (side->Flags[lane] & (int)SideFlags.Box) != 0 ? 0 : side->HalfX[lane];
        return side->Reach[lane] - radius > RoundShare * side->Extent[lane];
    }
}
