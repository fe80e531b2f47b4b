using System.Globalization;
using System.Text;

namespace Farseer.Samples.Terminal;

/// <summary>The escape sequences in use.</summary>
internal static class Ansi
{
    public const string Plain = "\e[0m";
    public const string ClearScreen = "\e[2J";
    public const string ClearRestOfLine = "\e[K";

    /// <summary>The second screen keeps what the user had on the first. The mouse is reported while a button is held.</summary>
    public const string Enter = "\e[?1049h\e[?25l\e[2J\e[?1002h\e[?1006h";
    public const string Leave = "\e[?1006l\e[?1002l\e[0m\e[?25h\e[?1049l";

    /// <summary>Terminals that know it show the frame at once; the others ignore it.</summary>
    public const string BeginFrame = "\e[?2026h";
    public const string EndFrame = "\e[?2026l";

    public static void AppendColor(StringBuilder text, byte color) =>
        text.Append("\e[38;5;").Append(color.ToString(CultureInfo.InvariantCulture)).Append('m');

    public static void AppendGoTo(StringBuilder text, int row) =>
        text.Append("\e[").Append((row + 1).ToString(CultureInfo.InvariantCulture)).Append(";1H");
}
