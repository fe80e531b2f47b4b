using System;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// The joints that close loops within trees. With Y the inverse mass of a tree that its edges leave, J the rows of all joints that close
/// its loops and K = J Y Jᵀ, the multipliers λ = K⁻¹ (t - J v) of a velocity v that meets the edges make it meet the loops too: tree and
/// loops are one exact solution. The columns of K are solutions of the tree to an impulse along each row.
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
    private readonly Column<int> _rowOf = new Column<int>();
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
        s.Column(_rowOf);
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
        _rowOf.EnsureCapacity(loops);
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
        int rows = 0;
        int squares = 0;
        int most = 0;
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            JointTree* tree = _forest.Trees + i;
            tree->LoopRow = rows;
            tree->LoopSquare = squares;
            for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
            {
                _rowOf[at] = rows;
                rows += _active[_joints[at]].BuiltHard;
            }

            tree->LoopRows = rows - tree->LoopRow;
            squares += tree->LoopRows * tree->LoopRows;
            most = Math.Max(most, tree->LoopRows);
        }

        _target.EnsureCapacity(rows);
        _residual.EnsureCapacity(rows);
        _lambda.EnsureCapacity(rows);
        _scale.EnsureCapacity(rows);
        _inverse.EnsureCapacity(squares);
        _work.EnsureCapacity(2 * most * most);
    }

    /// <summary>The joint that is the loop at a place.</summary>
    public int JointAt(int loop) => _joints[loop];

    /// <summary>What the rows of a loop are to reach.</summary>
    public double* TargetOf(int loop) => _target.Pointer + _rowOf[loop];

    public void ClearTargets(JointTree* tree) => Clear(_target.Pointer + tree->LoopRow, tree->LoopRows);

    /// <summary>Inverts K of a tree that has just been factored. Its velocities stay; the targets of its edges are lost.</summary>
    public void Factor(JointTree* tree)
    {
        int n = tree->LoopRows;
        if (n == 0)
        {
            return;
        }

        Keep(tree);
        ClearEdgeTargets(tree);
        double* k = _inverse.Pointer + tree->LoopSquare;
        for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
        {
            for (int r = 0; r < _active[_joints[at]].BuiltHard; r++)
            {
                int column = _rowOf[at] - tree->LoopRow + r;
                ClearVelocities(tree);
                Push(at, r, 1);
                double own = Speed(at, r);
                _scale[tree->LoopRow + column] = own > 0 ? 1 / Math.Sqrt(own) : 0;
                TreeSolve.Run(_forest, tree);
                for (int to = tree->LoopFirst; to < tree->LoopEnd; to++)
                {
                    for (int q = 0; q < _active[_joints[to]].BuiltHard; q++)
                    {
                        k[((_rowOf[to] - tree->LoopRow + q) * n) + column] = Speed(to, q);
                    }
                }
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

        Keep(tree);
        TreeSolve.Run(_forest, tree);
        for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
        {
            FindResidual(at);
        }

        FindImpulses(tree);
        Recall(tree);
        for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
        {
            for (int r = 0; r < _active[_joints[at]].BuiltHard; r++)
            {
                Push(at, r, _lambda[_rowOf[at] + r]);
            }
        }

        TreeSolve.Run(_forest, tree);
    }

    /// <summary>Adds the impulses found last to what the joints gave.</summary>
    public void Give(JointTree* tree)
    {
        for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
        {
            Give(at);
        }
    }

    /// <summary>In a walk: the impulses that take the loops of a tree to their targets.</summary>
    public void Sweep(JointTree* tree)
    {
        JointForestView view = _forest.View;
        for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
        {
            RowEnds.Visit(view, &_active.Pointer[_joints[at]].Ends);
            FindResidual(at);
        }

        FindImpulses(tree);
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
        {
            ActiveJoint* joint = _active.Pointer + _joints[at];
            RowEnds.Visit(view, &joint->Ends);
            Clear(a, 3);
            Clear(b, 3);
            JointRows* rows = _rows.Pointer + _joints[at];
            for (int r = 0; r < joint->BuiltHard; r++)
            {
                AddScaled(rows->A + (r * 3), _lambda[_rowOf[at] + r], a);
                AddScaled(rows->B + (r * 3), _lambda[_rowOf[at] + r], b);
            }

            RowEnds.Apply(view, &joint->Ends, a, b);
            Give(at);
        }
    }

    /// <summary>λ from the residuals.</summary>
    private void FindImpulses(JointTree* tree) => TreeSolve.Multiply(
        _inverse.Pointer + tree->LoopSquare, _residual.Pointer + tree->LoopRow, tree->LoopRows, _lambda.Pointer + tree->LoopRow);

    private void FindResidual(int at)
    {
        int first = _rowOf[at];
        for (int r = 0; r < _active[_joints[at]].BuiltHard; r++)
        {
            _residual[first + r] = _target[first + r] - Speed(at, r);
        }
    }

    private void Give(int at)
    {
        ActiveJoint* joint = _active.Pointer + _joints[at];
        for (int r = 0; r < joint->BuiltHard; r++)
        {
            AddScaled(_rows.Pointer[_joints[at]].B + (r * 3), _lambda[_rowOf[at] + r], joint->Given);
        }
    }

    private double Speed(int at, int row)
    {
        int joint = _joints[at];
        ref RowEnds ends = ref _active[joint].Ends;
        TreeNode* nodes = _forest.Nodes;
        return SmallMatrix.Dot(_rows.Pointer[joint].A + (row * 3), nodes[ends.NodeA].Velocity)
            + SmallMatrix.Dot(_rows.Pointer[joint].B + (row * 3), nodes[ends.NodeB].Velocity);
    }

    private void Push(int at, int row, double impulse)
    {
        int joint = _joints[at];
        double* a = stackalloc double[3] { 0, 0, 0 };
        double* b = stackalloc double[3] { 0, 0, 0 };
        AddScaled(_rows.Pointer[joint].A + (row * 3), impulse, a);
        AddScaled(_rows.Pointer[joint].B + (row * 3), impulse, b);
        RowEnds.Push(_forest.Nodes, &_active.Pointer[joint].Ends, a, b);
    }

    private void Keep(JointTree* tree)
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
