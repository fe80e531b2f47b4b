using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>
/// Finds islands of many levels that are a little too deep in each of them. What soft contacts take back of an overlap leaves at the rate
/// r, and the passes that forget that speed reach some levels far: of a tower of n levels the top goes off at r·E, with E the sum over the
/// levels. Gravity takes that back within the way E itself if (r·E)² ≤ 2·g·E. What is more is pushed apart as deep islands are, without
/// speed, until half of that is left: 40 boxes that began 2 mm in each other threw the topmost up by 1.1 m.
/// </summary>
internal sealed unsafe class DeepStacks
{
    /// <summary>
    /// Up to so many levels a sweep pushes far enough. Beyond, deep islands remember their pushes (<see cref="Solver.CarriedPushes"/>);
    /// with fewer levels a tower would rise too high.
    /// </summary>
    private const int ManyLevels = 16;

    /// <summary>Times the sag that a load explains.</summary>
    private const float Sags = 3f;

    /// <summary>Of what makes an island deep: from there on it may be left to soft contacts.</summary>
    private const float Leaves = 0.5f;

    /// <summary>By body: its island was deep in the step before.</summary>
    private readonly Column<byte> _wereDeep = new Column<byte>();
    private int _bodies;
    private bool _wereAny;

    /// <summary>Makes such islands deep.</summary>
    /// <param name="islands">The islands.</param>
    /// <param name="graph">The rows.</param>
    /// <param name="c">The substep.</param>
    /// <param name="cold">Most contacts are new: only then, and after they were deep, islands are looked at.</param>
    /// <param name="scratch">Where to work.</param>
    /// <param name="deep">By island: above 0 if it is deep.</param>
    /// <param name="anyDeep">Some island is.</param>
    /// <returns>The same afterwards.</returns>
    public bool Find(
        IslandStore islands, ConstraintGraph graph, in ContactCoefficients c, bool cold, Scratch scratch, float* deep, bool anyDeep)
    {
        bool looks = c.Gravity > 0 && (cold || _wereAny);
        if (looks)
        {
            Judge(islands, graph, c, cold, scratch, deep);
        }

        if (looks || anyDeep)
        {
            Remember(islands, deep);
        }

        return anyDeep || _wereAny;
    }

    /// <summary>An island of so many levels.</summary>
    public static bool IsHigh(IslandStore islands, int island) => islands.FirstSlot[island + 1] - islands.FirstSlot[island] > ManyLevels;

    /// <summary>How far the surfaces of a point are apart before anything has moved in this step, plus the depth of rest.</summary>
    public static float Separation(ContactPointLanes* point, int lane) =>
        point->Base[lane] + (point->NormalArmB[lane] - point->NormalArmA[lane]);

    /// <summary>Room for so many bodies.</summary>
    public void Reserve(int bodyEnd) => _wereDeep.EnsureCapacity(bodyEnd);

    private void Judge(IslandStore islands, ConstraintGraph graph, in ContactCoefficients c, bool cold, Scratch scratch, float* deep)
    {
        int mark = scratch.Mark;
        float* least = scratch.Take<float>(Math.Max(1, islands.SlotCount));
        for (int i = 0; i < islands.SlotCount; i++)
        {
            least[i] = float.MaxValue;
        }

        byte* were = scratch.Take<byte>(Math.Max(1, islands.Count));
        FindWere(islands, were);
        float* excess = stackalloc float[ContactBundle.Lanes];
        foreach (GraphColor color in graph.Used)
        {
            foreach (ContactBundle* row in color.Bundles)
            {
                Collect(row, c, excess, least);
            }
        }

        float most = 2 * c.Gravity / (c.BiasRate * c.BiasRate);
        for (int i = 0; i < islands.Count; i++)
        {
            if (deep[i] > 0 || !(cold || were[i] != 0))
            {
                continue;
            }

            float sum = 0;
            for (int slot = islands.FirstSlot[i]; slot < islands.FirstSlot[i + 1]; slot++)
            {
                sum += least[slot] == float.MaxValue ? 0 : least[slot];
            }

            deep[i] = sum > (were[i] != 0 ? Leaves * most : most) ? 1 : 0;
        }

        scratch.Release(mark);
    }

    /// <summary>The least excess of the rows of each level that touch: one that is not too deep holds its level.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    private static void Collect(ContactBundle* row, in ContactCoefficients c, float* excess, float* least)
    {
        ContactBundle.AskAhead(row->Point0.NormalArmA);
        ContactBundle.AskAhead(row->Point0.NormalArmB);
        ContactBundle.AskAhead(row->Point0.Base);
        ContactBundle.AskAhead(row->Point1.Base);
        ContactBundle.AskAhead(row->K11);
        ContactBundle.AskAhead(row->Slot);
        int below = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            Wide separation = Wide.Min(SeparationOf(&row->Point0, lane), SeparationOf(&row->Point1, lane));
            Wide load = Wide.Max(
                Wide.Load(row->Point0.Normal + lane) * Wide.Load(row->K11 + lane),
                Wide.Load(row->Point1.Normal + lane) * Wide.Load(row->K22 + lane));
            Wide sunk = Wide.Max((Wide.Zero - separation) - (Wide.Splat(Sags) * WideCoefficients.Sag(c, load)), Wide.Zero);

            // An empty lane has no point.
            WideMask apart = (separation - ContactBundle.RestDepth(row, lane)) > Wide.Zero;
            sunk = Wide.Select(apart, Wide.Splat(float.MaxValue), sunk);
            sunk.Store(excess + lane);
            below |= WideLanes.Bits(sunk < WideTable.Read(least, row->Slot + lane)) << lane;
        }

        for (int lane = 0; below != 0; lane++, below >>= 1)
        {
            // Lanes of the same level may all be below what it was.
            int slot = row->Slot[lane];
            if ((below & 1) != 0 && excess[lane] < least[slot])
            {
                least[slot] = excess[lane];
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide SeparationOf(ContactPointLanes* point, int lane) => Wide.Load(point->Base + lane)
        + (Wide.Load(point->NormalArmB + lane) - Wide.Load(point->NormalArmA + lane));

    private void FindWere(IslandStore islands, byte* were)
    {
        for (int i = 0; i < islands.Count; i++)
        {
            were[i] = 0;
        }

        int end = _wereAny ? Math.Min(_bodies, islands.BodyEnd) : 0;
        for (int body = 0; body < end; body++)
        {
            int island = islands.Of(body);
            if (_wereDeep[body] != 0 && island >= 0 && island < islands.Count)
            {
                were[island] = 1;
            }
        }
    }

    private void Remember(IslandStore islands, float* deep)
    {
        _bodies = islands.BodyEnd;
        Reserve(_bodies);
        _wereAny = false;
        for (int body = 0; body < _bodies; body++)
        {
            int island = islands.Of(body);
            bool isDeep = island >= 0 && island < islands.Count && deep[island] > 0;
            _wereDeep[body] = isDeep ? (byte)1 : (byte)0;
            _wereAny |= isDeep;
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_wereDeep);
        s.Value(ref _bodies);
        s.Value(ref _wereAny);
    }
}
