using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Fine;

/// <summary>
/// Newton's and Euler's equations of rigid bodies with Coulomb's friction and impacts, in steps a thousand times smaller than those of
/// the scene. It shares no line with the library and has none of its tolerances: circles are round, surfaces rest at gap 0 (or as deep
/// as they
/// started), hinges are iterated to rest, flight is exact. What it leaves is the error of its step, first order in 1/60000 s.
/// </summary>
internal sealed class FineMotion
{
    /// <summary>Small steps in a step of the scene. Halving it moves no row of the scenes by more than the tests say.</summary>
    public const int Division = 1000;

    private const int Sweeps = 40;

    private readonly FineScene _scene;
    private readonly int _division;
    private readonly double _step;
    private readonly double _fastest;
    private readonly Dictionary<(FineShape, FineShape), FineContact?> _known = [];
    private readonly List<FineContact> _touching = [];
    private List<FineContact> _contacts = [];

    private FineMotion(SceneFile file, int division)
    {
        _scene = FineScene.Of(file);
        _division = division;
        _step = (double)file.Dt / division;

        // Nothing closes in at more than twice the speeds that were recorded, and what gravity makes of them in a step.
        _fastest = (2 * file.Recordings.Values.SelectMany(r => r.Rows.Values).SelectMany(r => r).Where(r => !r.IsAbsent)
            .Select(r => Math.Abs(r.VelocityX) + Math.Abs(r.VelocityY)).DefaultIfEmpty(0).Max())
            + ((Math.Abs(_scene.Gravity.X) + Math.Abs(_scene.Gravity.Y)) * file.Dt) + 1;
        FindPairs();
    }

    /// <summary>
    /// The rows of all bodies, one for each sample; a body that is not there has an absent one. Null: the scene cannot be expressed.
    /// </summary>
    public static IReadOnlyDictionary<string, Row[]>? Run(SceneFile file, int division = Division)
    {
        try
        {
            return new FineMotion(file, division).Record(file);
        }
        catch (NotExpressedException)
        {
            return null;
        }
    }

    private Dictionary<string, Row[]> Record(SceneFile file)
    {
        Dictionary<string, List<Row>> rows = file.Recordings.Values.First().Rows.Keys.ToDictionary(id => id, _ => new List<Row>());
        HashSet<int> samples = [.. file.SampleSteps];
        for (int k = 0; ; k++)
        {
            if (samples.Contains(k))
            {
                foreach ((string id, List<Row> own) in rows)
                {
                    own.Add(_scene.Bodies.Find(b => b.Id == id)?.ToRow() ?? Row.Absent);
                }
            }

            if (k == file.Steps)
            {
                return rows.ToDictionary(p => p.Key, p => p.Value.ToArray());
            }

            _scene.Act(k);
            FindPairs();
            Advance();
        }
    }

    /// <summary>Pairs that were there keep their impulses.</summary>
    private void FindPairs()
    {
        _contacts = [];
        FineShape[] shapes = [.. _scene.Bodies.SelectMany(b => b.Shapes)];
        for (int i = 0; i < shapes.Length; i++)
        {
            for (int j = i + 1; j < shapes.Length; j++)
            {
                (FineShape a, FineShape b) = (shapes[i], shapes[j]);
                if (a.Body == b.Body || a.Body.InverseMass + b.Body.InverseMass == 0)
                {
                    continue;
                }

                if (!_known.TryGetValue((a, b), out FineContact? contact))
                {
                    _known.Add((a, b), contact = _scene.Meet(a, b));
                }

                if (contact is not null)
                {
                    _contacts.Add(contact);
                }
            }
        }
    }

    private void Advance()
    {
        foreach (IFinePull pull in _scene.Pulls)
        {
            pull.BeginStep();
        }

        for (int i = 0; i < _division; i++)
        {
            SmallStep();
        }
    }

    private void SmallStep()
    {
        _touching.Clear();
        foreach (FineContact contact in _contacts)
        {
            if (contact.Find(_fastest * _step))
            {
                _touching.Add(contact);
            }
        }

        foreach (FineContact contact in _touching)
        {
            contact.Begin(_scene.BounceThreshold);
        }

        foreach (FineBody body in _scene.Bodies)
        {
            if (body.InverseMass > 0 && !body.HasNoWeight)
            {
                body.VelocityX += _step * _scene.Gravity.X;
                body.VelocityY += _step * _scene.Gravity.Y;
            }

            body.Slow(_step);
        }

        foreach (IFinePull pull in _scene.Pulls)
        {
            pull.Pull(_step);
        }

        int sweeps = _touching.Count + _scene.Hinges.Count > 0 ? Sweeps : 0;
        for (int sweep = 0; sweep < sweeps; sweep++)
        {
            foreach (FineHinge hinge in _scene.Hinges)
            {
                hinge.Solve(_step);
            }

            foreach (FineContact contact in _touching)
            {
                contact.Solve(_step);
            }
        }

        foreach (FineBody body in _scene.Bodies)
        {
            if (body.InverseMass > 0)
            {
                // The mean velocity of the small step where gravity alone acts; elsewhere the next gap takes the half square back.
                (double gx, double gy) = body.HasNoWeight ? default : _scene.Gravity;
                body.X += _step * (body.VelocityX - (_step * gx / 2));
                body.Y += _step * (body.VelocityY - (_step * gy / 2));
                body.Angle += _step * body.Spin;
            }
        }
    }
}
