using System;

namespace Farseer.Accuracy;

/// <summary>A mistake in the command line; its message is the one line that the user sees.</summary>
internal sealed class UsageException : Exception
{
    public UsageException(string message)
        : base(message)
    {
    }
}
