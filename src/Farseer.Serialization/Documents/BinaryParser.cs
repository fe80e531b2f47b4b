using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>Takes a binary file apart. No length is believed before as many bytes are seen to be there.</summary>
internal sealed class BinaryParser
{
    private readonly SceneDocument _document;
    private readonly byte[] _bytes;
    private readonly List<(int Offset, int Length)> _names = new List<(int Offset, int Length)>();

    // Of what is open, whether it is an object.
    private readonly Stack<bool> _open = new Stack<bool>();
    private int _at = BinarySink.Mark.Length;

    private BinaryParser(SceneDocument document)
    {
        _document = document;
        _bytes = document.Bytes;
    }

    public static void Parse(SceneDocument document)
    {
        var parser = new BinaryParser(document);
        do
        {
            parser.Next();
        }
        while (parser._open.Count > 0);

        if (parser._at != parser._bytes.Length)
        {
            throw document.Fault("the file goes on behind its end", parser._at);
        }
    }

    private void Next()
    {
        int name = -1;
        int nameLength = 0;
        if (_open.Count > 0 && _open.Peek())
        {
            ulong number = Count();
            if (number == 0)
            {
                End();
                return;
            }

            (name, nameLength) = NameOf(number - 1);
        }

        int start = _at;
        var kind = (SceneKind)Byte();
        if (kind == SceneKind.End && _open.Count > 0 && !_open.Peek())
        {
            End();
            return;
        }

        int offset = _at;
        Skip(kind, start, ref offset);
        _document.Add(kind, offset, _at - offset, name, nameLength);
        if (kind is SceneKind.Array or SceneKind.Object)
        {
            _open.Push(kind == SceneKind.Object);
        }
    }

    private void End()
    {
        _open.Pop();
        _document.Close(_at);
    }

    private (int Offset, int Length) NameOf(ulong number)
    {
        if (number < (ulong)_names.Count)
        {
            return _names[(int)number];
        }

        if (number != (ulong)_names.Count)
        {
            throw _document.Fault("there is no name of this number", _at);
        }

        int length = Length(1);
        _names.Add((_at, length));
        _at += length;
        return _names[_names.Count - 1];
    }

    private void Skip(SceneKind kind, int start, ref int offset)
    {
        switch (kind)
        {
            case SceneKind.Null or SceneKind.False or SceneKind.True or SceneKind.Array or SceneKind.Object:
                break;
            case SceneKind.Whole:
                Count();
                break;
            case SceneKind.Single:
                Forward(sizeof(float));
                break;
            case SceneKind.Double:
                Forward(sizeof(double));
                break;
            case SceneKind.String or SceneKind.Bytes:
                int length = Length(1);
                offset = _at;
                _at += length;
                break;
            case SceneKind.Singles:
                int floats = Length(sizeof(float));
                offset = _at;
                _at += floats * sizeof(float);
                break;
            case SceneKind.Wholes:
                int wholes = Length(1);
                offset = _at;
                for (int i = 0; i < wholes; i++)
                {
                    Count();
                }

                break;
            default:
                throw _document.Fault("no value begins like this", start);
        }
    }

    /// <summary>A number of items of so many bytes each, which must be there.</summary>
    private int Length(int size)
    {
        int at = _at;
        ulong length = Count();
        return length <= (ulong)((_bytes.Length - _at) / size)
            ? (int)length
            : throw _document.Fault("a length is more than what is left of the file", at);
    }

    private void Forward(int bytes) =>
        _at = bytes <= _bytes.Length - _at ? _at + bytes : throw _document.Fault("the file ends within a value", _at);

    private byte Byte() => _at < _bytes.Length ? _bytes[_at++] : throw _document.Fault("the file ends too early", _at);

    private ulong Count()
    {
        int at = _at;
        return VarInt.TryRead(_bytes, ref _at, out ulong value) ? value : throw _document.Fault("a number does not end", at);
    }
}
