using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.Numerics;

/// <summary>
/// Asks for memory that is read soon and at places that the processor cannot foresee: records reached by an index. Changes nothing but
/// time, and any address will do; but to take the address of a field is to look whether its record is there: what may lie behind the last
/// record is asked for by counting bytes.
/// </summary>
internal static unsafe class Prefetch
{
    public const int LineBytes = 64;

    /// <summary>False where nothing would be asked for: the walk to what might be can be left out.</summary>
#if NET8_0_OR_GREATER
    public static bool IsUseful => Sse.IsSupported;
#else
    public static bool IsUseful => false;
#endif

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Line(void* address)
    {
#if NET8_0_OR_GREATER
        if (Sse.IsSupported)
        {
            Sse.Prefetch0(address);
        }
#endif
    }

    /// <summary>
    /// The same, no nearer than the second-level cache: for the many lines of what is read some steps on. The nearest cache waits for few
    /// lines at a time, and has no room for so many.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void LineInBulk(void* address)
    {
#if NET8_0_OR_GREATER
        if (Sse.IsSupported)
        {
            Sse.Prefetch1(address);
        }
#endif
    }
}
