using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>
/// How far two correct single-precision runs may drift apart by rounding alone. One addition rounds by
/// at most half an ulp; N independent ones walk away by about sqrt(N) ulps, so the tolerance is
/// (2 + sqrt(N)) ulps of the largest magnitude. Steady motion adds the same increment in each step of a recording, and half an ulp
/// is lost to the same side each time: it has 2 + N / 2. A contact point's place rounds by an ulp of the
/// position, which turns a body of half-width r by ulp / r: where bodies touch, a rotation has that
/// magnitude too, and an angular velocity that of the velocity over r.
/// </summary>
public sealed record FloatTolerance(double Position, double Rotation, double LinearVelocity, double AngularVelocity)
{
    public static FloatTolerance Of(SceneFile file, IEnumerable<Row[]> bodies)
    {
        List<Row> rows = bodies.SelectMany(r => r).Where(r => !r.IsAbsent).ToList();
        double position = Largest(rows, r => Math.Max(Math.Abs(r.X), Math.Abs(r.Y)));
        double rotation = Largest(rows, r => Math.Abs(r.Rotation));
        double velocity = Largest(rows, r => Math.Max(Math.Abs(r.VelocityX), Math.Abs(r.VelocityY)));
        double angular = Largest(rows, r => Math.Abs(r.AngularVelocity));

        // What pushes an overlap apart is a velocity too, though none that is recorded: all of the way may be gone in one step.
        if (SceneSizes.MayTouch(file) && file.Format == SceneFormat.Farseer)
        {
            velocity = Math.Max(velocity, Steps(file, bodies).DefaultIfEmpty(0).Max());
        }

        if (SceneSizes.MayTouch(file))
        {
            double halfWidth = SceneSizes.SmallestHalfWidth(file);
            rotation = Math.Max(rotation, position / halfWidth);
            angular = Math.Max(angular, velocity / halfWidth);
        }

        double ulps = 2 + Math.Sqrt((double)file.Steps * (file.Refined?.DtDivisor ?? 1));
        double steady = file.Refined is null && file.Format == SceneFormat.Farseer ? 2 + (file.Steps / 2.0) : ulps;
        return new FloatTolerance(Ulp(position) * steady, Ulp(rotation) * steady, Ulp(velocity) * steady, Ulp(angular) * steady);
    }

    /// <summary>The ways between the first two samples of each body, over a step: there an overlap is pushed apart.</summary>
    private static IEnumerable<double> Steps(SceneFile file, IEnumerable<Row[]> bodies) => bodies.Where(b => b.Length > 1)
        .Select(b => Math.Max(Math.Abs(b[1].X - b[0].X), Math.Abs(b[1].Y - b[0].Y)) / file.Dt);

    /// <summary>
    /// What joints make of the rounding of places: they turn a share of it into speed in each step, and a velocity below half an ulp
    /// of a place in
    /// a step moves nothing. It is due to a body that the refined run holds still, every place and angle the same to the last bit, by that
    /// run's steps; one that moves there has none of it. Where there is no refined run it is due to what is joined, by the recording's
    /// steps.
    /// </summary>
    public static Difference OfStanding(SceneFile file, Row[] rows)
    {
        bool isDue = file.Refined is null
            ? file.Format == SceneFormat.Farseer && (file.Joints.Count > 0 || Json.Items(file.Root, "paths").Any())
            : rows.All(r => r.X == rows[0].X && r.Y == rows[0].Y && r.Rotation == rows[0].Rotation);
        if (!isDue)
        {
            return default;
        }

        double step = file.Dt / (double)(file.Refined?.DtDivisor ?? 1);
        double place = Ulp(Math.Max(Math.Abs(rows[0].X), Math.Abs(rows[0].Y)));
        return new Difference(0, 0, place / 2 / step, Ulp(Math.Abs(rows[0].Rotation)) / 2 / step);
    }

    public static double Ulp(double magnitude) => magnitude == 0 ? 0 : MathF.BitIncrement((float)magnitude) - (float)magnitude;

    private static double Largest(List<Row> rows, Func<Row, double> value) => rows.Count == 0 ? 0 : rows.Max(value);
}

/// <summary>The lengths of a scene that tolerances depend on, read from its arguments.</summary>
public static class SceneSizes
{
    public static bool MayTouch(SceneFile file) => file.Geoms.Count > 1;

    public static double AllowedPenetration(SceneFile file) => file.RestDepth;

    public static double SmallestHalfWidth(SceneFile file)
        => file.Geoms.Select(g => HalfWidth(file, g)).Where(w => w > 0).DefaultIfEmpty(double.PositiveInfinity).Min();

    /// <summary>The radius of a circle, or 0.</summary>
    public static double Radius(MadeObject geom) =>
        Json.Optional(geom.Args, "radius") is { ValueKind: JsonValueKind.Number } e ? e.GetDouble() : 0;

    /// <summary>The longer half side of a box, or 0.</summary>
    public static double Largest(MadeObject geom)
        => new[] { "width", "height" }.Select(n => Json.Optional(geom.Args, n)).Where(e => e.ValueKind == JsonValueKind.Number)
            .Select(e => e.GetDouble() / 2).DefaultIfEmpty(0).Max();

    /// <summary>How far a polygon of a circle's edges stays inside the circle.</summary>
    public static double Sagitta(MadeObject geom)
    {
        JsonElement radius = Json.Optional(geom.Args, "radius");
        JsonElement edges = Json.Optional(geom.Args, "numberOfEdges");
        return radius.ValueKind == JsonValueKind.Number && edges.ValueKind == JsonValueKind.Number
            ? radius.GetDouble() * (1 - Math.Cos(Math.PI / edges.GetDouble()))
            : 0;
    }

    /// <summary>How long an edge of a circle's polygon is.</summary>
    public static double Edge(MadeObject geom) => Json.Optional(geom.Args, "numberOfEdges") is { ValueKind: JsonValueKind.Number } edges
        ? 2 * Radius(geom) * Math.Sin(Math.PI / edges.GetDouble())
        : 0;

    private static double HalfWidth(SceneFile file, MadeObject geom)
    {
        double Argument(string name) =>
            Json.Optional(geom.Args, name) is { ValueKind: JsonValueKind.Number } e ? e.GetDouble() : double.PositiveInfinity;
        double width = Math.Min(Argument("radius"), Math.Min(Argument("width"), Argument("height")) / 2);
        if (double.IsFinite(width))
        {
            return width;
        }

        JsonElement named = Json.Optional(geom.Args, "vertices");
        JsonElement points =
            named.ValueKind == JsonValueKind.String ? Json.Optional(Json.Optional(file.Root, "vertices"), named.GetString()!) : named;
        if (points.ValueKind != JsonValueKind.Array || points.GetArrayLength() == 0)
        {
            return 0;
        }

        double Extent(int axis) =>
            points.EnumerateArray().Max(p => p[axis].GetDouble()) - points.EnumerateArray().Min(p => p[axis].GetDouble());
        return Math.Min(Extent(0), Extent(1)) / 2;
    }
}
