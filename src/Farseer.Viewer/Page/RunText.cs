using System;
using System.Collections.Generic;
using System.IO;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Viewer.Recording;

namespace FarseerGames.FarseerPhysics.Viewer.Page;

/// <summary>A recording as text: what there is as JSON, and the packed columns, one a line.</summary>
internal sealed class RunText
{
    private readonly RunRecorder _recorder;
    private readonly RunData _run;
    private readonly Precision _precision;
    private readonly Vector2 _min;
    private readonly Vector2 _max;
    private readonly List<byte[]> _blocks = new List<byte[]>();

    public RunText(RunRecorder recorder)
    {
        _recorder = recorder;
        _run = recorder.Data;
        (_min, _max) = ViewOf(recorder);
        double size = Math.Max((double)_max.X - _min.X, (double)_max.Y - _min.Y);
        _precision = Precision.Fitting(_run, recorder.Options.MostBytes, size);
        Describe();
    }

    public JsonText Json { get; } = new JsonText();

    public void WriteBlocks(TextWriter writer)
    {
        foreach (byte[] block in _blocks)
        {
            writer.Write(Convert.ToBase64String(block));
            writer.Write('\n');
        }
    }

    private void Describe()
    {
        Json.Open('{');
        Json.Name("title").Value(_recorder.Options.Title);
        Json.Name("yUp").Value(_recorder.IsYUp);
        Json.Name("frames").Value(_run.FrameCount);
        Json.Name("digits").Value(_precision.Digits);
        Json.Name("contactDigits").Value(_precision.ContactDigits);
        Json.Name("hasContacts").Value(_recorder.Options.Contacts && _precision.HasContacts);
        Json.Name("hasEvents").Value(_recorder.Options.Events);
        Json.Name("view").Open('[').Value(_min.X).Value(_min.Y).Value(_max.X).Value(_max.Y).Close(']');
        DescribeTracks();
        Json.Name("bodyCount").Value(_run.Bodies.Names.Count);
        Json.Name("bodyNames");
        Names(_run.Bodies.Names);
        DescribeShapes();
        DescribeGeoms();
        DescribeLinks();
        Json.Name("fluids").Open('[');
        _run.Fluids.Counts.ForEach(c => Json.Value(c));
        Json.Close(']').Close('}');
    }

    private void DescribeTracks()
    {
        Json.Name("tracks").Open('{');
        foreach (Track track in Precision.Tracks(_run))
        {
            if (track == _run.Contacts.Track && !_precision.HasContacts)
            {
                continue;
            }

            Json.Name(track.Name).Open('{').Name("columns").Open('[');
            for (int c = 0; c < track.Columns.Length; c++)
            {
                Describe(track, c);
            }

            Json.Close(']').Name("chunks").Open('[');
            foreach (PackedChunk chunk in track.Chunks)
            {
                Json.Open('[').Value(chunk.First).Value(chunk.Frames).Value(chunk.Slots).Value(_blocks.Count).Close(']');
                for (int c = 0; c < track.Columns.Length; c++)
                {
                    _blocks.Add(_precision.Packed(track, chunk, c));
                }
            }

            Json.Close(']').Close('}');
        }

        Json.Close('}');
    }

    private void Describe(Track track, int column)
    {
        ColumnSpec spec = track.Columns[column];
        Json.Open('{').Name("name").Value(spec.Name).Name("kind");
        if (_precision.Digits == Precision.Exact || spec.Digits == Digits.All)
        {
            Json.Value(spec.Kind switch
            {
                ColumnKind.Double => "double",
                ColumnKind.Single => "single",
                ColumnKind.Integer => "integer",
                _ => "byte",
            });
        }
        else
        {
            ColumnCodec.Rounding rounding = PackedChunk.RoundingOf(track, column, _precision.DigitsOf(track, spec), _precision.SceneSize);
            Json.Value("decimal").Name("decimals").Value(rounding.Decimals).Name("base").Value(rounding.Base);
            Json.Name("steady").Value(PackedChunk.IsSteady(spec));
        }

        Json.Close('}');
    }

    /// <summary>By number, of those that have a name.</summary>
    private void Names(List<string?> names)
    {
        Json.Open('{');
        for (int i = 0; i < names.Count; i++)
        {
            if (names[i] is { } name)
            {
                Json.Name(i.ToString(System.Globalization.CultureInfo.InvariantCulture)).Value(name);
            }
        }

        Json.Close('}');
    }

    private void DescribeShapes()
    {
        Json.Name("shapes").Open('[');
        foreach (GeomForm form in _run.Geoms.Forms)
        {
            Json.Open('{').Name("kind").Value(form.Kind switch
            {
                FormKind.Circle => "circle",
                FormKind.Capsule or FormKind.Rounded => "round",
                FormKind.Segment => "line",
                FormKind.Chain when !form.IsLoop => "line",
                _ => "outline",
            });
            Json.Name("radius").Value(form.Radius).Name("points").Open('[');
            foreach (Vector2 point in form.Kind == FormKind.Box ? Corners(form.Size / 2) : form.Points)
            {
                Json.Value(point.X).Value(point.Y);
            }

            Json.Close(']').Close('}');
        }

        Json.Close(']');
    }

    private static Vector2[] Corners(Vector2 half) =>
        new[] { -half, new Vector2(half.X, -half.Y), half, new Vector2(-half.X, half.Y) };

    private void DescribeGeoms()
    {
        List<GeomTable.Entry> geoms = _run.Geoms.Entries;
        Json.Name("geoms").Open('{');
        Numbers("body", e => e.Body);
        Numbers("shape", e => e.Shape);
        Numbers("from", e => e.From);
        Numbers("to", e => e.To);
        Numbers("x", e => e.Offset.X);
        Numbers("y", e => e.Offset.Y);
        Numbers("turn", e => e.Rotation);
        Numbers("sensor", e => e.IsSensor ? 1 : 0);
        Json.Name("names");
        Names(geoms.ConvertAll(e => e.Name));
        Json.Close('}');

        void Numbers(string name, Func<GeomTable.Entry, float> read)
        {
            Json.Name(name).Open('[');
            geoms.ForEach(e => Json.Value(read(e)));
            Json.Close(']');
        }
    }

    private void DescribeLinks()
    {
        Json.Name("links").Open('[');
        foreach (LinkTrack.Ends link in _run.Links.All)
        {
            Json.Open('{').Name("kind").Value(link.Kind).Name("name").Value(link.Name).Name("spring").Value(link.IsSpring);
            Json.Name("a").Value(link.BodyA).Name("b").Value(link.BodyB).Name("world").Value(link.IsToWorld);
            Json.Name("at").Open('[').Value(link.InA.X).Value(link.InA.Y).Value(link.InB.X).Value(link.InB.Y).Close(']');
            if (link.IsOver)
            {
                Json.Name("over").Open('[').Value(link.Over1.X).Value(link.Over1.Y).Value(link.Over2.X).Value(link.Over2.Y).Close(']');
            }

            Json.Close('}');
        }

        Json.Close(']');
    }

    /// <summary>What the options say, else all geoms that can move in the first frame with some room around, else all geoms.</summary>
    private static (Vector2 Min, Vector2 Max) ViewOf(RunRecorder recorder)
    {
        RunRecorderOptions options = recorder.Options;
        if (options.ViewMin != options.ViewMax)
        {
            return (Vector2.Min(options.ViewMin, options.ViewMax), Vector2.Max(options.ViewMin, options.ViewMax));
        }

        SceneBounds bounds = new SceneBounds(recorder.Data);
        return bounds.Find();
    }
}
