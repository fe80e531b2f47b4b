using System;
using System.Collections.Generic;
using System.Linq;

namespace Farseer.Accuracy.Dials;

/// <summary>A kind of scene, and the error by which its user would judge it.</summary>
/// <param name="Name">One word, of which the plot has its name.</param>
/// <param name="Title">What it is, for people.</param>
/// <param name="Error">Which error is told, with its unit.</param>
/// <param name="Scene">What is run.</param>
/// <param name="Parameters">Each a sample; the error is their median.</param>
/// <param name="Metrics">One metric that is an error; or coordinates, held against a run with far more substeps.</param>
/// <param name="Failure">The error with which the scene has failed, in the unit of the metric; plots give shares of it.</param>
/// <param name="Rounding">Errors below are rounding of floats or chance: no dial is asked to lessen them.</param>
/// <param name="Advice">What to do, in a sentence.</param>
internal sealed record DialKind(
    string Name,
    string Title,
    string Error,
    SceneInfo Scene,
    double[] Parameters,
    string[] Metrics,
    double Failure,
    double Rounding,
    string Advice)
{
    /// <summary>What a figure of the metric is in the unit that is told; 1 but where the metric has another.</summary>
    public double Unit { get; init; } = 1;

    /// <summary>Coordinates have no meaning but against a reference.</summary>
    public bool IsAgainstReference => Metrics.Length > 1;

    /// <summary>The samples, ready to run.</summary>
    public IEnumerable<SceneChoice> Choices =>
        Parameters.Select(p => new SceneChoice(Scene, p, FormattableString.Invariant($"{Scene.Name}={p:R}")));
}
