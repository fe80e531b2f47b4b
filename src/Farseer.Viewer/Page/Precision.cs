using System;
using FarseerGames.FarseerPhysics.Viewer.Recording;

namespace FarseerGames.FarseerPhysics.Viewer.Page;

/// <summary>With how many digits a recording is written: as many as fit.</summary>
internal sealed class Precision
{
    /// <summary>All bits.</summary>
    public const int Exact = 0;

    private const int MostDigits = 7;
    private const int LeastDigits = 3;

    // Four letters stand for three bytes.
    private const double BytesPerByte = 4.0 / 3;

    private Precision(int digits, bool hasContacts, double sceneSize)
    {
        Digits = digits;
        HasContacts = hasContacts;
        SceneSize = sceneSize;
    }

    /// <summary>Decimal digits of what is as large as the scene, or of the largest; <see cref="Exact"/>: all bits.</summary>
    public int Digits { get; }

    public bool HasContacts { get; }

    public double SceneSize { get; }

    public static Precision Fitting(RunData run, long mostBytes, double sceneSize)
    {
        double room = mostBytes / BytesPerByte;
        if (ExactBytes(run) <= room)
        {
            return new Precision(Exact, true, sceneSize);
        }

        foreach (bool hasContacts in new[] { true, false })
        {
            for (int digits = MostDigits; digits >= LeastDigits; digits--)
            {
                Precision precision = new Precision(digits, hasContacts, sceneSize);
                if (precision.Estimate(run) <= room)
                {
                    return precision;
                }
            }
        }

        return new Precision(LeastDigits, false, sceneSize);
    }

    public byte[] Packed(PackedChunk chunk, int column) =>
        Digits == Exact ? chunk.Packed(column) : chunk.Rounded(column, Digits, SceneSize);

    private static double ExactBytes(RunData run)
    {
        double sum = 0;
        foreach (Track track in Tracks(run))
        {
            foreach (PackedChunk chunk in track.Chunks)
            {
                sum += chunk.Bytes;
            }
        }

        return sum;
    }

    public static Track[] Tracks(RunData run) => new[]
    {
        run.Bodies.Track, run.Links.Track, run.Fluids.Track, run.Contacts.Track, run.Events.Track, run.Steps.Track,
    };

    /// <summary>What bodies and contacts will take, judged by a few chunks of each, with a margin; the rest as it is.</summary>
    private double Estimate(RunData run)
    {
        const double Margin = 1.08;
        double sum = 0;
        foreach (Track track in Tracks(run))
        {
            if (track != run.Contacts.Track || HasContacts)
            {
                sum += Margin * Estimate(track);
            }
        }

        return sum;
    }

    private double Estimate(Track track)
    {
        int count = track.Chunks.Count;
        if (count == 0)
        {
            return 0;
        }

        double bytes = 0;
        double frames = 0;
        double all = 0;
        int stride = Math.Max(1, count / 4);
        for (int i = 0; i < count; i++)
        {
            all += track.Chunks[i].Frames;
            if (i % stride != stride / 2)
            {
                continue;
            }

            frames += track.Chunks[i].Frames;
            for (int c = 0; c < track.Columns.Length; c++)
            {
                bytes += Packed(track.Chunks[i], c).Length;
            }
        }

        return bytes * all / frames;
    }
}
