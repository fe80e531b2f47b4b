using System;
using System.Collections.Generic;
using System.Text;

namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>
/// A file, taken apart and not yet believed: records of where its values stand. It takes a multiple of the file's size, whatever lengths
/// the file claims.
/// </summary>
internal sealed class SceneDocument
{
    /// <summary>How deep values may stand in each other; files of this library need eight.</summary>
    public const int MostDepth = 32;

    /// <summary>The member of the root that no sum covers: it is the sum.</summary>
    public const string ChecksumName = "checksum";

    private readonly List<SceneRecord> _records = new List<SceneRecord>();
    private readonly Stack<int> _open = new Stack<int>();
    private ulong _sum = 14695981039346656037;

    public SceneDocument(byte[] bytes, bool isText)
    {
        Bytes = bytes;
        IsText = isText;
    }

    public byte[] Bytes { get; }

    public bool IsText { get; }

    /// <summary>What the values come to, whatever lies between them.</summary>
    public string Checksum => _sum.ToString("x16", System.Globalization.CultureInfo.InvariantCulture);

    public SceneNode Root => new SceneNode(this, 0);

    public int Depth => _open.Count;

    public static SceneDocument Parse(byte[] bytes)
    {
        bool isBinary = bytes.AsSpan().StartsWith(BinarySink.Mark);
        var document = new SceneDocument(bytes, !isBinary);
        if (isBinary)
        {
            BinaryParser.Parse(document);
        }
        else
        {
            JsonParser.Parse(document);
        }

        return document;
    }

    public SceneRecord Record(int index) => _records[index];

    /// <summary>A value comes next; of an array or object its beginning.</summary>
    public void Add(SceneKind kind, int offset, int length, int nameOffset, int nameLength)
    {
        if (_open.Count == 1 && nameLength == ChecksumName.Length && Name(nameOffset, nameLength) == ChecksumName)
        {
            kind = kind == SceneKind.String ? kind : throw Fault("the checksum must be a text", offset);
        }
        else
        {
            Sum((byte)kind);
            Sum(nameOffset < 0 ? default : new ReadOnlySpan<byte>(Bytes, nameOffset, nameLength));
            Sum(kind is SceneKind.Array or SceneKind.Object ? default : new ReadOnlySpan<byte>(Bytes, offset, length));
        }

        bool opens = kind is SceneKind.Array or SceneKind.Object;
        _records.Add(new SceneRecord
        {
            Offset = offset, Length = length, NameOffset = nameOffset, NameLength = nameLength, Next = _records.Count + 1, Kind = kind,
        });
        if (opens)
        {
            if (_open.Count == MostDepth)
            {
                throw Fault("more than 32 arrays or objects stand in each other", offset);
            }

            _open.Push(_records.Count - 1);
        }
    }

    /// <summary>The array or object that was begun last ends.</summary>
    public void Close(int end)
    {
        Sum((byte)SceneKind.End);
        int index = _open.Pop();
        SceneRecord record = _records[index];
        record.Next = _records.Count;
        record.Length = end - record.Offset;
        _records[index] = record;
    }

    public string Name(int offset, int length) => Encoding.UTF8.GetString(Bytes, offset, length);

    public SceneFileException Fault(string problem, int offset, Exception? cause = null)
    {
        Place(offset, out long line, out long position);
        return new SceneFileException(problem, "", "", offset, line, position, cause);
    }

    /// <summary>Line and place of a byte, from 1; both 0 in a binary file.</summary>
    public void Place(int offset, out long line, out long position)
    {
        line = IsText ? 1 : 0;
        int start = 0;
        for (int i = 0; IsText && i < offset && i < Bytes.Length; i++)
        {
            if (Bytes[i] == '\n')
            {
                line++;
                start = i + 1;
            }
        }

        position = IsText ? offset - start + 1 : 0;
    }

    /// <summary>The names and places that lead to a value.</summary>
    public string PathOf(int index)
    {
        var path = new StringBuilder();
        int at = 0;
        while (at != index)
        {
            bool isArray = _records[at].Kind == SceneKind.Array;
            int place = 0;
            int end = _records[at].Next;
            at++;
            while (at < end && _records[at].Next <= index)
            {
                at = _records[at].Next;
                place++;
            }

            if (isArray)
            {
                path.Append('[').Append(place.ToString(System.Globalization.CultureInfo.InvariantCulture)).Append(']');
            }
            else
            {
                path.Append(path.Length > 0 ? "." : "").Append(Name(_records[at].NameOffset, _records[at].NameLength));
            }
        }

        return path.ToString();
    }

    private void Sum(ReadOnlySpan<byte> bytes)
    {
        foreach (byte b in bytes)
        {
            Sum(b);
        }

        Sum(0xFF);
    }

    private void Sum(byte b) => _sum = (_sum ^ b) * 1099511628211;
}
