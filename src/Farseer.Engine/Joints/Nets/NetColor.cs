using System.Runtime.CompilerServices;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Nets;

/// <summary>The pivots of one colour: no two share a body that can move, so a bundle's lanes never meet.</summary>
internal sealed unsafe class NetColor
{
    private readonly Column<NetBundle> _bundles = new Column<NetBundle>();
    private readonly Column<NetAnchors> _anchors = new Column<NetAnchors>();
    private readonly int _lanesUsed;

    /// <param name="sequential">True for the overflow, whose pivots may share bodies: one filled lane a bundle.</param>
    public NetColor(bool sequential) => _lanesUsed = sequential ? 1 : NetBundle.Lanes;

    public int RowCount { get; private set; }

    public int BundleCount => (RowCount + _lanesUsed - 1) / _lanesUsed;

    public NetBundle* Bundles => _bundles.Pointer;

    public NetBundle* BundleOf(int row) => _bundles.Pointer + (row / _lanesUsed);

    public int FirstRowOf(int bundle) => bundle * _lanesUsed;

    public int LaneOf(int row) => row % _lanesUsed;

    public ref NetAnchors AnchorsOf(int row) => ref _anchors[row];

    /// <summary>Appends an empty row; the caller fills it.</summary>
    public int AddRow()
    {
        int row = RowCount++;
        _anchors.EnsureCapacity(RowCount);
        if (LaneOf(row) == 0)
        {
            _bundles.EnsureCapacity(BundleCount);
            Unsafe.InitBlock(BundleOf(row), 0, (uint)sizeof(NetBundle));
            for (int lane = 0; lane < NetBundle.Lanes; lane++)
            {
                BundleOf(row)->Joint[lane] = -1;
            }
        }

        return row;
    }

    /// <summary>Removes a row; the last one takes its place.</summary>
    /// <returns>The joint that moved into <paramref name="row"/>, or -1.</returns>
    public int RemoveRow(int row)
    {
        int last = RowCount - 1;
        int moved = -1;
        if (row != last)
        {
            MoveLane(BundleOf(last), LaneOf(last), BundleOf(row), LaneOf(row));
            _anchors[row] = _anchors[last];
            moved = BundleOf(row)->Joint[LaneOf(row)];
        }

        ClearLane(BundleOf(last), LaneOf(last));
        RowCount = last;
        return moved;
    }

    private static void MoveLane(NetBundle* source, int sourceLane, NetBundle* target, int targetLane)
    {
        int* from = (int*)source + sourceLane;
        int* to = (int*)target + targetLane;
        for (int i = 0; i < sizeof(NetBundle) / sizeof(int); i += NetBundle.Lanes)
        {
            to[i] = from[i];
        }
    }

    // Both ends of an empty lane are the dummy body, which nothing moves: its row finds no speed and gives no impulse.
    private static void ClearLane(NetBundle* bundle, int lane)
    {
        int* row = (int*)bundle + lane;
        for (int i = 0; i < sizeof(NetBundle) / sizeof(int); i += NetBundle.Lanes)
        {
            row[i] = 0;
        }

        bundle->Joint[lane] = -1;
    }
}
