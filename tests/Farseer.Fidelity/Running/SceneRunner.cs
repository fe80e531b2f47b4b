using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Reflection;
using System.Text.Json;
using System.Text.Json.Nodes;
using Farseer.Fidelity.Building;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Running;

/// <summary>Steps a built scene and records it as the original was recorded.</summary>
public sealed class SceneRunner
{
    private readonly BuiltScene _scene;
    private readonly Dictionary<string, List<Row>> _rows;
    private readonly Dictionary<string, List<JsonElement>> _observed;
    private readonly JsonElement[] _answers;
    private readonly Action<float> _update;

    private SceneRunner(BuiltScene scene, IEnumerable<string> bodies)
    {
        _scene = scene;
        _rows = bodies.ToDictionary(id => id, _ => new List<Row>());
        _observed = scene.File.Observe.ToDictionary(o => o, _ => new List<JsonElement>());
        _answers = new JsonElement[scene.File.Queries.Count];
        MethodInfo update = scene.Simulator.GetType().GetMethod("Update", [typeof(float)])
            ?? throw new MissingPartException("PhysicsSimulator.Update(float)");
        _update = update.CreateDelegate<Action<float>>(scene.Simulator);
    }

    public static RunResult Run(SceneFile file, int iterations, object? quirks)
    {
        BuiltScene scene = SceneBuilder.Build(file, iterations, quirks);
        SceneRunner runner = new(scene, file.Recordings[iterations].Rows.Keys);
        runner.StepThrough();
        Recording recording = new(
            runner._rows.ToDictionary(p => p.Key, p => p.Value.ToArray()),
            runner._observed.ToDictionary(p => p.Key, p => p.Value.ToArray()),
            scene.Events.ToEvents(),
            runner._answers);
        return new RunResult(recording, runner.MassProperties(), scene.PathResults);
    }

    private void StepThrough()
    {
        SceneFile file = _scene.File;
        HashSet<int> samples = [.. file.SampleSteps];
        Record(0, samples);
        for (int k = 0; k < file.Steps; k++)
        {
            foreach (SceneAction action in file.Actions.Where(a => a.Step <= k && k <= a.Until))
            {
                Perform(action);
            }

            _scene.Events.Update = k + 1;
            _update(file.Dt);
            Record(k + 1, samples);
        }
    }

    private void Record(int updates, HashSet<int> samples)
    {
        for (int i = 0; i < _answers.Length; i++)
        {
            if (_scene.File.Queries[i].AfterStep == updates)
            {
                _answers[i] = Element(Ask(_scene.File.Queries[i]));
            }
        }

        if (!samples.Contains(updates))
        {
            return;
        }

        foreach ((string id, List<Row> rows) in _rows)
        {
            object body = _scene[id];
            Vector2 position = (Vector2)Facade.Get(body, "Position")!;
            Vector2 velocity = (Vector2)Facade.Get(body, "LinearVelocity")!;
            rows.Add(new Row(
                position.X,
                position.Y,
                (float)Facade.Get(body, "Rotation")!,
                velocity.X,
                velocity.Y,
                (float)Facade.Get(body, "AngularVelocity")!));
        }

        foreach ((string expression, List<JsonElement> values) in _observed)
        {
            values.Add(Element(Observe(expression)));
        }
    }

    private void Perform(SceneAction action)
    {
        if (action.Remove is { } removed)
        {
            object target = _scene[removed];
            MethodInfo remove = Facade.Methods(_scene.Simulator.GetType(), "Remove", isStatic: false)
                .FirstOrDefault(m => m.GetParameters() is [{ } only] && only.ParameterType.IsInstanceOfType(target))
                ?? throw new MissingPartException("PhysicsSimulator.Remove(" + target.GetType().Name + ")");
            Facade.Invoke(remove, _scene.Simulator, [target]);
        }
        else if (action.Dispose is { } disposed)
        {
            ((IDisposable)_scene[disposed]).Dispose();
        }
        else
        {
            object target = _scene[action.Target ?? throw new BadSceneException("an action has no 'target'.")];
            if (action.Call is { } call)
            {
                List<JsonElement> args = action.Args.ValueKind == JsonValueKind.Array ? [.. action.Args.EnumerateArray()] : [];
                _scene.Caller.Call(target.GetType(), target, call, args);
            }
            else
            {
                foreach (JsonProperty property in action.Set.EnumerateObject())
                {
                    SceneBuilder.SetProperty(_scene, target, property.Name, property.Value);
                }
            }
        }
    }

    private JsonNode? Ask(SceneQuery query)
    {
        if (query.Static is { } path)
        {
            string[] parts = path.Split('.');
            return ResultWriter.Write(_scene, _scene.Caller.Call(Facade.Type(parts[0]), null, parts[1], query.Args), null);
        }

        object target =
            query.Vertices.ValueKind == JsonValueKind.Undefined ? _scene[query.Target!] : _scene.Values.Vertices(query.Vertices);
        return query.Get is { } member
            ? ResultWriter.Write(_scene, Facade.Get(target, member))
            : ResultWriter.Write(_scene, _scene.Caller.Call(target.GetType(), target, query.Call!, query.Args), target);
    }

    private JsonNode? Observe(string expression)
    {
        if (expression == "simulator.ContactPairs")
        {
            return ContactPairs();
        }

        // An id may itself hold a dot (the parts of a path), so the longest id that exists wins.
        int dot = expression.LastIndexOf('.');
        while (dot > 0 && _scene.Find(expression[..dot]) is null)
        {
            dot = expression.LastIndexOf('.', dot - 1);
        }

        object? value =
            dot > 0 ? _scene[expression[..dot]] : throw new BadSceneException($"nothing in the scene is called as in '{expression}'.");
        foreach (string member in expression[(dot + 1)..].Split('.'))
        {
            value = value is null ? null : Facade.Get(value, member);
        }

        return ResultWriter.Write(_scene, value);
    }

    private JsonArray ContactPairs()
    {
        List<string> pairs = [];
        foreach (object arbiter in ((IEnumerable)Facade.Get(_scene.Simulator, "ArbiterList")!).Cast<object>())
        {
            int count = ((ICollection)Facade.Get(arbiter, "ContactList")!).Count;
            if (count > 0)
            {
                pairs.Add($"{Name(arbiter, "A")}|{Name(arbiter, "B")}:{count}");
            }
        }

        pairs.Sort(StringComparer.Ordinal);
        return new JsonArray(pairs.Select(p => (JsonNode?)p).ToArray());
    }

    private string? Name(object arbiter, string side)
        => _scene.IdOf(Facade.Get(arbiter, Facade.HasMember(arbiter, "Geometry" + side) ? "Geometry" + side : "Geom" + side));

    private Dictionary<string, double[]> MassProperties()
    {
        Dictionary<string, double[]> result = [];
        foreach (JsonProperty body in Json.Members(_scene.File.Root, "massProperties"))
        {
            object target = _scene[body.Name];
            result.Add(body.Name, body.Value.EnumerateObject().Select(p => (double)(float)Facade.Get(target, p.Name)!).ToArray());
        }

        return result;
    }

    private static JsonElement Element(JsonNode? node) => JsonSerializer.SerializeToElement(node);
}

/// <summary>A run: what was recorded, the masses and inertias at its end by body, and the paths as they were made.</summary>
public sealed record RunResult(
    Recording Recording, IReadOnlyDictionary<string, double[]> MassProperties, IReadOnlyDictionary<string, JsonElement> PathResults);
