using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Springs;

/// <summary>
/// Springs at bodies that contacts or joints hold as well, or that are too stiff for <see cref="FreeMeshes"/>, solved together. With vθ = v
/// + θ(v₁ − v) and x₁ = x + h·vθ the springs pull by where they are at the
/// part θ of the substep:
/// <para>(M + θ·Σ JᵀsJ)·vθ = M·(v + θ·drive) − θ·Σ Jᵀ·h·k·C,  s = h(θhk + c).</para>
/// θ = 1/2 is the midpoint rule, of second order and without a loss of energy; θ = 1 the implicit Euler rule, which takes from the
/// swings that a substep cannot show. Both are stable at any constant and rest where the forces balance. The matrix is symmetric
/// and positive definite: conjugate gradients need at most as many rounds as the mesh has degrees of freedom, few if it is loose.
/// Sweeping over the springs instead would leave stiff chains too long, and a warm start of such sweeps is unstable.
/// <para>Where joints hold bodies in trees, M is that of the trees: vθ is sought among the velocities that the joints allow, and a
/// residual is turned into a velocity by the tree's own response. With the mass of a nailed body alone a spring would pull as if
/// that could fall for a substep, and stretch by (g + F/m)·θh² too far.</para>
/// </summary>
internal sealed unsafe partial class SpringMesh
{
    /// <summary>Ratio of the squared residuals at which a solution is good: 1e-7 in the velocities, what a float holds.</summary>
    private const double Tolerance = 1e-14;
    private const int MostRounds = 300;

    private readonly Column<Mesh> _meshes = new Column<Mesh>();
    private readonly Column<int> _rows = new Column<int>();
    private readonly Column<int> _slots = new Column<int>();
    private readonly Column<int> _bodies = new Column<int>();
    private readonly Column<int> _held = new Column<int>();
    private readonly Column<double> _mass = new Column<double>();
    private readonly Column<double> _velocity = new Column<double>();
    private readonly Column<double> _residual = new Column<double>();
    private readonly Column<double> _direction = new Column<double>();
    private readonly Column<double> _image = new Column<double>();
    private readonly Column<double> _diagonal = new Column<double>();
    private readonly Column<double> _scaled = new Column<double>();
    private readonly FreeMeshes _free = new FreeMeshes();
    private int _count;
    private int _nextSlot;

    public void Begin(int rows, int bodies, JointSolver? joints)
    {
        _joints = joints;
        _count = 0;
        _treeCount = 0;
        _rows.EnsureCapacity(rows);
        _slots.EnsureCapacity(bodies);
        _free.Begin(rows, bodies);
    }

    /// <summary>A new mesh.</summary>
    /// <param name="isLoose">Loose enough for the midpoint rule.</param>
    /// <param name="pace">The pace if nothing but springs holds its bodies, see <see cref="FreeMeshes"/>; none: others do.</param>
    public int Add(bool isLoose, in FreePace pace)
    {
        _meshes.EnsureCapacity(_count + 1);
        _meshes[_count] = new Mesh { Theta = isLoose ? 0.5 : 1, Pace = pace, Free = -1 };
        return _count++;
    }

    /// <summary>Tells of a spring of a mesh before its place is known.</summary>
    public void Count(int mesh, in SpringRow row)
    {
        _meshes[mesh].RowCount++;
        Forget(row.Def.BodyA);
        Forget(row.Def.BodyB);
    }

    /// <summary>Lays the meshes out one after the other.</summary>
    public void Arrange()
    {
        int next = 0;
        for (int i = 0; i < _count; i++)
        {
            _meshes[i].FirstRow = next;
            next += _meshes[i].RowCount;
            _meshes[i].RowCount = 0;
        }

        _nextSlot = 0;
        int size = Math.Max(1, (6 * next) + (3 * (_joints?.Responses.TreeBodies ?? 0)));
        _trees.EnsureCapacity(Math.Max(1, 2 * next));
        _scaled.EnsureCapacity(size);
        _bodies.EnsureCapacity(size);
        _held.EnsureCapacity(size);
        _mass.EnsureCapacity(size);
        _velocity.EnsureCapacity(size);
        _residual.EnsureCapacity(size);
        _direction.EnsureCapacity(size);
        _image.EnsureCapacity(size);
        _diagonal.EnsureCapacity(size);
    }

    /// <summary>Puts a spring into its mesh; the springs come in order.</summary>
    public void Place(int mesh, int row) => _rows[_meshes[mesh].FirstRow + _meshes[mesh].RowCount++] = row;

    /// <summary>The kicks of one substep.</summary>
    public void Solve(SpringRow* rows, BodyStore bodies, double h)
    {
        for (int i = 0; i < _count; i++)
        {
            Solve(ref _meshes[i], rows, bodies, h);
        }
    }

    private void Solve(ref Mesh mesh, SpringRow* rows, BodyStore bodies, double h)
    {
        if (mesh.Pace.Parts > 0)
        {
            if (mesh.Free < 0)
            {
                mesh.Free = _free.Add(rows, _rows.Pointer + mesh.FirstRow, mesh.RowCount, mesh.Pace);
            }

            if (_free.Run(mesh.Free, bodies, h))
            {
                return;
            }
        }

        if (mesh.SlotCount == 0)
        {
            Enlist(ref mesh, rows, bodies);
        }

        // The midpoint rule sees the lines as they are in the middle of the way, the other as they are at its start.
        double ahead = mesh.Theta < 1 ? h * mesh.Theta : 0;
        for (int i = 0; i < mesh.RowCount; i++)
        {
            ref SpringRow row = ref rows[_rows[mesh.FirstRow + i]];
            EndState a = EndState.Read(bodies, row.Def.BodyA, row.MovesA, row.ActsA);
            EndState b = EndState.Read(bodies, row.Def.BodyB, row.MovesB, row.ActsB);
            EndState seenA = Seen(a, row.Def.BodyA, row.MovesA);
            EndState seenB = Seen(b, row.Def.BodyB, row.MovesB);
            row.Stretch = SpringKernel.FormJacobian(ref row, seenA, seenB, ahead) - (ahead * PlainSpeed(row, a, b));
            row.Saturated = 0;
        }

        // A torque limit that is reached turns a spring into a given torque; the others are then solved again beside it. Each round but the
        // last has one such more.
        do
        {
            Iterate(mesh, rows, bodies, h);
        }
        while (MarkSaturated(mesh, rows, bodies, h));

        if (mesh.TreeCount > 0)
        {
            PushByImpulses(mesh, rows, bodies, h);
            return;
        }

        for (int i = 0; i < mesh.SlotCount; i++)
        {
            int body = _bodies[mesh.FirstSlot + i];
            EndState end = EndState.Read(bodies, body, 1, 1);
            double* v = _velocity.Pointer + (3 * (mesh.FirstSlot + i));
            double x = ((v[0] - end.VX) / mesh.Theta) - end.DriveX;
            double y = ((v[1] - end.VY) / mesh.Theta) - end.DriveY;
            double w = ((v[2] - end.W) / mesh.Theta) - end.DriveW;
            Push(mesh, mesh.FirstSlot + i, bodies, x, y, w, h);
        }
    }

    private void Push(in Mesh mesh, int slot, BodyStore bodies, double x, double y, double w, double h)
    {
        EndState.Push(bodies, _bodies[slot], _held[slot], x, y, w);
        if (_held[slot] == 0 && mesh.Theta < 1)
        {
            double back = (mesh.Theta - 1) * h;
            EndState.Shift(bodies, _bodies[slot], back * x, back * y, back * w);
        }
    }

    private void Enlist(ref Mesh mesh, SpringRow* rows, BodyStore bodies)
    {
        mesh.FirstSlot = _nextSlot;
        mesh.FirstTree = _treeCount;
        for (int i = 0; i < mesh.RowCount; i++)
        {
            ref SpringRow row = ref rows[_rows[mesh.FirstRow + i]];
            Enlist(ref mesh, row.Def.BodyA, row.MovesA, row.HeldA, bodies);
            Enlist(ref mesh, row.Def.BodyB, row.MovesB, row.HeldB, bodies);
        }
    }

    private void Enlist(ref Mesh mesh, int body, int moves, int held, BodyStore bodies)
    {
        if (moves == 0 || _slots[body] >= 0)
        {
            return;
        }

        int tree = _joints?.Responses.TreeOfBody(body) ?? -1;
        if (tree < 0)
        {
            AddSlot(ref mesh, body, held, bodies);
            return;
        }

        _trees[_treeCount++] = new TreeSlots { Tree = tree, FirstSlot = _nextSlot };
        mesh.TreeCount++;
        for (int i = 0; i < _joints!.Responses.SizeOf(tree); i++)
        {
            AddSlot(ref mesh, _joints.Responses.BodyOf(tree, i), InTree, bodies);
        }
    }

    private void AddSlot(ref Mesh mesh, int body, int held, BodyStore bodies)
    {
        int slot = _nextSlot++;
        mesh.SlotCount++;
        _slots[body] = slot;
        _bodies[slot] = body;
        _held[slot] = held;
        ref BodyMass mass = ref bodies.Mass[body];
        _mass[3 * slot] = _mass[(3 * slot) + 1] = 1.0 / mass.InverseMass;
        _mass[(3 * slot) + 2] = mass.InverseInertia > 0 ? 1.0 / mass.InverseInertia : 1;
    }

    /// <summary>Conjugate gradients from the velocities without springs, scaled by the diagonal.</summary>
    private void Iterate(in Mesh mesh, SpringRow* rows, BodyStore bodies, double h)
    {
        int first = 3 * mesh.FirstSlot;
        int size = 3 * mesh.SlotCount;
        double* v = _velocity.Pointer + first;
        double* r = _residual.Pointer + first;
        double* p = _direction.Pointer + first;
        double* q = _image.Pointer + first;
        double* z = _scaled.Pointer + first;
        Start(mesh, rows, bodies, h);
        double rz = Scale(mesh);
        for (int i = 0; i < size; i++)
        {
            p[i] = z[i];
        }

        double goal = rz * Tolerance;
        int rounds = Math.Min(MostRounds, (2 * size) + 8);
        for (int round = 0; round < rounds && rz > goal; round++)
        {
            Multiply(mesh, rows, h);
            double pq = 0;
            for (int i = 0; i < size; i++)
            {
                pq += p[i] * q[i];
            }

            double step = rz / pq;
            for (int i = 0; i < size; i++)
            {
                v[i] += step * p[i];
                r[i] -= step * q[i];
            }

            double next = Scale(mesh);
            double keep = next / rz;
            rz = next;
            for (int i = 0; i < size; i++)
            {
                p[i] = z[i] + (keep * p[i]);
            }
        }
    }

    /// <summary>Velocities from the residual: by the diagonal, or as a tree answers.</summary>
    /// <returns>Their product with the residual.</returns>
    private double Scale(in Mesh mesh)
    {
        double* r = _residual.Pointer;
        double* z = _scaled.Pointer;
        int first = 3 * mesh.FirstSlot;
        int end = first + (3 * mesh.SlotCount);
        for (int i = first; i < end; i++)
        {
            z[i] = r[i] / _diagonal[i];
        }

        for (int i = mesh.FirstTree; i < mesh.FirstTree + mesh.TreeCount; i++)
        {
            int slot = 3 * _trees[i].FirstSlot;
            _joints!.Responses.Respond(_trees[i].Tree, r + slot, z + slot);
        }

        double sum = 0;
        for (int i = first; i < end; i++)
        {
            sum += r[i] * z[i];
        }

        return sum;
    }

    /// <summary>The first guess, its residual, which is what the springs give at it, and the diagonal.</summary>
    private void Start(in Mesh mesh, SpringRow* rows, BodyStore bodies, double h)
    {
        for (int i = mesh.FirstSlot; i < mesh.FirstSlot + mesh.SlotCount; i++)
        {
            EndState end = EndState.Read(bodies, _bodies[i], 1, 1);
            double* v = _velocity.Pointer + (3 * i);
            v[0] = end.VX + (mesh.Theta * end.DriveX);
            v[1] = end.VY + (mesh.Theta * end.DriveY);
            v[2] = end.W + (mesh.Theta * end.DriveW);
            for (int k = 3 * i; k < (3 * i) + 3; k++)
            {
                _residual[k] = 0;
                _diagonal[k] = _mass[k];
            }
        }

        for (int i = mesh.FirstTree; i < mesh.FirstTree + mesh.TreeCount; i++)
        {
            StartTree(mesh, _trees[i], bodies);
        }

        for (int i = 0; i < mesh.RowCount; i++)
        {
            ref SpringRow row = ref rows[_rows[mesh.FirstRow + i]];
            if (row.Saturated != 0)
            {
                AddTurn(row, _residual.Pointer, mesh.Theta * row.GivenA, mesh.Theta * row.GivenB);
                continue;
            }

            Add(row, _residual.Pointer, mesh.Theta * Impulse(row, mesh, bodies, h));
            double weight = mesh.Theta * Weight(row, mesh, h);
            AddDiagonal(row, weight, mesh.Theta * Spin(row, h));
            if (row.Def.Kind == SpringKind.Angular)
            {
                double spin = -mesh.Theta * Spin(row, h);
                AddTurn(row, _residual.Pointer, spin * TurnOf(row.Def.BodyA, row.MovesA), spin * TurnOf(row.Def.BodyB, row.MovesB));
            }
        }
    }

    private void Multiply(in Mesh mesh, SpringRow* rows, double h)
    {
        double* p = _direction.Pointer;
        double* q = _image.Pointer;
        for (int i = 3 * mesh.FirstSlot; i < 3 * (mesh.FirstSlot + mesh.SlotCount); i++)
        {
            q[i] = _mass[i] * p[i];
        }

        for (int i = 0; i < mesh.RowCount; i++)
        {
            ref SpringRow row = ref rows[_rows[mesh.FirstRow + i]];
            if (row.Saturated != 0)
            {
                continue;
            }

            int a = row.MovesA != 0 ? 3 * _slots[row.Def.BodyA] : -1;
            int b = row.MovesB != 0 ? 3 * _slots[row.Def.BodyB] : -1;
            double speed = 0;
            if (a >= 0)
            {
                speed -= (row.NormalX * p[a]) + (row.NormalY * p[a + 1]) + (TurnA(row) * p[a + 2]);
            }

            if (b >= 0)
            {
                speed += (row.NormalX * p[b]) + (row.NormalY * p[b + 1]) + (TurnB(row) * p[b + 2]);
            }

            Add(row, q, mesh.Theta * Weight(row, mesh, h) * speed);
            if (row.Def.Kind == SpringKind.Angular)
            {
                double spin = mesh.Theta * Spin(row, h);
                AddTurn(row, q, a >= 0 ? spin * p[a + 2] : 0, b >= 0 ? spin * p[b + 2] : 0);
            }
        }
    }

    private bool MarkSaturated(in Mesh mesh, SpringRow* rows, BodyStore bodies, double h)
    {
        bool any = false;
        for (int i = 0; i < mesh.RowCount; i++)
        {
            ref SpringRow row = ref rows[_rows[mesh.FirstRow + i]];
            if (row.Def.Kind != SpringKind.Angular || row.Saturated != 0)
            {
                continue;
            }

            double most = row.Def.MaxTorque * h;
            double impulse = Impulse(row, mesh, bodies, h);
            double onA = -impulse - (Spin(row, h) * TurnOf(row.Def.BodyA, row.MovesA));
            double onB = impulse - (Spin(row, h) * TurnOf(row.Def.BodyB, row.MovesB));
            if (Math.Abs(onA) > most || Math.Abs(onB) > most)
            {
                row.Saturated = 1;
                row.GivenA = Math.Min(Math.Max(onA, -most), most);
                row.GivenB = Math.Min(Math.Max(onB, -most), most);
                any = true;
            }
        }

        return any;
    }

    /// <summary>What the spring gives in the substep at the present guess, without the damping of single spins.</summary>
    private double Impulse(in SpringRow row, in Mesh mesh, BodyStore bodies, double h)
    {
        double speedA = SpeedOfEnd(row.Def.BodyA, row.MovesA, row, row.TurnA, bodies);
        double speed = SpeedOfEnd(row.Def.BodyB, row.MovesB, row, row.TurnB, bodies) - speedA;
        return -((h * row.Def.Stiffness * row.Stretch) + (Weight(row, mesh, h) * speed));
    }

    private static double Weight(in SpringRow row, in Mesh mesh, double h) =>
        h * ((mesh.Theta * h * row.Def.Stiffness) + (row.Def.Kind == SpringKind.Linear ? row.Def.Damping : 0));

    private static double Spin(in SpringRow row, double h) => row.Def.Kind == SpringKind.Angular ? h * row.Def.Damping : 0;

    private static double TurnA(in SpringRow row) => row.InverseInertiaA > 0 ? row.TurnA : 0;

    private static double TurnB(in SpringRow row) => row.InverseInertiaB > 0 ? row.TurnB : 0;

    private double TurnOf(int body, int moves) => moves != 0 ? _velocity[(3 * _slots[body]) + 2] : 0;

    private double SpeedOfEnd(int body, int moves, in SpringRow row, double turn, BodyStore bodies)
    {
        if (moves == 0)
        {
            ref BodyState state = ref bodies.State[body];
            return (row.NormalX * state.LinearVelocity.X) + (row.NormalY * state.LinearVelocity.Y) + (turn * state.AngularVelocity);
        }

        double* end = _velocity.Pointer + (3 * _slots[body]);
        return (row.NormalX * end[0]) + (row.NormalY * end[1]) + (turn * end[2]);
    }

    /// <summary>target += Jᵀ·amount.</summary>
    private void Add(in SpringRow row, double* target, double amount)
    {
        if (row.MovesA != 0)
        {
            double* a = target + (3 * _slots[row.Def.BodyA]);
            a[0] -= row.NormalX * amount;
            a[1] -= row.NormalY * amount;
            a[2] -= TurnA(row) * amount;
        }

        if (row.MovesB != 0)
        {
            double* b = target + (3 * _slots[row.Def.BodyB]);
            b[0] += row.NormalX * amount;
            b[1] += row.NormalY * amount;
            b[2] += TurnB(row) * amount;
        }
    }

    private void AddTurn(in SpringRow row, double* target, double onA, double onB)
    {
        if (row.InverseInertiaA > 0)
        {
            target[(3 * _slots[row.Def.BodyA]) + 2] += onA;
        }

        if (row.InverseInertiaB > 0)
        {
            target[(3 * _slots[row.Def.BodyB]) + 2] += onB;
        }
    }

    private void AddDiagonal(in SpringRow row, double weight, double spin)
    {
        if (row.MovesA != 0)
        {
            AddDiagonal(_diagonal.Pointer + (3 * _slots[row.Def.BodyA]), row, TurnA(row), weight, spin);
        }

        if (row.MovesB != 0)
        {
            AddDiagonal(_diagonal.Pointer + (3 * _slots[row.Def.BodyB]), row, TurnB(row), weight, spin);
        }
    }

    private static void AddDiagonal(double* target, in SpringRow row, double turn, double weight, double spin)
    {
        target[0] += weight * row.NormalX * row.NormalX;
        target[1] += weight * row.NormalY * row.NormalY;
        target[2] += (weight * turn * turn) + spin;
    }

    private struct Mesh
    {
        public double Theta;
        public FreePace Pace;
        public int Free;
        public int FirstRow;
        public int RowCount;
        public int FirstSlot;
        public int SlotCount;
        public int FirstTree;
        public int TreeCount;
    }
}
