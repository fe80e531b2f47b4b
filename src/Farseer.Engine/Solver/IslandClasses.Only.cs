using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;

namespace Farseer.Engine.Solver;

/// <summary>Worlds whose rows are all of one class: nothing is borrowed.</summary>
internal sealed unsafe partial class IslandClasses
{
    /// <summary>The one class that has bodies, if all rows of the graph are of it as well and lie as its own copies would; else 0.</summary>
    private int FindOnly()
    {
        int only = 0;
        int classes = 0;
        for (int index = 0; index < Count; index++)
        {
            if (_counts[index] > 0)
            {
                only = index;
                classes++;
            }
        }

        if (classes != 1 || only == 0 || _graph.Groups.Count > 1)
        {
            return 0;
        }

        foreach (GraphColor color in _graph.Solved)
        {
            foreach (ContactBundle* bundle in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    if (bundle->Contact[lane] >= 0 && ClassOf(bundle->BodyA[lane], bundle->BodyB[lane]) != only)
                    {
                        return 0;
                    }
                }
            }
        }

        return only;
    }

    /// <summary>All rows are of one class: the graph's colours are its.</summary>
    private void Stay()
    {
        float share = 1f / (1 << _only);
        ScaleAll(share);
        foreach (GraphColor color in _graph.Solved)
        {
            _borrowed[_only][_used[_only]++] = color;
            foreach (ContactBundle* bundle in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    ShortenPace(bundle, lane, share);
                }
            }
        }

        _rowCounts[_only] = _graph.RowCount;
    }

    private void ScaleAll(float factor)
    {
        foreach (GraphColor color in _graph.Solved)
        {
            foreach (ContactBundle* bundle in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    ContactLanes.Scale(bundle, lane, factor);
                }
            }
        }
    }
}
