using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Fine;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// What is not compared, by what a scene contains: what the library has on purpose and the original has not, and what is a detail of
/// the original's method.
/// </summary>
internal sealed class FlashExemptions
{
    private readonly SceneFile _file;
    private readonly HashSet<string> _stuck;
    private readonly HashSet<string> _moved;
    private readonly HashSet<string> _bullets;
    private readonly Dictionary<string, double> _halfWidths = [];

    public FlashExemptions(SceneFile file)
    {
        _file = file;
        FineBody[] bodies = [.. Json.Items(file.Root, "bodies").Select(Read)];
        foreach (FineBody body in bodies)
        {
            _halfWidths[body.Id] = body.Shapes.Select(s => s.HalfWidth()).DefaultIfEmpty(0).Min();
        }

        bool IsMoving(string id) => file.Recordings.Values.Any(r => r.Rows.ContainsKey(id));
        IReadOnlyList<string>[] joints = [.. file.Joints.Select(j => Names(j.Args).ToList())];
        _stuck = [.. bodies.Where(b => IsMoving(b.Id) && joints.Any(j => j.Contains(b.Id)) && bodies.Any(o => o != b
            && IsStuck(b, o))).Select(b => b.Id)];
        _moved = [.. _stuck.Concat(bodies.Select(b => b.Id).Where(id => joints.Any(j => j.Contains(id) && j.Any(_stuck.Contains))))];
        _bullets =
        [
            .. file.Bodies.Where(b => Json.Optional(b.Args, "isBullet").ValueKind == JsonValueKind.True).Select(b => b.Id),
            .. Json.Items(file.Root, "actions").Where(a => Json.OptionalText(a, "call") == "SetBullet").Select(a => Json.Text(a, "target")),
        ];
    }

    /// <summary>What of it the scene has, for the report.</summary>
    public IEnumerable<string> Reasons()
    {
        if (_moved.Count > 0)
        {
            yield return "not compared: " + string.Join(", ", _moved.Order(StringComparer.Ordinal))
                + ": starts deep in another while a joint holds it, or is joined to what does";
        }
    }

    /// <summary>
    /// A body whose motion is not compared: it starts deeper in another than half its width while a joint holds it, and no equation
    /// says which of
    /// the two gives way; or it is joined to such a body.
    /// </summary>
    public bool HoldsMotion(string body) => _moved.Contains(body);

    /// <summary>
    /// An event of a body that starts so; or of two moving bodies, none of them a bullet, that close in by more than half the
    /// narrower one's width in a step: the original does not look for those between its steps unless the pair is new, the library
    /// always does.
    /// </summary>
    public bool Holds(SceneEvent e, int iterations)
    {
        string[] bodies = [.. _file.Geoms.Where(g => g.Id == e.First || g.Id == e.Second).Select(g => g.Body!)];
        return bodies.Any(_stuck.Contains) || IsMissed(bodies, e, iterations);
    }

    /// <summary>
    /// A body that damping stops within one step of Euler's: 1 - c dt is 0 or less, where the true decay leaves a little. When it sleeps is
    /// not compared.
    /// </summary>
    public static bool IsStoppedByDamping(SceneFile file, string body) => file.Bodies.Where(b => b.Id == body)
        .Any(b => Math.Max(Json.Number(b.Args, "linearDamping", 0), Json.Number(b.Args, "angularDamping", 0)) * file.Dt >= 1);

    private static FineBody Read(JsonElement body)
    {
        JsonElement def = Json.Required(body, "def");
        JsonElement at = Json.Optional(def, "position");
        FineBody made = new(Json.Text(body, "id")) { Angle = Json.Number(def, "angle", 0) };
        (made.X, made.Y) = at.ValueKind == JsonValueKind.Array ? (at[0].GetDouble(), at[1].GetDouble()) : (0, 0);
        foreach (JsonElement shape in Json.Items(body, "shapes"))
        {
            try
            {
                made.Shapes.Add(FlashFineScene.ReadShape(made, shape));
            }
            catch (NotExpressedException)
            {
                // A shape that does not collide with all, a sensor for one, sticks in nothing.
            }
        }

        return made;
    }

    private static bool IsStuck(FineBody body, FineBody other) => body.Shapes.Any(a => other.Shapes.Any(b =>
    {
        FineContact contact = new(a, b, 0, 0);
        return contact.Find(0) && contact.Gap < -a.HalfWidth();
    }));

    /// <summary>The ids that a joint names, whether by fields or as arguments.</summary>
    private static IEnumerable<string> Names(JsonElement joint) => joint.EnumerateObject()
        .SelectMany(p => p.Value.ValueKind == JsonValueKind.Array ? [.. p.Value.EnumerateArray()] : new[] { p.Value })
        .Where(v => v.ValueKind == JsonValueKind.String).Select(v => v.GetString()!);

    private bool IsMissed(string[] bodies, SceneEvent e, int iterations)
    {
        IReadOnlyDictionary<string, Row[]> rows = _file.Recordings[iterations].Rows;
        if (bodies is not [{ } first, { } second] || bodies.Any(_bullets.Contains) || !rows.ContainsKey(first) || !rows.ContainsKey(second))
        {
            return false;
        }

        // The fastest of the samples around: the event may itself be the impact that slows it.
        int k = Array.FindLastIndex(_file.SampleSteps, s => s < e.Runs[0].First);
        double closing = Enumerable.Range(Math.Max(0, k - 1), 2).Where(i => !rows[first][i].IsAbsent && !rows[second][i].IsAbsent)
            .Select(i => Discretisation.Speed(rows[first][i], rows[second][i])).DefaultIfEmpty(0).Max();
        return closing * _file.Dt > Math.Min(_halfWidths.GetValueOrDefault(first), _halfWidths.GetValueOrDefault(second));
    }
}
