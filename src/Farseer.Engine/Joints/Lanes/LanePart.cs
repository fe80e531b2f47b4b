using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>A part of the solver of trees on lanes, and what it works on with the others.</summary>
internal abstract unsafe class LanePart
{
    /// <summary>Where the second and the third number of a vector are.</summary>
    protected const int Y = DoubleLanes.BundleLanes;
    protected const int W = 2 * DoubleLanes.BundleLanes;

    protected readonly LaneWork _work;
    protected readonly Column<LaneNode> _nodes;
    protected readonly Column<LanePlace> _places;
    protected readonly Column<LaneAnchor> _anchors;
    protected readonly Column<LanePlace> _anchorPlaces;
    protected readonly Column<LaneTrees> _bundles;
    protected readonly Column<LaneSoft> _softs;
    protected readonly Column<LaneSoftPlace> _softPlaces;
    protected readonly Column<LaneWalk> _walks;

    protected LanePart(LaneWork work)
    {
        _work = work;
        _nodes = work.Nodes;
        _places = work.Places;
        _anchors = work.Anchors;
        _anchorPlaces = work.AnchorPlaces;
        _bundles = work.Bundles;
        _softs = work.Softs;
        _softPlaces = work.SoftPlaces;
        _walks = work.Walks;
    }

    protected static void Copy(double* from, double* to, int count)
    {
        for (int k = 0; k < count * DoubleLanes.BundleLanes; k += WideDouble.Count)
        {
            WideDouble.Load(from + k).Store(to + k);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    protected static void PutBack(double* from, double* to)
    {
        to[0] = from[0];
        to[1] = from[Y];
        to[2] = from[W];
    }

    protected static void TakeOver(double* from, double* to)
    {
        to[0] = from[0];
        to[Y] = from[1];
        to[W] = from[2];
    }
}
