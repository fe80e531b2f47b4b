using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Numerics;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>
/// Walks along the smooth curve through the control points of a path and finds the places of its links: the first half a width from
/// the start, each next one a width from the one before, as the crow flies.
/// </summary>
internal sealed class PathWalk
{
    /// <summary>The curve runs from 0 to 1; version 2.0.1 walked it in 2,000 steps.</summary>
    private const float Stride = 0.0005f;

    /// <summary>Halvings of a stride: one part in 2^24 of it is below the rounding of the parameter.</summary>
    private const int Halvings = 24;

    private readonly Vertices _points;
    private readonly float _width;
    private readonly Curve _x = new Curve();
    private readonly Curve _y = new Curve();
    private readonly int _most;
    private readonly bool _uprightLiesAcross;

    private PathWalk(Vertices points, float width, int most, bool uprightLiesAcross)
    {
        _uprightLiesAcross = uprightLiesAcross;
        _points = points;
        _width = width;
        _most = most;
        float increment = 1f / points.Count;
        for (int i = 0; i < points.Count; i++)
        {
            float k = increment * (i + 1);
            _x.Keys.Add(new CurveKey(k, points[i].X));
            _y.Keys.Add(new CurveKey(k, points[i].Y));
        }

        _x.ComputeTangents(CurveTangent.Smooth);
        _y.ComputeTangents(CurveTangent.Smooth);
    }

    /// <summary>Centre and angle of each link.</summary>
    public List<(Vector2 Position, float Rotation)> Links { get; } = new List<(Vector2 Position, float Rotation)>();

    /// <summary>Where the last search along the curve ended.</summary>
    public Vector2 End { get; private set; }

    /// <summary>
    /// The links as version 2.0.1 placed them if those are as many as fit, otherwise at their exact distance: whole strides lose a
    /// tenth of the links of a rope of 100. More than <paramref name="most"/> are not looked for. Empty if the curve never gets half a
    /// width away from its start.
    /// </summary>
    public static PathWalk Along(Vertices points, float width, int most, bool uprightLiesAcross)
    {
        var exact = new PathWalk(points, width, most, uprightLiesAcross);
        exact.Walk(true);
        var coarse = new PathWalk(points, width, most, uprightLiesAcross);
        coarse.Walk(false);
        return coarse.Links.Count == exact.Links.Count ? coarse : exact;
    }

    private void Walk(bool exactly)
    {
        float k = 0;
        Vector2 before = _points[0];
        if (!Advance(ref k, before, _width / 2, exactly, out Vector2 place))
        {
            return;
        }

        // The direction of the first link comes from a point a width from the START; that of the others from one a width ahead.
        Advance(ref k, before, _width, exactly, out Vector2 ahead);
        End = ahead;
        Links.Add((place, Angle(before, ahead)));
        before = place;
        while (k < 1 && Links.Count < _most)
        {
            Advance(ref k, before, _width, exactly, out place);
            float here = k;
            if (k < 1)
            {
                Advance(ref k, place, _width, exactly, out ahead);
                End = ahead;
            }

            Links.Add((place, Angle(before, ahead)));
            before = place;
            if (exactly && k < 1)
            {
                // Version 2.0.1 went on from the point ahead, a stride too far; the next link belongs exactly there.
                k = here;
            }
        }
    }

    /// <summary>
    /// The angle of the way from the link before to the point ahead. It is kept between -90 and 90 degrees, as the original's: where
    /// the curve goes to the left, a link faces backwards.
    /// </summary>
    private float Angle(Vector2 before, Vector2 ahead)
    {
        Vector2 along = ahead - before;
        if (_uprightLiesAcross && along.X == 0)
        {
            return 0;
        }

        return along.X < 0 ? (float)StableMath.Atan2(-along.Y, -along.X) : (float)StableMath.Atan2(along.Y, along.X);
    }

    /// <summary>
    /// Goes on until the straight distance from a point is reached, or to the end of the curve: then false, and the end is the place.
    /// </summary>
    private bool Advance(ref float k, Vector2 from, float distance, bool exactly, out Vector2 place)
    {
        while (true)
        {
            float last = k;
            k += Stride;
            place = At(k);
            if (!(Vector2.Distance(from, place) < distance))
            {
                if (exactly)
                {
                    Refine(last, ref k, from, distance, ref place);
                }

                return true;
            }

            if (k >= 1)
            {
                return false;
            }
        }
    }

    private void Refine(float low, ref float high, Vector2 from, float distance, ref Vector2 place)
    {
        for (int i = 0; i < Halvings; i++)
        {
            float middle = 0.5f * (low + high);
            Vector2 there = At(middle);
            if (Vector2.Distance(from, there) < distance)
            {
                low = middle;
            }
            else
            {
                high = middle;
                place = there;
            }
        }
    }

    private Vector2 At(float k) => new Vector2(_x.Evaluate(k), _y.Evaluate(k));
}
