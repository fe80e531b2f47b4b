using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>
/// The time constant of the feed-forward of each island, and whether it is deep. The feed-forward acts as an integral term on
/// an oscillator and is stable only if it is slow against the island's slowest mode. With Δ the sum over the levels of the
/// static sag, g/Δ estimates the square of that mode's frequency; τ = 16·√(Δ/g) stood in every scene, below 8 tall stacks
/// swing themselves up.
/// </summary>
internal sealed unsafe class FeedForwardSettings
{
    private const float TimeFactor = 16f;
    private const float ShortestTime = 0.05f;
    private const float LongestTime = 20f;

    private readonly Column<float> _rate = new Column<float>();
    private readonly Column<float> _deep = new Column<float>();

    /// <summary>Writes rate and deepness into every row.</summary>
    /// <returns>True if any island is deep.</returns>
    public bool Apply(IslandStore islands, ConstraintGraph graph, in ContactCoefficients c)
    {
        CollectSag(islands, graph, c);
        _rate.EnsureCapacity(islands.Count);
        for (int i = 0; i < islands.Count; i++)
        {
            float sag = 0;
            for (int slot = islands.FirstSlot[i]; slot < islands.FirstSlot[i + 1]; slot++)
            {
                sag += islands.SlotSag[slot];
            }

            float time = LongestTime;
            if (c.Gravity > 0)
            {
                time = TimeFactor * (float)Math.Sqrt(sag / c.Gravity);
                time = time < ShortestTime ? ShortestTime : time > LongestTime ? LongestTime : time;
            }

            _rate[i] = Math.Min(1f, c.Substep / time);
        }

        return WriteRows(graph);
    }

    private void CollectSag(IslandStore islands, ConstraintGraph graph, in ContactCoefficients c)
    {
        float* slotSag = islands.SlotSag;
        for (int i = 0; i < islands.SlotCount; i++)
        {
            slotSag[i] = 0;
        }

        _deep.EnsureCapacity(Math.Max(islands.Count, 1));
        for (int i = 0; i < islands.Count; i++)
        {
            _deep[i] = 0;
        }

        for (int k = 0; k < ConstraintGraph.ColorCount; k++)
        {
            GraphColor color = graph[k];
            for (int r = 0; r < color.RowCount; r++)
            {
                ContactBundle* row = color.BundleOf(r);
                int lane = color.LaneOf(r);
                float load = Math.Max(row->Point0.Normal[lane] * row->K11[lane], row->Point1.Normal[lane] * row->K22[lane]);
                float sag = c.Sag(load);
                int slot = row->Level[lane];
                if (sag > slotSag[slot])
                {
                    slotSag[slot] = sag;
                }

                if (row->Deep[lane] > 0)
                {
                    _deep[row->Island[lane]] = 1;
                }
            }
        }
    }

    private bool WriteRows(ConstraintGraph graph)
    {
        float any = 0;
        for (int k = 0; k < ConstraintGraph.ColorCount; k++)
        {
            GraphColor color = graph[k];
            for (int r = 0; r < color.RowCount; r++)
            {
                ContactBundle* row = color.BundleOf(r);
                int lane = color.LaneOf(r);
                int island = row->Island[lane];
                row->FeedRate[lane] = _rate[island];
                float deep = _deep[island];
                row->Deep[lane] = deep;
                any = Math.Max(any, deep);
            }
        }

        return any > 0;
    }
}
