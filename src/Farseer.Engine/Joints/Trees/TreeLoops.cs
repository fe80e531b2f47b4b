using System;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// The joints that close loops within trees. With Y the inverse mass of a tree that its edges leave, J the rows of all joints that close
/// its loops and K = J Y Jᵀ, the multipliers λ = K⁻¹ (t - J v) of a velocity v that meets the edges make it meet the loops too: tree and
/// loops are one exact solution. The columns of K are solutions of the tree to an impulse along each row. Limits of these joints that hold
/// are rows of K as well, after those that always do: iterated against the loop, they gave way the more the less it left them.
/// </summary>
internal sealed unsafe class TreeLoops
{
    /// <summary>
    /// ρ of K in terms of its rows' own responses: K (K² + ρ²)⁻¹ is the inverse wherever there is a response, and goes to 0 with it. In a
    /// grid of welds the tree alone holds what its loops would, and a linkage has dead centres; the plain inverse would divide rounding by
    /// rounding there.
    /// </summary>
    private const double Dead = 1e-4;

    private readonly Column<int> _joints = new Column<int>();

    /// <summary>The joint of a row of K, and its place there.</summary>
    private readonly Column<int> _jointOf = new Column<int>();
    private readonly Column<int> _indexOf = new Column<int>();
    private readonly Column<double> _inverse = new Column<double>();
    [NotState(Why.OfOneStep)]
    private readonly Column<double> _work = new Column<double>();
    [NotState(Why.OfOneStep)]
    private readonly Column<double> _scale = new Column<double>();
    [NotState(Why.OfOneStep)]
    private readonly Column<double> _target = new Column<double>();
    [NotState(Why.OfOneStep)]
    private readonly Column<double> _residual = new Column<double>();
    [NotState(Why.OfOneStep)]
    private readonly Column<double> _lambda = new Column<double>();
    [NotState(Why.OfOneStep)]
    private readonly Column<double> _kept = new Column<double>();

    [NotState(Why.Elsewhere)]
    private readonly JointForest _forest;

    [NotState(Why.Elsewhere)]
    private readonly Column<ActiveJoint> _active;

    [NotState(Why.Elsewhere)]
    private readonly Column<JointRows> _rows;

    public TreeLoops(JointForest forest, Column<ActiveJoint> active, Column<JointRows> rows)
    {
        _forest = forest;
        _active = active;
        _rows = rows;
    }

    public void Visit(StateStream s)
    {
        s.Column(_joints);
        s.Column(_jointOf);
        s.Column(_indexOf);
        s.Column(_inverse);
    }

    /// <summary>Sorts the joints that close loops by their trees; the forest has been built.</summary>
    public void Build(int count)
    {
        JointTree* trees = _forest.Trees;
        int loops = 0;
        int bodies = 0;
        for (int i = 0; i < count; i++)
        {
            _active[i].LeadsLoops = false;
            if (_active[i].Role == JointRole.Loop)
            {
                loops++;
                trees[_forest.Nodes[_active[i].Ends.NodeA].Tree].LoopEnd++;
            }
        }

        _joints.EnsureCapacity(loops);
        int first = 0;
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            JointTree* tree = trees + i;
            int own = tree->LoopEnd;
            tree->LoopFirst = first;
            tree->LoopEnd = first;
            first += own;
            bodies = own > 0 ? Math.Max(bodies, tree->End - tree->First) : bodies;
        }

        for (int i = 0; i < count; i++)
        {
            if (_active[i].Role == JointRole.Loop)
            {
                JointTree* tree = trees + _forest.Nodes[_active[i].Ends.NodeA].Tree;
                _active[i].LeadsLoops = tree->LoopEnd == tree->LoopFirst;
                _joints[tree->LoopEnd++] = i;
            }
        }

        PlaceRows();
        _kept.EnsureCapacity(3 * bodies);
    }

    private void PlaceRows()
    {
        int room = 0;
        int squares = 0;
        int most = 0;
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            JointTree* tree = _forest.Trees + i;
            tree->LoopRow = room;
            tree->LoopSquare = squares;
            int rows = 0;
            for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
            {
                // One of a range's two limits holds at most; there may be several ranges.
                rows += _active[_joints[at]].BuiltCount;
                tree->HasLimits |= _active[_joints[at]].BlockLimits;
            }

            room += rows;
            squares += rows * rows;
            most = Math.Max(most, rows);
        }

        _jointOf.EnsureCapacity(room);
        _indexOf.EnsureCapacity(room);
        _target.EnsureCapacity(room);
        _residual.EnsureCapacity(room);
        _lambda.EnsureCapacity(room);
        _scale.EnsureCapacity(room);
        _inverse.EnsureCapacity(squares);
        _work.EnsureCapacity(2 * most * most);
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            JointTree* tree = _forest.Trees + i;
            tree->LoopRows = 0;
            for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
            {
                for (int r = 0; r < _active[_joints[at]].BuiltHard; r++)
                {
                    Hold(tree, _joints[at], r);
                }
            }

            tree->LoopHard = tree->LoopRows;
        }
    }

    /// <summary>The joint that is the loop at a place.</summary>
    public int JointAt(int loop) => _joints[loop];

    /// <summary>The joint of a row of K, from <see cref="JointTree.LoopRow"/> on, and its place there.</summary>
    public int JointOf(int row) => _jointOf[row];

    public int IndexOf(int row) => _indexOf[row];

    /// <summary>What a row is to reach.</summary>
    public ref double TargetOf(int row) => ref _target[row];

    /// <summary>What a row gave in the last solution.</summary>
    public double LambdaOf(int row) => _lambda[row];

    public void ClearTargets(JointTree* tree) => Clear(_target.Pointer + tree->LoopRow, tree->LoopRows);

    /// <summary>A row of a joint holds from the next <see cref="Factor"/> on; it has given nothing yet.</summary>
    public void Hold(JointTree* tree, int joint, int index)
    {
        int row = tree->LoopRow + tree->LoopRows++;
        _jointOf[row] = joint;
        _indexOf[row] = index;
        _lambda[row] = 0;
    }

    /// <summary>After <see cref="ReleaseAll"/>, row by row: one that holds on, with what it gave.</summary>
    public void Keep(JointTree* tree, int row)
    {
        double given = _lambda[row];
        Hold(tree, _jointOf[row], _indexOf[row]);
        _lambda[tree->LoopRowEnd - 1] = given;
    }

    /// <summary>No limit holds.</summary>
    /// <returns>One past the last row that held.</returns>
    public int ReleaseAll(JointTree* tree)
    {
        int end = tree->LoopRowEnd;
        tree->LoopRows = tree->LoopHard;
        return end;
    }

    /// <summary>The limit holds, or that at the other end of its range.</summary>
    public bool Holds(JointTree* tree, int joint, int index)
    {
        for (int row = tree->FirstLoopLimit; row < tree->LoopRowEnd; row++)
        {
            if (_jointOf[row] == joint && _rows.Pointer[joint].BoundSame(_indexOf[row], index))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Inverts K of a tree that has just been factored. Its velocities stay; the targets of its edges are lost.</summary>
    public void Factor(JointTree* tree)
    {
        int n = tree->LoopRows;
        if (n == 0)
        {
            return;
        }

        KeepVelocities(tree);
        ClearEdgeTargets(tree);
        double* k = _inverse.Pointer + tree->LoopSquare;
        for (int column = 0; column < n; column++)
        {
            ClearVelocities(tree);
            Push(tree->LoopRow + column, 1);
            double own = Speed(tree->LoopRow + column);
            _scale[tree->LoopRow + column] = own > 0 ? 1 / Math.Sqrt(own) : 0;
            TreeSolve.Run(_forest, tree);
            for (int row = 0; row < n; row++)
            {
                k[(row * n) + column] = Speed(tree->LoopRow + row);
            }
        }

        Recall(tree);
        Invert(k, _scale.Pointer + tree->LoopRow, n);
    }

    /// <summary>
    /// <see cref="TreeSolve.Run"/> of a tree with its loops: the impulses of the loops act on the bodies' own masses before the tree is
    /// solved, so that the multipliers of its edges are those of both.
    /// </summary>
    public void Solve(JointTree* tree)
    {
        if (tree->LoopRows == 0)
        {
            TreeSolve.Run(_forest, tree);
            return;
        }

        KeepVelocities(tree);
        TreeSolve.Run(_forest, tree);
        FindImpulses(tree);
        Recall(tree);
        for (int row = tree->LoopRow; row < tree->LoopRowEnd; row++)
        {
            Push(row, _lambda[row]);
        }

        TreeSolve.Run(_forest, tree);
    }

    /// <summary>Adds the impulses found last to what the joints gave; those of limits that hold also to their rows.</summary>
    public void Give(JointTree* tree)
    {
        for (int row = tree->LoopRow; row < tree->LoopRowEnd; row++)
        {
            ActiveJoint* joint = _active.Pointer + _jointOf[row];
            JointRows* rows = _rows.Pointer + _jointOf[row];
            AddScaled(rows->B + (_indexOf[row] * 3), _lambda[row], joint->Given);
            if (_indexOf[row] >= rows->Hard)
            {
                joint->Lambda[_indexOf[row]] += _lambda[row];
            }
        }
    }

    /// <summary>In a walk: the impulses that take the loops of a tree to their targets.</summary>
    public void Sweep(JointTree* tree)
    {
        JointForestView view = _forest.View;
        for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
        {
            RowEnds.Visit(view, &_active.Pointer[_joints[at]].Ends);
        }

        FindImpulses(tree);
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        for (int row = tree->LoopRow; row < tree->LoopRowEnd; row++)
        {
            ActiveJoint* joint = _active.Pointer + _jointOf[row];
            RowEnds.Visit(view, &joint->Ends);
            Impulse(row, _lambda[row], a, b);
            RowEnds.Apply(view, &joint->Ends, a, b);
        }

        Give(tree);
    }

    /// <summary>λ from what is left to the targets.</summary>
    private void FindImpulses(JointTree* tree)
    {
        for (int row = tree->LoopRow; row < tree->LoopRowEnd; row++)
        {
            _residual[row] = _target[row] - Speed(row);
        }

        TreeSolve.Multiply(
            _inverse.Pointer + tree->LoopSquare, _residual.Pointer + tree->LoopRow, tree->LoopRows, _lambda.Pointer + tree->LoopRow);
    }

    private double Speed(int row)
    {
        JointRows* rows = _rows.Pointer + _jointOf[row];
        ref RowEnds ends = ref _active[_jointOf[row]].Ends;
        TreeNode* nodes = _forest.Nodes;
        return SmallMatrix.Dot(rows->A + (_indexOf[row] * 3), nodes[ends.NodeA].Velocity)
            + SmallMatrix.Dot(rows->B + (_indexOf[row] * 3), nodes[ends.NodeB].Velocity);
    }

    private void Push(int row, double impulse)
    {
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        Impulse(row, impulse, a, b);
        RowEnds.Push(_forest.Nodes, &_active.Pointer[_jointOf[row]].Ends, a, b);
    }

    private void Impulse(int row, double impulse, double* a, double* b)
    {
        JointRows* rows = _rows.Pointer + _jointOf[row];
        Clear(a, 3);
        Clear(b, 3);
        AddScaled(rows->A + (_indexOf[row] * 3), impulse, a);
        AddScaled(rows->B + (_indexOf[row] * 3), impulse, b);
    }

    private void KeepVelocities(JointTree* tree)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            double* v = _forest.Nodes[i].Velocity;
            double* kept = _kept.Pointer + (3 * (i - tree->First));
            kept[0] = v[0];
            kept[1] = v[1];
            kept[2] = v[2];
        }
    }

    private void Recall(JointTree* tree)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            double* v = _forest.Nodes[i].Velocity;
            double* kept = _kept.Pointer + (3 * (i - tree->First));
            v[0] = kept[0];
            v[1] = kept[1];
            v[2] = kept[2];
        }
    }

    private void ClearVelocities(JointTree* tree)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            Clear(_forest.Nodes[i].Velocity, 3);
        }
    }

    private void ClearEdgeTargets(JointTree* tree)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            Clear(_forest.Nodes[i].Target, 3);
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            Clear(_forest.Anchors[i].Target, 3);
        }
    }

    /// <summary>K (K² + ρ²)⁻¹ in terms of the rows' own responses, in place.</summary>
    private void Invert(double* k, double* scale, int n)
    {
        double* square = _work.Pointer;
        double* scaled = square + (n * n);
        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
            {
                scaled[(i * n) + j] = 0.5 * (k[(i * n) + j] + k[(j * n) + i]) * scale[i] * scale[j];
            }
        }

        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j <= i; j++)
            {
                double sum = i == j ? Dead * Dead : 0;
                for (int m = 0; m < n; m++)
                {
                    sum += scaled[(i * n) + m] * scaled[(m * n) + j];
                }

                square[(i * n) + j] = sum;
            }
        }

        FactorCholesky(square, n);
        for (int column = 0; column < n; column++)
        {
            SolveCholesky(square, n, scaled + column);
        }

        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
            {
                k[(i * n) + j] = 0.5 * (scaled[(i * n) + j] + scaled[(j * n) + i]) * scale[i] * scale[j];
            }
        }
    }

    private static void FactorCholesky(double* m, int n)
    {
        for (int j = 0; j < n; j++)
        {
            for (int i = j; i < n; i++)
            {
                double sum = m[(i * n) + j];
                for (int p = 0; p < j; p++)
                {
                    sum -= m[(i * n) + p] * m[(j * n) + p];
                }

                // K² is known to some last places of its largest; ρ² is above them, but for roundings of many rows.
                m[(i * n) + j] = i == j ? Math.Sqrt(Math.Max(sum, 0.5 * Dead * Dead)) : sum / m[(j * n) + j];
            }
        }
    }

    /// <summary>Solves for a column of a matrix of n columns.</summary>
    private static void SolveCholesky(double* m, int n, double* x)
    {
        for (int i = 0; i < n; i++)
        {
            double sum = x[i * n];
            for (int p = 0; p < i; p++)
            {
                sum -= m[(i * n) + p] * x[p * n];
            }

            x[i * n] = sum / m[(i * n) + i];
        }

        for (int i = n - 1; i >= 0; i--)
        {
            double sum = x[i * n];
            for (int p = i + 1; p < n; p++)
            {
                sum -= m[(p * n) + i] * x[p * n];
            }

            x[i * n] = sum / m[(i * n) + i];
        }
    }

    private static void AddScaled(double* j, double factor, double* r)
    {
        r[0] += j[0] * factor;
        r[1] += j[1] * factor;
        r[2] += j[2] * factor;
    }

    private static void Clear(double* values, int count)
    {
        for (int i = 0; i < count; i++)
        {
            values[i] = 0;
        }
    }
}
