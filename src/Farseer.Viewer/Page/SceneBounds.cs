using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Viewer.Recording;

namespace FarseerGames.FarseerPhysics.Viewer.Page;

/// <summary>Where the bodies of a recording begin.</summary>
internal sealed class SceneBounds
{
    private const float Room = 0.15f;

    private readonly RunData _run;
    private Vector2 _min;
    private Vector2 _max;

    public SceneBounds(RunData run) => _run = run;

    /// <summary>The box of what can move in the first frame, with some room around; of all if nothing can.</summary>
    public (Vector2 Min, Vector2 Max) Find()
    {
        Measure(movingOnly: true);
        if (!(_min.X <= _max.X))
        {
            Measure(movingOnly: false);
        }

        if (!(_min.X <= _max.X))
        {
            return (-Vector2.One, Vector2.One);
        }

        Vector2 room = new Vector2(Math.Max((_max - _min).Length() * Room, float.Epsilon));
        return (_min - room, _max + room);
    }

    private void Measure(bool movingOnly)
    {
        _min = new Vector2(float.PositiveInfinity);
        _max = new Vector2(float.NegativeInfinity);
        PackedChunk chunk = _run.Bodies.Track.Chunks[0];
        double[] x = chunk.Values(BodyTrack.X);
        double[] y = chunk.Values(BodyTrack.Y);
        double[] flags = chunk.Values(BodyTrack.Flags);
        foreach (GeomTable.Entry geom in _run.Geoms.Entries)
        {
            if (geom.From > 0 || (movingOnly && ((int)flags[geom.Body] & BodyTrack.Fixed) != 0))
            {
                continue;
            }

            Vector2 place = new Vector2((float)x[geom.Body], (float)y[geom.Body]);
            Vector2 reach = new Vector2(geom.Offset.Length() + ReachOf(_run.Geoms.Forms[geom.Shape]));
            _min = Vector2.Min(_min, place - reach);
            _max = Vector2.Max(_max, place + reach);
        }
    }

    private static float ReachOf(GeomForm form)
    {
        float reach = form.Size.Length() / 2;
        foreach (Vector2 point in form.Points)
        {
            reach = Math.Max(reach, point.Length());
        }

        return reach + form.Radius;
    }
}
