using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Text.Json;
using Farseer.Fidelity.Running;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Building;

/// <summary>A scene made with the library: its simulator and everything in it, by id.</summary>
public sealed class BuiltScene
{
    private readonly Dictionary<string, object> _objects = [];
    private readonly Dictionary<object, string> _ids = new(ReferenceComparer.Instance);

    public BuiltScene(SceneFile file, object simulator)
    {
        File = file;
        Simulator = simulator;
        Values = new ValueReader(Json.Optional(file.Root, "vertices"), Find);
        Caller = new Caller(Values);
    }

    public SceneFile File { get; }

    public object Simulator { get; }

    public ValueReader Values { get; }

    public Caller Caller { get; }

    /// <summary>Counts, control points and places of each path, just after its factory returned.</summary>
    public Dictionary<string, JsonElement> PathResults { get; } = [];

    public EventLog Events { get; } = new();

    public void Add(string id, object value)
    {
        _objects.Add(id, value);
        _ids[value] = id;
    }

    public object? Find(string id) => id switch
    {
        "simulator" => Simulator,
        "inactivityController" => Facade.Get(Simulator, "InactivityController"),
        _ => _objects.GetValueOrDefault(id),
    };

    public object this[string id] => Find(id) ?? throw new BadSceneException($"there is no '{id}' in the scene.");

    public string? IdOf(object? value) => value is null ? null : _ids.GetValueOrDefault(value);

    /// <summary>Identity, whatever equality the library's types define: a geom is itself alone.</summary>
    private sealed class ReferenceComparer : IEqualityComparer<object>
    {
        public static readonly ReferenceComparer Instance = new();

        public new bool Equals(object? x, object? y) => ReferenceEquals(x, y);

        public int GetHashCode(object obj) => RuntimeHelpers.GetHashCode(obj);
    }
}
