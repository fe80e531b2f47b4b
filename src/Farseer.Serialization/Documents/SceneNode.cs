using System;
using System.Buffers.Text;
using System.Collections.Generic;
using System.Numerics;
using System.Text;
using System.Text.Json;

namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>A value of a document, to be read as what it should be.</summary>
internal readonly struct SceneNode
{
    private readonly SceneDocument _document;
    private readonly int _index;

    public SceneNode(SceneDocument document, int index)
    {
        _document = document;
        _index = index;
    }

    public SceneDocument Document => _document;

    public SceneKind Kind => Record.Kind;

    public bool IsNull => Kind == SceneKind.Null;

    private SceneRecord Record => _document.Record(_index);

    private ReadOnlySpan<byte> Span => new ReadOnlySpan<byte>(_document.Bytes, Record.Offset, Record.Length);

    /// <summary>The items of an array.</summary>
    public List<SceneNode> Items()
    {
        if (Kind != SceneKind.Array)
        {
            throw Error("must be an array");
        }

        return Within();
    }

    /// <summary>The members of an object by name.</summary>
    public Dictionary<string, SceneNode> Members()
    {
        if (Kind != SceneKind.Object)
        {
            throw Error("must be an object");
        }

        var members = new Dictionary<string, SceneNode>();
        foreach (SceneNode node in Within())
        {
            SceneRecord record = node.Record;
            string name = _document.Name(record.NameOffset, record.NameLength);
            if (members.ContainsKey(name))
            {
                throw node.Error("stands there twice");
            }

            members.Add(name, node);
        }

        return members;
    }

    public bool Flag() => Kind is SceneKind.True or SceneKind.False ? Kind == SceneKind.True : throw Error("must be true or false");

    public int Whole()
    {
        long value = 0;
        bool isWhole = Kind == SceneKind.Whole ? TryVarInt(out value)
            : Kind == SceneKind.Number && Utf8Parser.TryParse(Span, out value, out int used) && used == Span.Length;
        return isWhole && value >= int.MinValue && value <= int.MaxValue ? (int)value : throw Error("must be a whole number");
    }

    public long Long()
    {
        long value = 0;
        bool isWhole = Kind == SceneKind.Whole ? TryVarInt(out value)
            : Kind == SceneKind.Number && Utf8Parser.TryParse(Span, out value, out int used) && used == Span.Length;
        return isWhole ? value : throw Error("must be a whole number");
    }

    public float Single()
    {
        switch (Kind)
        {
            case SceneKind.Single:
                return Float(Record.Offset);
            case SceneKind.Number when Utf8Parser.TryParse(Span, out float value, out int used)
                && used == Span.Length
                && !float.IsInfinity(value):
                return value;
            case SceneKind.String when NumberText.TryName(Text(), out double named):
                return (float)named;
            case SceneKind.Whole:
                return Whole();
            default:
                throw Error("must be a number");
        }
    }

    public double Double()
    {
        switch (Kind)
        {
            case SceneKind.Double:
                uint low = Word(Record.Offset);
                return BitConverter.Int64BitsToDouble((long)(((ulong)Word(Record.Offset + 4) << 32) | low));
            case SceneKind.Number when Utf8Parser.TryParse(Span, out double value, out int used)
                && used == Span.Length
                && !double.IsInfinity(value):
                return value;
            case SceneKind.String when NumberText.TryName(Text(), out double named):
                return named;
            default:
                return Single();
        }
    }

    /// <summary>A number that is neither infinite nor none.</summary>
    public double Finite()
    {
        double value = Double();
        return double.IsNaN(value) || double.IsInfinity(value) ? throw Error("must be finite") : value;
    }

    public string Text()
    {
        if (Kind != SceneKind.String)
        {
            throw Error("must be a text");
        }

        if (!_document.IsText)
        {
            return Encoding.UTF8.GetString(_document.Bytes, Record.Offset, Record.Length);
        }

        var reader = new Utf8JsonReader(Span);
        reader.Read();
        try
        {
            return reader.GetString()!;
        }
        catch (InvalidOperationException exception)
        {
            throw Error("is no text: " + exception.Message);
        }
    }

    public byte[] Bytes()
    {
        if (Kind == SceneKind.Bytes)
        {
            return Span.ToArray();
        }

        try
        {
            return Convert.FromBase64String(Text());
        }
        catch (FormatException)
        {
            throw Error("must be base 64");
        }
    }

    public Vector2 Vector()
    {
        float[] numbers = Singles();
        return numbers.Length == 2 ? new Vector2(numbers[0], numbers[1]) : throw Error("must be two numbers");
    }

    public Vector2[] Vectors()
    {
        float[] numbers = Singles();
        if (numbers.Length % 2 != 0)
        {
            throw Error("must be pairs of numbers");
        }

        var vectors = new Vector2[numbers.Length / 2];
        for (int i = 0; i < vectors.Length; i++)
        {
            vectors[i] = new Vector2(numbers[2 * i], numbers[(2 * i) + 1]);
        }

        return vectors;
    }

    public float[] Singles()
    {
        if (Kind != SceneKind.Singles)
        {
            return Items().ConvertAll(static item => item.Single()).ToArray();
        }

        var values = new float[Record.Length / sizeof(float)];
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = Float(Record.Offset + (i * sizeof(float)));
        }

        return values;
    }

    public int[] Wholes()
    {
        if (Kind != SceneKind.Wholes)
        {
            return Items().ConvertAll(static item => item.Whole()).ToArray();
        }

        var values = new List<int>();
        int at = Record.Offset;
        while (at < Record.Offset + Record.Length && VarInt.TryRead(_document.Bytes, ref at, out ulong value))
        {
            long signed = VarInt.Signed(value);
            values.Add(signed >= int.MinValue && signed <= int.MaxValue ? (int)signed : throw Error("must be whole numbers"));
        }

        return values.ToArray();
    }

    public SceneFileException Error(string problem, Exception? cause = null)
    {
        SceneRecord record = Record;
        _document.Place(record.Offset, out long line, out long position);
        return new SceneFileException(problem, _document.PathOf(_index), Shown(), record.Offset, line, position, cause);
    }

    private string Shown()
    {
        string shown = Kind switch
        {
            SceneKind.Array or SceneKind.Object or SceneKind.Singles or SceneKind.Wholes or SceneKind.Bytes => "",
            SceneKind.Null => "null",
            SceneKind.True => "true",
            SceneKind.False => "false",
            SceneKind.Whole => TryVarInt(out long whole) ? whole.ToString(System.Globalization.CultureInfo.InvariantCulture) : "",
            SceneKind.Single => NumberText.Of(Float(Record.Offset)),
            SceneKind.Double => NumberText.Of(Double()),
            _ => Encoding.UTF8.GetString(_document.Bytes, Record.Offset, Math.Min(Record.Length, 60)),
        };
        return shown.Length > 60 ? shown.Substring(0, 60) : shown;
    }

    private List<SceneNode> Within()
    {
        var items = new List<SceneNode>();
        int end = Record.Next;
        for (int i = _index + 1; i < end; i = _document.Record(i).Next)
        {
            items.Add(new SceneNode(_document, i));
        }

        return items;
    }

    private bool TryVarInt(out long value)
    {
        int at = Record.Offset;
        bool isThere = VarInt.TryRead(_document.Bytes, ref at, out ulong bits);
        value = VarInt.Signed(bits);
        return isThere;
    }

    private float Float(int offset)
    {
        uint bits = Word(offset);
        return System.Runtime.CompilerServices.Unsafe.As<uint, float>(ref bits);
    }

    private uint Word(int offset)
    {
        byte[] bytes = _document.Bytes;
        return bytes[offset] | ((uint)bytes[offset + 1] << 8) | ((uint)bytes[offset + 2] << 16) | ((uint)bytes[offset + 3] << 24);
    }
}
