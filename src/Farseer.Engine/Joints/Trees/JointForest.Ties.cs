using Farseer.Engine.Joints.Nets;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Trees;

/// <content>
/// Which joints make edges of a tree. Of ropes those that tie groups of bodies which nothing else ties together, and go round nowhere.
/// Iterated, a chain of eight with twenty links' weight at its end gained energy: what the passes had not settled was pushed on from. A net
/// of ropes stays iterated, and so do sliders and ranges of angles, whose ways in the original are recorded.
/// </content>
internal sealed unsafe partial class JointForest
{
    /// <summary>The tree of a union, by body; and a mark of the group of that body: ropes go round in it.</summary>
    private readonly Column<int> _group = new Column<int>();
    private readonly Column<byte> _marks = new Column<byte>();

    private void FindTies(ActiveJoint* active, int count, byte* moves, NetSearch nets, int bodyEnd)
    {
        bool any = false;
        for (int i = 0; i < count; i++)
        {
            active[i].Ties = active[i].Kind == JointKind.Rope && InBlock(active[i]) && IsBetween(active[i], moves)
                && !nets.IsNet(active[i].Ends.BodyA) && !nets.IsNet(active[i].Ends.BodyB);
            any |= active[i].Ties;
        }

        if (!any)
        {
            return;
        }

        StartGroups(bodyEnd);
        for (int i = 0; i < count; i++)
        {
            if (active[i].BuiltHard > 0 && IsBetween(active[i], moves))
            {
                _group[GroupOf(active[i].Ends.BodyA)] = GroupOf(active[i].Ends.BodyB);
            }
        }

        // Within a group that other joints hold together a limit is a row of it.
        for (int i = 0; i < count; i++)
        {
            active[i].Ties = active[i].Ties && GroupOf(active[i].Ends.BodyA) != GroupOf(active[i].Ends.BodyB);
        }

        for (int i = 0; i < count; i++)
        {
            if (active[i].Ties)
            {
                Tie(GroupOf(active[i].Ends.BodyA), GroupOf(active[i].Ends.BodyB));
            }
        }

        for (int i = 0; i < count; i++)
        {
            active[i].Ties = active[i].Ties && _marks[GroupOf(active[i].Ends.BodyA)] == 0;
        }
    }

    private static bool IsBetween(in ActiveJoint joint, byte* moves) => moves[joint.Ends.BodyA] != 0 && moves[joint.Ends.BodyB] != 0;

    private void Tie(int one, int other)
    {
        _marks[other] |= one == other ? (byte)1 : _marks[one];
        _group[one] = other;
    }

    private int GroupOf(int body)
    {
        while (_group[body] != body)
        {
            _group[body] = _group[_group[body]];
            body = _group[body];
        }

        return body;
    }

    private void StartGroups(int bodyEnd)
    {
        _group.EnsureCapacity(bodyEnd);
        _marks.EnsureCapacity(bodyEnd);
        for (int i = 0; i < bodyEnd; i++)
        {
            _group[i] = i;
            _marks[i] = 0;
        }
    }
}
