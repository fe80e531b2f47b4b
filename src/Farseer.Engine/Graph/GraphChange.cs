namespace Farseer.Engine.Graph;

/// <summary>A row that came or went since the islands were last brought up to date.</summary>
internal struct GraphChange
{
    /// <summary>In <see cref="Contact"/>: the row went.</summary>
    public const int Gone = -1;

    public int BodyA;
    public int BodyB;
    public int Contact;
}
