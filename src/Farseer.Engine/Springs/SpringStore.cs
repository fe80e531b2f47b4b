using System;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Springs;

/// <summary>
/// The springs of one step. They are handed in anew in each step, in the order in which they act, and forgotten at its end: a
/// spring that is disabled, broken or disposed is simply not there, and no state of it outlives the step.
/// </summary>
internal sealed unsafe class SpringStore
{
    /// <summary>
    /// Largest sum of k·h²/m and c·h/m over the springs at the bodies of one spring up to which a mesh is integrated by the
    /// midpoint rule, which keeps the energy; above it by the implicit Euler rule, which takes the swings away that a substep is
    /// too long for.
    /// </summary>
    private const double LooseLoad = 1;

    /// <summary>Share of the turning in the inverse mass below which a spring counts as pulling through the centres.</summary>
    private const double CentralShare = 1e-3;

    private readonly Column<SpringRow> _rows = new Column<SpringRow>();
    private readonly Column<BodyRecord> _records = new Column<BodyRecord>();
    private readonly Column<int> _treeBodies = new Column<int>();

    // None before there is a spring.
    [NotState(Why.OfOneStep)]
    private SpringMesh? _mesh;

    public int Count { get; private set; }

    /// <summary>True if a spring of this step pulls at a body; valid after <see cref="Prepare"/>.</summary>
    public bool Touches(int body) => Count > 0 && _records[body].Springs > 0;

    public void Add(in SpringDef def)
    {
        _rows.EnsureCapacity(Count + 1);
        _rows[Count++] = new SpringRow { Def = def };
    }

    /// <summary>The bodies of a spring of this step.</summary>
    public void Ends(int spring, out int a, out int b)
    {
        a = _rows[spring].Def.BodyA;
        b = _rows[spring].Def.BodyB;
    }

    public void Clear()
    {
        for (int i = 0; i < Count; i++)
        {
            ref SpringDef def = ref _rows[i].Def;
            Forget(def.BodyA);
            Forget(def.BodyB);
        }

        Count = 0;
    }

    /// <summary>Fixes for the step what each spring needs, and how it is integrated.</summary>
    /// <param name="bodies">The bodies.</param>
    /// <param name="moves">1 for each body that forces may move.</param>
    /// <param name="degrees">Number of contacts at each body.</param>
    /// <param name="joints">The joints, or null if there are none.</param>
    /// <param name="allHeld">True if joints of the user's own may hold any body.</param>
    /// <param name="h">The substep, seconds.</param>
    public void Prepare(BodyStore bodies, byte* moves, int* degrees, JointSolver? joints, bool allHeld, double h)
    {
        if (Count == 0)
        {
            return;
        }

        _records.EnsureCapacity(bodies.Ids.End);
        for (int i = 0; i < Count; i++)
        {
            ref SpringRow row = ref _rows[i];
            Settle(bodies, ref row, moves);
            row.HeldA = row.MovesA != 0 && (allHeld || IsHeld(row.Def.BodyA, degrees, joints)) ? 1 : 0;
            row.HeldB = row.MovesB != 0 && (allHeld || IsHeld(row.Def.BodyB, degrees, joints)) ? 1 : 0;
            SpringKernel.Place(ref row);
            double stretch = SpringKernel.FormJacobian(ref row, EndState.AtStart, EndState.AtStart, 0);
            if (row.MovesA != 0)
            {
                Note(row.Def.BodyA, row.Def, SpringKernel.InverseMassA(row), h);
                double arm = Math.Sqrt((row.ArmAX * row.ArmAX) + (row.ArmAY * row.ArmAY));
                NoteSwing(row.Def.BodyA, row, arm, row.InverseMassA, row.InverseInertiaA, stretch, h);
            }

            if (row.MovesB != 0)
            {
                Note(row.Def.BodyB, row.Def, SpringKernel.InverseMassB(row), h);
                double arm = Math.Sqrt((row.ArmBX * row.ArmBX) + (row.ArmBY * row.ArmBY));
                NoteSwing(row.Def.BodyB, row, arm, row.InverseMassB, row.InverseInertiaB, stretch, h);
            }
        }

        JoinMeshes(joints);
        for (int i = 0; i < Count; i++)
        {
            _rows[i].Form = Choose(_rows[i], h);
            _rows[i].LawMass = -1;
        }

        _mesh ??= new SpringMesh();
        _mesh.Begin(Count, bodies.Ids.End, joints);
        for (int i = 0; i < Count; i++)
        {
            ref SpringRow row = ref _rows[i];
            if (row.Form == SpringForm.Mesh)
            {
                ref BodyRecord root = ref _records[RootOf(row)];
                if (root.Mesh < 0)
                {
                    root.Mesh = _mesh.Add(root.Load <= LooseLoad, root.Held ? default : FreeMeshes.PaceFor(root.Swing, root.Drag));
                }

                _mesh.Count(root.Mesh, row);
            }
        }

        _mesh.Arrange();
        for (int i = 0; i < Count; i++)
        {
            if (_rows[i].Form == SpringForm.Mesh)
            {
                _mesh.Place(_records[RootOf(_rows[i])].Mesh, i);
            }
        }
    }

    /// <summary>The kicks of one substep, after the drive of the bodies and before their constraints.</summary>
    public void Apply(BodyStore bodies, double h)
    {
        for (int i = 0; i < Count; i++)
        {
            ref SpringRow row = ref _rows[i];
            if (row.Form == SpringForm.Exact)
            {
                SpringKernel.Kick(ref row, bodies, h);
            }
        }

        if (Count > 0)
        {
            _mesh!.Solve(_rows.Pointer, bodies, h);
        }
    }

    private static bool IsHeld(int body, int* degrees, JointSolver? joints) =>
        degrees[body] > 0 || (joints != null && joints.Holds(body));

    private static void Settle(BodyStore bodies, ref SpringRow row, byte* moves)
    {
        SpringKernel.Pin(ref row, bodies);
        int a = row.Def.BodyA;
        int b = row.Def.BodyB;
        row.MovesA = moves[a];
        row.MovesB = moves[b];
        row.ActsA = Acts(bodies, a);
        row.ActsB = Acts(bodies, b);
        row.InverseMassA = row.MovesA != 0 ? bodies.Mass[a].InverseMass : 0;
        row.InverseMassB = row.MovesB != 0 ? bodies.Mass[b].InverseMass : 0;
        row.InverseInertiaA = row.MovesA != 0 ? bodies.Mass[a].InverseInertia : 0;
        row.InverseInertiaB = row.MovesB != 0 ? bodies.Mass[b].InverseInertia : 0;
        SpringKernel.SetOffsets(ref row, bodies);
    }

    // Pinned ends are at body 0, which is static; all others are enabled.
    private static int Acts(BodyStore bodies, int body) => (bodies.Flags[body] & BodyFlags.Static) == 0 ? 1 : 0;

    private void Note(int body, in SpringDef def, double inverseMass, double h)
    {
        ref BodyRecord record = ref _records[body];
        if (record.Springs == 0)
        {
            record.Root = body;
            record.Mesh = -1;
        }

        record.Springs++;
        record.OwnLoad += ((def.Stiffness * h * h) + (def.Damping * h)) * inverseMass;
    }

    /// <summary>
    /// What a spring has in the fastest swing and decay of its body, wherever the body turns: no eigenvalue of M⁻¹K is greater than the
    /// largest sum of these at both ends of a spring. A tension that pulls beside the centre is stiff against turns.
    /// </summary>
    private void NoteSwing(int body, in SpringRow row, double arm, double inverseMass, double inverseInertia, double stretch, double h)
    {
        bool linear = row.Def.Kind == SpringKind.Linear;
        double most = linear ? inverseMass + (inverseInertia * arm * arm) : inverseInertia;
        double tension = linear ? inverseInertia * arm * Math.Abs(stretch) : 0;
        ref BodyRecord record = ref _records[body];
        record.OwnSwing += row.Def.Stiffness * h * h * (most + tension);
        record.OwnDrag += row.Def.Damping * h * most;
    }

    private void Forget(int body)
    {
        if (body < _records.Capacity)
        {
            _records[body] = default;
        }
    }

    /// <summary>
    /// Finds what hangs together by springs and trees of joints. The root of a mesh then holds its number of springs and its largest load,
    /// the others keep the mark that they are touched.
    /// </summary>
    private void JoinMeshes(JointSolver? joints)
    {
        int trees = joints?.Responses.TreeCount ?? 0;
        _treeBodies.EnsureCapacity(trees);
        for (int i = 0; i < trees; i++)
        {
            _treeBodies[i] = -1;
        }

        for (int i = 0; i < Count; i++)
        {
            ref SpringRow row = ref _rows[i];
            if (row.MovesA != 0 && row.MovesB != 0)
            {
                Join(row.Def.BodyA, row.Def.BodyB);
            }

            if (joints != null)
            {
                JoinByTree(joints, row.Def.BodyA, row.MovesA);
                JoinByTree(joints, row.Def.BodyB, row.MovesB);
            }
        }

        for (int i = 0; i < Count; i++)
        {
            ref SpringRow row = ref _rows[i];
            if (row.MovesA != 0 || row.MovesB != 0)
            {
                double loadA = row.MovesA != 0 ? _records[row.Def.BodyA].OwnLoad : 0;
                double loadB = row.MovesB != 0 ? _records[row.Def.BodyB].OwnLoad : 0;
                ref BodyRecord root = ref _records[RootOf(row)];
                root.Load = Math.Max(root.Load, loadA + loadB);
                root.Swing = Math.Max(root.Swing, OwnSwing(row.Def.BodyA, row.MovesA) + OwnSwing(row.Def.BodyB, row.MovesB));
                root.Drag = Math.Max(root.Drag, OwnDrag(row.Def.BodyA, row.MovesA) + OwnDrag(row.Def.BodyB, row.MovesB));
                root.Held |= row.HeldA != 0 || row.HeldB != 0;
                root.Rows++;
            }
        }
    }

    private double OwnSwing(int body, int moves) => moves != 0 ? _records[body].OwnSwing : 0;

    private double OwnDrag(int body, int moves) => moves != 0 ? _records[body].OwnDrag : 0;

    private void Join(int first, int second)
    {
        int a = Find(first);
        int b = Find(second);
        if (a != b)
        {
            _records[b].Root = a;
        }
    }

    /// <summary>Springs at one tree of joints pull at each other through it.</summary>
    private void JoinByTree(JointSolver joints, int body, int moves)
    {
        int tree = moves != 0 ? joints.Responses.TreeOfBody(body) : -1;
        if (tree >= 0 && _treeBodies[tree] < 0)
        {
            _treeBodies[tree] = body;
        }
        else if (tree >= 0)
        {
            Join(_treeBodies[tree], body);
        }
    }

    private int RootOf(in SpringRow row) => Find(row.MovesA != 0 ? row.Def.BodyA : row.Def.BodyB);

    private int Find(int body)
    {
        while (_records[body].Root != body)
        {
            _records[body].Root = _records[_records[body].Root].Root;
            body = _records[body].Root;
        }

        return body;
    }

    private SpringForm Choose(in SpringRow row, double h)
    {
        if (row.MovesA == 0 && row.MovesB == 0)
        {
            return SpringForm.Idle;
        }

        ref BodyRecord root = ref _records[RootOf(row)];
        if (root.Rows > 1 || row.HeldA != 0 || row.HeldB != 0 || row.Def.Kind == SpringKind.Angular)
        {
            return SpringForm.Mesh;
        }

        double mass = SpringKernel.InverseMassA(row) + SpringKernel.InverseMassB(row);
        double turning = (row.TurnA * row.TurnA * row.InverseInertiaA) + (row.TurnB * row.TurnB * row.InverseInertiaB);
        bool isResolved = SpringLaw.IsResolved(row.Def.Stiffness * h * h * mass, row.Def.Damping * h * mass);
        bool isStraight = turning <= CentralShare * mass || root.Load <= LooseLoad;
        return isResolved && isStraight ? SpringForm.Exact : SpringForm.Mesh;
    }

    /// <summary>What the springs of the step say of a body; of the root of a mesh also what they say of the mesh.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 1)]
    private struct BodyRecord
    {
        public int Springs;
        public int Root;
        public int Rows;
        public int Mesh;
        public bool Held;
        public double OwnLoad;
        public double Load;

        /// <summary>Bounds of (ωh)² and c·h/m.</summary>
        public double OwnSwing;
        public double OwnDrag;
        public double Swing;
        public double Drag;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_rows);
        s.Column(_records);
        s.Column(_treeBodies);
        Count = s.Value(Count);
    }
}
