using System;

namespace Farseer.Engine.Joints.Trees;

/// <content>Room, and guests: bodies without joints that take part in a step because they touch trees.</content>
internal sealed unsafe partial class JointForest
{
    /// <summary>Sends the guests of the last step away.</summary>
    public void ClearGuests()
    {
        for (int i = _ownNodes; i < Count; i++)
        {
            _nodeOf[Nodes[i].Body] = -1;
        }

        Count = _ownNodes;
        TreeCount = _ownTrees;
    }

    /// <summary>
    /// Makes room for so many guests, of bodies that may be younger than the trees; in a small world for all bodies at once, so that one
    /// guest more does not allocate late in a run.
    /// </summary>
    public void ReserveGuests(int count, int bodyEnd)
    {
        int room = Math.Min(bodyEnd - _ownNodes, Math.Max(count, FewGuests + (GuestsANode * _ownNodes)));
        _nodes.EnsureCapacity(_ownNodes + room);
        _trees.EnsureCapacity(_ownTrees + room);
        _nodeOf.EnsureCapacity(bodyEnd);
        for (; _mapped < bodyEnd; _mapped++)
        {
            _nodeOf[_mapped] = -1;
        }
    }

    /// <summary>Lets a body without joints take part as a tree of its own.</summary>
    public void AddGuest(int body)
    {
        AddSingle(body);
        Trees[TreeCount - 1].Guest = true;
    }

    /// <summary>Makes room for trees of so many joints and bodies, of which not all may act now.</summary>
    public void Reserve(int joints, int bodyEnd)
    {
        _nodeOf.EnsureCapacity(bodyEnd);
        _start.EnsureCapacity(bodyEnd + 2);
        _entries.EnsureCapacity((joints * 2) + 1);
        _queue.EnsureCapacity(bodyEnd + 1);
        _places.EnsureCapacity(bodyEnd + 1);
        _edgeJoints.EnsureCapacity(joints + 1);
        _anchors.EnsureCapacity(joints + 1);
        int nodes = Math.Min(joints * 2, bodyEnd) + 1;
        _nodes.EnsureCapacity(nodes);
        _trees.EnsureCapacity(nodes);
    }

    /// <summary>
    /// Trees, and nodes, that there is room for, guests with them: what grows with it does not when there are others, or more of them, than
    /// in the step before.
    /// </summary>
    public int TreeRoom => _trees.Capacity;

    public int NodeRoom => _nodes.Capacity;
}
