using System;
using System.Text.Json;

namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>Takes JSON apart. Comments, and a comma after the last item, are allowed: people write such files.</summary>
internal static class JsonParser
{
    public static void Parse(SceneDocument document)
    {
        ReadOnlySpan<byte> bytes = document.Bytes;
        int start = bytes.Length >= 3 && bytes[0] == 0xEF && bytes[1] == 0xBB && bytes[2] == 0xBF ? 3 : 0;
        var options = new JsonReaderOptions
        {
            CommentHandling = JsonCommentHandling.Skip,
            AllowTrailingCommas = true,
            MaxDepth = SceneDocument.MostDepth,
        };
        var reader = new Utf8JsonReader(bytes.Slice(start), options);
        int name = -1;
        int nameLength = 0;
        try
        {
            while (reader.Read())
            {
                int offset = start + (int)reader.TokenStartIndex;
                int length = (int)(start + reader.BytesConsumed) - offset;
                switch (reader.TokenType)
                {
                    case JsonTokenType.PropertyName:
                        name = offset + 1;
                        nameLength = reader.ValueSpan.Length;
                        continue;
                    case JsonTokenType.EndObject or JsonTokenType.EndArray:
                        document.Close(offset + 1);
                        break;
                    default:
                        // A number ends where its digits do; what the reader has consumed may be more.
                        bool isNumber = reader.TokenType == JsonTokenType.Number;
                        document.Add(Kind(reader.TokenType), offset, isNumber ? reader.ValueSpan.Length : length, name, nameLength);
                        break;
                }

                name = -1;
                nameLength = 0;
            }
        }
        catch (JsonException exception)
        {
            string problem = exception.Message;
            int end = problem.IndexOf(" LineNumber:", StringComparison.Ordinal);
            problem = end > 0 ? problem.Substring(0, end) : problem;
            throw new SceneFileException(
                "is no JSON. " + problem,
                "",
                "",
                start + reader.BytesConsumed,
                (exception.LineNumber ?? 0) + 1,
                (exception.BytePositionInLine ?? 0) + 1,
                exception);
        }
    }

    private static SceneKind Kind(JsonTokenType type) => type switch
    {
        JsonTokenType.StartObject => SceneKind.Object,
        JsonTokenType.StartArray => SceneKind.Array,
        JsonTokenType.String => SceneKind.String,
        JsonTokenType.Number => SceneKind.Number,
        JsonTokenType.True => SceneKind.True,
        JsonTokenType.False => SceneKind.False,
        _ => SceneKind.Null,
    };
}
