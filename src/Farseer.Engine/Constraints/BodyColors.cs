using Farseer.Engine.Storage;

namespace Farseer.Engine.Constraints;

/// <summary>
/// Colours of rows between two bodies: rows of one colour share no body that moves, so their lanes never meet. A body remembers its
/// colours in a mask; a new row starts at a colour drawn from its pair and takes the first that neither body has. Greedy lowest-first
/// colouring solves all rows of one kind (left supports, right supports) together, which pushes large pyramids sideways: of 20
/// rows, at 5 substeps, it left 29 mm/s of sway, the drawn colours 0.2. Rows at something that cannot move have colours of their own,
/// solved last, so that the ground has the last word.
/// </summary>
internal sealed class BodyColors
{
    /// <summary>Colours of rows between two bodies that can move.</summary>
    public const int Dynamic = 40;

    /// <summary>
    /// The first of the last of these, which are for rows of a body that outweighs the other by far: it may have many rows of one of them,
    /// the light one has one. A drum with a hundred contacts had thirty colours of one row, and for the others none.
    /// </summary>
    public const int FirstShared = 36;

    /// <summary>All colours but the overflows; bits of the masks.</summary>
    public const int Masked = 63;

    /// <summary>Rows between moving bodies for which no colour was free.</summary>
    public const int DynamicOverflow = Masked;

    /// <summary>Rows at something that cannot move for which no colour was free.</summary>
    public const int StaticOverflow = Masked + 1;

    public const int Count = Masked + 2;

    /// <summary>Colours among which a new row draws.</summary>
    public const int Drawn = 8;

    /// <summary>
    /// In a mask: the colours that are shared, and whether the body is the heavy one of a row of them. Who is that is not the light one of
    /// another.
    /// </summary>
    private const ulong SharedColors = (1UL << Dynamic) - (1UL << FirstShared);
    private const ulong IsHeavy = 1UL << Masked;

    private readonly Column<ulong> _masks = new Column<ulong>();

    /// <summary>The colours in the order of solving: moving pairs, their overflow, ground pairs, their overflow.</summary>
    public static int InOrder(int position) => position < Dynamic
        ? position
        : position == Dynamic ? DynamicOverflow : position == Count - 1 ? StaticOverflow : position - 1;

    /// <summary>One body of each row of the colour cannot move, and several rows may share it.</summary>
    public static bool IsGrounded(int color) => color >= Dynamic && color != DynamicOverflow;

    /// <summary>Rows of the colour may share the heavier of their bodies.</summary>
    public static bool IsShared(int color) => color is >= FirstShared and < Dynamic;

    public void EnsureBodies(int capacity) => _masks.EnsureCapacity(capacity);

    /// <param name="a">A body of the row.</param>
    /// <param name="b">The other.</param>
    /// <param name="movesA">The first can move.</param>
    /// <param name="movesB">The second can.</param>
    /// <param name="preferred">Colours that a row between moving bodies is to draw from if one of them is free.</param>
    public int Choose(int a, int b, bool movesA, bool movesB, ulong preferred = 0)
    {
        if (movesA && movesB)
        {
            ulong taken = _masks[a] | _masks[b];
            return Draw((preferred & ~taken) != 0 ? taken | ~preferred : taken, a, b);
        }

        return LowestClear(movesA ? _masks[a] : _masks[b], Dynamic, Masked, StaticOverflow);
    }

    /// <summary>A shared colour for a row of two bodies that can move.</summary>
    /// <param name="light">The body that has no other row of it.</param>
    /// <param name="heavy">The one that may, and is not to be marked with it.</param>
    /// <returns>The colour, or -1: there is none.</returns>
    public int ChooseShared(int light, int heavy)
    {
        if ((_masks[light] & IsHeavy) != 0 || (_masks[heavy] & SharedColors) != 0)
        {
            return -1;
        }

        int color = LowestClear(_masks[light], FirstShared, Dynamic, -1);
        _masks[heavy] |= color >= 0 ? IsHeavy : 0;
        return color;
    }

    /// <summary>A body is marked with a colour.</summary>
    public bool Has(int body, int color) => (_masks[body] & (1UL << color)) != 0;

    /// <summary>A body has no rows any more.</summary>
    public void Clear(int body) => _masks[body] = 0;

    public void Mark(int body, int color, bool moves)
    {
        if (moves && color < Masked)
        {
            _masks[body] |= 1UL << color;
        }
    }

    public void Unmark(int body, int color)
    {
        if (color < Masked)
        {
            _masks[body] &= ~(1UL << color);
        }
    }

    private static int Draw(ulong mask, int a, int b)
    {
        uint hash = ((uint)a * 73856093u) ^ ((uint)b * 19349663u);
        hash ^= hash >> 15;
        hash *= 0x2C1B3C6Du;
        hash ^= hash >> 12;
        int start = (int)(hash % Drawn);
        for (int i = 0; i < Drawn; i++)
        {
            int color = (start + i) % Drawn;
            if ((mask & (1UL << color)) == 0)
            {
                return color;
            }
        }

        return LowestClear(mask, Drawn, FirstShared, DynamicOverflow);
    }

    private static int LowestClear(ulong mask, int from, int to, int overflow)
    {
        for (int i = from; i < to; i++)
        {
            if ((mask & (1UL << i)) == 0)
            {
                return i;
            }
        }

        return overflow;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_masks);
    }
}
