using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Farseer.Fidelity.Flash;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>
/// Judges the trajectory: against <c>refined</c> within the original's own error, or, where there is
/// none, against the recording within the method's spread and the integrator's error. Where the equations of motion are the
/// reference, the limit is the original's own error against them, as <see cref="OwnError"/> says.
/// </summary>
public static class RowJudge
{
    /// <summary>The files give the original's own error with four digits: it may be half of the last one more.</summary>
    private const double WrittenDigits = 1.0005;

    private const double LeastWays = 2;

    private static readonly string[] Names = ["position", "rotation", "linearVelocity", "angularVelocity"];

    public static IEnumerable<Check> Judge(
        SceneFile file, int iterations, Recording ours, IReadOnlyDictionary<string, Row[]>? motion = null)
    {
        IReadOnlyDictionary<string, Row[]> reference = motion ?? file.Refined?.Rows ?? file.Recordings[iterations].Rows;
        if (reference.Count == 0)
        {
            return [];
        }

        // Without a refined run the recordings at 5 and at 100 iterations are the two ends of the method's
        // spread: what counts is the distance to the nearer one.
        List<IReadOnlyDictionary<string, Row[]>> references = file.Refined is null && motion is null
            ? file.Recordings.Values.Select(r => r.Rows).ToList()
            : [reference];
        FloatTolerance rounding = FloatTolerance.Of(file, reference.Values);
        Difference? own = motion is null ? file.Refined?.FromRecorded : OwnError(file, iterations, motion);
        FlashExemptions? exempt = file.Format == SceneFormat.Box2DFlash ? new(file) : null;
        Worst[] worst = [new(), new(), new(), new()];
        foreach ((string body, Row[] expected) in reference)
        {
            if (exempt?.HoldsMotion(body) is true)
            {
                continue;
            }

            Impacts impacts = new(file, expected, rounding);
            Difference standing = FloatTolerance.OfStanding(file, expected);
            Discretisation? discretisation = own is null ? new Discretisation(file, expected, impacts) : null;
            for (int k = 0; k < expected.Length; k++)
            {
                Row got = ours.Rows[body][k];
                if (got.IsAbsent || expected[k].IsAbsent)
                {
                    string which = body + (got.IsAbsent ? " is not there" : " is there") + " after "
                        + file.SampleSteps[k].ToString(CultureInfo.InvariantCulture);
                    worst[0].Take(got.IsAbsent == expected[k].IsAbsent ? 0 : double.PositiveInfinity, 0, which);
                    continue;
                }

                Difference error = references.Select(r => Errors(got, r[body], impacts, k)).Aggregate(Smaller);
                Difference settling = file.Format == SceneFormat.Farseer
                    ? Settling.At(file, file.SampleSteps[k])
                    : Settling.AfterTouch(file, iterations, expected, impacts, k);
                Difference limit = Limits(file, own, rounding, discretisation?.At(k), settling);
                if (file.Format == SceneFormat.Box2DFlash)
                {
                    limit = FlashSlops.Add(file, iterations, body, expected, k, limit);
                }

                string where = body + " after " + file.SampleSteps[k].ToString(CultureInfo.InvariantCulture);
                worst[0].Take(error.Position, limit.Position, where);
                worst[1].Take(error.Rotation, limit.Rotation, where);
                worst[2].Take(error.LinearVelocity, limit.LinearVelocity + standing.LinearVelocity, where);
                worst[3].Take(error.AngularVelocity, limit.AngularVelocity + standing.AngularVelocity, where);
            }
        }

        List<Check> checks = [];
        for (int i = 0; i < Names.Length; i++)
        {
            checks.Add(worst[i].ToCheck(Names[i]));
        }

        return checks;
    }

    /// <summary>The limits that do not depend on the row: what a query after the run may be off by.</summary>
    public static Difference LargestLimits(SceneFile file, int iterations)
    {
        IReadOnlyDictionary<string, Row[]> reference = file.Refined?.Rows ?? file.Recordings[iterations].Rows;
        FloatTolerance rounding = FloatTolerance.Of(file, reference.Values);
        Difference largest = Limits(file, file.Refined?.FromRecorded, rounding, null, default);
        if (file.Refined is null)
        {
            foreach (Row[] rows in reference.Values)
            {
                Difference own = Limits(
                    file, null, rounding, new Discretisation(file, rows, new Impacts(file, rows, rounding)).At(rows.Length - 1), default);
                largest = Larger(largest, own);
            }
        }

        return largest;
    }

    /// <summary>
    /// The original's largest error against the equations of motion, over all bodies as where the file gives it: which of them is
    /// farthest off
    /// is chance, as two that whirl on springs show. A body that the original leads another way altogether (it passes through what it
    /// should hit) is left out: by more than half of its way, or of its turn where it stays, is no error of a path.
    /// </summary>
    public static Difference OwnError(SceneFile file, int iterations, IReadOnlyDictionary<string, Row[]> motion)
    {
        FloatTolerance rounding = FloatTolerance.Of(file, motion.Values);
        Difference largest = default;
        foreach ((string body, Row[] rows) in motion)
        {
            Row[] recorded = file.Recordings[iterations].Rows[body];
            Impacts impacts = new(file, rows, rounding);
            int[] both = [.. Enumerable.Range(0, rows.Length).Where(k => !recorded[k].IsAbsent && !rows[k].IsAbsent)];
            Difference own = both.Select(k => Errors(recorded[k], rows, impacts, k)).Aggregate(default(Difference), Larger);
            double way = both.Select(k => Way(rows[both[0]], rows[k])).DefaultIfEmpty(0).Max();
            double turn = both.Select(k => Math.Abs(rows[k].Rotation - rows[both[0]].Rotation)).DefaultIfEmpty(0).Max();
            if (own.Position > Math.Max(file.RestDepth, way / LeastWays) || (way == 0 && own.Rotation > turn / LeastWays))
            {
                continue;
            }

            if (file.Format == SceneFormat.Box2DFlash)
            {
                // Whole turns ahead or behind count: such a body may stand at any angle.
                own = own with { Rotation = both.Select(k => Math.Abs(recorded[k].Rotation - rows[k].Rotation)).DefaultIfEmpty(0).Max() };
            }

            largest = Larger(largest, own);
        }

        return largest;
    }

    private static double Way(Row a, Row b) => Math.Sqrt(((a.X - b.X) * (a.X - b.X)) + ((a.Y - b.Y) * (a.Y - b.Y)));

    private static Difference Limits(
        SceneFile file, Difference? error, FloatTolerance rounding, Difference? discretisation, Difference settling)
    {
        // A contact rests AT AllowedPenetration here, anywhere between 0 and it in the original.
        double depth = SceneSizes.MayTouch(file) ? SceneSizes.AllowedPenetration(file) : 0;
        if (error is { } own)
        {
            return new Difference(
                (own.Position * WrittenDigits) + rounding.Position + depth,
                (own.Rotation * WrittenDigits) + rounding.Rotation + settling.Rotation,
                (own.LinearVelocity * WrittenDigits) + rounding.LinearVelocity + settling.LinearVelocity,
                (own.AngularVelocity * WrittenDigits) + rounding.AngularVelocity + settling.AngularVelocity);
        }

        Difference spread = file.Spread ?? default;
        Difference integrator = discretisation ?? default;
        return new Difference(
            spread.Position + (file.Growth * integrator.Position) + rounding.Position + depth,
            spread.Rotation + (file.Growth * integrator.Rotation) + rounding.Rotation + settling.Rotation,
            spread.LinearVelocity + (file.Growth * integrator.LinearVelocity) + rounding.LinearVelocity + settling.LinearVelocity,
            spread.AngularVelocity + (file.Growth * integrator.AngularVelocity) + rounding.AngularVelocity + settling.AngularVelocity);
    }

    /// <summary>
    /// The differences of one row. Beside an impact the moment decides which velocity a sample shows, so
    /// there a velocity may be any between those of the rows around the impact.
    /// </summary>
    private static Difference Errors(Row got, Row[] expected, Impacts impacts, int k)
    {
        Row wanted = expected[k];
        double position = Way(got, wanted);
        double turn = Math.Abs(got.Rotation - wanted.Rotation) % (2 * Math.PI);
        double linear = Discretisation.Speed(got, wanted);
        double angular = Math.Abs(got.AngularVelocity - wanted.AngularVelocity);
        foreach (int before in new[] { k - 1, k })
        {
            if (impacts.Between(before))
            {
                Row from = expected[before];
                Row to = expected[before + 1];
                linear = Math.Min(linear, ToSegment(got, from, to));
                double low = Math.Min(from.AngularVelocity, to.AngularVelocity);
                double high = Math.Max(from.AngularVelocity, to.AngularVelocity);
                angular = Math.Min(angular, Math.Max(0, Math.Max(low - got.AngularVelocity, got.AngularVelocity - high)));
            }
        }

        return new Difference(position, Math.Min(turn, (2 * Math.PI) - turn), linear, angular);
    }

    private static Difference Larger(Difference a, Difference b) => new(
        Math.Max(a.Position, b.Position),
        Math.Max(a.Rotation, b.Rotation),
        Math.Max(a.LinearVelocity, b.LinearVelocity),
        Math.Max(a.AngularVelocity, b.AngularVelocity));

    private static Difference Smaller(Difference a, Difference b) => new(
        Math.Min(a.Position, b.Position),
        Math.Min(a.Rotation, b.Rotation),
        Math.Min(a.LinearVelocity, b.LinearVelocity),
        Math.Min(a.AngularVelocity, b.AngularVelocity));

    private static double ToSegment(Row got, Row from, Row to)
    {
        double dx = to.VelocityX - from.VelocityX;
        double dy = to.VelocityY - from.VelocityY;
        double length = (dx * dx) + (dy * dy);
        double along = length == 0 ? 0 : (((got.VelocityX - from.VelocityX) * dx) + ((got.VelocityY - from.VelocityY) * dy)) / length;
        along = Math.Clamp(along, 0, 1);
        double x = got.VelocityX - from.VelocityX - (along * dx);
        double y = got.VelocityY - from.VelocityY - (along * dy);
        return Math.Sqrt((x * x) + (y * y));
    }
}

/// <summary>Keeps the comparison that is worst against its limit.</summary>
public sealed class Worst
{
    private double _share = -1;
    private Check _check = new(string.Empty, 0, 0, string.Empty);

    public void Take(double error, double limit, string where)
    {
        double share = double.IsFinite(error) ? (limit > 0 ? error / limit : error == 0 ? 0 : double.MaxValue) : double.PositiveInfinity;
        if (share > _share)
        {
            _share = share;
            _check = new Check(string.Empty, double.IsFinite(error) ? error : double.MaxValue, limit, where);
        }
    }

    public Check ToCheck(string what) => _check with { What = what };
}
