using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Chains;
using Farseer.Engine.Joints.Lanes;
using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Nets;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>A part of the joint solver: what it works on with the others, and the way to them.</summary>
internal abstract unsafe class JointPart
{
    protected readonly JointSolver _solver;
    protected readonly JointWork _work;
    protected readonly Column<ActiveJoint> _active;
    protected readonly Column<int> _agenda;
    protected readonly ChainSolver _chains;
    protected readonly TreeContactPass _contactPass;
    protected readonly Column<TreeContact> _contacts;
    protected readonly JointForest _forest;
    protected readonly Column<int> _joints;
    protected readonly JointKinds _kinds;
    protected readonly TreeLanes _lanes;
    protected readonly TreeLoops _loops;
    protected readonly LooseSolver _loose;
    protected readonly NetSolver _nets;
    protected readonly Column<int> _nodes;
    protected readonly JointPass _pass;
    protected readonly Column<JointRows> _rows;
    protected readonly RadixSort _sort;
    protected readonly JointStore _store;
    protected readonly Column<int> _trees;

    protected JointPart(JointSolver solver, JointWork work)
    {
        _solver = solver;
        _work = work;
        _active = work.Active;
        _agenda = work.Agenda;
        _chains = work.Chains;
        _contactPass = work.ContactPass;
        _contacts = work.Contacts;
        _forest = work.Forest;
        _joints = work.Joints;
        _kinds = work.Kinds;
        _lanes = work.Lanes;
        _loops = work.Loops;
        _loose = work.Loose;
        _nets = work.Nets;
        _nodes = work.Nodes;
        _pass = work.Pass;
        _rows = work.Rows;
        _sort = work.Sort;
        _store = work.Store;
        _trees = work.Trees;
    }
}
