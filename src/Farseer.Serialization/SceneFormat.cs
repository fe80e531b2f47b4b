namespace FarseerGames.FarseerPhysics.Serialization;

/// <summary>How a scene is written. Both hold the same; which one a file has is found out when it is loaded.</summary>
public enum SceneFormat
{
    /// <summary>JSON: to read, to compare and to write by hand. The default.</summary>
    Json,

    /// <summary>Binary: a third of the size.</summary>
    Binary,
}
