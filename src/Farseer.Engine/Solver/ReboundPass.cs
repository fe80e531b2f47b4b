using System;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// The weak bounces of large piles in turmoil, which are not worth the order of <see cref="ImpactPass"/> and would not be through with it within a
/// substep: see <see cref="ReboundKernel"/>.
/// </summary>
internal sealed unsafe class ReboundPass
{
    /// <summary>
    /// Contacts of an island that bounce weakly, and those among them that strike as the step begins, from which on it is in turmoil. A pile
    /// that a few bodies hit keeps the exact order: they come back from it as fast as they should, which by Newton's rule they do not.
    /// </summary>
    private const int Many = 2048;
    private const int ManyStrikes = 256;

    /// <summary>Bundles from one that is read to the one asked for.</summary>
    private const int Ahead = 5;

    /// <summary>The same of those of which nearly all is read.</summary>
    private const int PartingAhead = 2;

    private readonly Column<Entry> _entries = new Column<Entry>();

    /// <summary>Those of which in this substep some contacts approach fast enough to bounce.</summary>
    private readonly Column<Entry> _striking = new Column<Entry>();

    /// <summary>What these are to part with.</summary>
    private readonly Column<ReboundSpeeds> _speeds = new Column<ReboundSpeeds>();
    private readonly Column<int> _rows = new Column<int>();
    private readonly Column<int> _strikes = new Column<int>();
    private readonly Column<byte> _inTurmoil = new Column<byte>();
    private int _count;
    private int _strikingCount;

    /// <summary>Takes the weak bounces out of the rows of islands in turmoil.</summary>
    public void Begin(ReadOnlySpan<GraphColor> colors, int rowCount, IslandStore islands, BodyStore bodies, in ContactCoefficients c)
    {
        _count = 0;
        if (rowCount < Many)
        {
            return;
        }

        ListWeak(colors);
        int weak = _count;
        _count = 0;
        if (weak * ContactBundle.Lanes < Many || !FindTurmoil(weak, islands, bodies, c))
        {
            return;
        }

        for (int i = 0; i < weak; i++)
        {
            if (ReboundKernel.Take(_entries[i].Row, _inTurmoil.Pointer, islands.OfSlot))
            {
                _entries[_count++].Row = _entries[i].Row;
            }
        }
    }

    /// <summary>Before the velocities of a substep are integrated.</summary>
    public void Prepare(BodyStore bodies, in ContactCoefficients c)
    {
        _strikingCount = 0;
        _striking.EnsureCapacity(_count);
        _speeds.EnsureCapacity(_count);
        for (int i = 0; i < _count; i++)
        {
            Entry* entry = _entries.Pointer + i;
            ContactBundle* ahead = _entries[Math.Min(i + Ahead, _count - 1)].Row;
            Prefetch.Line(ahead->Restitution);
            ReboundKernel.AskFor(ahead);
            if (ReboundKernel.Note(entry->Row, _speeds.Pointer + _strikingCount, bodies.State.Pointer, bodies.Drive.Pointer, c))
            {
                _striking[_strikingCount++].Row = entry->Row;
            }
        }
    }

    /// <summary>After the relax pass.</summary>
    public void Run(BodyStore bodies, in ContactCoefficients c)
    {
        // Of those that approached four in five have not met: only of the others all is read.
        int parting = 0;
        for (int i = 0; i < _strikingCount; i++)
        {
            ReboundKernel.AskForImpulses(_striking[Math.Min(i + Ahead, _strikingCount - 1)].Row);
            if (ReboundKernel.HaveMet(_striking[i].Row, _speeds.Pointer + i))
            {
                _striking[parting++] = new Entry { Row = _striking[i].Row, Speeds = i };
            }
        }

        for (int i = 0; i < parting; i++)
        {
            ContactBundle.AskFor(_striking[Math.Min(i + PartingAhead, parting - 1)].Row);
            ReboundKernel.Part(_striking[i].Row, _speeds.Pointer + _striking[i].Speeds, bodies.State.Pointer, c);
        }
    }

    /// <summary>Lists the bundles with contacts that bounce weakly.</summary>
    private void ListWeak(ReadOnlySpan<GraphColor> colors)
    {
        for (int k = 0; k < colors.Length; k++)
        {
            foreach (ContactBundle* row in colors[k].Bundles)
            {
                ContactBundle.AskAhead(row->Restitution);
                if (ReboundKernel.WeakLanes(row) != 0)
                {
                    _entries.EnsureCapacity(_count + 1);
                    _entries[_count++].Row = row;
                }
            }
        }
    }

    private bool FindTurmoil(int weakCount, IslandStore islands, BodyStore bodies, in ContactCoefficients c)
    {
        // A row whose bodies cannot move any more is of island 0, if there is one or not.
        int end = Math.Max(1, islands.Count);

        _rows.EnsureCapacity(bodies.State.Capacity);
        _strikes.EnsureCapacity(bodies.State.Capacity);
        _inTurmoil.EnsureCapacity(bodies.State.Capacity);
        for (int i = 0; i < end; i++)
        {
            _rows[i] = 0;
            _strikes[i] = 0;
        }

        for (int i = 0; i < weakCount; i++)
        {
            ContactBundle* row = _entries[i].Row;
            ContactBundle* ahead = _entries[Math.Min(i + Ahead, weakCount - 1)].Row;
            Prefetch.Line(ahead->Restitution);
            Prefetch.Line(ahead->Slot);
            ReboundKernel.AskFor(ahead);
            int weak = ReboundKernel.WeakLanes(row);
            int strikes = weak & ReboundKernel.FastLanes(row, bodies.State.Pointer, bodies.Drive.Pointer, c);
            for (int lane = 0; weak >> lane != 0; lane++)
            {
                int island = islands.OfSlot[row->Slot[lane]];
                _rows[island] += (weak >> lane) & 1;
                _strikes[island] += (strikes >> lane) & 1;
            }
        }

        bool any = false;
        for (int i = 0; i < end; i++)
        {
            bool turmoil = _rows[i] >= Many && _strikes[i] >= ManyStrikes;
            _inTurmoil[i] = (byte)(turmoil ? 1 : 0);
            any |= turmoil;
        }

        return any;
    }

    /// <summary>A bundle with such contacts, and where its speeds are once it parts.</summary>
    [StructLayout(LayoutKind.Sequential)]
    private struct Entry
    {
        public ContactBundle* Row;
        public int Speeds;
    }
}
