namespace Farseer.Engine.Storage;

/// <summary>
/// Sorts unsigned keys, with or without a payload, in ascending order: O(n) a byte of key, stable, no allocation once the scratch memory
/// has grown. Bytes that are the same in all keys cost one counting pass together and no move, so small numbers in wide keys are cheap.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class RadixSort
{
    // Below this count an insertion sort wins over clearing and summing the histograms.
    private const int SmallCount = 48;

    private const int Digits = 8;
    private const int Values = 256;

    private readonly Scratch _scratch = new Scratch();

    /// <summary>Makes room for sorts of so many keys.</summary>
    public void Reserve(int count)
    {
        if (count > SmallCount)
        {
            _scratch.Reserve((count * (sizeof(ulong) + sizeof(int))) + (Digits * Values * sizeof(int)) + 128);
        }
    }

    public void Sort(ulong* keys, int count) => Sort(_scratch, keys, null, count);

    public void Sort(ulong* keys, int* values, int count) => Sort(_scratch, keys, values, count);

    /// <param name="scratch">Where room is found meanwhile.</param>
    /// <param name="keys">Sorted in place.</param>
    /// <param name="values">Moved along with the keys; may be null.</param>
    /// <param name="count">Keys to sort.</param>
    public static void Sort(Scratch scratch, ulong* keys, int* values, int count)
    {
        if (count <= SmallCount)
        {
            SortSmall(keys, values, count);
            return;
        }

        int mark = scratch.Mark;
        int* histograms = scratch.Take<int>(Digits * Values);
        Count(keys, count, histograms);
        ulong* from = keys;
        ulong* to = scratch.Take<ulong>(count);
        int* fromValues = values;
        int* toValues = values == null ? null : scratch.Take<int>(count);
        for (int digit = 0; digit < Digits; digit++)
        {
            int* histogram = histograms + (digit * Values);
            int shift = digit * 8;
            if (histogram[(int)(from[0] >> shift) & 255] == count)
            {
                continue;
            }

            int sum = 0;
            for (int i = 0; i < Values; i++)
            {
                int here = histogram[i];
                histogram[i] = sum;
                sum += here;
            }

            if (values == null)
            {
                for (int i = 0; i < count; i++)
                {
                    ulong key = from[i];
                    to[histogram[(int)(key >> shift) & 255]++] = key;
                }
            }
            else
            {
                for (int i = 0; i < count; i++)
                {
                    ulong key = from[i];
                    int slot = histogram[(int)(key >> shift) & 255]++;
                    to[slot] = key;
                    toValues[slot] = fromValues[i];
                }
            }

            ulong* keySwap = from;
            from = to;
            to = keySwap;
            int* valueSwap = fromValues;
            fromValues = toValues;
            toValues = valueSwap;
        }

        if (from != keys)
        {
            Copy(from, keys, fromValues, values, count);
        }

        scratch.Release(mark);
    }

    /// <summary>Maps a float to a number with the same order; −0 counts as +0. The value must not be NaN.</summary>
    public static uint OrderedBits(float value)
    {
        value += 0f;
        int bits = *(int*)&value;
        return bits < 0 ? ~(uint)bits : (uint)bits | 0x80000000u;
    }

    private static void Count(ulong* keys, int count, int* histograms)
    {
        for (int i = 0; i < Digits * Values; i++)
        {
            histograms[i] = 0;
        }

        for (int i = 0; i < count; i++)
        {
            ulong key = keys[i];
            histograms[(int)key & 255]++;
            histograms[256 + ((int)(key >> 8) & 255)]++;
            histograms[512 + ((int)(key >> 16) & 255)]++;
            histograms[768 + ((int)(key >> 24) & 255)]++;
            histograms[1024 + ((int)(key >> 32) & 255)]++;
            histograms[1280 + ((int)(key >> 40) & 255)]++;
            histograms[1536 + ((int)(key >> 48) & 255)]++;
            histograms[1792 + ((int)(key >> 56) & 255)]++;
        }
    }

    private static void SortSmall(ulong* keys, int* values, int count)
    {
        for (int i = 1; i < count; i++)
        {
            ulong key = keys[i];
            int value = values == null ? 0 : values[i];
            int j = i;
            for (; j > 0 && keys[j - 1] > key; j--)
            {
                keys[j] = keys[j - 1];
                if (values != null)
                {
                    values[j] = values[j - 1];
                }
            }

            keys[j] = key;
            if (values != null)
            {
                values[j] = value;
            }
        }
    }

    private static void Copy(ulong* from, ulong* to, int* fromValues, int* toValues, int count)
    {
        for (int i = 0; i < count; i++)
        {
            to[i] = from[i];
        }

        if (toValues != null)
        {
            for (int i = 0; i < count; i++)
            {
                toValues[i] = fromValues[i];
            }
        }
    }
}
