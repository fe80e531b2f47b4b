using System.Text;

namespace Farseer.Samples.Terminal;

/// <summary>One row of coloured text that never grows wider than the terminal.</summary>
internal sealed class TextRow
{
    private readonly StringBuilder _text = new();
    private readonly int _width;
    private readonly bool _colored;
    private int _used;

    public TextRow(int width, bool colored)
    {
        _width = width;
        _colored = colored;
    }

    public TextRow Add(string text, byte color)
    {
        int room = _width - _used;
        string shown = text.Length > room ? text[..room] : text;
        if (shown.Length == 0)
        {
            return this;
        }

        if (_colored)
        {
            Ansi.AppendColor(_text, color);
        }

        _text.Append(shown);
        _used += shown.Length;
        return this;
    }

    public override string ToString() => _colored ? _text + Ansi.Plain : _text.ToString();
}
