using Farseer.Engine.Contacts;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>The contacts of one colour: no two share a body that can move, so a bundle's lanes never meet.</summary>
internal sealed unsafe class GraphColor
{
    private readonly Column<ContactBundle> _bundles = new Column<ContactBundle>();
    private readonly int _lanesUsed;

    /// <param name="sequential">True for the overflow, whose contacts may share bodies: one filled lane a bundle.</param>
    /// <param name="grounded">True for a colour of contacts with the ground.</param>
    /// <param name="source">Of a copy: the colour whose rows it borrows.</param>
    public GraphColor(bool sequential = false, bool grounded = false, int source = -1)
    {
        _lanesUsed = sequential ? 1 : WideLanes.BundleLanes;
        IsGrounded = grounded;
        Source = source;
    }

    /// <summary>One body of each contact does not move, and several contacts may share it.</summary>
    public bool IsGrounded { get; }

    /// <summary>Place of the colour whose rows this one borrows; -1 if they are its own.</summary>
    public int Source { get; }

    public int RowCount { get; private set; }

    /// <summary>Its contacts may share bodies and are solved one after the other.</summary>
    public bool IsSequential => _lanesUsed == 1;

    public int BundleCount => (RowCount + _lanesUsed - 1) / _lanesUsed;

    public ContactBundle* Bundles => _bundles.Pointer;

    public ContactBundle* BundleOf(int row) => _bundles.Pointer + (row / _lanesUsed);

    public int LaneOf(int row) => row % _lanesUsed;

    /// <summary>Drops all rows, which only have been lent to it.</summary>
    public void Clear() => RowCount = 0;

    /// <summary>Appends an empty row; the caller fills it.</summary>
    public int AddRow()
    {
        int row = RowCount++;
        if (LaneOf(row) == 0)
        {
            _bundles.EnsureCapacity(BundleCount);
            for (int lane = 0; lane < WideLanes.BundleLanes; lane++)
            {
                ContactRowWriter.ClearLane(BundleOf(row), lane);
            }
        }

        return row;
    }

    /// <summary>Removes a row; the last one takes its place.</summary>
    /// <returns>The contact that moved into <paramref name="row"/>, or -1.</returns>
    public int RemoveRow(int row)
    {
        int last = RowCount - 1;
        int moved = -1;
        if (row != last)
        {
            ContactRowWriter.MoveLane(BundleOf(last), LaneOf(last), BundleOf(row), LaneOf(row));
            moved = BundleOf(row)->Contact[LaneOf(row)];
        }

        ContactRowWriter.ClearLane(BundleOf(last), LaneOf(last));
        RowCount = last;
        return moved;
    }
}
