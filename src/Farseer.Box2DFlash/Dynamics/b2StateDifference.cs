using Farseer.Engine.Storage;

namespace Box2D.Dynamics;

/// <summary>A field of the state that has one value here and another one there: see <see cref="b2StateComparison"/>.</summary>
/// <example>
/// <code>
/// foreach (b2StateDifference difference in world.Compare(other).Differences)
/// {
///     Console.WriteLine(difference.Item + " " + difference.Field + ": " + difference.FirstBits + ", " + difference.SecondBits);
/// }
/// </code>
/// </example>
public sealed class b2StateDifference
{
    internal b2StateDifference(in StateMismatch mismatch, string item)
    {
        Section = mismatch.Note.Part;
        Index = mismatch.Record >= 0 ? mismatch.Record : mismatch.Note.Item;
        Item = item;
        Field = mismatch.Field;
        FirstValue = mismatch.One;
        SecondValue = mismatch.Other;
        FirstBits = mismatch.OneBits;
        SecondBits = mismatch.OtherBits;
    }

    /// <summary>The part of the simulation that the field belongs to: that of a body, shape or joint, or one of the solver.</summary>
    public string Section { get; }

    /// <summary>Which of several the field belongs to, counted from 0; −1 if there is one alone.</summary>
    public int Index { get; }

    /// <summary>
    /// The item that it concerns, as far as that is known: a body, shape or joint by its index in the list, or a pair of shapes; else
    /// empty.
    /// </summary>
    public string Item { get; }

    /// <summary>The name of the field.</summary>
    public string Field { get; }

    /// <summary>Its value in the first state.</summary>
    public string FirstValue { get; }

    /// <summary>Its value in the second state.</summary>
    public string SecondValue { get; }

    /// <summary>The bits of its value in the first state, hexadecimal; empty for a reference to an object.</summary>
    public string FirstBits { get; }

    /// <summary>The bits of its value in the second state, hexadecimal; empty for a reference to an object.</summary>
    public string SecondBits { get; }

    /// <summary>All of it in a line.</summary>
    /// <returns>A line of text.</returns>
    public override string ToString() => StateReport.Line(Section, Index, Item, Field, FirstValue, SecondValue, FirstBits, SecondBits);
}
