using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Extremes;

/// <summary>Runs of the catalogue and of worlds of their own, judged by yes or no.</summary>
internal static class Probe
{
    private static readonly Dictionary<(string Scene, double Parameter), IReadOnlyList<(string Name, double Value)>> _done = [];

    /// <summary>The figure of a scene, or infinity if it exploded. A scene runs once for all its figures.</summary>
    public static double Figure(string scene, double parameter, string metric)
    {
        if (!_done.TryGetValue((scene, parameter), out IReadOnlyList<(string Name, double Value)>? metrics))
        {
            metrics = Play(scene, parameter);
            _done.Add((scene, parameter), metrics);
        }

        foreach ((string name, double value) in metrics)
        {
            if (name == metric)
            {
                return value;
            }
        }

        return double.PositiveInfinity;
    }

    private static IReadOnlyList<(string Name, double Value)> Play(string scene, double parameter)
    {
        SceneInfo info = Catalogue.Find(scene) ?? throw new ArgumentException($"no scene is called {scene}", nameof(scene));
        var trial = new Trial(parameter, new Dial(Options.DefaultIterations, Options.DefaultDt));
        try
        {
            info.Play(trial);
        }
        catch (ExplodedException)
        {
            return [];
        }

        return trial.Metrics;
    }

    /// <summary>Plays a world; false if it exploded.</summary>
    public static bool World(Func<Rig, bool> play, double gravity = 10, double dt = Options.DefaultDt)
    {
        using var rig = new Rig(new Dial(Options.DefaultIterations, dt), gravity);
        try
        {
            return play(rig);
        }
        catch (ExplodedException)
        {
            return false;
        }
    }

    /// <summary>A stack of boxes of 1 m on a ground.</summary>
    public static List<Actor> Stack(Rig rig, int n, double mass = 1)
    {
        rig.AddGround();
        var boxes = new List<Actor>();
        for (int i = 0; i < n; i++)
        {
            boxes.Add(rig.AddBox(0, 0.5 + i, 1, 1, density: mass));
        }

        return boxes;
    }

    /// <summary>The largest displacement of a body since the start is at most this.</summary>
    public static bool Stayed(IEnumerable<Actor> actors, double limit)
    {
        foreach (Actor actor in actors)
        {
            if (!(actor.Displacement.Length <= limit))
            {
                return false;
            }
        }

        return true;
    }
}
