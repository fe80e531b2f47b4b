using System;
using System.IO;
using System.Text;
using System.Text.Json;

namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>Writes JSON: an item a line, numbers that belong together in one.</summary>
internal sealed class JsonSink : SceneSink, IDisposable
{
    private readonly MemoryStream _stream = new MemoryStream();
    private readonly Utf8JsonWriter _writer;

    public JsonSink() => _writer = new Utf8JsonWriter(_stream, new JsonWriterOptions { Indented = true });

    public byte[] ToArray()
    {
        _writer.Flush();
        return _stream.ToArray();
    }

    public void Dispose()
    {
        _writer.Dispose();
        _stream.Dispose();
    }

    public override void BeginObject() => _writer.WriteStartObject();

    public override void EndObject() => _writer.WriteEndObject();

    public override void BeginArray() => _writer.WriteStartArray();

    public override void EndArray() => _writer.WriteEndArray();

    public override void Name(string name) => _writer.WritePropertyName(name);

    public override void Null() => _writer.WriteNullValue();

    public override void Flag(bool value) => _writer.WriteBooleanValue(value);

    public override void Whole(long value) => _writer.WriteNumberValue(value);

    public override void Number(float value) => Raw(NumberText.Of(value));

    public override void Number(double value) => Raw(NumberText.Of(value));

    public override void Text(string value) => _writer.WriteStringValue(value);

    public override void Bytes(byte[] value) => _writer.WriteBase64StringValue(value);

    public override void Numbers(ReadOnlySpan<float> values)
    {
        var text = new StringBuilder("[");
        for (int i = 0; i < values.Length; i++)
        {
            text.Append(i == 0 ? "" : ", ").Append(NumberText.Of(values[i]));
        }

        Raw(text.Append(']').ToString());
    }

    public override void Wholes(ReadOnlySpan<int> values)
    {
        var text = new StringBuilder("[");
        for (int i = 0; i < values.Length; i++)
        {
            text.Append(i == 0 ? "" : ", ").Append(values[i].ToString(System.Globalization.CultureInfo.InvariantCulture));
        }

        Raw(text.Append(']').ToString());
    }

    private void Raw(string json) => _writer.WriteRawValue(json, skipInputValidation: true);
}
