using System;

namespace Farseer.Scenes;

/// <summary>A scene file that cannot be used; the message is one line with the place.</summary>
public sealed class SceneFileException : Exception
{
    public SceneFileException(string message)
        : base(message)
    {
    }
}
