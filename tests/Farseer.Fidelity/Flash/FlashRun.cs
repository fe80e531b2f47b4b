using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Text.Json;
using System.Text.Json.Nodes;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Farseer.Fidelity.Running;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>Steps a scene and records it as the original was recorded.</summary>
internal sealed class FlashRun
{
    private readonly FlashScene _scene;
    private readonly Dictionary<string, List<Row>> _rows;
    private readonly Dictionary<string, List<JsonElement>> _observed;
    private readonly JsonElement[] _answers;
    private readonly JsonArray _actions = [];
    private readonly Dictionary<string, bool> _asleep = [];
    private readonly Dictionary<string, bool> _frozen = [];
    private readonly Dictionary<string, double[]> _masses = [];

    private FlashRun(SceneFile file, int iterations, Box2DFlash202Quirks quirks)
    {
        _scene = new FlashScene(file, quirks);
        _rows = file.Recordings[iterations].Rows.Keys.ToDictionary(id => id, _ => new List<Row>());
        _observed = file.Observe.ToDictionary(o => o, _ => new List<JsonElement>());
        _answers = new JsonElement[file.Queries.Count];
        _scene.Log.Register();
        _scene.Build();
        MassProperties();
        StepThrough(iterations);
    }

    public RunResult Result => new(
        new Recording(
            _rows.ToDictionary(p => p.Key, p => p.Value.ToArray()),
            _observed.ToDictionary(p => p.Key, p => p.Value.ToArray()),
            _scene.Log.Contacts.ToEvents(SleepOf),
            _answers),
        _masses,
        new Dictionary<string, JsonElement>());

    /// <summary>By body: the steps after which its state was found changed.</summary>
    public Dictionary<string, List<(int Step, bool State)>> SleepChanges { get; } = [];

    public Dictionary<string, List<(int Step, bool State)>> FrozenChanges { get; } = [];

    /// <summary>The lists of the log and of actions, by the names of the scene files.</summary>
    public IReadOnlyDictionary<string, JsonElement> Lists => new Dictionary<string, JsonElement>
    {
        ["boundaryEvents"] = Element(_scene.Log.Boundary),
        ["destructionEvents"] = Element(_scene.Log.Destruction),
        ["filterCalls"] = Element(_scene.Log.Filter),
        ["callbackResults"] = Element(_scene.Log.Callbacks),
        ["actionResults"] = Element(_actions),
    };

    public static FlashRun Of(SceneFile file, int iterations, Box2DFlash202Quirks quirks) => new(file, iterations, quirks);

    private IEnumerable<(int From, int To)> SleepOf(string shape)
    {
        string? body = _scene.File.Geoms.FirstOrDefault(g => g.Id == shape)?.Body;
        return body is not null && SleepChanges.TryGetValue(body, out List<(int Step, bool State)>? changes)
            ? SleepIntervals.Of(changes, _scene.File.Steps)
            : [];
    }

    private void StepThrough(int iterations)
    {
        SceneFile file = _scene.File;
        HashSet<int> samples = [.. file.SampleSteps];
        List<JsonElement> actions = Json.Items(file.Root, "actions").ToList();
        float dt = file.Dt;
        Record(0, samples);
        for (int k = 0; k < file.Steps; k++)
        {
            _scene.Log.Step = k + 1;
            foreach (JsonElement action in actions)
            {
                int from = action.GetProperty("step").GetInt32();
                int until = Json.Optional(action, "until") is { ValueKind: JsonValueKind.Number } u ? u.GetInt32() : from;
                if (from <= k && k <= until)
                {
                    dt = Json.Optional(action, "dt") is { ValueKind: JsonValueKind.Number } changed ? changed.GetSingle() : dt;
                    Perform(action, k);
                }
            }

            _scene.World.Step(dt, iterations);
            Record(k + 1, samples);
        }
    }

    private void Perform(JsonElement action, int step)
    {
        if (Json.OptionalText(action, "create") is { } kind)
        {
            string? id = _scene.Create(kind, Json.OptionalText(action, "target"), action.GetProperty("value"));
            _actions.Add(new JsonArray(step, "create " + kind, id));
        }
        else if (Json.OptionalText(action, "call") is { } call)
        {
            string target = Json.Text(action, "target");
            object value = _scene[target];
            object? result = FlashValues.Call(_scene, value, call, Json.Items(action, "args").ToList());
            if (value.GetType().GetMethods().First(m => m.Name == call && m.DeclaringType != typeof(object)).ReturnType != typeof(void))
            {
                _actions.Add(new JsonArray(step, target + "." + call, FlashValues.Write(_scene, result)));
            }
        }
    }

    private void Record(int step, HashSet<int> samples)
    {
        foreach ((string id, b2Body body) in _scene.Bodies)
        {
            Note(_asleep, SleepChanges, id, IsThere(body) && body.IsSleeping(), step);
            Note(_frozen, FrozenChanges, id, IsThere(body) && body.IsFrozen(), step);
        }

        for (int i = 0; i < _answers.Length; i++)
        {
            if (_scene.File.Queries[i].AfterStep == step)
            {
                _answers[i] = Element(Ask(_scene.File.Queries[i]));
            }
        }

        if (!samples.Contains(step))
        {
            return;
        }

        foreach ((string id, List<Row> rows) in _rows)
        {
            rows.Add(_scene.Find(id) is b2Body body && IsThere(body) ? RowOf(body) : Row.Absent);
        }

        foreach ((string expression, List<JsonElement> values) in _observed)
        {
            int dot = expression.LastIndexOf('.');
            object? value = _scene.Find(expression[..dot]);
            values.Add(
                Element(value is null ? null : FlashValues.Write(_scene, FlashValues.Call(_scene, value, expression[(dot + 1)..], []))));
        }
    }

    private static void Note(
        Dictionary<string, bool> states, Dictionary<string, List<(int, bool)>> changes, string id, bool state, int step)
    {
        if (state != states.GetValueOrDefault(id))
        {
            states[id] = state;
            changes.TryAdd(id, []);
            changes[id].Add((step, state));
        }
    }

    private bool IsThere(b2Body body)
    {
        for (b2Body? b = _scene.World.GetBodyList(); b is not null; b = b.GetNext())
        {
            if (ReferenceEquals(b, body))
            {
                return true;
            }
        }

        return false;
    }

    private static Row RowOf(b2Body body) => new(
        body.GetPosition().x,
        body.GetPosition().y,
        body.GetAngle(),
        body.GetLinearVelocity().x,
        body.GetLinearVelocity().y,
        body.GetAngularVelocity());

    private JsonNode? Ask(SceneQuery query)
    {
        object target = _scene[query.Target!];
        if (query.Get == "debugDraw")
        {
            return FlashDrawing.Of(_scene, query.Args.Select(a => a.GetString()!));
        }

        if (query.Get is { } list)
        {
            return ListOf(FlashValues.Call(_scene, target, list, []));
        }

        return (target, query.Call) switch
        {
            (b2World world, "Query") => Query(world, query),
            (b2Shape shape, "TestPoint") => shape.TestPoint(shape.GetBody()!.GetXForm(), FlashValues.Vector(query.Args[0])),
            (b2Shape shape, "TestSegment") => Segment(shape, query),
            (b2Shape shape, "ComputeAABB") => Box(shape),
            (b2Shape shape, "ComputeMass") => Mass(shape),
            _ => FlashValues.Write(_scene, FlashValues.Call(_scene, target, query.Call!, query.Args)),
        };
    }

    private JsonArray ListOf(object? first)
    {
        JsonArray ids = [];
        for (object? item = first; item is not null; item = Next(item))
        {
            ids.Add(FlashValues.Write(_scene, item));
        }

        return ids;

        static object? Next(object item) => item switch
        {
            b2Body body => body.GetNext(),
            b2Shape shape => shape.GetNext(),
            b2Joint joint => joint.GetNext(),
            b2JointEdge edge => edge.next,
            _ => null,
        };
    }

    private JsonObject Query(b2World world, SceneQuery query)
    {
        List<b2Shape> shapes = [];
        int count = world.Query((b2AABB)FlashValues.Read(_scene, query.Args[0], typeof(b2AABB))!, shapes, query.Args[1].GetInt32());
        return new JsonObject { ["count"] = count, ["shapes"] = new JsonArray(shapes.Select(s => (JsonNode?)_scene.IdOf(s)).ToArray()) };
    }

    private JsonObject Segment(b2Shape shape, SceneQuery query)
    {
        b2Segment segment = new() { p1 = FlashValues.Vector(query.Args[0]), p2 = FlashValues.Vector(query.Args[1]) };
        float[] lambda = new float[1];
        b2Vec2 normal = new();
        bool hit = shape.TestSegment(shape.GetBody()!.GetXForm(), lambda, normal, segment, query.Args[2].GetSingle());
        return hit
            ? new JsonObject { ["hit"] = true, ["lambda"] = lambda[0], ["normal"] = FlashValues.Write(_scene, normal) }
            : new JsonObject { ["hit"] = false };
    }

    private JsonNode? Box(b2Shape shape)
    {
        b2AABB box = new();
        shape.ComputeAABB(box, shape.GetBody()!.GetXForm());
        return FlashValues.Write(_scene, box);
    }

    private JsonNode? Mass(b2Shape shape)
    {
        b2MassData mass = new();
        shape.ComputeMass(mass);
        return FlashValues.Write(_scene, mass);
    }

    private void MassProperties()
    {
        foreach (JsonProperty body in Json.Members(_scene.File.Root, "massProperties"))
        {
            b2Body b = _scene.Body(body.Name);
            _masses.Add(body.Name, [b.GetMass(), b.GetInertia(), b.GetLocalCenter().x, b.GetLocalCenter().y, b.IsStatic() ? 1 : 0]);
        }
    }

    private static JsonElement Element(JsonNode? node) => JsonSerializer.SerializeToElement(node);
}
