using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Loose;

/// <content>Which joints go side by side.</content>
internal sealed unsafe partial class LooseSolver
{
    /// <summary>What nobody reads: where the lanes write that move nothing.</summary>
    private const int Nobody = 0;
    private const int TypeBits = 3;
    private const int KindBits = 5;
    private const int LevelShift = 32;

    private readonly Column<int> _placeOf = new Column<int>();
    private readonly Column<int> _levels = new Column<int>();
    private readonly Column<ulong> _keys = new Column<ulong>();
    private readonly Column<int> _items = new Column<int>();
    private readonly RadixSort _sort = new RadixSort();

    /// <summary>The joint has no rows but those that are iterated by themselves, of a kind that can be written on lanes.</summary>
    public static bool Knows(ActiveJoint* joint, JointRows* rows) =>
        joint->Role == JointRole.Iterated && rows->Hard == 0 && rows->Count > 0 && !joint->Overrun && !joint->Ends.Coupled
        && LooseForms.Knows(joint->Kind);

    /// <summary>Before the joints of a step are taken.</summary>
    /// <param name="forest">The trees.</param>
    /// <param name="active">The joints.</param>
    /// <param name="rows">Their rows.</param>
    /// <param name="step">What the joints see of the step.</param>
    public void Begin(JointForest forest, ActiveJoint* active, JointRows* rows, in JointStep step)
    {
        _forest = forest;
        _active = active;
        _rows = rows;
        _step = step;
        _bundleCount = 0;
        _rowCount = 0;
        _jointCount = 0;
        _bodyCount = Nobody + 1;
    }

    /// <summary>Makes room for all joints that could be taken, so that those which are let go of late in a run do not allocate.</summary>
    /// <param name="count">Active joints.</param>
    public void Reserve(int count)
    {
        int joints = 0;
        int most = 0;
        for (int i = 0; i < count; i++)
        {
            if (Knows(_active + i, _rows + i))
            {
                joints++;
                most += _rows[i].Count;
            }
        }

        if (joints > 0)
        {
            _bundles.EnsureCapacity(joints);
            _places.EnsureCapacity(joints);
            _looseRows.EnsureCapacity(most);
            _keys.EnsureCapacity(joints);
            _items.EnsureCapacity(joints);
            _sort.Reserve(joints);
            ReserveBodies();
        }
    }

    /// <summary>Makes room for the bodies of these joints, guests with them.</summary>
    public void ReserveBodies()
    {
        if (_bundles.Capacity > 0)
        {
            int bodies = _forest.NodeRoom + _bundles.Capacity + 1;
            _bodies.EnsureCapacity(bodies);
            _levels.EnsureCapacity(bodies);
            _placeOf.EnsureCapacity(_forest.NodeRoom);
            _turns.Clear(bodies);
        }
    }

    /// <summary>Takes a body.</summary>
    public void TakeBody(int node)
    {
        _bodies.EnsureCapacity(_bodyCount + 1);
        _levels.EnsureCapacity(_bodyCount + 1);
        _levels[_bodyCount] = 0;
        _placeOf[node] = _bodyCount;
        _bodies[_bodyCount] = default;
        _bodies[_bodyCount++].Node = node;
    }

    /// <summary>
    /// Takes a joint, in the order in which they are solved. Its level is one above those of the joints before it that share a body with
    /// it: joints of one level may be solved in any order, and those of different levels that share a body keep theirs.
    /// </summary>
    public void TakeJoint(int index)
    {
        ref RowEnds ends = ref _active[index].Ends;
        int level = 0;
        level = ends.NodeA >= 0 ? System.Math.Max(level, _levels[_placeOf[ends.NodeA]]) : level;
        level = ends.NodeB >= 0 ? System.Math.Max(level, _levels[_placeOf[ends.NodeB]]) : level;
        Lift(ends.NodeA, level + 1);
        Lift(ends.NodeB, level + 1);
        _keys.EnsureCapacity(_jointCount + 1);
        _items.EnsureCapacity(_jointCount + 1);
        _keys[_jointCount] = ((ulong)(uint)level << LevelShift) | ShapeOf(index);
        _items[_jointCount++] = index;
    }

    private void Lift(int node, int level)
    {
        if (node >= 0)
        {
            _levels[_placeOf[node]] = level;
        }
    }

    private uint ShapeOf(int index)
    {
        JointRows* rows = _rows + index;
        uint shape = (uint)rows->Count;
        for (int k = 0; k < rows->Count; k++)
        {
            shape = (shape << TypeBits) | rows->Type[k];
        }

        return (shape << KindBits) | (uint)_active[index].Kind;
    }

    /// <summary>Puts the joints that were taken into bundles, level by level.</summary>
    private void Bundle()
    {
        _sort.Sort(_keys.Pointer, _items.Pointer, _jointCount);
        _bundles.EnsureCapacity(_jointCount);
        _places.EnsureCapacity(_jointCount);
        for (int first = 0; first < _jointCount;)
        {
            int end = first + 1;
            while (end < _jointCount && end < first + DoubleLanes.BundleLanes && _keys[end] == _keys[first])
            {
                end++;
            }

            AddBundle(first, end - first);
            first = end;
        }
    }

    private void AddBundle(int first, int count)
    {
        JointRows* rows = _rows + _items[first];
        LoosePlace* place = _places.Pointer + _bundleCount++;
        *place = default;
        place->Kind = _active[_items[first]].Kind;
        place->FirstRow = _rowCount;
        place->Rows = rows->Count;
        place->Count = count;
        place->OnlyLimits = true;
        place->SoftPoint = rows->SoftPoint;
        for (int k = 0; k < rows->Count; k++)
        {
            place->Type[k] = rows->Type[k];
            place->OnlyLimits &= rows->Type[k] == (byte)RowType.Limit;
        }

        _rowCount += rows->Count;
        _looseRows.EnsureCapacity(_rowCount);
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
        {
            // Empty lanes are copies of the first that move nothing.
            bool real = lane < count;
            int index = _items[real ? first + lane : first];
            ref RowEnds ends = ref _active[index].Ends;
            place->Active[lane] = index;
            place->BodyA[lane] = real ? PlaceOf(ends.NodeA, ends.BodyA) : place->BodyA[0];
            place->BodyB[lane] = real ? PlaceOf(ends.NodeB, ends.BodyB) : place->BodyB[0];
            place->IntoA[lane] = real && ends.NodeA >= 0 ? place->BodyA[lane] : Nobody;
            place->IntoB[lane] = real && ends.NodeB >= 0 ? place->BodyB[lane] : Nobody;
            if (!place->OnlyLimits)
            {
                _bodies[place->IntoA[lane]].Held = true;
                _bodies[place->IntoB[lane]].Held = true;
            }
        }
    }

    private int PlaceOf(int node, int body)
    {
        if (node >= 0)
        {
            return _placeOf[node];
        }

        // Most hang on the world's frame.
        if (_bodies[_bodyCount - 1].Node < 0 && _bodies[_bodyCount - 1].Body == body && _bodyCount - 1 > Nobody)
        {
            return _bodyCount - 1;
        }

        _bodies.EnsureCapacity(_bodyCount + 1);
        LooseBody* still = _bodies.Pointer + _bodyCount;
        *still = default;
        still->Node = -1;
        still->Body = body;
        still->Pose[2] = double.NaN;
        return _bodyCount++;
    }
}
