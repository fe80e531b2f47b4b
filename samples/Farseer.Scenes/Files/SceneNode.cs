using System.Collections.Generic;
using System.Globalization;
using System.Numerics;
using System.Text.Json;

namespace Farseer.Scenes;

/// <summary>A value of a scene file that knows its place, so that every complaint can name it.</summary>
internal readonly struct SceneNode
{
    private readonly SceneSource _source;
    private readonly JsonElement _element;
    private readonly string _path;

    public SceneNode(SceneSource source, JsonElement element, string path)
    {
        _source = source;
        _element = element;
        _path = path;
    }

    public SceneNode this[string name] => Find(name) ?? throw Fault($"has no '{name}'");

    public SceneNode? Find(string name)
    {
        Expect(JsonValueKind.Object, "an object {...}");
        return _element.TryGetProperty(name, out JsonElement child)
            ? new SceneNode(_source, child, _path.Length == 0 ? name : _path + "." + name)
            : null;
    }

    public IEnumerable<(string Name, SceneNode Value)> Members()
    {
        Expect(JsonValueKind.Object, "an object {...}");
        foreach (JsonProperty property in _element.EnumerateObject())
        {
            yield return (property.Name, this[property.Name]);
        }
    }

    public List<SceneNode> Items()
    {
        Expect(JsonValueKind.Array, "a list [...]");
        List<SceneNode> items = [];
        foreach (JsonElement child in _element.EnumerateArray())
        {
            items.Add(new SceneNode(_source, child, string.Create(CultureInfo.InvariantCulture, $"{_path}[{items.Count}]")));
        }

        return items;
    }

    public string Text()
    {
        Expect(JsonValueKind.String, "a text");
        return _element.GetString()!;
    }

    public bool Flag()
    {
        if (_element.ValueKind is not (JsonValueKind.True or JsonValueKind.False))
        {
            throw Fault("must be true or false");
        }

        return _element.GetBoolean();
    }

    public float Number()
    {
        Expect(JsonValueKind.Number, "a number");
        float value = _element.GetSingle();
        return float.IsFinite(value) ? value : throw Fault("is too large for single precision");
    }

    public int Whole()
    {
        Expect(JsonValueKind.Number, "a whole number");
        return _element.TryGetInt32(out int value) ? value : throw Fault("must be a whole number");
    }

    public bool IsText => _element.ValueKind == JsonValueKind.String;

    public Vector2 Vector()
    {
        List<SceneNode> items = Items();
        return items.Count == 2 ? new Vector2(items[0].Number(), items[1].Number()) : throw Fault("must be a pair [x, y]");
    }

    public SceneFileException Fault(string complaint) => _source.Fault(_path, complaint);

    private void Expect(JsonValueKind kind, string what)
    {
        if (_element.ValueKind != kind)
        {
            throw Fault("must be " + what);
        }
    }
}
