namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>What a value of a document is. The numbers stand in binary files.</summary>
internal enum SceneKind : byte
{
    /// <summary>Of binary files: the end of an array.</summary>
    End,

    Null,

    False,

    True,

    /// <summary>A whole number of a binary file.</summary>
    Whole,

    Single,

    Double,

    String,

    /// <summary>Bytes of a binary file; a text of a JSON file that is read as bytes is base 64.</summary>
    Bytes,

    Array,

    Object,

    /// <summary>Floats of a binary file, one after the other.</summary>
    Singles,

    /// <summary>Whole numbers of a binary file, one after the other.</summary>
    Wholes,

    /// <summary>A number of a JSON file, in its own digits.</summary>
    Number,
}
