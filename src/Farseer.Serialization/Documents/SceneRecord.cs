namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>A value of a document: where it stands in the file, and where it ends among the records.</summary>
internal struct SceneRecord
{
    public int Offset;
    public int Length;

    /// <summary>Where the name of a member stands; below 0: the value has none.</summary>
    public int NameOffset;
    public int NameLength;

    /// <summary>The record behind the value and all that is in it.</summary>
    public int Next;
    public SceneKind Kind;
}
