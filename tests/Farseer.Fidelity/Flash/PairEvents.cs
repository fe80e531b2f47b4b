using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Running;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// The calls of a contact listener by pair of shapes. A pair begins with the Add of its first point and ends with the Remove of its
/// last one; in between, which of its features a point is named by, and so whether it is exchanged for another, is the detail of the
/// original's clipping. Which shape comes first is not compared either, nor a contact that is lost for no more than two steps and had
/// again, nor what is told of bodies asleep: the original tells of them or not by a flag that their static neighbours take over.
/// </summary>
internal sealed class PairEvents
{
    private const int ShortLoss = 2;

    private readonly Dictionary<(string, string), Pair> _pairs = [];
    private readonly List<Pair> _order = [];

    public void Add(int step, string kind, string shape1, string shape2)
    {
        (string, string) key = string.CompareOrdinal(shape1, shape2) < 0 ? (shape1, shape2) : (shape2, shape1);
        if (!_pairs.TryGetValue(key, out Pair? pair))
        {
            _pairs.Add(key, pair = new Pair(key.Item1, key.Item2));
            _order.Add(pair);
        }

        List<int> steps = kind switch
        {
            "Result" => pair.Solved,
            "Remove" => pair.Removed,
            _ => pair.Touching,
        };
        if (steps.Count == 0 || steps[^1] != step)
        {
            steps.Add(step);
        }
    }

    /// <param name="asleep">From when until when the body of a shape slept: meanwhile a pair goes on as it was, told or not.</param>
    public IReadOnlyList<SceneEvent> ToEvents(Func<string, IEnumerable<(int From, int To)>> asleep)
    {
        foreach (Pair pair in _order)
        {
            foreach ((int from, int to) in asleep(pair.First).Concat(asleep(pair.Second)).OrderBy(i => i.From))
            {
                pair.Sleep(from, to);
            }
        }

        List<(int Step, string Kind, Pair Pair)> all = [.. _order.SelectMany(p => p.Events().Select(e => (e.Step, e.Kind, p)))];
        EventLog log = new();
        foreach ((int step, string kind, Pair pair) in all.OrderBy(e => e.Step))
        {
            log.Update = step;
            log.Add(kind, pair.First, pair.Second);
        }

        return log.ToEvents();
    }

    private sealed class Pair(string first, string second)
    {
        public string First => first;

        public string Second => second;

        public List<int> Touching { get; } = [];

        public List<int> Solved { get; } = [];

        public List<int> Removed { get; } = [];

        public void Sleep(int from, int to)
        {
            int removed = Removed.Find(r => r >= from);
            int end = removed >= from && removed > 0 ? Math.Min(to, removed - 1) : to;
            Fill(Touching, from, end);
            Fill(Solved, from, end);
        }

        public IEnumerable<(int Step, string Kind)> Events()
        {
            foreach ((int begin, int end) in Runs(Touching))
            {
                yield return (begin, "Add");
                for (int step = begin + 1; step <= end; step++)
                {
                    yield return (step, "Persist");
                }

                int removed = Removed.Find(r => r >= end);
                if (removed >= end && (removed == end || removed <= end + ShortLoss))
                {
                    yield return (removed, "Remove");
                }
            }

            foreach ((int begin, int end) in Runs(Solved))
            {
                for (int step = begin; step <= end; step++)
                {
                    yield return (step, "Result");
                }
            }
        }

        private static void Fill(List<int> steps, int from, int to)
        {
            if (!steps.Exists(s => s < from && s >= from - 1 - ShortLoss))
            {
                return;
            }

            for (int step = from; step <= to; step++)
            {
                if (!steps.Contains(step))
                {
                    steps.Add(step);
                }
            }

            steps.Sort();
        }

        private static IEnumerable<(int Begin, int End)> Runs(List<int> steps)
        {
            for (int i = 0; i < steps.Count;)
            {
                int end = i;
                while (end + 1 < steps.Count && steps[end + 1] <= steps[end] + 1 + ShortLoss)
                {
                    end++;
                }

                yield return (steps[i], steps[end]);
                i = end + 1;
            }
        }
    }
}
