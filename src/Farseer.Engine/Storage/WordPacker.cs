using System;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.Arm;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.Storage;

/// <summary>
/// Differences of words in few bytes, four words at a time: a difference takes none, two, three or four bytes, without those above that are
/// zero, and one byte tells which of these it is for each of the four, the lower bits of the choices in its lower half. Where the processor
/// has an instruction that moves bytes as a table says, the four are packed at once; the bytes are the same either way.
/// </summary>
internal sealed unsafe class WordPacker
{
    /// <summary>Words that are packed at once.</summary>
    public const int Words = 4;

    /// <summary>Most bytes of four differences; so many are written or read in any case, whatever of them counts.</summary>
    public const int MostBytes = Words * sizeof(uint);

    private const int Codes = 256;

    // By the byte that tells the choices: how many bytes they are, and from where each byte comes on the way there and back.
    private readonly Column<byte> _length = new Column<byte>(Codes);
    private readonly Column<byte> _packing = new Column<byte>(Codes * MostBytes);
    private readonly Column<byte> _unpacking = new Column<byte>(Codes * MostBytes);

    public WordPacker()
    {
        const byte Nowhere = 0x80;
        for (int code = 0; code < Codes; code++)
        {
            byte* packing = _packing.Pointer + (code * MostBytes);
            byte* unpacking = _unpacking.Pointer + (code * MostBytes);
            int at = 0;
            for (int i = 0; i < MostBytes; i++)
            {
                packing[i] = Nowhere;
                unpacking[i] = Nowhere;
            }

            for (int word = 0; word < Words; word++)
            {
                for (int i = 0; i < BytesOf(code, word); i++, at++)
                {
                    packing[at] = (byte)((word * sizeof(uint)) + i);
                    unpacking[(word * sizeof(uint)) + i] = (byte)at;
                }
            }

            _length[code] = (byte)at;
        }
    }

    /// <summary>Packs what makes the first words of the second.</summary>
    /// <param name="from">Four words.</param>
    /// <param name="to">What they become.</param>
    /// <param name="at">Where the bytes go to; there is room for <see cref="MostBytes"/>.</param>
    /// <param name="code">Which choices were taken; 0: nothing differs.</param>
    /// <returns>Where the next bytes go to.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public byte* Pack(uint* from, uint* to, byte* at, out byte code)
    {
#if NET8_0_OR_GREATER
        if (MovesBytes)
        {
            Vector128<uint> difference = Vector128.Load(to) - Vector128.Load(from);
            Vector128<uint> folded = (difference << 1) ^ Vector128.ShiftRightArithmetic(difference.AsInt32(), 31).AsUInt32();
            uint zero = Vector128.Equals(folded, Vector128<uint>.Zero).ExtractMostSignificantBits();
            uint two = Vector128.Equals(folded & Vector128.Create(0xFFFF0000), Vector128<uint>.Zero).ExtractMostSignificantBits();
            uint three = Vector128.Equals(folded & Vector128.Create(0xFF000000), Vector128<uint>.Zero).ExtractMostSignificantBits();
            code = (byte)((two & ~zero) | (~three & 0xF) | ((~two & 0xF) << Words));
            Move(folded.AsByte(), Vector128.Load(_packing.Pointer + (code * MostBytes))).Store(at);
            return at + _length.Pointer[code];
        }
#endif
        return PackEach(from, to, at, out code);
    }

    /// <summary>Packs what makes the first sixteen words of the second, four by four.</summary>
    /// <param name="from">Sixteen words.</param>
    /// <param name="to">What they become.</param>
    /// <param name="codes">Where the choices of each four go to.</param>
    /// <param name="at">Where the bytes go to; there is room for four times <see cref="MostBytes"/>.</param>
    /// <returns>Where the next bytes go to.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public byte* PackBlock(uint* from, uint* to, byte* codes, byte* at)
    {
#if NET8_0_OR_GREATER
        if (MovesBytes && Vector512.IsHardwareAccelerated)
        {
            Vector512<uint> difference = Vector512.Load(to) - Vector512.Load(from);
            Vector512<uint> folded = (difference << 1) ^ Vector512.ShiftRightArithmetic(difference.AsInt32(), 31).AsUInt32();
            var zero = (uint)Vector512.Equals(folded, Vector512<uint>.Zero).ExtractMostSignificantBits();
            var two = (uint)Vector512.Equals(folded & Vector512.Create(0xFFFF0000), Vector512<uint>.Zero).ExtractMostSignificantBits();
            var three = (uint)Vector512.Equals(folded & Vector512.Create(0xFF000000), Vector512<uint>.Zero).ExtractMostSignificantBits();
            uint low = (two & ~zero) | ~three;
            uint high = ~two << Words;
            at = Put(folded.GetLower().GetLower(), (low & 0xF) | (high & 0xF0), codes, at);
            at = Put(folded.GetLower().GetUpper(), ((low >> 4) & 0xF) | ((high >> 4) & 0xF0), codes + 1, at);
            at = Put(folded.GetUpper().GetLower(), ((low >> 8) & 0xF) | ((high >> 8) & 0xF0), codes + 2, at);
            return Put(folded.GetUpper().GetUpper(), ((low >> 12) & 0xF) | ((high >> 12) & 0xF0), codes + 3, at);
        }
#endif
        at = Pack(from, to, at, out codes[0]);
        at = Pack(from + Words, to + Words, at, out codes[1]);
        at = Pack(from + (2 * Words), to + (2 * Words), at, out codes[2]);
        return Pack(from + (3 * Words), to + (3 * Words), at, out codes[3]);
    }

    /// <summary>Changes four words by what was packed.</summary>
    /// <returns>Where the bytes of the next four are.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public byte* Unpack(byte* at, byte code, uint* words)
    {
#if NET8_0_OR_GREATER
        if (MovesBytes)
        {
            Vector128<uint> folded = Move(Vector128.Load(at), Vector128.Load(_unpacking.Pointer + (code * MostBytes))).AsUInt32();
            Vector128<uint> difference = (folded >> 1) ^ (Vector128<uint>.Zero - (folded & Vector128<uint>.One));
            (Vector128.Load(words) + difference).Store(words);
            return at + _length.Pointer[code];
        }
#endif
        return UnpackEach(at, code, words);
    }

    /// <summary>How many bytes the difference of a word takes.</summary>
    private static int BytesOf(int code, int word)
    {
        int choice = ((code >> word) & 1) | (((code >> (word + Words)) & 1) << 1);
        return choice == 0 ? 0 : choice + 1;
    }

    private static byte* PackEach(uint* from, uint* to, byte* at, out byte code)
    {
        int choices = 0;
        for (int word = 0; word < Words; word++)
        {
            uint folded = StateBlock.Fold(to[word] - from[word]);
            int choice = folded == 0 ? 0 : folded < 1u << 16 ? 1 : folded < 1u << 24 ? 2 : 3;
            choices |= ((choice & 1) | ((choice >> 1) << Words)) << word;
            for (int i = choice == 0 ? -1 : choice; i >= 0; i--, folded >>= 8)
            {
                *at++ = (byte)folded;
            }
        }

        code = (byte)choices;
        return at;
    }

    private static byte* UnpackEach(byte* at, byte code, uint* words)
    {
        for (int word = 0; word < Words; word++)
        {
            uint folded = 0;
            int bytes = BytesOf(code, word);
            for (int i = 0; i < bytes; i++)
            {
                folded |= (uint)*at++ << (8 * i);
            }

            words[word] += StateBlock.Unfold(folded);
        }

        return at;
    }

#if NET8_0_OR_GREATER
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private byte* Put(Vector128<uint> folded, uint code, byte* codes, byte* at)
    {
        *codes = (byte)code;
        Move(folded.AsByte(), Vector128.Load(_packing.Pointer + (code * MostBytes))).Store(at);
        return at + _length.Pointer[code];
    }

    private static bool MovesBytes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => BitConverter.IsLittleEndian && (Ssse3.IsSupported || AdvSimd.Arm64.IsSupported);
    }

    /// <summary>Bytes from the places that are given, zero for those that are none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<byte> Move(Vector128<byte> bytes, Vector128<byte> places) =>
        Ssse3.IsSupported ? Ssse3.Shuffle(bytes, places) : AdvSimd.Arm64.VectorTableLookup(bytes, places);
#endif
}
