using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Surveys;

/// <summary>One try of a survey: a small world whose outcome is known.</summary>
/// <param name="What">Its parameters, for people.</param>
/// <param name="Limit">The largest figure that is right.</param>
/// <param name="Measure">Plays the world and tells its figure: the larger, the worse; not a number if a body was lost.</param>
internal sealed record Variation(string What, double Limit, Func<double> Measure);

/// <summary>A kind of fault that was found once, asked about in many variations.</summary>
internal abstract class Survey
{
    /// <summary>
    /// Its word on the command line. What begins with a kind's word and goes on with a small letter is a part of that
    /// kind.
    /// </summary>
    public abstract string Name { get; }

    /// <summary>What the figure is and what it must not exceed.</summary>
    public abstract string What { get; }

    /// <summary>How many variations are drawn at random beside the grid unless the command line says otherwise.</summary>
    public abstract int Draws { get; }

    /// <summary>The input that was reported, then a grid of its parameters.</summary>
    public abstract IEnumerable<Variation> Grid();

    /// <summary>A variation at random.</summary>
    public abstract Variation Draw(Dice dice);

    /// <summary>The grid and so many random variations; the same for the same seed.</summary>
    public IEnumerable<Variation> Variations(uint seed, int? draws)
    {
        foreach (Variation variation in Grid())
        {
            yield return variation;
        }

        var dice = new Dice(seed, Name);
        for (int i = 0; i < (draws ?? Draws); i++)
        {
            yield return Draw(dice);
        }
    }

    public static IReadOnlyList<Survey> All { get; } =
    [
        new DragSurvey(), new FlashDragSurvey(), new PileSurvey(), new LandingSurvey(), new ImpactSurvey(), new EnergySurvey(),
        new FixedSlideSurvey(), new MotorMomentumSurvey(), new WheelSurvey(), new RopeSwingSurvey(),
        new TileLandingSurvey(), new PressedWalkSurvey(), new BendSurvey(), new CornerSurvey(),
        new ThinWallSurvey(), new HoleSurvey(), new SupportSurvey(), new FloatSurvey(),
        new ColumnSurvey(), new GrowingBounceSurvey(), new ChainBodySurvey(),
    ];
}
