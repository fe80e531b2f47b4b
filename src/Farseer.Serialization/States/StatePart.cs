using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Serialization.Documents;

namespace FarseerGames.FarseerPhysics.Serialization.States;

/// <summary>
/// The state of a world as a part of a file: its bytes, which objects of the file it refers to, and how much room its columns have. Only an
/// unchanged file of the same layout is believed: the bytes are memory of the engine.
/// </summary>
internal sealed class StatePart
{
    /// <summary>Places of objects begin here; the numbers below stand for what is no object of the file.</summary>
    private const int FirstPlace = 8;

    private const int Nothing = 0;
    private const int ReadersOwn = 1;
    private const int FirstFixed = 2;

    public StatePart(byte[] bytes, int[] references, int[] room, ulong layout)
    {
        Bytes = bytes;
        References = references;
        Room = room;
        Layout = layout;
    }

    public byte[] Bytes { get; }

    public int[] References { get; }

    public int[] Room { get; }

    public ulong Layout { get; }

    /// <param name="stream">What was written.</param>
    /// <param name="places">The objects of the file, in one order.</param>
    /// <param name="layout">Of which layout it is.</param>
    /// <param name="fixedOnes">The world and the like: at most six.</param>
    public static StatePart Of(StateStream stream, IEnumerable<object> places, ulong layout, params object[] fixedOnes)
    {
        var numbers = new Dictionary<object, int>();
        for (int i = 0; i < fixedOnes.Length; i++)
        {
            numbers.Add(fixedOnes[i], FirstFixed + i);
        }

        int next = FirstPlace;
        foreach (object item in places)
        {
            numbers.Add(item, next++);
        }

        var references = new int[stream.ObjectCount];
        for (int i = 0; i < references.Length; i++)
        {
            object? item = stream.Objects[i];
            references[i] = item is null ? Nothing : numbers.TryGetValue(item, out int number) ? number : ReadersOwn;
        }

        return new StatePart(stream.Bytes.ToArray(), references, stream.Room!.ToArray(), layout);
    }

    public static StatePart Read(SceneObject members)
    {
        SceneNode layout = members.Take("layout");
        if (!ulong.TryParse(
            layout.Text(),
            System.Globalization.NumberStyles.HexNumber,
            System.Globalization.CultureInfo.InvariantCulture,
            out ulong number))
        {
            throw layout.Error("must be 16 hexadecimal digits");
        }

        SceneNode size = members.Take("size");
        SceneNode packed = members.Take("bytes");
        byte[] bytes = Unpack(packed.Bytes(), size);
        var part = new StatePart(bytes, members.Take("references").Wholes(), members.Take("room").Wholes(), number);
        members.Finish();
        return part;
    }

    public void Write(SceneSink sink)
    {
        sink.Name("layout");
        sink.Text(Layout.ToString("x16", System.Globalization.CultureInfo.InvariantCulture));
        sink.Name("size");
        sink.Whole(Bytes.Length);
        sink.Name("bytes");
        sink.Bytes(Pack(Bytes));
        sink.Name("references");
        sink.Wholes(References);
        sink.Name("room");
        sink.Wholes(Room);
    }

    /// <summary>A stream to be read by a world that has these objects.</summary>
    public StateStream ToStream(IEnumerable<object> places, Func<string, Exception?, Exception> fault, params object[] fixedOnes)
    {
        object[] items = places.ToArray();
        var stream = new StateStream { Room = new List<int>(Room) };
        object?[] objects = Array.ConvertAll(References, number => number switch
        {
            Nothing => null,
            ReadersOwn => (object)stream,
            >= FirstFixed and < FirstPlace when number - FirstFixed < fixedOnes.Length => fixedOnes[number - FirstFixed],
            >= FirstPlace when number - FirstPlace < items.Length => items[number - FirstPlace],
            _ => throw fault("refers to an object that is not in the file", null),
        });
        stream.Load(Bytes, objects);
        return stream;
    }

    private static byte[] Pack(byte[] bytes)
    {
        using var packed = new MemoryStream();
        using (var deflate = new DeflateStream(packed, CompressionLevel.Optimal, leaveOpen: true))
        {
            deflate.Write(bytes, 0, bytes.Length);
        }

        return packed.ToArray();
    }

    private static byte[] Unpack(byte[] packed, SceneNode size)
    {
        // Nothing is packed by more than this; a claim beyond it is not believed.
        const long MostRatio = 1032;
        long claimed = size.Long();
        if (claimed < 0 || claimed > Math.Min(int.MaxValue, (packed.Length + 64) * MostRatio))
        {
            throw size.Error("does not fit the bytes");
        }

        var bytes = new byte[claimed];
        int count = 0;
        try
        {
            using var deflate = new DeflateStream(new MemoryStream(packed), CompressionMode.Decompress);
            for (int read = 1; read > 0 && count < bytes.Length; count += read)
            {
                read = deflate.Read(bytes, count, bytes.Length - count);
            }
        }
        catch (InvalidDataException exception)
        {
            throw size.Error("comes with bytes that cannot be unpacked", exception);
        }

        return count == bytes.Length ? bytes : throw size.Error("does not fit the bytes");
    }
}
