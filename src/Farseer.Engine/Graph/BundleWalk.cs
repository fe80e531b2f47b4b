using Farseer.Engine.Contacts;

namespace Farseer.Engine.Graph;

/// <summary>The bundles of a colour one by one, for <c>foreach</c>. Valid until rows of this colour come or go.</summary>
internal unsafe ref struct BundleWalk
{
    private BundleRuns _runs;
    private ContactBundle* _end;

    public BundleWalk(BundleRuns runs)
    {
        _runs = runs;
        Current = null;
        _end = null;
    }

    public ContactBundle* Current { get; private set; }

    public readonly BundleWalk GetEnumerator() => this;

    public bool MoveNext()
    {
        if (++Current < _end)
        {
            return true;
        }

        if (!_runs.Next())
        {
            return false;
        }

        Current = _runs.Bundles;
        _end = Current + _runs.Count;
        return true;
    }
}
