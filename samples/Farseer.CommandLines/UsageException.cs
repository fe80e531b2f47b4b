using System;

namespace Farseer.CommandLines;

/// <summary>The command line asks for something that is not there; the message is the one line that the user sees.</summary>
public sealed class UsageException : Exception
{
    public UsageException(string message)
        : base(message)
    {
    }
}
