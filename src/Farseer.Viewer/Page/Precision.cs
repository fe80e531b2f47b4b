using System;
using FarseerGames.FarseerPhysics.Viewer.Recording;

namespace FarseerGames.FarseerPhysics.Viewer.Page;

/// <summary>With how many digits a recording is written: as many as fit.</summary>
internal sealed class Precision
{
    /// <summary>All bits.</summary>
    public const int Exact = 0;

    // From the finest to the coarsest, and of the impulses of contacts, which take most room; 0 leaves contacts out.
    private static readonly (int Digits, int ContactDigits)[] _steps =
    {
        (7, 6), (6, 5), (6, 4), (5, 4), (5, 3), (5, 2), (4, 2), (3, 2), (5, 0), (4, 0), (3, 0),
    };

    // Four letters stand for three bytes.
    private const double BytesPerByte = 4.0 / 3;

    private Precision(int digits, int contactDigits, double sceneSize)
    {
        Digits = digits;
        ContactDigits = contactDigits;
        SceneSize = sceneSize;
    }

    /// <summary>Decimal digits of what is as large as the scene, or of the largest; <see cref="Exact"/>: all bits.</summary>
    public int Digits { get; }

    /// <summary>The same of the impulses of contacts.</summary>
    public int ContactDigits { get; }

    public bool HasContacts => Digits == Exact || ContactDigits > 0;

    public double SceneSize { get; }

    /// <summary>The finest that fits, by search: each step takes less room than the one before.</summary>
    public static Precision Fitting(RunData run, long mostBytes, double sceneSize)
    {
        double room = mostBytes / BytesPerByte;
        if (ExactBytes(run) <= room)
        {
            return new Precision(Exact, Exact, sceneSize);
        }

        int low = 0;
        int high = _steps.Length - 1;
        while (low < high)
        {
            int middle = (low + high) / 2;
            if (At(middle, sceneSize).Estimate(run) <= room)
            {
                high = middle;
            }
            else
            {
                low = middle + 1;
            }
        }

        return At(high, sceneSize);
    }

    public int DigitsOf(Track track, in ColumnSpec column) =>
        track.Name == ContactTrack.Name && column.Digits == Recording.Digits.Size ? ContactDigits : Digits;

    public byte[] Packed(Track track, PackedChunk chunk, int column) =>
        Digits == Exact ? chunk.Packed(column) : chunk.Rounded(column, DigitsOf(track, track.Columns[column]), SceneSize);

    private static Precision At(int step, double sceneSize) => new Precision(_steps[step].Digits, _steps[step].ContactDigits, sceneSize);

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
        int stride = Math.Max(1, count / 3);
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
                bytes += Packed(track, track.Chunks[i], c).Length;
            }
        }

        return bytes * all / frames;
    }
}
