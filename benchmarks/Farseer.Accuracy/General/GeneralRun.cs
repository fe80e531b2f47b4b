using System;
using System.Collections.Generic;
using System.IO;

namespace Farseer.Accuracy.General;

/// <summary>How the general scenes are run.</summary>
/// <param name="Dial">Iterations and step length; scenes that compare dials multiply it.</param>
/// <param name="Seed">Of the parameters that are drawn.</param>
/// <param name="IsFull">True: every scene in its stated length.</param>
/// <param name="Each">Where every sample is told; null: nowhere.</param>
internal sealed record GeneralSettings(Dial Dial, uint Seed, bool IsFull, TextWriter? Each)
{
    public static GeneralSettings Default { get; } = new(new Dial(Options.DefaultIterations, Options.DefaultDt), 1, false, null);
}

/// <summary>A figure of a scene as it came out.</summary>
internal sealed record Outcome(GeneralScene Scene, Figure Figure, double Value, string Parameters)
{
    public bool IsMet => Figure.IsMet(Value);
}

/// <summary>One run of one scene: draws parameters, makes worlds, keeps the worst of each figure.</summary>
internal sealed class GeneralRun
{
    private readonly GeneralScene _scene;
    private readonly GeneralSettings _settings;
    private readonly Dictionary<string, Outcome> _worst = [];

    private GeneralRun(GeneralScene scene, GeneralSettings settings)
    {
        _scene = scene;
        _settings = settings;
        Dice = new Dice(settings.Seed, scene.Id);
    }

    public Dial Dial => _settings.Dial;

    public bool IsFull => _settings.IsFull;

    public Dice Dice { get; }

    public static List<Outcome> Of(GeneralScene scene, GeneralSettings settings)
    {
        var run = new GeneralRun(scene, settings);
        scene.Play(run);
        var outcomes = new List<Outcome>();
        foreach (Figure figure in scene.Figures)
        {
            outcomes.Add(run._worst.TryGetValue(figure.Name, out Outcome? outcome)
                ? outcome
                : throw new InvalidOperationException($"{scene.Id} did not note {figure.Name}."));
        }

        return outcomes;
    }

    /// <summary>An empty world with the dial of the run, or with another.</summary>
    public Rig World(double gravity = 10, Dial? dial = null) => new(dial ?? Dial, gravity);

    /// <summary>A figure of a scene of the other catalogue.</summary>
    public double Published(string scene, double parameter, string metric, Dial dial)
    {
        SceneChoice choice = Options.ParseScene(FormattableString.Invariant($"{scene}={parameter:R}"));
        return Runner.Run(choice, dial, 1).Find(row => row.Metric == metric)!.Value;
    }

    /// <summary>Plays what belongs to one set of parameters; a world that explodes is the worst that can be, in every figure.</summary>
    public void Sample(string parameters, Action play)
    {
        try
        {
            play();
        }
        catch (ExplodedException)
        {
            foreach (Figure figure in _scene.Figures)
            {
                Keep(new Outcome(_scene, figure, figure.Worst, parameters + " exploded"));
            }
        }
    }

    /// <summary>A figure at one set of parameters.</summary>
    public void Note(string figure, double value, string parameters)
    {
        Figure known = Array.Find(_scene.Figures, one => one.Name == figure)
            ?? throw new InvalidOperationException($"{_scene.Id} has no figure {figure}.");
        Keep(new Outcome(_scene, known, double.IsFinite(value) ? value : known.Worst, parameters));
    }

    private void Keep(Outcome outcome)
    {
        _settings.Each?.WriteLine(FormattableString.Invariant(
            $"    {_scene.Id} {outcome.Figure.Name} {outcome.Value:G4} {outcome.Parameters}"));
        if (!_worst.TryGetValue(outcome.Figure.Name, out Outcome? before) || outcome.Figure.IsWorse(outcome.Value, before.Value))
        {
            _worst[outcome.Figure.Name] = outcome;
        }
    }
}
