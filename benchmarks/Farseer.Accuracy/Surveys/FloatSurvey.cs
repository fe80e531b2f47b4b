using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>What floats displaces its own weight, however few corners it has.</summary>
internal sealed class FloatSurvey : Survey
{
    private const double Limit = 0.02;

    private static readonly string[] _shapes = ["plank", "box", "triangle", "pentagon", "ball"];

    public override string Name => "K15";

    public override string What =>
        "floating bodies at rest: share under the surface less density, at the most in the last 2 of 40 s; at most 0.02";

    public override int Draws => 110;

    public override IEnumerable<Variation> Grid()
    {
        foreach (string shape in _shapes)
        {
            foreach (float density in (float[])[0.1f, 0.25f, 0.4f, 0.5f, 0.75f, 0.9f])
            {
                yield return Float(shape, density, 1, 1, 0);
                yield return Float(shape, density, 1, 1, 0.4f);
                yield return Float(shape, density, 0.3f, 1, 0.4f);
            }
        }
    }

    public override Variation Draw(Dice dice) => Float(
        dice.Of(_shapes), dice.Between(0.05, 0.95), dice.Wide(0.2, 5), dice.Wide(0.2, 20), dice.Between(-3, 3));

    private static Variation Float(string shape, float density, float size, float fluid, float turn) => new(
        FormattableString.Invariant($"{shape} of {size} m and {density} of the density of a fluid of {fluid}, turned by {turn}"),
        Limit,
        () => Play(shape, density, size, fluid, turn));

    private static double Play(string shape, float density, float size, float fluid, float turn)
    {
        using var yard = new Yard(0.001f * size);
        Body body = shape switch
        {
            "plank" => yard.Box(0, 0.5f * size, 2 * size, 0.5f * size),
            "box" => yard.Box(0, 0.5f * size, size, size),
            "triangle" => yard.Regular(0, 0.5f * size, 3, size),
            "pentagon" => yard.Regular(0, 0.5f * size, 5, size),
            _ => yard.Ball(0, 0.5f * size, 0.5f * size),
        };
        yard.Step();
        Geom geom = yard.Simulator.GeomList[0];
        float mass = density * fluid * geom.WorldVertices.GetArea();
        body.MomentOfInertia *= mass / body.Mass;
        body.Mass = mass;
        body.Rotation = turn;
        var sea = new FluidDragController();

        // So much drag that one with a twentieth of itself in the fluid rests in time.
        var water = new AABBFluidContainer(new AABB(new Vector2(-1000, -1000), new Vector2(1000, 0)));
        sea.Initialize(water, fluid, 20 / (size * fluid), 2 * size * size, new Vector2(0, -10));
        sea.AddGeom(geom);
        yard.Simulator.Add(sea);
        yard.Steps(2280);
        double worst = 0;
        yard.Steps(120, after: () =>
        {
            double under = AreaUnder(geom.WorldVertices) / geom.WorldVertices.GetArea();
            worst = Math.Max(worst, Math.Abs(under - density));
        });
        return yard.Figure(worst);
    }

    /// <summary>The area of an outline below the level 0: its edges are cut there.</summary>
    private static double AreaUnder(Vertices outline)
    {
        double area = 0;
        for (int i = 0; i < outline.Count; i++)
        {
            Vector2 a = outline[i];
            Vector2 b = outline[(i + 1) % outline.Count];

            // Of the trapezium between an edge and the level only what is below counts.
            double low = Math.Min(a.Y, b.Y);
            double high = Math.Max(a.Y, b.Y);
            if (low < 0)
            {
                double share = high <= 0 ? 1 : low / (low - high);
                double mean = high <= 0 ? (low + high) / 2 : low / 2;
                area += (b.X - (double)a.X) * share * mean;
            }
        }

        return Math.Abs(area);
    }
}
