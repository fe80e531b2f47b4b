using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// The trees that joints with hard rows make of the bodies. A joint with something that cannot move is an anchor of its body
/// and not an edge, so a bridge with two abutments is a tree and no loop. A component with many loops (a net) is left to the
/// iteration: there the walks between the ends of its loops would cost more than they gain.
/// </summary>
internal sealed unsafe class JointForest
{
    /// <summary>A component is a net if it has more loops than this and more than one for each <see cref="NetShare"/> bodies.</summary>
    private const int FewLoops = 4;
    private const int NetShare = 8;
    private const int RowsOfEdge = 3;

    private readonly Column<TreeNode> _nodes = new Column<TreeNode>();
    private readonly Column<TreeAnchor> _anchors = new Column<TreeAnchor>();
    private readonly Column<int> _edgeJoints = new Column<int>();
    private readonly Column<int> _nodeOf = new Column<int>();
    private readonly Column<int> _start = new Column<int>();
    private readonly Column<int> _entries = new Column<int>();
    private readonly Column<int> _queue = new Column<int>();
    private int _mapped;
    private int _edgeJointCount;

    public TreeNode* Nodes => _nodes.Pointer;

    public TreeAnchor* Anchors => _anchors.Pointer;

    /// <summary>Active joints of the edges; see <see cref="TreeNode.EdgeFirst"/>.</summary>
    public int* EdgeJoints => _edgeJoints.Pointer;

    /// <summary>Nodes of trees and of single bodies with joints, parents before children.</summary>
    public int Count { get; private set; }

    public int AnchorCount { get; private set; }

    /// <summary>Node of a body, -1: none.</summary>
    public int NodeOf(int body) => body < _mapped ? _nodeOf[body] : -1;

    /// <summary>Builds the trees and gives every active joint its nodes and its role.</summary>
    /// <param name="active">The joints, in their order.</param>
    /// <param name="count">Number of joints.</param>
    /// <param name="mass">Masses of the bodies.</param>
    /// <param name="moves">1 for a body that can move.</param>
    /// <param name="bodyEnd">One past the highest body.</param>
    public void Build(ActiveJoint* active, int count, BodyMass* mass, byte* moves, int bodyEnd)
    {
        Reset(count, bodyEnd);
        CollectEntries(active, count, moves, bodyEnd);
        for (int body = 0; body < bodyEnd; body++)
        {
            if (_start[body + 1] > _start[body] && _nodeOf[body] == -1)
            {
                int found = Discover(body, active, moves, out int edges);
                int loops = edges - (found - 1);
                if (loops > FewLoops && loops * NetShare > found)
                {
                    AddSingles(found);
                }
                else
                {
                    Grow(ChooseRoot(found, active, mass, moves), active, moves);
                }
            }
        }

        for (int i = 0; i < count; i++)
        {
            active[i].NodeA = moves[active[i].BodyA] != 0 ? _nodeOf[active[i].BodyA] : -1;
            active[i].NodeB = moves[active[i].BodyB] != 0 ? _nodeOf[active[i].BodyB] : -1;
            active[i].Coupled = active[i].NodeA >= 0 && active[i].NodeB >= 0
                && Nodes[active[i].NodeA].Root == Nodes[active[i].NodeB].Root;
        }
    }

    private void Reset(int count, int bodyEnd)
    {
        _nodeOf.EnsureCapacity(bodyEnd);
        _start.EnsureCapacity(bodyEnd + 2);
        _entries.EnsureCapacity((count * 2) + 1);
        _queue.EnsureCapacity(bodyEnd + 1);
        _edgeJoints.EnsureCapacity(count + 1);
        _anchors.EnsureCapacity(count + 1);
        _nodes.EnsureCapacity((count * 2) + 1);
        _mapped = bodyEnd;
        for (int i = 0; i < bodyEnd; i++)
        {
            _nodeOf[i] = -1;
        }

        Count = 0;
        AnchorCount = 0;
        _edgeJointCount = 0;
    }

    /// <summary>The joints of each moving body, in the order of the joints.</summary>
    private void CollectEntries(ActiveJoint* active, int count, byte* moves, int bodyEnd)
    {
        int* start = _start.Pointer;
        for (int i = 0; i < bodyEnd + 2; i++)
        {
            start[i] = 0;
        }

        for (int i = 0; i < count; i++)
        {
            active[i].Role = JointRole.Iterated;
            start[active[i].BodyA + 2] += moves[active[i].BodyA];
            start[active[i].BodyB + 2] += moves[active[i].BodyB];
        }

        for (int i = 2; i < bodyEnd + 2; i++)
        {
            start[i] += start[i - 1];
        }

        // Filling moves each start to its end, which is the start of the next: hence the offset by one.
        for (int i = 0; i < count; i++)
        {
            if (moves[active[i].BodyA] != 0)
            {
                _entries[start[active[i].BodyA + 1]++] = i;
            }

            if (moves[active[i].BodyB] != 0)
            {
                _entries[start[active[i].BodyB + 1]++] = i;
            }
        }
    }

    private static int Other(in ActiveJoint joint, int body) => joint.BodyA == body ? joint.BodyB : joint.BodyA;

    /// <summary>Puts the component of a body into the queue and counts its edges.</summary>
    private int Discover(int first, ActiveJoint* active, byte* moves, out int edges)
    {
        int found = 0;
        int ends = 0;
        _queue[found++] = first;
        _nodeOf[first] = -2;
        for (int head = 0; head < found; head++)
        {
            int body = _queue[head];
            for (int k = _start[body]; k < _start[body + 1]; k++)
            {
                ref ActiveJoint joint = ref active[_entries[k]];
                int other = Other(joint, body);
                if (moves[other] == 0 || joint.BuiltHard <= 0)
                {
                    continue;
                }

                ends++;
                if (_nodeOf[other] == -1)
                {
                    _nodeOf[other] = -2;
                    _queue[found++] = other;
                }
            }
        }

        edges = ends / 2;
        return found;
    }

    /// <summary>A body with an anchor, else the heaviest; among equals the lowest index.</summary>
    private int ChooseRoot(int found, ActiveJoint* active, BodyMass* mass, byte* moves)
    {
        int best = _queue[0];
        bool bestAnchored = IsAnchored(best, active, moves);
        for (int i = 1; i < found; i++)
        {
            int body = _queue[i];
            bool anchored = IsAnchored(body, active, moves);
            bool heavier = mass[body].Mass > mass[best].Mass || (mass[body].Mass == mass[best].Mass && body < best);
            if ((anchored && !bestAnchored) || (anchored == bestAnchored && heavier))
            {
                best = body;
                bestAnchored = anchored;
            }
        }

        return best;
    }

    private bool IsAnchored(int body, ActiveJoint* active, byte* moves)
    {
        for (int k = _start[body]; k < _start[body + 1]; k++)
        {
            ref ActiveJoint joint = ref active[_entries[k]];
            if (joint.BuiltHard > 0 && moves[Other(joint, body)] == 0)
            {
                return true;
            }
        }

        return false;
    }

    private void AddSingles(int found)
    {
        for (int i = 0; i < found; i++)
        {
            AddNode(_queue[i], -1);
        }
    }

    private int AddNode(int body, int parent)
    {
        int index = Count++;
        TreeNode* node = Nodes + index;
        *node = default;
        node->Body = body;
        node->Parent = parent;
        node->Root = parent < 0 ? index : Nodes[parent].Root;
        node->Depth = parent < 0 ? 0 : Nodes[parent].Depth + 1;
        node->UnaryFirst = AnchorCount;
        node->EdgeFirst = _edgeJointCount;
        _nodeOf[body] = index;
        return index;
    }

    /// <summary>Breadth first from the root; the first joint to reach a body, and those parallel to it, make the edge.</summary>
    private void Grow(int root, ActiveJoint* active, byte* moves)
    {
        int head = AddNode(root, -1);
        for (; head < Count; head++)
        {
            int body = Nodes[head].Body;
            AddAnchors(head, active, moves);
            for (int k = _start[body]; k < _start[body + 1]; k++)
            {
                ref ActiveJoint joint = ref active[_entries[k]];
                int other = Other(joint, body);
                if (moves[other] != 0 && joint.BuiltHard > 0 && joint.BuiltHard <= RowsOfEdge && _nodeOf[other] < 0)
                {
                    AddEdge(AddNode(other, head), body, active);
                }
            }
        }
    }

    private void AddEdge(int child, int parentBody, ActiveJoint* active)
    {
        TreeNode* node = Nodes + child;
        int body = node->Body;
        for (int k = _start[body]; k < _start[body + 1]; k++)
        {
            ref ActiveJoint joint = ref active[_entries[k]];
            if (Other(joint, body) == parentBody && joint.BuiltHard > 0 && node->Rows + joint.BuiltHard <= RowsOfEdge)
            {
                joint.Role = JointRole.Edge;
                node->Rows += joint.BuiltHard;
                node->EdgeCount++;
                _edgeJoints[_edgeJointCount++] = _entries[k];
            }
        }
    }

    private void AddAnchors(int index, ActiveJoint* active, byte* moves)
    {
        TreeNode* node = Nodes + index;
        node->UnaryFirst = AnchorCount;
        int body = node->Body;
        for (int k = _start[body]; k < _start[body + 1]; k++)
        {
            ref ActiveJoint joint = ref active[_entries[k]];
            if (moves[Other(joint, body)] == 0 && joint.BuiltHard > 0 && joint.BuiltHard <= RowsOfEdge)
            {
                joint.Role = JointRole.Anchor;
                node->UnaryCount++;
                TreeAnchor* anchor = _anchors.Pointer + AnchorCount++;
                *anchor = default;
                anchor->Active = _entries[k];
                anchor->Node = index;
                anchor->Rows = joint.BuiltHard;
            }
        }
    }
}
