namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>Whole numbers of as many bytes as they need, seven bits in each.</summary>
internal static class VarInt
{
    public static bool TryRead(byte[] bytes, ref int at, out ulong value)
    {
        value = 0;
        for (int shift = 0; shift < 64; shift += 7)
        {
            if (at >= bytes.Length)
            {
                return false;
            }

            byte part = bytes[at++];
            value |= (ulong)(part & 0x7F) << shift;
            if (part < 0x80)
            {
                return true;
            }
        }

        return false;
    }

    public static long Signed(ulong value) => (long)(value >> 1) ^ -(long)(value & 1);
}
