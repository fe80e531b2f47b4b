using Farseer.Engine.Contacts;

namespace Farseer.Engine.Graph;

/// <summary>The bundles of a colour one by one, for <c>foreach</c>. Valid until rows of this colour come or go.</summary>
internal unsafe ref struct BundleWalk
{
    private BundleRuns _runs;
    private int _left;

    public BundleWalk(BundleRuns runs)
    {
        _runs = runs;
        Current = null;
        _left = 0;
    }

    public ContactBundle* Current { get; private set; }

    public readonly BundleWalk GetEnumerator() => this;

    public bool MoveNext()
    {
        if (--_left > 0)
        {
            Current = ContactBundle.Next(Current);
            return true;
        }

        if (!_runs.Next())
        {
            return false;
        }

        Current = _runs.Bundles;
        _left = _runs.Count;
        return true;
    }
}
