using System.Collections.Generic;
using System.Text;

namespace Farseer.Engine.Storage;

/// <summary>Differences of states as text.</summary>
internal static class StateReport
{
    /// <summary>One of them.</summary>
    public static string Line(
        string section, int index, string item, string field, string first, string second, string firstBits, string secondBits)
    {
        var text = new StringBuilder(section);
        if (index >= 0)
        {
            text.Append(' ').Append(index);
        }

        if (item.Length > 0)
        {
            text.Append(" (").Append(item).Append(')');
        }

        text.Append(text.Length > 0 ? " " : "").Append(field).Append(": ");
        Append(text, first, firstBits);
        text.Append(", ");
        Append(text, second, secondBits);
        return text.ToString();
    }

    /// <summary>All of them.</summary>
    public static string Text(IReadOnlyCollection<object> differences)
    {
        if (differences.Count == 0)
        {
            return "The states are the same.";
        }

        var text = new StringBuilder();
        foreach (object difference in differences)
        {
            text.Append(text.Length > 0 ? "\n" : "").Append(difference);
        }

        return text.ToString();
    }

    private static void Append(StringBuilder text, string value, string bits)
    {
        text.Append(value);
        if (bits.Length > 0 && bits != value)
        {
            text.Append(" [").Append(bits).Append(']');
        }
    }
}
