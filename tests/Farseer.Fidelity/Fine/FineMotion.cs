using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Fine;

/// <summary>
/// Newton's and Euler's equations of rigid bodies with Coulomb's friction and impacts, in steps a thousand times smaller than those of
/// the scene. It shares no line with the library and has none of its tolerances: surfaces rest at gap 0 (or as deep as they
/// started), hinges are iterated to rest, flight is exact. What it leaves is the error of its step, first order in 1/60000 s.
/// </summary>
internal sealed class FineMotion
{
    /// <summary>Small steps in a step of the scene. Halving it moves no row of the scenes by more than the tests say.</summary>
    public const int Division = 1000;

    private const int Sweeps = 40;

    /// <summary>The original's: what meets more slowly does not bounce.</summary>
    private const double BounceThreshold = 1;

    private readonly SceneFile _file;
    private readonly int _division;
    private readonly double _step;
    private readonly double _gravityX;
    private readonly double _gravityY;
    private readonly List<FineBody> _bodies;
    private readonly List<FineHinge> _hinges = [];
    private readonly List<FineDrag> _drags = [];
    private readonly List<FineContact> _contacts = [];
    private readonly List<FineContact> _touching = [];

    private FineMotion(SceneFile file, int division)
    {
        _file = file;
        _division = division;
        _step = (double)file.Dt / division;
        _gravityX = file.Gravity[0].GetDouble();
        _gravityY = file.Gravity[1].GetDouble();
        _bodies = [.. Json.Items(file.Root, "bodies").Select(FineBody.Read)];
        foreach (JsonElement joint in Json.Items(file.Root, "joints"))
        {
            MakeJoint(joint);
        }

        FindPairs();
    }

    /// <summary>The rows of all bodies, one for each sample; a body that is not there has an absent one.</summary>
    public static IReadOnlyDictionary<string, Row[]> Run(SceneFile file, int division = Division)
    {
        FineMotion motion = new(file, division);
        Dictionary<string, List<Row>> rows = file.Recordings.Values.First().Rows.Keys.ToDictionary(id => id, _ => new List<Row>());
        HashSet<int> samples = [.. file.SampleSteps];
        for (int k = 0; ; k++)
        {
            if (samples.Contains(k))
            {
                foreach ((string id, List<Row> own) in rows)
                {
                    own.Add(motion._bodies.Find(b => b.Id == id)?.ToRow() ?? Row.Absent);
                }
            }

            if (k == file.Steps)
            {
                return rows.ToDictionary(p => p.Key, p => p.Value.ToArray());
            }

            motion.Act(k);
            motion.Advance();
        }
    }

    private void Act(int step)
    {
        foreach (JsonElement action in Json.Items(_file.Root, "actions").Where(a => a.GetProperty("step").GetInt32() == step))
        {
            if (Json.OptionalText(action, "create") is { } kind)
            {
                Create(kind, action);
                continue;
            }

            string call = Json.Text(action, "call");
            List<JsonElement> args = [.. Json.Items(action, "args")];
            string target = Json.Text(action, "target");
            if (call == "SetTarget")
            {
                _drags.Single(d => d.Id == target).SetTarget(args[0]);
            }
            else if (call == "DestroyBody")
            {
                _bodies.RemoveAll(b => b.Id == args[0].GetString());
            }
            else
            {
                Body(target).Call(call, args);
            }
        }

        FindPairs();
    }

    private void Create(string kind, JsonElement action)
    {
        JsonElement value = action.GetProperty("value");
        switch (kind)
        {
            case "body":
                _bodies.Add(FineBody.Read(value));
                break;
            case "shape":
                FineBody body = Body(Json.Text(action, "target"));
                body.Shapes.Add(FineShape.Read(body, value));
                break;
            default:
                MakeJoint(value);
                break;
        }
    }

    private void MakeJoint(JsonElement joint)
    {
        switch (Json.Text(joint, "type"))
        {
            case "b2RevoluteJointDef":
                JsonElement[] made = [.. Json.Items(joint, "Initialize")];
                _hinges.Add(new FineHinge(Body(made[1].GetString()!), made[2][0].GetDouble(), made[2][1].GetDouble()));
                break;
            case "b2MouseJointDef":
                _drags.Add(new FineDrag(Body(Json.Text(joint, "body2")), joint));
                break;
            case string other:
                throw new BadSceneException(other + " has no part in the equations of motion.");
        }
    }

    private FineBody Body(string id) => _bodies.Single(b => b.Id == id);

    /// <summary>Pairs that were there keep their impulses.</summary>
    private void FindPairs()
    {
        List<FineContact> before = [.. _contacts];
        _contacts.Clear();
        FineShape[] shapes = [.. _bodies.SelectMany(b => b.Shapes)];
        for (int i = 0; i < shapes.Length; i++)
        {
            for (int j = i + 1; j < shapes.Length; j++)
            {
                (FineShape a, FineShape b) = (shapes[i], shapes[j]);
                if (a.Body != b.Body && a.Body.InverseMass + b.Body.InverseMass > 0)
                {
                    _contacts.Add(before.Find(c => c.A == a && c.B == b) ?? new FineContact(a, b));
                }
            }
        }
    }

    private void Advance()
    {
        foreach (FineDrag drag in _drags)
        {
            drag.BeginStep();
        }

        for (int i = 0; i < _division; i++)
        {
            SmallStep();
        }
    }

    private void SmallStep()
    {
        // Nothing in the scenes closes in faster than this many metres a second.
        const double Fastest = 400;
        _touching.Clear();
        foreach (FineContact contact in _contacts)
        {
            if (contact.Find(Fastest * _step))
            {
                _touching.Add(contact);
            }
        }

        foreach (FineContact contact in _touching)
        {
            contact.Begin(BounceThreshold);
        }

        foreach (FineBody body in _bodies.Where(b => b.InverseMass > 0))
        {
            body.VelocityX += _step * _gravityX;
            body.VelocityY += _step * _gravityY;
        }

        foreach (FineDrag drag in _drags)
        {
            drag.Pull(_step);
        }

        int sweeps = _touching.Count + _hinges.Count > 0 ? Sweeps : 0;
        for (int sweep = 0; sweep < sweeps; sweep++)
        {
            foreach (FineHinge hinge in _hinges)
            {
                hinge.Solve(_step);
            }

            foreach (FineContact contact in _touching)
            {
                contact.Solve(_step);
            }
        }

        foreach (FineBody body in _bodies.Where(b => b.InverseMass > 0))
        {
            // The mean velocity of the small step where gravity alone acts; elsewhere the next gap takes the half square back.
            body.X += _step * (body.VelocityX - (_step * _gravityX / 2));
            body.Y += _step * (body.VelocityY - (_step * _gravityY / 2));
            body.Angle += _step * body.Spin;
        }
    }
}

/// <summary>A body's point held at a point of the world.</summary>
internal sealed class FineHinge
{
    private readonly FineBody _body;
    private readonly (double X, double Y) _local;
    private readonly double _x;
    private readonly double _y;

    public FineHinge(FineBody body, double x, double y)
    {
        _body = body;
        _local = body.ToLocal((x, y));
        (_x, _y) = (x, y);
    }

    /// <summary>Brings the point to where it belongs by the end of the small step: K has rows (m + i ry², -i rx ry), (-i rx ry, m + i rx²).</summary>
    public void Solve(double step)
    {
        (double px, double py) = _body.ToWorld(_local);
        (double rx, double ry) = (px - _body.X, py - _body.Y);
        double vx = _body.VelocityX - (_body.Spin * ry) + ((px - _x) / step);
        double vy = _body.VelocityY + (_body.Spin * rx) + ((py - _y) / step);
        double i = _body.InverseInertia;
        double k11 = _body.InverseMass + (i * ry * ry);
        double k12 = -i * rx * ry;
        double k22 = _body.InverseMass + (i * rx * rx);
        double determinant = (k11 * k22) - (k12 * k12);
        _body.Push(px, py, -((k22 * vx) - (k12 * vy)) / determinant, -((k11 * vy) - (k12 * vx)) / determinant);
    }
}

/// <summary>
/// A mouse joint with the quirks of the original: force -(k x + c v) at the anchor with k and c those of the frequency and the body's
/// mass, divided by the time step, at most maxForce long; and the body's spin loses 2 % at the beginning of each step.
/// </summary>
internal sealed class FineDrag
{
    private const double DefaultFrequency = 5;
    private const double DefaultDamping = 0.7;
    private const double SpinKept = 0.98;

    private readonly FineBody _body;
    private readonly (double X, double Y) _local;
    private readonly double _stiffness;
    private readonly double _damping;
    private readonly double _most;
    private double _x;
    private double _y;

    public FineDrag(FineBody body, JsonElement joint)
    {
        Id = Json.Text(joint, "id");
        _body = body;
        SetTarget(Json.Required(joint, "target"));
        _local = body.ToLocal((_x, _y));
        double turn = 2 * Math.PI * Number(joint, "frequencyHz", DefaultFrequency);
        double step = Json.Required(joint, "timeStep").GetDouble();
        double mass = 1 / body.InverseMass;
        _stiffness = mass * turn * turn / step;
        _damping = 2 * mass * Number(joint, "dampingRatio", DefaultDamping) * turn / step;
        _most = Json.Required(joint, "maxForce").GetDouble();
    }

    public string Id { get; }

    public void SetTarget(JsonElement target) => (_x, _y) = (target[0].GetDouble(), target[1].GetDouble());

    public void BeginStep() => _body.Spin *= SpinKept;

    public void Pull(double step)
    {
        (double px, double py) = _body.ToWorld(_local);
        double vx = _body.VelocityX - (_body.Spin * (py - _body.Y));
        double vy = _body.VelocityY + (_body.Spin * (px - _body.X));
        double fx = -(_stiffness * (px - _x)) - (_damping * vx);
        double fy = -(_stiffness * (py - _y)) - (_damping * vy);
        double length = Math.Sqrt((fx * fx) + (fy * fy));
        double share = length > _most ? _most / length : 1;
        _body.Push(px, py, step * share * fx, step * share * fy);
    }

    private static double Number(JsonElement joint, string name, double other)
        => Json.Optional(joint, name) is { ValueKind: JsonValueKind.Number } e ? e.GetDouble() : other;
}
