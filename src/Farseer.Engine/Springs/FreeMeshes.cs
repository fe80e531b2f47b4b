using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Springs;

/// <summary>
/// Springs that share bodies which nothing else holds. A substep is cut into as many parts as the fastest swing of the mesh asks for, and
/// each is gone through by a splitting of fourth order: kicks by the springs where the bodies are, and ways by their velocities, in turns.
/// It takes the springs as they are, however they turn; it keeps momentum, and energy for any time, and rests where the forces balance. A
/// kick is the exact course of v' = M⁻¹(f − C·v) at that place, to fourth order.
/// <para>An implicit step of the whole substep has a system to solve instead, takes longer for it, and shifts what swings fast or takes
/// it away.</para>
/// </summary>
internal sealed unsafe class FreeMeshes
{
    /// <summary>Parts beyond which a mesh is left to <see cref="SpringMesh"/>: a swing that turns by some 18 rounds in a substep.</summary>
    private const int MostParts = 64;

    /// <summary>
    /// Swing, the turn of the fastest one, and decay in a substep up to which one kick will do, and four; and in each part of six. There
    /// the frequency of the fastest is off by 3e-4 and its energy, to and fro, by 8e-4 of itself; that of one half as fast by a sixteenth,
    /// with one kick by a quarter.
    /// </summary>
    private const double LeapSwing = 0.06;
    private const double LeapDrag = 0.02;
    private const double FourSwing = 0.8;
    private const double FourDrag = 0.5;
    private const double Swing = 1.8;
    private const double Drag = 1.5;

    /// <summary>
    /// Decay in a part up to which one term of the series of a kick will do, two, and three: the fastest decay is then off by less than
    /// 1e-3 of itself.
    /// </summary>
    private const double OneTerm = 0.002;
    private const double TwoTerms = 0.03;
    private const double ThreeTerms = 0.2;

    /// <summary>
    /// Share of its energy that a mesh may gain in a substep: more than the ripple of any swing at the paces above. A spring that is
    /// pressed to no length at all turns about between two kicks; there finer parts are tried once, and what gains then too is left to
    /// <see cref="SpringMesh"/>.
    /// </summary>
    private const double LargestGain = 2e-3;
    private const int Finer = 4;

    private readonly Column<FreeMesh> _meshes = new Column<FreeMesh>();
    private readonly Column<FreeBody> _bodies = new Column<FreeBody>();
    private readonly Column<FreeSpring> _springs = new Column<FreeSpring>();
    private readonly Column<int> _places = new Column<int>();
    private int _meshCount;
    private int _bodyCount;
    private int _springCount;

    /// <summary>The pace for a mesh; none if it is too stiff.</summary>
    /// <param name="swing">Bound of (ωh)² over its swings.</param>
    /// <param name="drag">Bound of c·h/m over its motions.</param>
    public static FreePace PaceFor(double swing, double drag)
    {
        double turn = Math.Sqrt(swing);
        if (turn <= LeapSwing && drag <= LeapDrag)
        {
            return new FreePace { Scheme = FreeScheme.Leap, Parts = 1, Drag = drag };
        }

        if ((turn / FourSwing) + (drag / FourDrag) <= 1)
        {
            return new FreePace { Scheme = FreeScheme.Four, Parts = 1, Drag = drag };
        }

        double parts = Math.Ceiling((turn / Swing) + (drag / Drag));
        return parts <= MostParts ? new FreePace { Scheme = FreeScheme.Six, Parts = (int)parts, Drag = drag / parts } : default;
    }

    /// <param name="springs">Springs at most.</param>
    /// <param name="bodies">End of the indices of bodies.</param>
    public void Begin(int springs, int bodies)
    {
        _meshCount = 0;
        _bodyCount = 0;
        _springCount = 0;
        _meshes.EnsureCapacity(springs);
        _springs.EnsureCapacity(springs);
        _bodies.EnsureCapacity(2 * springs);
        _places.EnsureCapacity(bodies);
    }

    /// <summary>Takes a mesh for the step.</summary>
    /// <returns>Its index.</returns>
    public int Add(SpringRow* rows, int* list, int count, in FreePace pace)
    {
        ref FreeMesh mesh = ref _meshes[_meshCount];
        mesh.FirstBody = _bodyCount;
        mesh.FirstSpring = _springCount;
        mesh.SpringCount = count;
        mesh.Pace = pace;
        mesh.Terms = pace.Drag <= OneTerm ? 1 : pace.Drag <= TwoTerms ? 2 : pace.Drag <= ThreeTerms ? 3 : 4;
        mesh.Turns = false;
        mesh.Driven = false;
        for (int i = 0; i < count; i++)
        {
            _places[rows[list[i]].Def.BodyA] = -1;
            _places[rows[list[i]].Def.BodyB] = -1;
        }

        for (int i = 0; i < count; i++)
        {
            ref SpringRow row = ref rows[list[i]];
            ref FreeSpring spring = ref _springs[_springCount++];
            spring.Kind = row.Def.Kind;
            bool armA = row.ArmAX != 0 || row.ArmAY != 0;
            bool armB = row.ArmBX != 0 || row.ArmBY != 0;
            bool hasArms = row.Def.Kind == SpringKind.Linear && (armA || armB);
            spring.HasArms = hasArms ? 1 : 0;
            mesh.Turns |= hasArms;
            mesh.Driven |= row.MovesA < row.ActsA || row.MovesB < row.ActsB;
            spring.A = Place(row.Def.BodyA, row.MovesA, row.ActsA, row.InverseMassA, row.InverseInertiaA);
            spring.B = Place(row.Def.BodyB, row.MovesB, row.ActsB, row.InverseMassB, row.InverseInertiaB);
            _bodies[spring.A].Turns |= hasArms && armA ? row.ActsA : 0;
            _bodies[spring.B].Turns |= hasArms && armB ? row.ActsB : 0;
            spring.OffsetX = row.OffsetX;
            spring.OffsetY = row.OffsetY;
            spring.ArmAX = row.ArmAX;
            spring.ArmAY = row.ArmAY;
            spring.ArmBX = row.ArmBX;
            spring.ArmBY = row.ArmBY;
            spring.Rest = row.Def.Kind == SpringKind.Linear ? row.Def.Rest : 0;
            spring.Stiffness = row.Def.Stiffness;
            spring.Damping = row.Def.Damping;
            spring.MaxTorque = row.Def.MaxTorque;
            spring.TurnA = 0;
            spring.TurnB = 0;
        }

        mesh.BodyCount = _bodyCount - mesh.FirstBody;
        return _meshCount++;
    }

    /// <summary>The kicks of one substep, and the shifts that make its ways those of the springs.</summary>
    /// <returns>False if it would gain energy: nothing is done.</returns>
    public bool Run(int index, BodyStore bodies, double h)
    {
        ref FreeMesh mesh = ref _meshes[index];
        if (!Advance(mesh, mesh.Pace, bodies, h))
        {
            var finer = new FreePace { Scheme = FreeScheme.Six, Parts = Finer * mesh.Pace.Parts, Drag = mesh.Pace.Drag };
            if (!Advance(mesh, finer, bodies, h))
            {
                return false;
            }
        }

        for (int i = mesh.FirstBody; i < mesh.FirstBody + mesh.BodyCount; i++)
        {
            if (_bodies[i].Moves != 0)
            {
                Write(_bodies.Pointer + i, bodies, h);
            }
        }

        return true;
    }

    private bool Advance(in FreeMesh mesh, in FreePace pace, BodyStore bodies, double h)
    {
        for (int i = mesh.FirstBody; i < mesh.FirstBody + mesh.BodyCount; i++)
        {
            Read(_bodies.Pointer + i, bodies, h);
        }

        double before = FreeMeshKernel.Energy(mesh, _bodies.Pointer, _springs.Pointer, out double givenBefore);
        FreeMeshKernel.Advance(mesh, pace, _bodies.Pointer, _springs.Pointer, h);
        double after = FreeMeshKernel.Energy(mesh, _bodies.Pointer, _springs.Pointer, out double given);
        return mesh.Driven || !(after - before > given - givenBefore + (LargestGain * (before + after)));
    }

    /// <summary>Ends that do not move are those of one spring each, so that each mesh moves its own.</summary>
    private int Place(int body, int moves, int acts, double inverseMass, double inverseInertia)
    {
        if (moves != 0 && _places[body] >= 0)
        {
            return _places[body];
        }

        _places[body] = _bodyCount;
        ref FreeBody place = ref _bodies[_bodyCount];
        place.Body = body;
        place.Moves = moves;
        place.Acts = acts;
        place.Turns = 0;
        place.InverseMass = inverseMass;
        place.InverseInertia = inverseInertia;
        return _bodyCount++;
    }

    private static void Read(FreeBody* body, BodyStore bodies, double h)
    {
        EndState end = EndState.Read(bodies, body->Body, body->Moves, body->Acts);
        body->X = end.X;
        body->Y = end.Y;
        body->Turned = end.Turned;
        body->Sin = 0;
        body->Cos = 1;
        body->VX = body->Acts != 0 ? end.VX : 0;
        body->VY = body->Acts != 0 ? end.VY : 0;
        body->W = body->Acts != 0 ? end.W : 0;
        body->LoadX = end.DriveX / h;
        body->LoadY = end.DriveY / h;
        body->LoadW = end.DriveW / h;
        body->ForceX = 0;
        body->ForceY = 0;
        body->Torque = 0;
        FreeMeshKernel.Turn(body);
    }

    private static void Write(FreeBody* body, BodyStore bodies, double h)
    {
        ref BodyState state = ref bodies.State[body->Body];
        ref BodyMotion motion = ref bodies.Motion[body->Body];
        double x = body->VX - state.LinearVelocity.X;
        double y = body->VY - state.LinearVelocity.Y;
        double w = body->W - state.AngularVelocity;

        // The integrator takes half of a steady change back, see Integrator.IntegratePositions; what is pushed is none to it.
        double backX = Smaller((double)state.LinearVelocity.X - motion.StartX, motion.ChangeX) / 2;
        double backY = Smaller((double)state.LinearVelocity.Y - motion.StartY, motion.ChangeY) / 2;
        double backW = Smaller((double)state.AngularVelocity - motion.StartW, motion.ChangeW) / 2;
        double wayX = body->X - state.DeltaPosition.X - (h * (body->VX - backX));
        double wayY = body->Y - state.DeltaPosition.Y - (h * (body->VY - backY));
        double turn = body->Turned - motion.Turned - (h * (body->W - backW));
        EndState.Push(bodies, body->Body, 0, x, y, w);
        EndState.Shift(bodies, body->Body, wayX, wayY, turn);
    }

    private static double Smaller(double a, double b) => Math.Max(Math.Min(a, b), 0) + Math.Min(Math.Max(a, b), 0);
}
