using System;
using System.Collections.Generic;
using System.IO;
using System.Text;

namespace Farseer.Samples.Terminal;

/// <summary>
/// The whole terminal as rows of text. Only rows that changed are written, all in one go: nothing flickers, and a slow
/// line carries little.
/// </summary>
internal sealed class TerminalScreen : IDisposable
{
    private readonly Stream _output = Console.OpenStandardOutput();
    private readonly StringBuilder _frame = new();
    private readonly List<string> _shown = [];
    private readonly bool _treatedControlC;
    private byte[] _bytes = new byte[16384];
    private int _width;
    private int _height;

    public TerminalScreen()
    {
        // Ctrl+C must not leave the user without a cursor on a foreign screen: it arrives as a key.
        _treatedControlC = Console.TreatControlCAsInput;
        Console.TreatControlCAsInput = true;
        _frame.Append(Ansi.Enter);
        Flush();
    }

    /// <summary>Size in characters, read anew: the window may have been resized.</summary>
    public (int Width, int Height) Measure()
    {
        int width = Math.Max(1, Console.WindowWidth);
        int height = Math.Max(1, Console.WindowHeight);
        if (width != _width || height != _height)
        {
            _width = width;
            _height = height;
            _shown.Clear();
            _frame.Append(Ansi.Plain).Append(Ansi.ClearScreen);
        }

        return (width, height);
    }

    /// <summary>Shows the rows, the first at the top.</summary>
    public void Show(List<string> rows)
    {
        _frame.Insert(0, Ansi.BeginFrame);
        for (int row = 0; row < rows.Count; row++)
        {
            if (row < _shown.Count && _shown[row] == rows[row])
            {
                continue;
            }

            Ansi.AppendGoTo(_frame, row);
            _frame.Append(rows[row]).Append(Ansi.ClearRestOfLine);
        }

        _shown.Clear();
        _shown.AddRange(rows);
        _frame.Append(Ansi.EndFrame);
        Flush();
    }

    public void Dispose()
    {
        _frame.Clear().Append(Ansi.Leave);
        Flush();
        Console.TreatControlCAsInput = _treatedControlC;
    }

    private void Flush()
    {
        string text = _frame.ToString();
        int most = Encoding.UTF8.GetMaxByteCount(text.Length);
        if (_bytes.Length < most)
        {
            _bytes = new byte[most];
        }

        int count = Encoding.UTF8.GetBytes(text, _bytes);
        _output.Write(_bytes, 0, count);
        _output.Flush();
        _frame.Clear();
    }
}
