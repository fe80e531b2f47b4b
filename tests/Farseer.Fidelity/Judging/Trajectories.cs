using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Fine;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>
/// Judges how the bodies of a scene move. Two things may be followed, each no less closely than the original's recording does: what the
/// original's own model converges to, and the equations of motion. They differ where the original's model is something else than the
/// scene (its circles are polygons, its steps decide when something breaks or bounces), so what does not fit the first is judged by
/// the second, if they know all that the scene holds.
/// </summary>
public sealed class Trajectories
{
    private readonly SceneFile _file;
    private readonly Lazy<IReadOnlyDictionary<string, Row[]>?> _motion;

    public Trajectories(SceneFile file)
    {
        _file = file;
        _motion = new(() => file.Steps > 0 ? FineMotion.Run(file) : null);
    }

    /// <summary>What the equations of motion give, once a run was judged by them; otherwise null.</summary>
    public IReadOnlyDictionary<string, Row[]>? Motion { get; private set; }

    public IReadOnlyList<Check> Judge(int iterations, Recording ours)
    {
        Check[] checks = [.. RowJudge.Judge(_file, iterations, ours)];
        if (checks.All(c => c.Passed) || _motion.Value is not { } motion)
        {
            return checks;
        }

        Check[] truer = [.. RowJudge.Judge(_file, iterations, ours, motion)];
        if (!truer.All(c => c.Passed))
        {
            return checks;
        }

        Motion = motion;
        return truer;
    }
}
