using System;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// The weak bounces of large piles, which are not worth the order of <see cref="ImpactPass"/> and would not be through with it within a
/// substep: see <see cref="ReboundKernel"/>.
/// </summary>
internal sealed unsafe class ReboundPass
{
    /// <summary>
    /// Contacts that can bounce from which on an island is large: as many bundles as a substep may visit for its impacts at least
    /// sixteen times each, if all strike.
    /// </summary>
    private const int Many = 2048;

    private readonly Column<Entry> _entries = new Column<Entry>();
    private readonly Column<int> _rows = new Column<int>();
    private readonly Column<byte> _large = new Column<byte>();
    private int _count;

    /// <summary>Takes the weak bounces out of the rows of large islands.</summary>
    public void Begin(ReadOnlySpan<GraphColor> colors, int rowCount)
    {
        _count = 0;
        if (rowCount < Many || !FindLarge(colors))
        {
            return;
        }

        for (int k = 0; k < colors.Length; k++)
        {
            GraphColor color = colors[k];
            for (int i = 0; i < color.BundleCount; i++)
            {
                if (ReboundKernel.Take(color.Bundles + i, _large.Pointer))
                {
                    _entries.EnsureCapacity(_count + 1);
                    _entries[_count++].Row = color.Bundles + i;
                }
            }
        }
    }

    /// <summary>Before the velocities of a substep are integrated.</summary>
    public void Prepare(BodyStore bodies, in ContactCoefficients c)
    {
        for (int i = 0; i < _count; i++)
        {
            Entry* entry = _entries.Pointer + i;
            entry->Any = ReboundKernel.Note(entry->Row, bodies.State.Pointer, bodies.Drive.Pointer, c);
        }
    }

    /// <summary>After the relax pass.</summary>
    public void Run(BodyStore bodies, in ContactCoefficients c)
    {
        for (int i = 0; i < _count; i++)
        {
            if (_entries[i].Any)
            {
                ReboundKernel.Part(_entries[i].Row, bodies.State.Pointer, c);
            }
        }
    }

    /// <summary>Counts the rows of each island that can bounce.</summary>
    private bool FindLarge(ReadOnlySpan<GraphColor> colors)
    {
        int end = 0;
        for (int k = 0; k < colors.Length; k++)
        {
            GraphColor color = colors[k];
            for (int i = 0; i < color.BundleCount; i++)
            {
                int* island = color.Bundles[i].Island;
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    end = Math.Max(end, island[lane] + 1);
                }
            }
        }

        _rows.EnsureCapacity(end);
        _large.EnsureCapacity(end);
        for (int i = 0; i < end; i++)
        {
            _rows[i] = 0;
        }

        for (int k = 0; k < colors.Length; k++)
        {
            GraphColor color = colors[k];
            for (int i = 0; i < color.BundleCount; i++)
            {
                ContactBundle* row = color.Bundles + i;
                int can = BounceKernel.BouncingLanes(row);
                for (int lane = 0; can >> lane != 0; lane++)
                {
                    _rows[row->Island[lane]] += (can >> lane) & 1;
                }
            }
        }

        bool any = false;
        for (int i = 0; i < end; i++)
        {
            _large[i] = (byte)(_rows[i] >= Many ? 1 : 0);
            any |= _rows[i] >= Many;
        }

        return any;
    }

    /// <summary>A bundle with such contacts.</summary>
    [StructLayout(LayoutKind.Sequential)]
    private struct Entry
    {
        public ContactBundle* Row;

        /// <summary>In this substep some of them approach fast enough to bounce.</summary>
        public bool Any;
    }
}
