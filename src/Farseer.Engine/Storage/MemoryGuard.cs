using System;
using System.Diagnostics;

namespace Farseer.Engine.Storage;

/// <summary>
/// Checks that only the guarded build has (and the debug build, as far as indices are concerned): property <c>Guarded=true</c>, which
/// defines GUARDED and takes the files of <c>Storage/Guarded</c> in place of those of the same name. In the ordinary build the calls are
/// left out.
/// </summary>
internal static partial class MemoryGuard
{
    /// <summary>Throws if memory beside any column was written.</summary>
    [Conditional("GUARDED")]
    public static void Verify() => VerifyBlocks();

    /// <summary>Throws if a place is beyond what is in use.</summary>
    [Conditional("GUARDED")]
    [Conditional("DEBUG")]
    public static void CheckIndex(int index, int count, Type type)
    {
        if ((uint)index >= (uint)count)
        {
            throw new MemoryFaultException($"Place {index} of {count} of {type} was asked for.");
        }
    }

    /// <summary>Fills memory whose content is undefined with numbers that nobody takes for a result.</summary>
    [Conditional("GUARDED")]
    public static unsafe void Spoil(void* start, long bytes) => SpoilBytes((byte*)start, bytes);

    static partial void VerifyBlocks();

    static unsafe partial void SpoilBytes(byte* start, long bytes);
}

/// <summary>The engine has used memory that it may not use.</summary>
internal sealed class MemoryFaultException : Exception
{
    public MemoryFaultException(string message)
        : base(message)
    {
    }
}
