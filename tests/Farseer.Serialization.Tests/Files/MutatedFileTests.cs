using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Serialization;
using Xunit;

namespace Farseer.Serialization.Tests.Files;

/// <summary>
/// Files with faults of all sorts load or are refused by the exception that is for it, in a time and with a memory that their size bounds.
/// FARSEER_MUTATED_FILES sets how many; the default is what the gate does.
/// </summary>
public sealed class MutatedFileTests
{
    private const int Usual = 10_000;

    [Theory]
    [InlineData(SceneFormat.Json)]
    [InlineData(SceneFormat.Binary)]
    public void File_WithFaults_LoadsOrIsRefused(SceneFormat format)
    {
        int count = int.TryParse(
            Environment.GetEnvironmentVariable("FARSEER_MUTATED_FILES"), NumberStyles.Integer, CultureInfo.InvariantCulture, out int asked)
            ? asked / 2 : Usual / 2;
        Action<byte[]>[] loads =
        [
            file => SceneFile.LoadSimulator(file), file => SceneFile.LoadWorld(file), file => SceneFile.LoadSimulator(file),
            file => SceneFile.LoadWorld(file), file => Replay.Load(file),
        ];
        byte[][] files =
        [
            SceneFile.Save(Moved(false), Saves.Options(format, false)),
            SceneFile.Save(FlashEverything.Build(), Saves.Options(format, false)),
            SceneFile.Save(Moved(true), Saves.Options(format, true)), SceneFile.Save(FlashEverything.Build(), Saves.Options(format, true)),
            Recorded(),
        ];
        long[] usual = [.. files.Select((file, i) => Bytes(() => loads[i](file)))];
        var random = new Random(20261129);
        int refused = 0;
        for (int i = 0; i < count; i++)
        {
            // A changed state is refused by its sum before anybody looks at it: mostly it is the scenes that are read.
            int kind = i % 20 < 17 ? i % 2 : 2 + (i % 3);
            byte[] file = Mutated(files[kind], files[random.Next(files.Length)], random);
            var watch = Stopwatch.StartNew();
            Exception? exception = null;
            long bytes = Bytes(() => exception = Record.Exception(() => loads[kind](file)));

            Assert.True(exception is null or SceneFileException, $"file {i}: {exception}");
            Assert.True(bytes <= (10 * usual[kind]) + (1 << 20), $"file {i} took {bytes} bytes, and the one without faults {usual[kind]}");
            Assert.True(watch.Elapsed < TimeSpan.FromSeconds(30), $"file {i} took {watch.Elapsed}");
            refused += exception is null ? 0 : 1;
        }

        // Most faults are noticed, and some values are as good as the ones that they replace.
        Assert.InRange(refused, count / 2, count - (count / 100));
    }

    private static long Bytes(Action act)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        act();
        return GC.GetAllocatedBytesForCurrentThread() - before;
    }

    private static PhysicsSimulator Moved(bool isMoved)
    {
        PhysicsSimulator simulator = Everything.Build();
        for (int i = 0; i < 3 && isMoved; i++)
        {
            simulator.Update(1f / 60);
        }

        return simulator;
    }

    private static byte[] Recorded()
    {
        var recorder = new SimulationRecorder(Everything.Build());
        for (int i = 0; i < 3; i++)
        {
            recorder.Simulator.BodyList.FirstOrDefault()?.ApplyTorque(1);
            recorder.Update(1f / 60);
        }

        return recorder.ToArray();
    }

    private static byte[] Mutated(byte[] file, byte[] other, Random random)
    {
        List<byte> bytes = [.. file];
        for (int faults = random.Next(1, 4); faults > 0 && bytes.Count > 16; faults--)
        {
            int at = random.Next(bytes.Count);
            int length = Math.Min(random.Next(1, 1 << random.Next(1, 10)), bytes.Count - at);
            switch (random.Next(9))
            {
                case 0:
                    bytes[at] = (byte)random.Next(256);
                    break;
                case 1:
                    bytes[at] ^= (byte)(1 << random.Next(8));
                    break;
                case 2:
                    bytes.RemoveRange(at, length);
                    break;
                case 3:
                    bytes.InsertRange(at, bytes.GetRange(at, length));
                    break;
                case 4:
                    bytes.InsertRange(at, other.Skip(random.Next(other.Length)).Take(length));
                    break;
                case 5:
                    bytes.RemoveRange(at, bytes.Count - at);
                    break;
                case 6:
                    for (int i = 0; i < Math.Min(10, length); i++)
                    {
                        bytes[at + i] = 0xFF;
                    }

                    break;
                default:
                    OtherNumber(bytes, at, random);
                    break;
            }
        }

        return [.. bytes];
    }

    /// <summary>In a text, puts another number where one stands.</summary>
    private static void OtherNumber(List<byte> bytes, int at, Random random)
    {
        string[] numbers = [
            "-1", "0", "1e38", "-1e-38", "2147483647", "-2147483648", "\"NaN\"", "\"Infinity\"", "1e308", "null", "[]", "{}", "true",
            "65536",
        ];
        int start = bytes.FindIndex(at, b => b is >= (byte)'0' and <= (byte)'9');
        if (start < 0)
        {
            return;
        }

        int end = bytes.FindIndex(start, b => b is not (>= (byte)'0' and <= (byte)'9' or (byte)'.' or (byte)'-' or (byte)'E' or (byte)'+'));
        bytes.RemoveRange(start, (end < 0 ? bytes.Count : end) - start);
        bytes.InsertRange(start, System.Text.Encoding.UTF8.GetBytes(numbers[random.Next(numbers.Length)]));
    }
}
