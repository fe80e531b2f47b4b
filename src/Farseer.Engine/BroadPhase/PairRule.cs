using System.Runtime.CompilerServices;

namespace Farseer.Engine.BroadPhase;

/// <summary>Which proxies look for pairs, and which pairs of them count; the one place where this is said.</summary>
internal static class PairRule
{
    /// <summary>True if the proxy is alive and moved: it must look for pairs.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Seeks(ProxyFlags flags) =>
        (flags & (ProxyFlags.Alive | ProxyFlags.Moved)) == (ProxyFlags.Alive | ProxyFlags.Moved);

    /// <summary>For two live proxies whose boxes overlap: at least one moved, not both static, of different bodies.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Wants(in ProxyInfo a, in ProxyInfo b) =>
        a.Body != b.Body & ((a.Flags | b.Flags) & ProxyFlags.Moved) != 0 & (a.Flags & b.Flags & ProxyFlags.Static) == 0;
}
