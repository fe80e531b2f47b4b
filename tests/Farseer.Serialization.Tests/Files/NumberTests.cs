using System;
using System.Linq;
using FarseerGames.FarseerPhysics.Serialization.Documents;
using Xunit;

namespace Farseer.Serialization.Tests.Files;

/// <summary>Numbers come back bit for bit.</summary>
public sealed class NumberTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Number_OfAnyBits_ComesBack(bool isBinary)
    {
        var random = new Random(7);
        float[] singles = [.. Enumerable.Range(0, 4000).Select(_ => BitConverter.Int32BitsToSingle(random.Next(int.MinValue, int.MaxValue)))
            .Select(Plain),
            0f, -0f, float.Epsilon, float.MaxValue, float.PositiveInfinity, float.NegativeInfinity, float.NaN];
        double[] doubles = [.. Enumerable.Range(0, 4000).Select(_ => BitConverter.Int64BitsToDouble(random.NextInt64())),
            0.0, -0.0, double.Epsilon, double.MaxValue, double.NegativeInfinity, double.NaN];
        int[] wholes = [0, -1, 1, int.MaxValue, int.MinValue, 300];
        SceneSink sink = isBinary ? new BinarySink() : new JsonSink();
        sink.BeginObject();
        sink.Name("singles");
        sink.Numbers(singles);
        sink.Name("wholes");
        sink.Wholes(wholes);
        sink.Name("doubles");
        sink.BeginArray();
        foreach (double value in doubles)
        {
            sink.Number(value);
        }

        sink.EndArray();
        sink.Name("bytes");
        sink.Bytes([1, 2, 255]);
        sink.Name("text");
        sink.Text("\u00e4 \"quoted\" \n\u2603");
        sink.Name("long");
        sink.Whole(long.MinValue);
        sink.EndObject();

        SceneDocument document = SceneDocument.Parse(sink is JsonSink json ? json.ToArray() : ((BinarySink)sink).ToArray());
        var root = new SceneObject(document.Root);

        Assert.Equal(singles.Select(BitConverter.SingleToInt32Bits), root.Take("singles").Singles().Select(BitConverter.SingleToInt32Bits));
        Assert.Equal(doubles.Select(Bits), root.Take("doubles").Items().Select(n => Bits(n.Double())));
        Assert.Equal(wholes, root.Take("wholes").Wholes());
        Assert.Equal([1, 2, 255], root.Take("bytes").Bytes());
        Assert.Equal("\u00e4 \"quoted\" \n\u2603", root.Take("text").Text());
        Assert.Equal(long.MinValue, root.Take("long").Long());
        root.Finish();
    }

    // What is no number comes back as one that is none; of which kind matters to nobody.
    private static float Plain(float value) => float.IsNaN(value) ? float.NaN : value;

    private static long Bits(double value) => double.IsNaN(value) ? -1 : BitConverter.DoubleToInt64Bits(value);
}
