using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Storage;

/// <summary>
/// An open-addressing map from a pair key to an index, expected O(1) an operation. A key that packs two small numbers must be
/// mixed by multiplication: the usual hash (low half xor high half) sends neighbouring pairs to the same slot. Removal shifts the run
/// back instead of leaving tombstones, so a map in steady use never has to be rebuilt. There is no enumeration on
/// purpose: its order would be that of the hash.
/// </summary>
internal sealed unsafe class PairMap
{
    private const ulong Golden = 0x9E3779B97F4A7C15UL;

    private Column<ulong> _keys = new Column<ulong>(16);
    private Column<int> _values = new Column<int>(16);
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
            Rehash(checked((int)wanted));
        }
    }

    public void Clear()
    {
        if (Count > 0)
        {
            Unsafe.InitBlock(_keys.Pointer, 0, checked((uint)(_mask + 1) * sizeof(ulong)));
            Count = 0;
        }
    }

    public bool TryGet(ulong key, out int value)
    {
        int slot = Find(key);
        value = slot < 0 ? 0 : _values.Pointer[slot];
        return slot >= 0;
    }

    public bool Contains(ulong key) => Find(key) >= 0;

    /// <summary>Asks for what <see cref="Contains"/> is going to read.</summary>
    public void AskFor(ulong key) => Prefetch.Line(_keys.Pointer + Home(key + 1));

    /// <summary>Asks for what <see cref="TryGet"/> and <see cref="Remove(ulong)"/> are going to read.</summary>
    public void AskForValue(ulong key)
    {
        int home = Home(key + 1);
        Prefetch.Line(_keys.Pointer + home);
        Prefetch.Line(_values.Pointer + home);
    }

    /// <summary>Adds the key, or changes the value of one that is there. Returns true if the key is new.</summary>
    public bool Set(ulong key, int value)
    {
        ulong stored = key + 1;
        System.Diagnostics.Debug.Assert(stored != 0, "the key of all ones marks nothing");
        if ((Count + 1) * 2L > _mask + 1)
        {
            EnsureCapacity(Count + 1);
        }

        ulong* keys = _keys.Pointer;
        int slot = Home(stored);
        while (keys[slot] != 0)
        {
            if (keys[slot] == stored)
            {
                _values.Pointer[slot] = value;
                return false;
            }

            slot = (slot + 1) & _mask;
        }

        keys[slot] = stored;
        _values.Pointer[slot] = value;
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

        ulong* keys = _keys.Pointer;
        int* values = _values.Pointer;
        value = values[hole];
        int next = hole;
        while (true)
        {
            next = (next + 1) & _mask;
            if (keys[next] == 0)
            {
                break;
            }

            // An entry may move back to the hole unless its home lies after the hole.
            int distanceToHome = (next - Home(keys[next])) & _mask;
            int distanceToHole = (next - hole) & _mask;
            if (distanceToHome >= distanceToHole)
            {
                keys[hole] = keys[next];
                values[hole] = values[next];
                hole = next;
            }
        }

        keys[hole] = 0;
        Count--;
        return true;
    }

    // Keys are stored plus one, so that an empty slot is zero and new memory is an empty table.
    private int Find(ulong key)
    {
        ulong stored = key + 1;
        ulong* keys = _keys.Pointer;
        int slot = Home(stored);
        while (keys[slot] != 0)
        {
            if (keys[slot] == stored)
            {
                return slot;
            }

            slot = (slot + 1) & _mask;
        }

        return -1;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int Home(ulong stored)
    {
        // The first product carries the lower half upwards, the shift brings the upper half down, the second product mixes them:
        // every step can be undone, so no two keys collide before the cut to the table's size.
        ulong mixed = stored * Golden;
        mixed ^= mixed >> 32;
        return (int)((mixed * Golden) >> _shift);
    }

    private void Rehash(int slots)
    {
        Column<ulong> oldKeys = _keys;
        Column<int> oldValues = _values;
        int oldSlots = _mask + 1;
        _keys = new Column<ulong>(slots);
        _values = new Column<int>(slots);
        _mask = slots - 1;
        _shift = 64;
        for (int s = slots; s > 1; s >>= 1)
        {
            _shift--;
        }

        ulong* keys = _keys.Pointer;
        for (int i = 0; i < oldSlots; i++)
        {
            ulong stored = oldKeys.Pointer[i];
            if (stored != 0)
            {
                int slot = Home(stored);
                while (keys[slot] != 0)
                {
                    slot = (slot + 1) & _mask;
                }

                keys[slot] = stored;
                _values.Pointer[slot] = oldValues.Pointer[i];
            }
        }
    }
}
