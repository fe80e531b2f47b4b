using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Trees;

/// <content>
/// Which joints close the loops of a tree: where it can be chosen, those without limits. A limit of an edge is a row of its block and holds
/// as its hard rows do; that of a joint which closes a loop is iterated against the rows of the loop, and gives way the more the less the
/// loop leaves it: the limits of four-bar linkages were passed by half a metre, and came back with more energy than they had gone with.
/// </content>
internal sealed unsafe partial class JointForest
{
    [NotState(Why.OfOneStep)]
    private bool _hasLimits;

    /// <summary>
    /// Bodies that joints with limits tie together are a group, and it is entered once: by the first joint that leads to it, from where
    /// the limits lead on.
    /// </summary>
    private void GroupByLimits(ActiveJoint* active, int count, byte* moves, int bodyEnd)
    {
        _hasLimits = false;
        for (int i = 0; i < count; i++)
        {
            if (!HasLimitRows(active[i]) || !IsBetween(active[i], moves))
            {
                continue;
            }

            if (!_hasLimits)
            {
                StartGroups(bodyEnd);
                _hasLimits = true;
            }

            _group[GroupOf(active[i].Ends.BodyA)] = GroupOf(active[i].Ends.BodyB);
        }
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

    private static bool HasLimitRows(in ActiveJoint joint) => joint.Limited && joint.BuiltHard > 0 && joint.BuiltHard < TreeFactor.MostRows;

    private bool MayLead(in ActiveJoint joint, int other) => !_hasLimits || HasLimitRows(joint) || _marks[GroupOf(other)] == 0;

    private void NoteReached(int body)
    {
        if (_hasLimits)
        {
            _marks[GroupOf(body)] = 1;
        }
    }
}
