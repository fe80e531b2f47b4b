using System.Runtime.CompilerServices;

namespace Farseer.Engine.BroadPhase;

/// <summary>Which proxies look for pairs, and which pairs of them count; the one place where this is said.</summary>
internal static class PairRule
{
    /// <summary>Bits of <see cref="ProxyFlags"/>.</summary>
    private const int KeyShift = 3;

    /// <summary>True if the proxy is alive and moved: it must look for pairs.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Seeks(ProxyFlags flags) =>
        (flags & (ProxyFlags.Alive | ProxyFlags.Moved)) == (ProxyFlags.Alive | ProxyFlags.Moved);

    /// <summary>For two live proxies whose boxes overlap: at least one moved, not both static, of different bodies.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Wants(in ProxyInfo a, in ProxyInfo b) =>
        a.Body != b.Body & ((a.Flags | b.Flags) & ProxyFlags.Moved) != 0 & (a.Flags & b.Flags & ProxyFlags.Static) == 0;

    /// <summary>Body and flags of a live proxy in one number, for searches that keep copies close together.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Key(in ProxyInfo info) => (info.Body << KeyShift) | (int)info.Flags;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Seeks(int key) => Seeks((ProxyFlags)key);

    /// <summary>The same rule for two keys.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Wants(int a, int b) =>
        (a ^ b) >> KeyShift != 0 & ((a | b) & (int)ProxyFlags.Moved) != 0 & (a & b & (int)ProxyFlags.Static) == 0;
}
