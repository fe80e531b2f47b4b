using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Running;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// The calls of a contact listener by pair of shapes. A pair begins with the Add of its first point and ends with the Remove of its
/// last one; in between, which of its features a point is named by, and so whether it is exchanged for another, is the detail of the
/// original's clipping. Which shape comes first is not compared either.
/// </summary>
internal sealed class PairEvents
{
    private readonly EventLog _log = new();
    private readonly Dictionary<(string, string), Pair> _pairs = [];
    private readonly List<Pair> _open = [];
    private int _step;

    public void Add(int step, string kind, string shape1, string shape2)
    {
        if (step != _step)
        {
            Close();
            _step = step;
        }

        (string, string) key = string.CompareOrdinal(shape1, shape2) < 0 ? (shape1, shape2) : (shape2, shape1);
        if (!_pairs.TryGetValue(key, out Pair? pair))
        {
            _pairs.Add(key, pair = new Pair(key.Item1, key.Item2));
        }

        if (!_open.Contains(pair))
        {
            _open.Add(pair);
            pair.Begin();
        }

        pair.Take(kind);
    }

    public IReadOnlyList<SceneEvent> ToEvents()
    {
        Close();
        return _log.ToEvents();
    }

    private void Close()
    {
        _log.Update = _step;
        foreach (Pair pair in _open)
        {
            foreach (string kind in pair.Kinds())
            {
                _log.Add(kind, pair.First, pair.Second);
            }
        }

        _open.Clear();
    }

    private sealed class Pair(string first, string second)
    {
        private readonly List<string> _kinds = [];
        private int _points;
        private int _before;

        public string First => first;

        public string Second => second;

        public void Begin()
        {
            _kinds.Clear();
            _before = _points;
        }

        public void Take(string kind)
        {
            _points += kind == "Add" ? 1 : kind == "Remove" ? -1 : 0;
            _kinds.Add(kind);
        }

        public IEnumerable<string> Kinds()
        {
            bool began = _before == 0 && _kinds.Contains("Add");
            bool ended = _points == 0 && _kinds.Contains("Remove");
            if (began)
            {
                yield return "Add";
            }
            else if (!ended)
            {
                yield return "Persist";
            }

            if (_kinds.Contains("Result"))
            {
                yield return "Result";
            }

            if (ended)
            {
                yield return "Remove";
            }
        }
    }
}
