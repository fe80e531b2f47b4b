using System;

namespace Farseer.Beside;

/// <summary>A mistake in the command line, or a build that cannot be made; its message is what the user sees.</summary>
internal sealed class UsageException : Exception
{
    public UsageException(string message)
        : base(message)
    {
    }
}
