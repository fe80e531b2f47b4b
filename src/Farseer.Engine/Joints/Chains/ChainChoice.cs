using System;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Chains;

/// <summary>Which trees are chains, where their numbers are, and which of them are solved as chains in a step.</summary>
[NotState(Why.Fixed)]
internal sealed unsafe class ChainChoice : ChainPart
{
    private readonly ChainExchange _exchange;

    public ChainChoice(ChainWork work, ChainExchange exchange)
        : base(work)
    {
        _exchange = exchange;
    }

    /// <summary>The trees have been built anew: finds which are chains, and where their numbers are until the next time.</summary>
    /// <param name="forest">The trees.</param>
    /// <param name="active">The joints that act.</param>
    /// <param name="rows">Their rows.</param>
    /// <param name="count">How many.</param>
    public void Renew(JointForest forest, ActiveJoint* active, JointRows* rows, int count)
    {
        _work.Forest = forest;
        _work.Active = active;
        _work.Count = 0;
        _work.QuietJoints = 0;
        _chains.EnsureCapacity(forest.OwnTrees);
        _work.GivenTrees.EnsureCapacity(forest.OwnTrees);
        for (int i = 0; i < forest.TreeCount; i++)
        {
            forest.Trees[i].IsChain = IsChain(forest.Trees + i, rows);
        }

        // Iterated rows are for the general passes.
        for (int i = 0; i < count; i++)
        {
            if (!active[i].IsEliminated)
            {
                Exclude(active[i].Ends.NodeA);
                Exclude(active[i].Ends.NodeB);
            }
        }

        MakeRoom();
        int numbers = 0;
        int places = 0;
        for (int i = 0; i < forest.TreeCount; i++)
        {
            if (forest.Trees[i].IsChain)
            {
                SetUp(_chains.Pointer + _work.Count++, i, ref numbers, ref places);
            }
        }
    }

    /// <summary>The trees are no more.</summary>
    public void Forget() => _work.Count = 0;

    /// <summary>
    /// Finds the chains that are quiet in this step: nothing touches them, and their joints are plain hinges as they were.
    /// </summary>
    /// <param name="step">What the joints see of the step.</param>
    /// <param name="allowed">Otherwise none is.</param>
    public void Look(in JointStep step, bool allowed)
    {
        _work.Step = step;
        _work.Any = false;
        _work.AllStay = true;
        _work.HasMoved = true;
        _work.QuietJoints = 0;
        for (int i = 0; i < _work.Count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            JointTree* tree = _work.Forest.Trees + chain->Tree;
            chain->IsLive = false;
            tree->IsQuiet = allowed && !tree->IsSuspect && IsQuiet(chain);
            if (tree->IsQuiet)
            {
                _work.QuietJoints += chain->Joints;
                _exchange.LoadPoses(chain);
            }
            else
            {
                _exchange.GiveVelocities(chain);
            }
        }
    }

    /// <summary>Turns to the quiet chains of a class.</summary>
    public void Select(int index, in JointStep step)
    {
        _work.Step = step;
        _work.LiveBodies = 0;
        for (int i = 0; i < _work.Count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            JointTree* tree = _work.Forest.Trees + chain->Tree;
            chain->IsLive = tree->IsQuiet && tree->Class == index;
            _work.LiveBodies += chain->IsLive ? chain->Bodies : 0;
        }

        _work.Any = _work.LiveBodies > 0;
    }

    /// <summary>A spring pulls at a chain after all, or something touches it: it is for the general passes.</summary>
    public void Refuse(int tree)
    {
        for (int i = 0; i < _work.Count; i++)
        {
            if (_chains[i].Tree == tree)
            {
                _work.LiveBodies -= _chains[i].IsLive ? _chains[i].Bodies : 0;
                _chains[i].IsLive = false;
                _exchange.GiveVelocities(_chains.Pointer + i);
            }
        }

        _work.Forest.Trees[tree].IsQuiet = false;
    }

    private void Exclude(int node)
    {
        if (node >= 0)
        {
            _work.Forest.Trees[_work.Forest.Nodes[node].Tree].IsChain = false;
        }
    }

    private bool IsQuiet(Chain* chain)
    {
        if (chain->Front > 0)
        {
            return false;
        }

        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = 0; i < chain->Bodies; i++)
        {
            if (_work.Step.Touches[places[i].Body] > 0)
            {
                return false;
            }
        }

        return HasPlainJoints(chain) && !(chain->Breaks && IsBreaking(chain));
    }

    public bool HasPlainJoints(Chain* chain)
    {
        if (chain->Edition != _store.Edition)
        {
            LoadSettings(chain);
        }

        return chain->IsPlain;
    }

    /// <summary>All joints are hinges of two rows and no others, that cannot break by their errors.</summary>
    private void LoadSettings(Chain* chain)
    {
        const JointFlags More = JointFlags.Limit | JointFlags.Motor | JointFlags.Spring;
        ChainView view = _work.ViewOf(chain);
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        chain->Edition = _store.Edition;
        chain->IsPlain = true;
        chain->Breaks = false;
        for (int i = 0; i < chain->Joints; i++)
        {
            ActiveJoint* active = _work.Active + places[i].Active;
            ref JointSettings settings = ref _store.Settings[active->Joint];
            bool rigid =
                settings.Softness == 0 && double.IsPositiveInfinity(settings.MaxImpulse) && double.IsPositiveInfinity(settings.Breakpoint);
            bool plain = (_store.Flags[active->Joint] & More) == 0 && (active->Kind != JointKind.Pin || settings.Target == 0);
            chain->IsPlain &= rigid && plain;
            chain->Breaks |= !double.IsPositiveInfinity(settings.BreakForce);
            ChainExchange.LoadAnchors(view, i, places[i].IsHighB, settings);
        }
    }

    /// <summary>That is for the general passes to see to.</summary>
    private bool IsBreaking(Chain* chain)
    {
        bool found = false;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = 0; i < chain->Joints; i++)
        {
            int joint = _work.Active[places[i].Active].Joint;
            ref JointState state = ref _store.States[joint];
            found |= Math.Sqrt((state.ForceX * state.ForceX) + (state.ForceY * state.ForceY)) > _store.Settings[joint].BreakForce;
        }

        return found;
    }

    /// <summary>Bodies one after the other, with one hinge each between them and nothing else; and at each end an anchor at most.</summary>
    private bool IsChain(JointTree* tree, JointRows* rows)
    {
        bool found = tree->Eliminates && !tree->HasLimits;
        int bodies = tree->End - tree->First;
        int anchors = tree->AnchorEnd - tree->AnchorFirst;
        int bend = BendOf(tree);
        for (int i = 1; found && i < bodies; i++)
        {
            TreeNode* node = _work.Forest.Nodes + tree->First + i;
            int parent = i == bend + 1 ? 0 : i - 1;
            found = node->Parent == tree->First + parent && node->EdgeCount == 1 && IsHinge(node->RowJoint[0], rows);
        }

        for (int i = 0; found && i < anchors; i++)
        {
            TreeAnchor* anchor = _work.Forest.Anchors + tree->AnchorFirst + i;
            int node = i == 0 ? tree->First : tree->End - 1;
            found = i < 2 && bend == bodies - 1 && anchor->Node == node && IsHinge(anchor->Active, rows);
        }

        return found && (anchors < 2 || bodies > 1);
    }

    private bool IsHinge(int active, JointRows* rows) => rows[active].Hard == 2 && rows[active].Count == 2
        && (_work.Active[active].Kind == JointKind.Revolute || _work.Active[active].Kind == JointKind.Pin);

    /// <summary>Bodies on the first way down from the root: the chain leads up these, and down the second way if there is one.</summary>
    private int BendOf(JointTree* tree)
    {
        int i = tree->First + 1;
        while (i < tree->End && _work.Forest.Nodes[i].Parent == i - 1)
        {
            i++;
        }

        return i - 1 - tree->First;
    }

    /// <summary>For all chains at once: grown chain by chain, the columns of many pendulums would be moved dozens of times.</summary>
    private void MakeRoom()
    {
        int numbers = 0;
        int places = 0;
        for (int i = 0; i < _work.Forest.TreeCount; i++)
        {
            if (_work.Forest.Trees[i].IsChain)
            {
                int bodies = BodiesOf(_work.Forest.Trees + i);
                numbers += ChainWork.RoomOf(bodies);
                places += PlacesOf(bodies);
            }
        }

        _work.Numbers.EnsureCapacity(numbers);
        _places.EnsureCapacity(places);
    }

    private static int FrontOf(JointTree* tree) => tree->AnchorEnd - tree->AnchorFirst > 1 ? 1 : 0;

    /// <summary>Of a chain, with what cannot move before its first body.</summary>
    private static int BodiesOf(JointTree* tree) => tree->End - tree->First + FrontOf(tree);

    private static int PlacesOf(int bodies) => bodies + 1;

    private void SetUp(Chain* chain, int index, ref int numbers, ref int places)
    {
        JointTree* tree = _work.Forest.Trees + index;
        int anchors = tree->AnchorEnd - tree->AnchorFirst;
        int front = FrontOf(tree);
        int bodies = BodiesOf(tree);
        *chain = default;
        chain->Tree = index;
        chain->Front = front;
        chain->Bend = BendOf(tree);
        chain->Bodies = bodies;
        chain->Joints = bodies - 1 + (anchors - front);
        tree->Chain = (int)(chain - _chains.Pointer);
        chain->First = numbers + ChainWork.Lead;
        chain->PlaceFirst = places;
        numbers += ChainWork.RoomOf(bodies);
        places += PlacesOf(bodies);
        _work.ClearNumbers(chain);
        SetPlaces(chain, tree);
    }

    private void SetPlaces(Chain* chain, JointTree* tree)
    {
        int bend = chain->Bend;
        int front = chain->Front;
        TreeNode* nodes = _work.Forest.Nodes;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        if (front > 0)
        {
            places[0].Node = -1;
            places[0].Active = _work.Forest.Anchors[tree->AnchorEnd - 1].Active;
            places[0].IsHighB = _work.Active[places[0].Active].Ends.NodeB == tree->First + bend;
            places[0].Body = StillBody(places[0].Active, places[0].IsHighB);
        }

        for (int i = front; i < chain->Bodies; i++)
        {
            int k = i - front;
            int node = tree->First + (k <= bend ? bend - k : k);
            places[i].Node = node;
            places[i].Body = nodes[node].Body;
            places[i].Active =
                k < bend ? nodes[node].RowJoint[0] : i < chain->Bodies - 1 ? nodes[tree->First + k + 1].RowJoint[0] : -1;
            if (i == chain->Joints - 1 && i == chain->Bodies - 1)
            {
                places[i].Active = _work.Forest.Anchors[tree->AnchorFirst].Active;
            }

            places[i].IsHighB = places[i].Active >= 0 && _work.Active[places[i].Active].Ends.NodeA == node;
        }

        places[chain->Bodies] = default;
        if (chain->Joints == chain->Bodies)
        {
            ChainPlace* last = places + chain->Bodies - 1;
            places[chain->Bodies].Body = StillBody(last->Active, !last->IsHighB);
        }
    }

    /// <summary>What an anchor holds on to.</summary>
    private int StillBody(int active, bool isA) => isA ? _work.Active[active].Ends.BodyA : _work.Active[active].Ends.BodyB;
}
