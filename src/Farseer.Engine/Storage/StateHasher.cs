namespace Farseer.Engine.Storage;

/// <summary>
/// A 64-bit hash of memory, the same bits on every processor. Eight numbers take a word each by turns: none waits for another one.
/// </summary>
internal static unsafe class StateHasher
{
    public const ulong Start = 14695981039346656037UL;

    private const ulong Prime = 0x9E3779B185EBCA87UL;
    private const int Lanes = 8;

    /// <summary>Adds a number.</summary>
    public static ulong Add(ulong hash, ulong value)
    {
        hash = (hash ^ value) * Prime;
        return hash ^ (hash >> 29);
    }

    /// <summary>
    /// Adds all that a stream holds, but for references and for what is not the same in simulations that were made in the same way.
    /// </summary>
    public static ulong Add(ulong hash, StateStream s)
    {
        int at = 0;
        for (int i = 0; i < s.LocalCount; i++)
        {
            hash = Add(hash, (byte*)s.Words + at, s.Local(i).At - at);
            at = s.Local(i).End;
        }

        return Add(hash, (byte*)s.Words + at, s.Length - at);
    }

    /// <summary>Adds so many bytes.</summary>
    public static ulong Add(ulong hash, byte* start, long bytes)
    {
        ulong* lanes = stackalloc ulong[Lanes];
        for (int i = 0; i < Lanes; i++)
        {
            lanes[i] = hash + (Prime * (ulong)i);
        }

        ulong* at = (ulong*)start;
        long blocks = bytes / (Lanes * sizeof(ulong));
        Mix(lanes, at, blocks);
        byte* rest = (byte*)(at + (blocks * Lanes));
        for (byte* end = start + bytes; rest < end; rest++)
        {
            lanes[0] = Add(lanes[0], *rest);
        }

        hash = Add(hash, (ulong)bytes);
        for (int i = 0; i < Lanes; i++)
        {
            hash = Add(hash, lanes[i]);
        }

        return hash;
    }

    private static void Mix(ulong* lanes, ulong* at, long blocks)
    {
        ulong a = lanes[0];
        ulong b = lanes[1];
        ulong c = lanes[2];
        ulong d = lanes[3];
        ulong e = lanes[4];
        ulong f = lanes[5];
        ulong g = lanes[6];
        ulong h = lanes[7];
        for (; blocks > 0; blocks--, at += Lanes)
        {
            a = Add(a, at[0]);
            b = Add(b, at[1]);
            c = Add(c, at[2]);
            d = Add(d, at[3]);
            e = Add(e, at[4]);
            f = Add(f, at[5]);
            g = Add(g, at[6]);
            h = Add(h, at[7]);
        }

        lanes[0] = a;
        lanes[1] = b;
        lanes[2] = c;
        lanes[3] = d;
        lanes[4] = e;
        lanes[5] = f;
        lanes[6] = g;
        lanes[7] = h;
    }
}
