using System;
using System.Collections.Generic;

namespace Farseer.Beside;

/// <summary>What became of a figure, the worst first.</summary>
internal enum Change
{
    /// <summary>Met before, missed after.</summary>
    Lost,

    /// <summary>Worse by more than a tenth.</summary>
    Worse,

    /// <summary>Missed before, met after.</summary>
    Gained,

    /// <summary>Better by more than a tenth.</summary>
    Better,

    /// <summary>Within a tenth.</summary>
    Same,
}

/// <summary>A figure in both builds.</summary>
internal sealed record FigurePair(Change Change, Figure Before, Figure After)
{
    /// <summary>How much worse: the difference as a share of the limit, or of the larger where zero is asked.</summary>
    public double Size
    {
        get
        {
            double difference = Math.Abs(After.Value - Before.Value);
            double unit = After.Limit != 0 ? Math.Abs(After.Limit) : Math.Max(Math.Abs(Before.Value), Math.Abs(After.Value));
            return difference / unit;
        }
    }
}

/// <summary>Sets the figures of two builds side by side.</summary>
internal sealed class FigureComparison
{
    /// <summary>Figures that differ by no more than this share of the larger are the same.</summary>
    private const double Tenth = 0.1;

    /// <summary>A difference below this share of the limit is rounding: zero and 1e-16 m are no news where 1e-6 m is asked.</summary>
    private const double Rounding = 1e-3;

    /// <summary>What chance exceeds, to one side, in one of forty comparisons.</summary>
    private const double Deviations = 2;

    private readonly List<FigurePair> _pairs = [];

    /// <param name="before">Of the earlier build.</param>
    /// <param name="after">Of the later one.</param>
    /// <param name="areDraws">They are draws of chaotic worlds: where a build has other bits, each is another draw.</param>
    public FigureComparison(IReadOnlyList<Figure> before, IReadOnlyList<Figure> after, bool areDraws = false)
    {
        Dictionary<string, Figure> known = ByName(before);
        (MetBefore, MissedBefore) = Count(before);
        (MetAfter, MissedAfter) = Count(after);
        foreach ((string name, Figure figure) in ByName(after))
        {
            if (known.Remove(name, out Figure? earlier))
            {
                _pairs.Add(new FigurePair(Judge(earlier, figure), earlier, figure));
            }
            else
            {
                New++;
            }
        }

        Gone = [.. known.Values];
        int lost = Of(Change.Lost).Count;
        int gained = Of(Change.Gained).Count;
        HasLost = areDraws ? lost - gained > Deviations * Math.Sqrt(lost + gained) : lost > 0;
    }

    /// <summary>
    /// Something is lost. Of draws some are lost and some gained by chance, and either is as likely if both builds are as good: the
    /// difference of the two numbers then has the root of their sum as its standard deviation.
    /// </summary>
    public bool HasLost { get; }

    public int MetBefore { get; }

    public int MissedBefore { get; }

    public int MetAfter { get; }

    public int MissedAfter { get; }

    /// <summary>Figures that the later build does not have.</summary>
    public IReadOnlyList<Figure> Gone { get; }

    /// <summary>How many figures the earlier build does not have.</summary>
    public int New { get; }

    /// <summary>The figures of one kind of change, the largest first.</summary>
    public List<FigurePair> Of(Change change)
    {
        List<FigurePair> pairs = _pairs.FindAll(pair => pair.Change == change);
        pairs.Sort((a, b) => b.Size.CompareTo(a.Size));
        return pairs;
    }

    /// <summary>Each build is held against its own limit: some limits are figures of the same build themselves.</summary>
    private static Change Judge(Figure before, Figure after)
    {
        if (before.IsMet != after.IsMet)
        {
            return after.IsMet ? Change.Gained : Change.Lost;
        }

        if (before.Value == after.Value)
        {
            return Change.Same;
        }

        double difference = Math.Abs(after.Value - before.Value);
        bool isSmall = difference <= Tenth * Math.Max(Math.Abs(before.Value), Math.Abs(after.Value))
            || difference <= Rounding * Math.Abs(after.Limit);
        return isSmall && double.IsFinite(difference) ? Change.Same : after.IsWorseThan(before) ? Change.Worse : Change.Better;
    }

    /// <summary>A name that comes again gets a number, so that no figure hides another one.</summary>
    private static Dictionary<string, Figure> ByName(IReadOnlyList<Figure> figures)
    {
        var named = new Dictionary<string, Figure>();
        foreach (Figure figure in figures)
        {
            string name = figure.Name;
            for (int i = 2; !named.TryAdd(name, figure with { Name = name }); i++)
            {
                name = FormattableString.Invariant($"{figure.Name} ({i})");
            }
        }

        return named;
    }

    private static (int Met, int Missed) Count(IReadOnlyList<Figure> figures)
    {
        int met = 0;
        foreach (Figure figure in figures)
        {
            met += figure.IsMet ? 1 : 0;
        }

        return (met, figures.Count - met);
    }
}
