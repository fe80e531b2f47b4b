using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Chains;

/// <summary>A part of the solver of chains, and what it works on with the others.</summary>
internal abstract unsafe class ChainPart
{
    protected readonly ChainWork _work;
    protected readonly Column<Chain> _chains;
    protected readonly Column<ChainPlace> _places;
    protected readonly JointStore _store;

    protected ChainPart(ChainWork work)
    {
        _work = work;
        _chains = work.Chains;
        _places = work.Places;
        _store = work.Store;
    }
}
