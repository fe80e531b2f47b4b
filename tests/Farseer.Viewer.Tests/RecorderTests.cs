using System;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using System.Text.RegularExpressions;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Viewer;
using FarseerGames.FarseerPhysics.Viewer.Recording;
using Xunit;

namespace Farseer.Viewer.Tests;

/// <summary>What is recorded, without a browser.</summary>
public sealed class RecorderTests
{
    private static readonly double[] _values =
        [0, -0.0, 1, -1.5, double.MaxValue, double.Epsilon, double.NaN, double.NegativeInfinity, 0.1, 1e7 + 0.1, 3, 3];

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    [InlineData(12)]
    public void Column_OfDoubles_ComesBackBitForBit(int slots)
    {
        byte[] packed = ColumnCodec.Encode(ColumnKind.Double, _values, slots);

        double[] back = ColumnCodec.Decode(ColumnKind.Double, packed, slots, _values.Length);

        Assert.Equal(_values.Select(BitConverter.DoubleToInt64Bits), back.Select(BitConverter.DoubleToInt64Bits));
    }

    [Fact]
    public void Column_OfOtherKinds_ComesBackAsItsKind()
    {
        double[] values = [0, 200, 7, -3];

        Assert.Equal([0, 200, 7, -3f], Back(ColumnKind.Single, values));
        Assert.Equal([0, 200, 7, -3], Back(ColumnKind.Integer, values));
        Assert.Equal([0, 200, 7, 1], Back(ColumnKind.Byte, [0, 200, 7, 1]));
        Assert.Equal(0.1f, Back(ColumnKind.Single, [0.1])[0]);
    }

    [Fact]
    public void Column_ThatDoesNotChange_CostsNothing()
    {
        double[] values = [.. Enumerable.Range(0, 60).SelectMany(_ => Enumerable.Range(0, 1000).Select(i => Math.Sqrt(i)))];

        byte[] one = ColumnCodec.Encode(ColumnKind.Double, values[..1000], 1000);
        byte[] all = ColumnCodec.Encode(ColumnKind.Double, values, 1000);

        // Deflate takes a byte or two for a thousand zeros.
        Assert.True(all.Length - one.Length < 60 * 1000 * 8 / 100, $"{one.Length} and {all.Length} bytes");
    }

    [Fact]
    public void Rounding_OfAWideRange_TakesFewerDecimals()
    {
        ColumnCodec.Rounding rounding = new(6, -1e7, 1e7);

        Assert.True(rounding.Decimals < 3);
        Assert.InRange(rounding.Whole(1e7) + rounding.Base, 0, double.MaxValue);
        Assert.Equal(0, rounding.Whole(double.NaN));
    }

    [Fact]
    public void Record_ChangesNoBitOfTheMotion()
    {
        PhysicsSimulator recorded = Worlds.Mixed();
        Worlds.Recorded(recorded, 200);
        PhysicsSimulator alone = Worlds.Mixed();
        for (int i = 0; i < 200; i++)
        {
            alone.Update(Worlds.Dt);
        }

        Assert.Equal(alone.MotionHash(), recorded.MotionHash());
    }

    [Fact]
    public void Compare_OfTheSameRun_FindsNothing()
    {
        Assert.Null(RunRecorder.Compare(Worlds.Recorded(Worlds.Mixed(), 130), Worlds.Recorded(Worlds.Mixed(), 130)));
    }

    [Fact]
    public void Compare_OfRunsThatPart_NamesUpdateBodyAndField()
    {
        RunDifference difference = RunRecorder.Compare(Parting(0), Parting(1e-6f))!;

        Assert.Equal((90, "body", 3, "spin"), (difference.Frame, difference.Subject, difference.Index, difference.Field));
        Assert.NotEqual(difference.First, difference.Second);
        Assert.StartsWith("update 91, body 3, spin:", difference.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Compare_OfALongerRun_NamesTheNumberOfFrames()
    {
        RunDifference difference = RunRecorder.Compare(Worlds.Recorded(Worlds.Mixed(), 20), Worlds.Recorded(Worlds.Mixed(), 25))!;

        Assert.Equal(("run", "frames", 20d, 25d), (difference.Subject, difference.Field, difference.First, difference.Second));
    }

    [Fact]
    public void Save_OfBodiesThatComeAndGo_KeepsTheirFrames()
    {
        PhysicsSimulator simulator = Worlds.Mixed();
        RunRecorder recorder = new(simulator);
        for (int i = 0; i < 100; i++)
        {
            if (i == 70)
            {
                simulator.RemoveWithParts(simulator.BodyList[2]);
            }

            simulator.Update(Worlds.Dt);
            recorder.Record(Worlds.Dt);
        }

        JsonElement run = Json(recorder);

        Assert.Equal(5, run.GetProperty("bodyCount").GetInt32());
        Assert.Equal([-1, -1, 70, -1, -1], run.GetProperty("geoms").GetProperty("to").EnumerateArray().Select(e => e.GetInt32()));
    }

    [Fact]
    public void Page_HoldsNothingThatAsksForTheNetwork()
    {
        string page = Text(Worlds.Recorded(Worlds.Mixed(), 5,
            new RunRecorderOptions { Title = "</title><script>alert(1)</script> & \u2028" }));

        Assert.DoesNotMatch(new Regex(@"https?://|\bfetch\(|XMLHttpRequest|\bimport\(|<link\b|@import|url\("), page);
        Assert.DoesNotContain("<script>alert", page, StringComparison.Ordinal);
        Assert.Contains("default-src 'none'", page, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(4_000_000, 0)]
    [InlineData(250_000, 7)]
    [InlineData(100_000, 7)]
    public void Save_WithMostBytes_LeavesOutDigits(long mostBytes, int mostDigits)
    {
        PhysicsSimulator simulator = Worlds.Pyramid(12);
        RunRecorder recorder = Worlds.Recorded(simulator, 240, new RunRecorderOptions { MostBytes = mostBytes });

        string text = Text(recorder);
        string data = Regex.Match(text, "<script type=\"text/plain\" id=\"data-0\">(.*?)</script>",
            RegexOptions.Singleline).Groups[1].Value;
        int digits = Json(recorder).GetProperty("digits").GetInt32();

        Assert.InRange(digits, mostDigits == 0 ? 0 : 1, mostDigits);
        Assert.True(data.Length <= mostBytes * 1.1, $"{data.Length} of {mostBytes} bytes");
    }

    [Fact]
    public void BadArguments_AreRefusedByName()
    {
        PhysicsSimulator simulator = new();
        RunRecorder recorder = new(simulator);

        Assert.Equal("simulator", Assert.Throws<ArgumentNullException>(() => new RunRecorder(null!)).ParamName);
        Assert.Equal("options", Assert.Throws<ArgumentOutOfRangeException>(() =>
            new RunRecorder(simulator, new RunRecorderOptions { MostBytes = 0 })).ParamName);
        Assert.Equal("dt", Assert.Throws<ArgumentOutOfRangeException>(() => recorder.Record(float.NaN)).ParamName);
        Assert.Equal("dt", Assert.Throws<ArgumentOutOfRangeException>(() => recorder.Record(-1)).ParamName);
        Assert.Throws<InvalidOperationException>(() => recorder.Write(TextWriter.Null));
        Assert.Equal("second", Assert.Throws<ArgumentNullException>(() => RunRecorder.Compare(recorder, null!)).ParamName);
        Assert.Equal(0, recorder.FrameCount);
    }

    /// <summary>At update 90 a body that hangs is turned by so much.</summary>
    private static RunRecorder Parting(float turn)
    {
        PhysicsSimulator simulator = Worlds.Mixed();
        RunRecorder recorder = new(simulator);
        for (int i = 0; i < 120; i++)
        {
            simulator.Update(Worlds.Dt);
            if (i == 90)
            {
                Body body = simulator.BodyList[3];
                body.AngularVelocity += turn;
            }

            recorder.Record(Worlds.Dt);
        }

        return recorder;
    }

    private static double[] Back(ColumnKind kind, double[] values) =>
        ColumnCodec.Decode(kind, ColumnCodec.Encode(kind, values, 2), 2, values.Length);

    private static JsonElement Json(RunRecorder recorder) =>
        JsonDocument.Parse(Regex.Match(Text(recorder), "<script type=\"application/json\" id=\"run-0\">(.*?)</script>",
            RegexOptions.Singleline).Groups[1].Value)
            .RootElement;

    private static string Text(RunRecorder recorder)
    {
        using StringWriter writer = new();
        recorder.Write(writer);
        return writer.ToString();
    }
}
