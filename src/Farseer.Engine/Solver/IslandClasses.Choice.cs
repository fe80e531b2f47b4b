using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;

namespace Farseer.Engine.Solver;

/// <summary>What the user chose; and worlds whose rows are all of one class: nothing is borrowed.</summary>
internal sealed unsafe partial class IslandClasses
{
    /// <summary>The user chose for a body that is solved, or for a kinematic one that joints hold on to.</summary>
    private static bool IsAnyChosen(in IslandClassInput input)
    {
        JointSolver? joints = input.Joints;
        BodyFlags* flags = input.Bodies.Flags.Pointer;
        BodyFlags all = BodyFlags.None;
        for (int i = 0; i < input.Count; i++)
        {
            all |= flags[input.List[i]];
        }

        for (int i = 0; joints != null && i < joints.Loads.Count; i++)
        {
            joints.Loads.GetBodies(i, out int a, out int b);
            all |= (ChosenForKinematic(flags[a]) | ChosenForKinematic(flags[b])) != 0 ? BodyFlags.Substeps : BodyFlags.None;
        }

        return (all & BodyFlags.Substeps) != 0;
    }

    private static int ChosenForKinematic(BodyFlags flags) => (flags & BodyFlags.Kinematic) != 0 ? ChosenSubsteps.Bits(flags) : 0;

    /// <summary>
    /// Where the user chose, the islands' own needs do not count; of several choices the finest does. What was chosen for a kinematic body
    /// counts for all that it touches or holds.
    /// </summary>
    private void Choose(in IslandClassInput input)
    {
        BodyStore bodies = input.Bodies;
        byte* moves = input.Moves;
        int* list = input.List;
        int count = input.Count;
        _chosen.EnsureCapacity(bodies.Ids.End);
        for (int i = 0; i < count; i++)
        {
            _chosen[Root(list[i])] = 0;
        }

        for (int i = 0; i < count; i++)
        {
            int root = Root(list[i]);
            _chosen[root] = moves[list[i]] != 0 ? (byte)Math.Max(_chosen[root], ChosenSubsteps.Bits(bodies.Flags[list[i]])) : (byte)0;
        }

        ForEachTie(_handOn, input);
        for (int i = 0; i < count; i++)
        {
            int root = Root(list[i]);
            _class[root] = _chosen[root] > 0 ? (byte)(_chosen[root] - 1) : _class[root];
        }
    }

    /// <summary>Hands the choice of a kinematic body on to the island at which it has a joint or contact.</summary>
    private void HandOn(int a, int b, BodyStore bodies, byte* moves)
    {
        if (moves[a] == moves[b])
        {
            return;
        }

        int still = moves[a] == 0 ? a : b;
        int root = Root(moves[a] == 0 ? b : a);
        _chosen[root] = (byte)Math.Max(_chosen[root], ChosenForKinematic(bodies.Flags[still]));
    }

    /// <summary>
    /// The one class that has bodies, if all rows of the graph are of it as well and lie as its own copies would; else 0.
    /// </summary>
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
            AddColor(_only, color);
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
