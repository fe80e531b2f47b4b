using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>
/// Judges the trajectory: against <c>refined</c> within the original's own error, or, where there is
/// none, against the recording within the method's spread and the integrator's error.
/// </summary>
public static class RowJudge
{
    /// <summary>The files give the original's own error with four digits: it may be half of the last one more.</summary>
    private const double WrittenDigits = 1.0005;

    private static readonly string[] Names = ["position", "rotation", "linearVelocity", "angularVelocity"];

    public static IEnumerable<Check> Judge(SceneFile file, int iterations, Recording ours, Func<string, double, Row>? closedForm)
    {
        IReadOnlyDictionary<string, Row[]> reference = file.Refined?.Rows ?? file.Recordings[iterations].Rows;
        if (reference.Count == 0)
        {
            return [];
        }

        if (closedForm is not null)
        {
            reference = reference.Keys.ToDictionary(b => b, b => file.SampleSteps.Select(s => closedForm(b, s * (double)file.Dt)).ToArray());
        }

        FloatTolerance rounding = FloatTolerance.Of(file, reference.Values);
        Worst[] worst = [new(), new(), new(), new()];
        foreach ((string body, Row[] expected) in reference)
        {
            Impacts impacts = new(file, expected, rounding);
            Discretisation? discretisation = file.Refined is null ? new Discretisation(file, expected, impacts) : null;
            for (int k = 0; k < expected.Length; k++)
            {
                Row got = ours.Rows[body][k];
                Difference error = Errors(got, expected, impacts, k);
                Difference limit = Limits(file, rounding, discretisation?.At(k));
                string where = body + " after " + file.SampleSteps[k].ToString(CultureInfo.InvariantCulture);
                worst[0].Take(error.Position, limit.Position, where);
                worst[1].Take(error.Rotation, limit.Rotation, where);
                worst[2].Take(error.LinearVelocity, limit.LinearVelocity, where);
                worst[3].Take(error.AngularVelocity, limit.AngularVelocity, where);
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
        Difference largest = Limits(file, rounding, new Difference(0, 0, 0, 0));
        if (file.Refined is null)
        {
            foreach (Row[] rows in reference.Values)
            {
                Difference own = Limits(file, rounding, new Discretisation(file, rows, new Impacts(file, rows, rounding)).At(rows.Length - 1));
                largest = new Difference(
                    Math.Max(largest.Position, own.Position),
                    Math.Max(largest.Rotation, own.Rotation),
                    Math.Max(largest.LinearVelocity, own.LinearVelocity),
                    Math.Max(largest.AngularVelocity, own.AngularVelocity));
            }
        }

        return largest;
    }

    private static Difference Limits(SceneFile file, FloatTolerance rounding, Difference? discretisation)
    {
        // A contact rests AT AllowedPenetration here, anywhere between 0 and it in the original.
        double depth = SceneSizes.MayTouch(file) ? SceneSizes.AllowedPenetration(file) : 0;
        if (file.Refined is { } refined)
        {
            Difference own = refined.FromRecorded;
            return new Difference(
                (own.Position * WrittenDigits) + rounding.Position + depth,
                (own.Rotation * WrittenDigits) + rounding.Rotation,
                (own.LinearVelocity * WrittenDigits) + rounding.LinearVelocity,
                (own.AngularVelocity * WrittenDigits) + rounding.AngularVelocity);
        }

        Difference spread = file.Spread ?? default;
        Difference integrator = discretisation ?? default;
        return new Difference(
            spread.Position + (file.Growth * integrator.Position) + rounding.Position + depth,
            spread.Rotation + (file.Growth * integrator.Rotation) + rounding.Rotation,
            spread.LinearVelocity + (file.Growth * integrator.LinearVelocity) + rounding.LinearVelocity,
            spread.AngularVelocity + (file.Growth * integrator.AngularVelocity) + rounding.AngularVelocity);
    }

    /// <summary>
    /// The differences of one row. Beside an impact the moment decides which velocity a sample shows, so
    /// there a velocity may be any between those of the rows around the impact.
    /// </summary>
    private static Difference Errors(Row got, Row[] expected, Impacts impacts, int k)
    {
        Row wanted = expected[k];
        double position = Math.Sqrt(((got.X - wanted.X) * (got.X - wanted.X)) + ((got.Y - wanted.Y) * (got.Y - wanted.Y)));
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
