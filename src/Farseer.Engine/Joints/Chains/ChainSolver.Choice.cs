using System;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Chains;

/// <content>Which trees are chains, where their numbers are, and which of them are solved here in a step.</content>
internal sealed unsafe partial class ChainSolver
{
    /// <summary>Room before the first column, so that columns are well aligned.</summary>
    private const int Lead = 8;

    /// <summary>The trees have been built anew: finds which are chains, and where their numbers are until the next time.</summary>
    /// <param name="forest">The trees.</param>
    /// <param name="active">The joints that act.</param>
    /// <param name="rows">Their rows.</param>
    /// <param name="count">How many.</param>
    public void Renew(JointForest forest, ActiveJoint* active, JointRows* rows, int count)
    {
        _forest = forest;
        _active = active;
        _count = 0;
        QuietJoints = 0;
        _chains.EnsureCapacity(forest.OwnTrees);
        _given.EnsureCapacity(forest.OwnTrees);
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
                SetUp(_chains.Pointer + _count++, i, ref numbers, ref places);
            }
        }
    }

    /// <summary>Some tree is a chain.</summary>
    public bool AnyChains => _count > 0;

    /// <summary>The trees are no more.</summary>
    public void Forget() => _count = 0;

    /// <summary>
    /// Finds the chains that are quiet in this step: nothing touches them, and their joints are plain hinges as they were.
    /// </summary>
    /// <param name="step">What the joints see of the step.</param>
    /// <param name="allowed">Otherwise none is.</param>
    public void Look(in JointStep step, bool allowed)
    {
        _step = step;
        Any = false;
        AllStay = true;
        HasMoved = true;
        QuietJoints = 0;
        for (int i = 0; i < _count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            JointTree* tree = _forest.Trees + chain->Tree;
            chain->IsLive = false;
            tree->IsQuiet = allowed && !tree->IsSuspect && IsQuiet(chain);
            if (tree->IsQuiet)
            {
                QuietJoints += chain->Joints;
                LoadPoses(chain);
            }
            else
            {
                GiveVelocities(chain);
            }
        }
    }

    /// <summary>Turns to the quiet chains of a class.</summary>
    public void Select(int index, in JointStep step)
    {
        _step = step;
        LiveBodies = 0;
        for (int i = 0; i < _count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            JointTree* tree = _forest.Trees + chain->Tree;
            chain->IsLive = tree->IsQuiet && tree->Class == index;
            LiveBodies += chain->IsLive ? chain->Bodies : 0;
        }

        Any = LiveBodies > 0;
    }

    /// <summary>A spring pulls at a chain after all, or something touches it: it is for the general passes.</summary>
    public void Refuse(int tree)
    {
        for (int i = 0; i < _count; i++)
        {
            if (_chains[i].Tree == tree)
            {
                LiveBodies -= _chains[i].IsLive ? _chains[i].Bodies : 0;
                _chains[i].IsLive = false;
                GiveVelocities(_chains.Pointer + i);
            }
        }

        _forest.Trees[tree].IsQuiet = false;
    }

    private void Exclude(int node)
    {
        if (node >= 0)
        {
            _forest.Trees[_forest.Nodes[node].Tree].IsChain = false;
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
            if (_step.Touches[places[i].Body] > 0)
            {
                return false;
            }
        }

        return HasPlainJoints(chain) && !(chain->Breaks && IsBreaking(chain));
    }

    private bool HasPlainJoints(Chain* chain)
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
        ChainView view = ViewOf(chain);
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        chain->Edition = _store.Edition;
        chain->IsPlain = true;
        chain->Breaks = false;
        for (int i = 0; i < chain->Joints; i++)
        {
            ActiveJoint* active = _active + places[i].Active;
            ref JointSettings settings = ref _store.Settings[active->Joint];
            bool rigid =
                settings.Softness == 0 && double.IsPositiveInfinity(settings.MaxImpulse) && double.IsPositiveInfinity(settings.Breakpoint);
            bool plain = (_store.Flags[active->Joint] & More) == 0 && (active->Kind != JointKind.Pin || settings.Target == 0);
            chain->IsPlain &= rigid && plain;
            chain->Breaks |= !double.IsPositiveInfinity(settings.BreakForce);
            LoadAnchors(view, i, places[i].IsHighB, settings);
        }
    }

    /// <summary>That is for the general passes to see to.</summary>
    private bool IsBreaking(Chain* chain)
    {
        bool found = false;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = 0; i < chain->Joints; i++)
        {
            int joint = _active[places[i].Active].Joint;
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
            TreeNode* node = _forest.Nodes + tree->First + i;
            int parent = i == bend + 1 ? 0 : i - 1;
            found = node->Parent == tree->First + parent && node->EdgeCount == 1 && IsHinge(node->RowJoint[0], rows);
        }

        for (int i = 0; found && i < anchors; i++)
        {
            TreeAnchor* anchor = _forest.Anchors + tree->AnchorFirst + i;
            int node = i == 0 ? tree->First : tree->End - 1;
            found = i < 2 && bend == bodies - 1 && anchor->Node == node && IsHinge(anchor->Active, rows);
        }

        return found && (anchors < 2 || bodies > 1);
    }

    private bool IsHinge(int active, JointRows* rows) => rows[active].Hard == 2 && rows[active].Count == 2
        && (_active[active].Kind == JointKind.Revolute || _active[active].Kind == JointKind.Pin);

    /// <summary>Bodies on the first way down from the root: the chain leads up these, and down the second way if there is one.</summary>
    private int BendOf(JointTree* tree)
    {
        int i = tree->First + 1;
        while (i < tree->End && _forest.Nodes[i].Parent == i - 1)
        {
            i++;
        }

        return i - 1 - tree->First;
    }

    /// <summary>An odd number of times 32 bytes, so that columns share no places of the cache.</summary>
    private static int StrideOf(int bodies)
    {
        int blocks = ((bodies + DoubleLanes.BundleLanes) / DoubleLanes.BundleLanes) + (ChainView.Margin / DoubleLanes.BundleLanes);
        return (blocks | 1) * DoubleLanes.BundleLanes;
    }

    private static int RoomOf(int bodies) => ((Lead + ((int)ChainColumn.Count * StrideOf(bodies))) | (Lead - 1)) + 1;

    /// <summary>For all chains at once: grown chain by chain, the columns of many pendulums would be moved dozens of times.</summary>
    private void MakeRoom()
    {
        int numbers = 0;
        int places = 0;
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            if (_forest.Trees[i].IsChain)
            {
                int bodies = BodiesOf(_forest.Trees + i);
                numbers += RoomOf(bodies);
                places += PlacesOf(bodies);
            }
        }

        _numbers.EnsureCapacity(numbers);
        _places.EnsureCapacity(places);
    }

    private static int FrontOf(JointTree* tree) => tree->AnchorEnd - tree->AnchorFirst > 1 ? 1 : 0;

    /// <summary>Of a chain, with what cannot move before its first body.</summary>
    private static int BodiesOf(JointTree* tree) => tree->End - tree->First + FrontOf(tree);

    private static int PlacesOf(int bodies) => bodies + 1;

    private void SetUp(Chain* chain, int index, ref int numbers, ref int places)
    {
        JointTree* tree = _forest.Trees + index;
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
        chain->First = numbers + Lead;
        chain->PlaceFirst = places;
        numbers += RoomOf(bodies);
        places += PlacesOf(bodies);
        ClearNumbers(chain);
        SetPlaces(chain, tree);
    }

    private void ClearNumbers(Chain* chain)
    {
        Clear(_numbers.Pointer + chain->First - Lead, RoomOf(chain->Bodies));
        long* exists = (long*)ViewOf(chain)[ChainColumn.Exists];
        for (int i = 0; i < chain->Joints; i++)
        {
            exists[i] = -1;
        }

        chain->Edition = _store.Edition - 1;
        chain->StillAngle = double.NaN;
        chain->FrontAngle = double.NaN;
    }

    private void SetPlaces(Chain* chain, JointTree* tree)
    {
        int bend = chain->Bend;
        int front = chain->Front;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        if (front > 0)
        {
            places[0].Node = -1;
            places[0].Active = _forest.Anchors[tree->AnchorEnd - 1].Active;
            places[0].IsHighB = _active[places[0].Active].Ends.NodeB == tree->First + bend;
            places[0].Body = StillBody(places[0].Active, places[0].IsHighB);
        }

        for (int i = front; i < chain->Bodies; i++)
        {
            int k = i - front;
            int node = tree->First + (k <= bend ? bend - k : k);
            places[i].Node = node;
            places[i].Body = _forest.Nodes[node].Body;
            places[i].Active =
                k < bend ? _forest.Nodes[node].RowJoint[0] : i < chain->Bodies - 1 ? _forest.Nodes[tree->First + k + 1].RowJoint[0] : -1;
            if (i == chain->Joints - 1 && i == chain->Bodies - 1)
            {
                places[i].Active = _forest.Anchors[tree->AnchorFirst].Active;
            }

            places[i].IsHighB = places[i].Active >= 0 && _active[places[i].Active].Ends.NodeA == node;
        }

        places[chain->Bodies] = default;
        if (chain->Joints == chain->Bodies)
        {
            ChainPlace* last = places + chain->Bodies - 1;
            places[chain->Bodies].Body = StillBody(last->Active, !last->IsHighB);
        }
    }

    /// <summary>What an anchor holds on to.</summary>
    private int StillBody(int active, bool isA) => isA ? _active[active].Ends.BodyA : _active[active].Ends.BodyB;
}
