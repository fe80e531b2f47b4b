using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Nets;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// The trees that joints with hard rows make of the bodies. A joint with something that cannot move is an anchor of its body
/// and not an edge, so a bridge with two abutments is a tree and no loop. The bodies of nets (<see cref="NetSearch"/>) are single.
/// </summary>
internal sealed unsafe partial class JointForest
{
    /// <summary>
    /// Guests for whom there is room from the first on: a world of so many bodies, or with so few for each jointed one, never grows.
    /// </summary>
    private const int FewGuests = 64;
    private const int GuestsANode = 4;

    private readonly Column<TreeNode> _nodes = new Column<TreeNode>();
    private readonly Column<JointTree> _trees = new Column<JointTree>();
    private readonly Column<TreeAnchor> _anchors = new Column<TreeAnchor>();
    private readonly Column<int> _edgeJoints = new Column<int>();
    private readonly Column<int> _nodeOf = new Column<int>();
    private readonly Column<int> _start = new Column<int>();
    private readonly Column<int> _entries = new Column<int>();
    private readonly Column<int> _queue = new Column<int>();
    private readonly Column<int> _places = new Column<int>();
    private int _mapped;
    private int _ownNodes;
    private int _ownTrees;
    private int _edgeJointCount;

    public TreeNode* Nodes => _nodes.Pointer;

    public TreeAnchor* Anchors => _anchors.Pointer;

    /// <summary>Active joints of the edges; see <see cref="TreeNode.EdgeFirst"/>.</summary>
    public int* EdgeJoints => _edgeJoints.Pointer;

    public JointTree* Trees => _trees.Pointer;

    public JointForestView View => new JointForestView(_nodes.Pointer, _trees.Pointer);

    /// <summary>Nodes of trees and of single bodies with joints, each tree in pre-order; then the guests.</summary>
    public int Count { get; private set; }

    public int TreeCount { get; private set; }

    public int AnchorCount { get; private set; }

    /// <summary>The trees of bodies that have joints.</summary>
    public int OwnTrees => _ownTrees;

    /// <summary>The first tree of a tree's group.</summary>
    public JointTree* GroupOf(JointTree* tree) => Trees + tree->Group;

    /// <summary>The tree of a row's bodies.</summary>
    public int TreeOf(in RowEnds ends) => Nodes[ends.NodeA >= 0 ? ends.NodeA : ends.NodeB].Tree;

    /// <summary>Node of a body, -1: none.</summary>
    public int NodeOf(int body) => body < _mapped ? _nodeOf[body] : -1;

    /// <summary>The body has one joint that acts.</summary>
    public bool IsOnlyJoint(int body) => _start[body + 1] == _start[body] + 1;

    /// <summary>Builds the trees and gives every active joint its nodes and its role.</summary>
    /// <param name="active">The joints, in their order.</param>
    /// <param name="count">Number of joints.</param>
    /// <param name="mass">Masses of the bodies.</param>
    /// <param name="moves">1 for a body that can move.</param>
    /// <param name="nets">The nets among the bodies.</param>
    /// <param name="bodyEnd">One past the highest body.</param>
    public void Build(ActiveJoint* active, int count, BodyMass* mass, byte* moves, NetSearch nets, int bodyEnd)
    {
        Reset(count, bodyEnd);
        CollectEntries(active, count, moves, bodyEnd);
        FindTies(active, count, moves, nets, bodyEnd);
        for (int body = 0; body < bodyEnd; body++)
        {
            if (_start[body + 1] > _start[body] && _nodeOf[body] == -1)
            {
                if (nets.IsNet(body))
                {
                    AddSingle(body);
                }
                else
                {
                    int found = Discover(body, active, moves);
                    Grow(ChooseRoot(found, active, mass, moves), active, moves);
                }
            }
        }

        for (int i = 0; i < count; i++)
        {
            SetNodes(ref active[i].Ends, moves);
            bool closes = active[i].Role == JointRole.Iterated && active[i].Ends.Coupled && active[i].BuiltHard > 0;
            active[i].Role = closes ? JointRole.Loop : active[i].Role;
        }

        _ownNodes = Count;
        _ownTrees = TreeCount;
    }

    /// <summary>Finds the nodes of two bodies.</summary>
    public void SetNodes(ref RowEnds ends, byte* moves)
    {
        ends.NodeA = moves[ends.BodyA] != 0 ? NodeOf(ends.BodyA) : -1;
        ends.NodeB = moves[ends.BodyB] != 0 ? NodeOf(ends.BodyB) : -1;
        ends.Coupled = ends.NodeA >= 0 && ends.NodeB >= 0 && Nodes[ends.NodeA].Tree == Nodes[ends.NodeB].Tree;
    }

    private void Reset(int count, int bodyEnd)
    {
        Reserve(count, bodyEnd);
        _mapped = bodyEnd;
        for (int i = 0; i < bodyEnd; i++)
        {
            _nodeOf[i] = -1;
        }

        Count = 0;
        TreeCount = 0;
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
            start[active[i].Ends.BodyA + 2] += moves[active[i].Ends.BodyA];
            start[active[i].Ends.BodyB + 2] += moves[active[i].Ends.BodyB];
        }

        for (int i = 2; i < bodyEnd + 2; i++)
        {
            start[i] += start[i - 1];
        }

        // Filling moves each start to its end, which is the start of the next: hence the offset by one.
        for (int i = 0; i < count; i++)
        {
            if (moves[active[i].Ends.BodyA] != 0)
            {
                _entries[start[active[i].Ends.BodyA + 1]++] = i;
            }

            if (moves[active[i].Ends.BodyB] != 0)
            {
                _entries[start[active[i].Ends.BodyB + 1]++] = i;
            }
        }
    }

    private static int Other(in ActiveJoint joint, int body) => joint.Ends.BodyA == body ? joint.Ends.BodyB : joint.Ends.BodyA;

    /// <summary>Puts the component of a body into the queue.</summary>
    private int Discover(int first, ActiveJoint* active, byte* moves)
    {
        int found = 0;
        _queue[found++] = first;
        _nodeOf[first] = -2;
        for (int head = 0; head < found; head++)
        {
            int body = _queue[head];
            for (int k = _start[body]; k < _start[body + 1]; k++)
            {
                ref ActiveJoint joint = ref active[_entries[k]];
                int other = Other(joint, body);
                if (moves[other] == 0 || !(joint.BuiltHard > 0 || joint.Ties))
                {
                    continue;
                }

                if (_nodeOf[other] == -1)
                {
                    _nodeOf[other] = -2;
                    _queue[found++] = other;
                }
            }
        }

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

    private void AddSingle(int body)
    {
        BeginTree();
        AddNode(body, -1);
        EndTree();
    }

    private void BeginTree()
    {
        JointTree* tree = Trees + TreeCount;
        *tree = default;
        tree->First = Count;
        tree->Current = Count;
        tree->AnchorFirst = AnchorCount;
    }

    private void EndTree()
    {
        JointTree* tree = Trees + TreeCount++;
        tree->End = Count;
        tree->AnchorEnd = AnchorCount;
        tree->Eliminates = tree->End - tree->First > 1 || tree->AnchorEnd > tree->AnchorFirst;
    }

    private int AddNode(int body, int parent)
    {
        int index = Count++;
        TreeNode* node = Nodes + index;
        *node = default;
        node->Bears = true;
        node->Body = body;
        node->Parent = parent;
        node->Tree = TreeCount;
        node->Depth = parent < 0 ? 0 : Nodes[parent].Depth + 1;
        node->EdgeFirst = _edgeJointCount;
        _nodeOf[body] = index;
        return index;
    }

    /// <summary>
    /// Breadth first from the root; the first joint to reach a body, and those parallel to it, make the edge. A joint that is a limit alone
    /// makes one only where no other joint leads: it would else make a loop of a joint that always holds.
    /// </summary>
    private void Grow(int root, ActiveJoint* active, byte* moves)
    {
        BeginTree();
        int head = AddNode(root, -1);
        int limits = head;
        do
        {
            for (; head < Count; head++)
            {
                Reach(head, false, active, moves);
            }

            while (limits < Count && !Reach(limits, true, active, moves))
            {
                limits++;
            }
        }
        while (head < Count);

        Order(Trees[TreeCount].First);
        for (int i = Trees[TreeCount].First; i < Count; i++)
        {
            AddAnchors(i, active, moves);
        }

        EndTree();
    }

    /// <summary>
    /// Adds the bodies that joints of a node lead to: all by those that have hard rows, or the first one by a limit alone.
    /// </summary>
    /// <returns>True if a limit led to a body.</returns>
    private bool Reach(int from, bool byLimit, ActiveJoint* active, byte* moves)
    {
        int body = Nodes[from].Body;
        for (int k = _start[body]; k < _start[body + 1]; k++)
        {
            ref ActiveJoint joint = ref active[_entries[k]];
            int other = Other(joint, body);
            bool leads = byLimit ? joint.Ties : joint.BuiltHard > 0 && joint.BuiltHard <= TreeFactor.MostRows;
            if (moves[other] != 0 && leads && _nodeOf[other] < 0)
            {
                AddEdge(AddNode(other, from), body, active);
                if (byLimit)
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>
    /// Puts the nodes of the tree being made into pre-order: a subtree is then a range, so a tour of the rows in this order
    /// crosses each edge twice at most.
    /// </summary>
    private void Order(int first)
    {
        int* size = _queue.Pointer;
        int* place = _places.Pointer;
        for (int i = first; i < Count; i++)
        {
            size[i - first] = 1;
        }

        for (int i = Count - 1; i > first; i--)
        {
            size[Nodes[i].Parent - first] += size[i - first];
        }

        // The place of a node's next child; children come breadth first, so those of a node keep their order.
        int* next = size;
        for (int i = first; i < Count; i++)
        {
            int parent = Nodes[i].Parent;
            int span = size[i - first];
            int at = first;
            if (parent >= 0)
            {
                at = next[parent - first];
                next[parent - first] += span;
            }

            place[i - first] = at;
            next[i - first] = at + 1;
        }

        for (int i = first; i < Count; i++)
        {
            int parent = Nodes[i].Parent;
            Nodes[i].Parent = parent < 0 ? -1 : place[parent - first];
            _nodeOf[Nodes[i].Body] = place[i - first];
        }

        // Each exchange brings a node to its place.
        for (int i = first; i < Count; i++)
        {
            for (int at = place[i - first]; at != i; at = place[i - first])
            {
                (Nodes[i], Nodes[at]) = (Nodes[at], Nodes[i]);
                (place[i - first], place[at - first]) = (place[at - first], at);
            }
        }
    }

    private void AddEdge(int child, int parentBody, ActiveJoint* active)
    {
        TreeNode* node = Nodes + child;
        int body = node->Body;
        for (int k = _start[body]; k < _start[body + 1]; k++)
        {
            int index = _entries[k];
            ref ActiveJoint joint = ref active[index];
            if (Other(joint, body) != parentBody || node->HardRows + joint.BuiltHard > TreeFactor.MostRows || !InBlock(joint))
            {
                continue;
            }

            joint.Role = JointRole.Edge;
            for (int r = 0; r < joint.BuiltHard; r++)
            {
                node->RowJoint[node->HardRows] = index;
                node->RowIndex[node->HardRows++] = r;
            }

            node->HasLimits |= joint.Limited;
            node->EdgeCount++;
            _edgeJoints[_edgeJointCount++] = index;
        }

        node->Rows = node->HardRows;
        node->HasLimits &= node->HardRows < TreeFactor.MostRows;
        Trees[TreeCount].HasLimits |= node->HasLimits;
        Trees[TreeCount].LimitEdges |= node->HardRows == 0;
    }

    /// <summary>It has rows for a block: rows that always hold, or limits.</summary>
    private static bool InBlock(in ActiveJoint joint) => joint.BuiltHard > 0 || (joint.BuiltHard == 0 && joint.Limited);

    private void AddAnchors(int index, ActiveJoint* active, byte* moves)
    {
        int body = Nodes[index].Body;
        for (int k = _start[body]; k < _start[body + 1]; k++)
        {
            ref ActiveJoint joint = ref active[_entries[k]];
            if (moves[Other(joint, body)] == 0 && joint.BuiltHard <= TreeFactor.MostRows && InBlock(joint))
            {
                joint.Role = JointRole.Anchor;
                Nodes[index].Anchored = true;
                TreeAnchor* anchor = _anchors.Pointer + AnchorCount++;
                *anchor = default;
                anchor->Active = _entries[k];
                anchor->Node = index;
                anchor->Rows = joint.BuiltHard;
                for (int r = 0; r < joint.BuiltHard; r++)
                {
                    anchor->RowIndex[r] = r;
                }

                Trees[TreeCount].HasLimits |= joint.Limited && joint.BuiltHard < TreeFactor.MostRows;
            }
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        // Of what each step works out for them anew only the part that their rows need is written.
        // What is behind the last one is made anew before it is read, and there is room for many more.
        Count = s.Value(Count);
        TreeCount = s.Value(TreeCount);
        AnchorCount = s.Value(AnchorCount);
        s.Local(_nodes, Count);
        s.Column(_trees, TreeCount);
        s.Local(_anchors, AnchorCount);
        s.Column(_edgeJoints);
        s.Column(_nodeOf);
        s.Column(_start);
        s.Column(_entries);
        s.Column(_queue);
        s.Column(_places);
        s.Value(ref _mapped);
        s.Value(ref _ownNodes);
        s.Value(ref _ownTrees);
        s.Value(ref _edgeJointCount);
        s.Column(_group);
        s.Column(_marks);
    }
}
