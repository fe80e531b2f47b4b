using System;
using System.Collections.Generic;
using System.IO;
using System.Text;

namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>
/// Writes the binary form: after eight bytes that tell it apart, a value is a <see cref="SceneKind"/> and what belongs to it. A name stands
/// in full where it comes first, and later as its number. Bytes come in the order of small machines, whichever one it runs on.
/// </summary>
internal sealed class BinarySink : SceneSink
{
    private readonly List<byte> _bytes = new List<byte>();
    private readonly Dictionary<string, int> _names = new Dictionary<string, int>();

    public BinarySink() => _bytes.AddRange(Mark.ToArray());

    /// <summary>How a binary file begins. A file that was sent as text does not begin so any more.</summary>
    public static ReadOnlySpan<byte> Mark => [0x89, (byte)'F', (byte)'R', (byte)'S', (byte)'\r', (byte)'\n', 0x1A, (byte)'\n'];

    public byte[] ToArray() => _bytes.ToArray();

    public override void BeginObject() => Kind(SceneKind.Object);

    public override void EndObject() => Count(0);

    public override void BeginArray() => Kind(SceneKind.Array);

    public override void EndArray() => Kind(SceneKind.End);

    public override void Name(string name)
    {
        if (_names.TryGetValue(name, out int number))
        {
            Count((ulong)number + 1);
            return;
        }

        Count((ulong)_names.Count + 1);
        _names.Add(name, _names.Count);
        Raw(Encoding.UTF8.GetBytes(name));
    }

    public override void Null() => Kind(SceneKind.Null);

    public override void Flag(bool value) => Kind(value ? SceneKind.True : SceneKind.False);

    public override void Whole(long value)
    {
        Kind(SceneKind.Whole);
        Signed(value);
    }

    public override void Number(float value)
    {
        Kind(SceneKind.Single);
        Word(Bits(value));
    }

    public override void Number(double value)
    {
        Kind(SceneKind.Double);
        long bits = BitConverter.DoubleToInt64Bits(value);
        Word((uint)bits);
        Word((uint)(bits >> 32));
    }

    public override void Text(string value)
    {
        Kind(SceneKind.String);
        Raw(Encoding.UTF8.GetBytes(value));
    }

    public override void Bytes(byte[] value)
    {
        Kind(SceneKind.Bytes);
        Raw(value);
    }

    public override void Numbers(ReadOnlySpan<float> values)
    {
        Kind(SceneKind.Singles);
        Count((ulong)values.Length);
        foreach (float value in values)
        {
            Word(Bits(value));
        }
    }

    public override void Wholes(ReadOnlySpan<int> values)
    {
        Kind(SceneKind.Wholes);
        Count((ulong)values.Length);
        foreach (int value in values)
        {
            Signed(value);
        }
    }

    private static uint Bits(float value) => (uint)System.Runtime.CompilerServices.Unsafe.As<float, int>(ref value);

    private void Kind(SceneKind kind) => _bytes.Add((byte)kind);

    private void Raw(byte[] bytes)
    {
        Count((ulong)bytes.Length);
        _bytes.AddRange(bytes);
    }

    private void Signed(long value) => Count((ulong)((value << 1) ^ (value >> 63)));

    private void Word(uint value)
    {
        for (int shift = 0; shift < 32; shift += 8)
        {
            _bytes.Add((byte)(value >> shift));
        }
    }

    private void Count(ulong value)
    {
        for (; value >= 0x80; value >>= 7)
        {
            _bytes.Add((byte)(value | 0x80));
        }

        _bytes.Add((byte)value);
    }
}
