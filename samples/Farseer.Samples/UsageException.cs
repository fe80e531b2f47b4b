using System;

namespace Farseer.Samples;

/// <summary>The command line asks for something that is not there; the message is one line.</summary>
internal sealed class UsageException : Exception
{
    public UsageException(string message)
        : base(message)
    {
    }
}
