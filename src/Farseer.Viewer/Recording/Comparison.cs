using System;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>
/// Finds the first difference of two runs. The hash of each frame says when; only that frame is looked at number by number.
/// </summary>
internal static class Comparison
{
    public static RunDifference? Find(RunData first, RunData second)
    {
        int common = Math.Min(first.FrameCount, second.FrameCount);
        int frame = FirstOtherHash(first.Steps.Track, second.Steps.Track, common);
        if (frame == common)
        {
            return first.FrameCount == second.FrameCount
                ? null
                : new RunDifference(common, "run", -1, null, "frames", first.FrameCount, second.FrameCount);
        }

        return InTrack(first.Bodies.Track, second.Bodies.Track, frame, _ => "body", i => first.Bodies.Names[i])
            ?? InTrack(first.Links.Track, second.Links.Track, frame, i => KindOf(first, i),
                i => first.Links.All[i].Name ?? first.Links.All[i].Kind)
            ?? Hashes(first, second, frame);
    }

    private static string KindOf(RunData run, int link) => run.Links.All[link].IsSpring ? "spring" : "joint";

    private static RunDifference Hashes(RunData first, RunData second, int frame) => new RunDifference(
        frame,
        "run",
        -1,
        null,
        "hash",
        Row(first.Steps.Track, frame, out _)[StepTrack.HashLow],
        Row(second.Steps.Track, frame, out _)[StepTrack.HashLow]);

    private static int FirstOtherHash(Track first, Track second, int common)
    {
        for (int frame = 0; frame < common;)
        {
            PackedChunk a = ChunkOf(first, frame);
            PackedChunk b = ChunkOf(second, frame);
            double[] highA = a.Values(StepTrack.HashHigh);
            double[] lowA = a.Values(StepTrack.HashLow);
            double[] highB = b.Values(StepTrack.HashHigh);
            double[] lowB = b.Values(StepTrack.HashLow);
            int end = Math.Min(common, Math.Min(a.First + a.Frames, b.First + b.Frames));
            for (; frame < end; frame++)
            {
                if (highA[frame - a.First] != highB[frame - b.First] || lowA[frame - a.First] != lowB[frame - b.First])
                {
                    return frame;
                }
            }
        }

        return common;
    }

    private static RunDifference? InTrack(
        Track first, Track second, int frame, Func<int, string> subject, Func<int, string?> name)
    {
        double[] a = Row(first, frame, out int slotsA);
        double[] b = Row(second, frame, out int slotsB);
        int columns = first.Columns.Length;
        for (int slot = 0; slot < Math.Min(slotsA, slotsB); slot++)
        {
            for (int c = 0; c < columns; c++)
            {
                double x = a[(slot * columns) + c];
                double y = b[(slot * columns) + c];
                if (BitConverter.DoubleToInt64Bits(x) != BitConverter.DoubleToInt64Bits(y))
                {
                    return new RunDifference(frame, subject(slot), slot, name(slot), first.Columns[c].Name, x, y);
                }
            }
        }

        return null;
    }

    /// <summary>The numbers of a frame, slot after slot.</summary>
    private static double[] Row(Track track, int frame, out int slots)
    {
        PackedChunk chunk = ChunkOf(track, frame);
        slots = chunk.Slots;
        int columns = track.Columns.Length;
        double[] row = new double[slots * columns];
        for (int c = 0; c < columns; c++)
        {
            double[] values = chunk.Values(c);
            for (int slot = 0; slot < slots; slot++)
            {
                row[(slot * columns) + c] = values[((frame - chunk.First) * slots) + slot];
            }
        }

        return row;
    }

    private static PackedChunk ChunkOf(Track track, int frame) => track.Chunks.Find(c => frame < c.First + c.Frames)!;
}
