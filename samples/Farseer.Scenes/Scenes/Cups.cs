using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes;

/// <summary>U-shaped bodies: a ball in a cup in a cup, and a cup turned over a post.</summary>
public sealed class Cups : Scene
{
    private const float Radius = 0.4f;
    private const float Post = 3f;
    private const float CapX = 5f;
    private Geom? _outer;
    private Geom? _inner;
    private Geom? _ball;
    private Geom? _cap;

    public override string Name => "cups";

    public override string Title => "U-shapes";

    public override string Description => "A ball falls into a cup that falls into a cup, and a cup hangs on a post: hollows are hollow.";

    public override int Steps => 480;

    public override SceneView View => new(new Vector2(-6f, -1f), new Vector2(9f, 8f));

    private static Cup Outer => new(4f, 3f, 0.5f);

    private static Cup Inner => new(2.4f, 2f, 0.4f);

    private static Cup Cap => new(2f, 2f, 0.5f);

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 30f);
        _outer = Place(simulator, Outer, new Vector2(0f, 0.3f), upsideDown: false);
        _inner = Place(simulator, Inner, new Vector2(0f, 3.6f), upsideDown: false);
        _ball = Make.Circle(simulator, new Vector2(0f, 7f), Radius);
        Make.Wall(simulator, new Vector2(CapX, 0.5f * Post), 0.8f, Post);
        _cap = Place(simulator, Cap, new Vector2(CapX, Post + 0.8f), upsideDown: true);
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double innerFloor = Outer.Wall;
        double ballFloor = innerFloor + Inner.Wall;

        // A contact may rest a fifth of its resting depth off; the ball stands on three of them.
        const double Limit = 0.2 * 3 * Make.Tolerance;
        return
        [
            SceneOutcome.Error("height of the outer cup (m)", _outer!.Body.Position.Y, Outer.CentroidHeight, Limit),
            SceneOutcome.Error("height of the inner cup (m)", _inner!.Body.Position.Y, innerFloor + Inner.CentroidHeight, Limit),
            SceneOutcome.Error("height of the ball (m)", _ball!.Body.Position.Y, ballFloor + Radius, Limit),
            SceneOutcome.Error("height of the cup on the post (m)", _cap!.Body.Position.Y, Post + Cap.Wall - Cap.CentroidHeight, Limit),
            SceneOutcome.AtMost("tilt of the cup on the post (rad)", Math.Abs(Measure.Angle(_cap.Body)), 0.01),
            SceneOutcome.AtMost("fastest point at the end (m/s)", Measure.FastestSpeed([_outer, _inner, _ball, _cap]), 5e-3),
        ];
    }

    /// <summary>Puts the lowest point of the cup at <paramref name="foot"/>.</summary>
    private static Geom Place(PhysicsSimulator simulator, Cup cup, Vector2 foot, bool upsideDown)
    {
        Vector2[] outline = cup.Outline();
        float centroid = cup.CentroidHeight;
        if (upsideDown)
        {
            centroid = cup.Height - centroid;
            for (int i = 0; i < outline.Length; i++)
            {
                // Half a turn, so that the order of the outline stays what it was.
                outline[i] = -outline[i];
            }
        }

        return Make.Polygon(simulator, foot + new Vector2(0f, centroid), outline, cup.Area);
    }

    /// <summary>A U with walls and floor of the same thickness; the origin is the middle of its underside.</summary>
    private readonly record struct Cup(float Width, float Height, float Wall)
    {
        public float Area => (Width * Height) - Hollow;

        /// <summary>Of the rectangle, less the hollow.</summary>
        public float CentroidHeight => ((Width * Height * 0.5f * Height) - (Hollow * 0.5f * (Height + Wall))) / Area;

        private float Hollow => (Width - (2f * Wall)) * (Height - Wall);

        public Vector2[] Outline()
        {
            float half = 0.5f * Width;
            float inside = half - Wall;
            return
            [
                new(-half, 0f), new(half, 0f), new(half, Height), new(inside, Height),
                new(inside, Wall), new(-inside, Wall), new(-inside, Height), new(-half, Height),
            ];
        }
    }
}
