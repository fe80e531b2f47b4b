using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Running;

/// <summary>Collects what the handlers saw, by update, in the form of the scene files.</summary>
public sealed class EventLog
{
    private readonly List<(string Type, string First, string Second)> _order = [];
    private readonly Dictionary<(string Type, string First, string Second), List<int>> _updates = [];

    /// <summary>The update that is under way, counted from 1.</summary>
    public int Update { get; set; }

    public void Add(string type, string first, string second)
    {
        (string, string, string) key = (type, first, second);
        if (!_updates.TryGetValue(key, out List<int>? updates))
        {
            _order.Add(key);
            _updates.Add(key, updates = []);
        }

        updates.Add(Update);
    }

    public IReadOnlyList<SceneEvent> ToEvents() => _order.Select(key =>
    {
        List<int> updates = _updates[key];
        List<(int First, int Last)> runs = [];
        foreach (int update in updates)
        {
            if (runs.Count > 0 && runs[^1].Last >= update - 1)
            {
                runs[^1] = (runs[^1].First, update);
            }
            else
            {
                runs.Add((update, update));
            }
        }

        return new SceneEvent(key.Type, key.First, key.Second, updates.Count, runs);
    }).ToList();
}
