using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Storage;

/// <summary>
/// An open-addressing map from a pair key to an index, expected O(1) an operation. A key that packs two small numbers must be
/// mixed by multiplication: the usual hash (low half xor high half) sends neighbouring pairs to the same slot. Removal shifts the run
/// back instead of leaving tombstones, so a map in steady use never has to be rebuilt. There is no enumeration on
/// purpose: its order would be that of the hash.
/// </summary>
/// <remarks>
/// While both numbers of all keys and all values are small enough, key and value share a word: that is two thirds of the memory, and one
/// line to wait for instead of two. The first that is larger turns the map into one of keys and values apart, for good.
/// </remarks>
internal sealed unsafe class PairMap
{
    private const ulong Golden = 0x9E3779B97F4A7C15UL;

    /// <summary>Bits of each of the two numbers, and of the value, of an entry of one word.</summary>
    private const int NumberBits = 20;
    private const int ValueBits = 24;
    private const int MostSpare = 1 << 13;
    private const uint NumberMask = (1u << NumberBits) - 1;
    private const uint ValueMask = (1u << ValueBits) - 1;

    // Of one word: the numbers of the key, then the value plus one. Apart: the keys plus one. So an empty slot is zero and new memory is an
    // empty table.
    private Column<ulong> _slots = new Column<ulong>(16);

    // The slots before the last growth, unless they are many: with them a table that goes back to a state and grows again needs no memory.
    [NotState(Why.Room)]
    private Column<ulong>? _spare;

    // The values; null while they are in the slots.
    private Column<int>? _values;
    private int _mask = 15;
    private int _shift = 60;

    public int Count { get; private set; }

    /// <summary>Makes room so that <paramref name="count"/> keys fit without allocation.</summary>
    public void EnsureCapacity(int count)
    {
        // At most half full: a linear probe then looks at 1.5 slots for a hit and 2.5 for a miss.
        long wanted = 16;
        while (wanted < (long)count * 2)
        {
            wanted *= 2;
        }

        if (wanted > _mask + 1)
        {
            Rehash(checked((int)wanted), _values != null);
        }
    }

    public void Clear()
    {
        if (Count > 0)
        {
            Unsafe.InitBlock(_slots.Pointer, 0, checked((uint)(_mask + 1) * sizeof(ulong)));
            Count = 0;
        }
    }

    public bool TryGet(ulong key, out int value)
    {
        int slot = Find(key);
        value = slot < 0 ? 0 : ValueAt(slot);
        return slot >= 0;
    }

    public bool Contains(ulong key) => Find(key) >= 0;

    /// <summary>Asks for what <see cref="Contains"/> is going to read.</summary>
    public void AskFor(ulong key) => Prefetch.Line(_slots.Pointer + Home(key));

    /// <summary>Asks for what <see cref="TryGet"/> and <see cref="Remove(ulong)"/> are going to read.</summary>
    public void AskForValue(ulong key)
    {
        int home = Home(key);
        Prefetch.Line(_slots.Pointer + home);
        if (_values != null)
        {
            Prefetch.Line(_values.Pointer + home);
        }
    }

    /// <summary>Adds the key, or changes the value of one that is there, which is at least 0. Returns true if the key is new.</summary>
    public bool Set(ulong key, int value)
    {
        System.Diagnostics.Debug.Assert(key + 1 != 0, "the key of all ones marks nothing");
        if ((Count + 1) * 2L > _mask + 1)
        {
            EnsureCapacity(Count + 1);
        }

        if (_values == null && !(IsShort(key) && (uint)value < ValueMask))
        {
            Rehash(_mask + 1, apart: true);
        }

        ulong* slots = _slots.Pointer;
        int slot = Home(key);
        while (slots[slot] != 0)
        {
            if (KeyAt(slot) == key)
            {
                Put(slot, key, value);
                return false;
            }

            slot = (slot + 1) & _mask;
        }

        Put(slot, key, value);
        Count++;
        return true;
    }

    public bool Remove(ulong key) => Remove(key, out _);

    public bool Remove(ulong key, out int value)
    {
        int hole = Find(key);
        if (hole < 0)
        {
            value = 0;
            return false;
        }

        ulong* slots = _slots.Pointer;
        value = ValueAt(hole);
        int next = hole;
        while (true)
        {
            next = (next + 1) & _mask;
            if (slots[next] == 0)
            {
                break;
            }

            // An entry may move back to the hole unless its home lies after the hole.
            int distanceToHome = (next - Home(KeyAt(next))) & _mask;
            int distanceToHole = (next - hole) & _mask;
            if (distanceToHome >= distanceToHole)
            {
                slots[hole] = slots[next];
                if (_values != null)
                {
                    _values[hole] = _values[next];
                }

                hole = next;
            }
        }

        slots[hole] = 0;
        Count--;
        return true;
    }

    private int Find(ulong key)
    {
        ulong* slots = _slots.Pointer;
        int slot = Home(key);
        if (_values != null)
        {
            while (slots[slot] != 0)
            {
                if (slots[slot] == key + 1)
                {
                    return slot;
                }

                slot = (slot + 1) & _mask;
            }

            return -1;
        }

        ulong wanted = Shorten(key);
        while (slots[slot] != 0)
        {
            if ((slots[slot] >> ValueBits) == wanted)
            {
                return IsShort(key) ? slot : -1;
            }

            slot = (slot + 1) & _mask;
        }

        return -1;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsShort(ulong key) => (key & ~(((ulong)NumberMask << 32) | NumberMask)) == 0;

    /// <summary>The numbers of a key side by side; of a key that is not short it may be those of another.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ulong Shorten(ulong key) => (((key >> 32) & NumberMask) << NumberBits) | (key & NumberMask);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private ulong KeyAt(int slot) => KeyOf(_slots.Pointer[slot], _values != null);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ulong KeyOf(ulong entry, bool apart) =>
        apart ? entry - 1 : ((entry >> (NumberBits + ValueBits)) << 32) | ((entry >> ValueBits) & NumberMask);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int ValueAt(int slot) => _values != null ? _values.Pointer[slot] : ValueOf(_slots.Pointer[slot]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int ValueOf(ulong entry) => (int)(entry & ValueMask) - 1;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Put(int slot, ulong key, int value)
    {
        if (_values == null)
        {
            _slots.Pointer[slot] = (Shorten(key) << ValueBits) | (uint)(value + 1);
            return;
        }

        _slots.Pointer[slot] = key + 1;
        _values.Pointer[slot] = value;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int Home(ulong key)
    {
        // The first product carries the lower half upwards, the shift brings the upper half down, the second product mixes them:
        // every step can be undone, so no two keys collide before the cut to the table's size.
        ulong mixed = (key + 1) * Golden;
        mixed ^= mixed >> 32;
        return (int)((mixed * Golden) >> _shift);
    }

    private void Rehash(int count, bool apart)
    {
        Column<ulong> oldSlots = _slots;
        Column<int>? oldValues = _values;
        int oldCount = _mask + 1;
        if (_spare?.Capacity >= count)
        {
            _slots = _spare;
            _spare = oldSlots;
        }
        else if (_slots.Capacity >= count && _spare?.Capacity >= oldCount)
        {
            Unsafe.CopyBlock(_spare.Pointer, _slots.Pointer, (uint)(oldCount * sizeof(ulong)));
            oldSlots = _spare;
        }
        else
        {
            _slots = new Column<ulong>(count);
            _spare = oldSlots.Capacity <= MostSpare ? oldSlots : null;
        }

        new System.Span<ulong>(_slots.Pointer, _slots.Capacity).Clear();
        _values = apart ? new Column<int>(count) : null;
        _mask = count - 1;
        _shift = 64;
        for (int s = count; s > 1; s >>= 1)
        {
            _shift--;
        }

        for (int i = 0; i < oldCount; i++)
        {
            ulong entry = oldSlots.Pointer[i];
            if (entry == 0)
            {
                continue;
            }

            ulong key = KeyOf(entry, oldValues != null);
            int slot = Home(key);
            while (_slots.Pointer[slot] != 0)
            {
                slot = (slot + 1) & _mask;
            }

            Put(slot, key, oldValues != null ? oldValues.Pointer[i] : ValueOf(entry));
        }
    }

    /// <summary>
    /// Writes, or reads, what later steps read of it. The table comes back in the size that it had: a larger one would have its
    /// entries elsewhere, and in what order they are removed matters to nobody, but the values would have to be put in one by
    /// one.
    /// </summary>
    public void Visit(StateStream s)
    {
        Count = s.Value(Count);
        s.Value(ref _mask);
        s.Value(ref _shift);
        if (s.Lacks(_values))
        {
            _values = new Column<int>();
        }

        s.Reference(ref _values);

        // A smaller one may have been made since.
        _slots.EnsureCapacity(_mask + 1);
        _values?.EnsureCapacity(_mask + 1);
        s.Column(_slots);
        if (_values != null)
        {
            s.Column(_values);
        }
    }
}
