using System;
using System.Buffers.Binary;

namespace Farseer.Rollback;

/// <summary>
/// What peers send: all inputs that the other has not acknowledged, so that a lost packet needs no answer, and the checksum of a
/// frame of which the sender knows all inputs.
/// </summary>
/// <param name="Next">The frame of the other's inputs that the sender waits for: it has all before.</param>
/// <param name="First">Frame of the first input.</param>
/// <param name="CheckedFrame">The frame of <paramref name="Checksum"/>; 0: none.</param>
/// <param name="Checksum">The checksum of that frame.</param>
/// <param name="Inputs">One a frame.</param>
internal sealed record InputPacket(int Next, int First, int CheckedFrame, ulong Checksum, byte[] Inputs)
{
    private const int HeadBytes = 20;

    public byte[] ToBytes()
    {
        byte[] bytes = new byte[HeadBytes + Inputs.Length];
        BinaryPrimitives.WriteInt32LittleEndian(bytes, Next);
        BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(4), First);
        BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(8), CheckedFrame);
        BinaryPrimitives.WriteUInt64LittleEndian(bytes.AsSpan(12), Checksum);
        Inputs.CopyTo(bytes, HeadBytes);
        return bytes;
    }

    /// <summary>Null of bytes that are no packet.</summary>
    public static InputPacket? Read(ReadOnlySpan<byte> bytes) =>
        bytes.Length < HeadBytes
            ? null
            : new InputPacket(
                BinaryPrimitives.ReadInt32LittleEndian(bytes),
                BinaryPrimitives.ReadInt32LittleEndian(bytes[4..]),
                BinaryPrimitives.ReadInt32LittleEndian(bytes[8..]),
                BinaryPrimitives.ReadUInt64LittleEndian(bytes[12..]),
                bytes[HeadBytes..].ToArray());
}
