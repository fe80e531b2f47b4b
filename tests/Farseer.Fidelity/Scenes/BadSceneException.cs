using System;

namespace Farseer.Fidelity.Scenes;

/// <summary>A scene file, folder or argument that cannot be used; the message is one line for the user.</summary>
public sealed class BadSceneException : Exception
{
    public BadSceneException(string message)
        : base(message)
    {
    }
}
