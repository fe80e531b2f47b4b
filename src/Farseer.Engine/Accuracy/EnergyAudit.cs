using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Solver;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Accuracy;

/// <summary>
/// Accounts for the energy of a step. Impulses p that act on a body in a substep change its energy by p·(v₀ + v₁)/2 each, with the
/// velocities v₀ and v₁ at the substep's ends: the shares of all causes add up to the change exactly, and a body at rest is worked on
/// by none of them. Gravity and forces are counted by the way that the body really went; what is missing between both is energy
/// that came from moving bodies without speed.
/// </summary>
internal sealed unsafe class EnergyAudit : ISolverAudit
{
    private const int Parts = (int)SolverPart.Count;

    private readonly Column<BodyStart> _start = new Column<BodyStart>();
    private readonly Column<VelocityChange> _last = new Column<VelocityChange>();
    private readonly Column<VelocityChange> _before = new Column<VelocityChange>();
    private readonly Column<VelocityChange> _booked = new Column<VelocityChange>();
    private readonly Column<VelocityChange> _inner = new Column<VelocityChange>();
    private readonly double[] _work = new double[Parts];
    [NotState(Why.Elsewhere)]
    private BodyStore _bodies = null!;
    [NotState(Why.Elsewhere)]
    private JointSolver? _joints;
    private Vector2 _gravity;
    private int* _list;
    private int _count;
    private double _substep;
    private double _dragWork;
    private double _motorWork;
    private double _supportX;
    private double _supportY;

    /// <summary>Follows the ways of the bodies.</summary>
    public MotionMeter Motion { get; } = new MotionMeter();

    /// <summary>A body as the step found it.</summary>
    public ref BodyStart StartOf(int body) => ref _start[body];

    /// <summary>Keeps where all bodies are and how they move before anything of the step acts.</summary>
    public void BeginStep(BodyStore bodies)
    {
        _bodies = bodies;
        int end = bodies.Ids.End;
        _start.EnsureCapacity(end);
        _before.EnsureCapacity(end);
        _inner.EnsureCapacity(end);
        Motion.BeginStep(end);
        for (int i = 0; i < end; i++)
        {
            ref BodyStart s = ref _start[i];
            s.X = bodies.Pose[i].X;
            s.Y = bodies.Pose[i].Y;
            s.Angle = bodies.Pose[i].Angle;
            s.Energy = Kinetic(i);
            s.Force = default;
            s.Solved = 0;
            s.Struck = 0;
            s.Aside = 0;
            _inner[i] = default;
        }

        Array.Clear(_work, 0, Parts);
        _dragWork = 0;
        _motorWork = 0;
        _supportX = 0;
        _supportY = 0;
        _count = 0;
    }

    /// <summary>After the forces were gathered and stored impulses have acted, before anything moves.</summary>
    public void BeginMotion(Vector2 gravity)
    {
        _gravity = gravity;
        int end = Math.Min(_bodies.Ids.End, _start.Capacity);
        for (int i = 0; i < end; i++)
        {
            _start[i].AfterImpulses = Kinetic(i);
            _start[i].Velocity = Velocity(i);
            _start[i].Force = _bodies.Force[i];
        }
    }

    /// <summary>
    /// Before the substeps of a list of bodies with constraints; a step may have several, which share no body that moves.
    /// </summary>
    public void BeginSolve(int* list, int count, double substep, JointSolver? joints)
    {
        _list = list;
        _count = count;
        _substep = substep;
        _joints = joints;
        _last.EnsureCapacity(Math.Max(1, count));
        _booked.EnsureCapacity(Math.Max(1, count * Parts));
        for (int i = 0; i < count; i++)
        {
            _start[list[i]].Solved = 1;
        }
    }

    public void BeginSubstep()
    {
        for (int i = 0; i < _count; i++)
        {
            VelocityChange v = Velocity(_list[i]);
            _last[i] = v;
            _before[_list[i]] = v;
            for (int k = 0; k < Parts; k++)
            {
                _booked[(i * Parts) + k] = default;
            }
        }
    }

    public void Book(SolverPart part)
    {
        for (int i = 0; i < _count; i++)
        {
            VelocityChange now = Velocity(_list[i]);
            ref VelocityChange booked = ref _booked[(i * Parts) + (int)part];
            booked.X += now.X - _last[i].X;
            booked.Y += now.Y - _last[i].Y;
            booked.W += now.W - _last[i].W;
            _last[i] = now;
        }
    }

    public void EndSubstep()
    {
        for (int i = 0; i < _count; i++)
        {
            int body = _list[i];
            if (!Moves(body) || !StateRange.Holds(_bodies.State[body]))
            {
                // A body that is about to be taken out: what was done to it is nobody's work.
                continue;
            }

            ref BodyMass mass = ref _bodies.Mass[body];
            VelocityChange now = Velocity(body);
            VelocityChange driven = Driven(body);
            Motion.Follow(body, _before[body], now, driven, _substep, Radius(mass));
            VelocityChange mean = _before[body];
            mean.X = (mean.X + now.X) / 2;
            mean.Y = (mean.Y + now.Y) / 2;
            mean.W = (mean.W + now.W) / 2;
            for (int k = 0; k < Parts; k++)
            {
                VelocityChange c = _booked[(i * Parts) + k];
                double work = Work(mass, c, mean);
                _work[k] += work;
                _start[body].Aside += k == (int)SolverPart.Springs || k == (int)SolverPart.UserJoints ? work : 0;
                if (k == (int)SolverPart.Contacts || k == (int)SolverPart.Joints || k == (int)SolverPart.Impacts)
                {
                    _inner[body].X += mass.Mass * c.X;
                    _inner[body].Y += mass.Mass * c.Y;
                    _supportX += mass.Mass * c.X;
                    _supportY += mass.Mass * c.Y;
                }
            }

            VelocityChange drag = _booked[(i * Parts) + (int)SolverPart.Drive];
            drag.X -= driven.X;
            drag.Y -= driven.Y;
            drag.W -= driven.W;
            double dragged = IsDragged(body) ? Work(mass, drag, mean) : 0;
            _dragWork += dragged;
            _start[body].Aside += dragged;
        }

        if (_joints != null)
        {
            _motorWork += _joints.MotorWork((double*)_before.Pointer);
        }
    }

    /// <summary>
    /// Before a body that flew free is followed through impacts: what drag took of its energy is known now, and what is missing
    /// besides in the end was the impacts'.
    /// </summary>
    public void BeginImpacts(int body)
    {
        ref BodyStart s = ref _start[body];
        s.Struck = 1;
        s.Dragged = Kinetic(body) - s.AfterImpulses - GravityWork(body, s) - ForceWork(body, s);
    }

    /// <summary>Sums up, at the poses that the step ended with.</summary>
    /// <param name="m">Receives energies and momenta.</param>
    /// <param name="groups">What is connected.</param>
    /// <param name="dt">Length of the step.</param>
    public void EndStep(ref StepMeasures m, BodyGroups groups, double dt)
    {
        double flown = 0;
        double struck = 0;
        int end = Math.Min(_bodies.Ids.End, _start.Capacity);
        for (int i = 1; i < end; i++)
        {
            if (!Moves(i))
            {
                continue;
            }

            ref BodyMass mass = ref _bodies.Mass[i];
            ref BodyStart s = ref _start[i];
            double kinetic = Kinetic(i);
            double gravity = GravityWork(i, s);
            double force = ForceWork(i, s);
            m.Kinetic += kinetic;
            m.KineticChange += kinetic - s.Energy;
            m.GravityWork += gravity;
            m.ForceWork += force;
            m.ImpulseWork += s.AfterImpulses - s.Energy;
            m.MomentumX += (double)mass.Mass * _bodies.State[i].LinearVelocity.X;
            m.MomentumY += (double)mass.Mass * _bodies.State[i].LinearVelocity.Y;

            // Bodies of the solver have their drag booked already.
            double rest = kinetic - s.AfterImpulses - gravity - force;
            struck += s.Struck != 0 ? rest - s.Dragged : 0;
            flown += s.Solved == 0 && IsDragged(i) ? (s.Struck != 0 ? s.Dragged : rest) : 0;
        }

        m.DragWork = _dragWork + flown;
        m.SpringWork = _work[(int)SolverPart.Springs];
        m.MotorWork = _motorWork;
        m.JointWork = _work[(int)SolverPart.Joints] - _motorWork;
        m.UserJointWork = _work[(int)SolverPart.UserJoints];
        m.ContactWork = _work[(int)SolverPart.Contacts] + struck;
        m.BounceWork = _work[(int)SolverPart.Impacts];
        m.SupportX = _supportX;
        m.SupportY = _supportY;
        FindUnbalanced(ref m, groups, dt);
    }

    /// <summary>
    /// What contacts, impacts and joints gave a body: all that is left of its energy when gravity and forces are counted by its way. By the
    /// substeps' kicks a ball would seem to gain, in the one in which it bounces, what gravity does there.
    /// </summary>
    /// <param name="body">A body that moves.</param>
    /// <param name="driven">What gravity and forces gave it.</param>
    public double ConstrainedWork(int body, out double driven)
    {
        ref BodyStart s = ref _start[body];
        driven = GravityWork(body, s) + ForceWork(body, s);
        return Kinetic(body) - s.AfterImpulses - driven - (s.Struck != 0 ? s.Dragged : s.Aside);
    }

    private double GravityWork(int body, in BodyStart s)
    {
        double dx = _bodies.Pose[body].X - s.X;
        double dy = _bodies.Pose[body].Y - s.Y;
        bool pulled = (_bodies.Flags[body] & BodyFlags.IgnoreGravity) == 0;
        return pulled ? _bodies.Mass[body].Mass * ((_gravity.X * dx) + (_gravity.Y * dy)) : 0;
    }

    private double ForceWork(int body, in BodyStart s)
    {
        double dx = _bodies.Pose[body].X - s.X;
        double dy = _bodies.Pose[body].Y - s.Y;
        return (s.Force.Force.X * dx) + (s.Force.Force.Y * dy) + (s.Force.Torque * (_bodies.Pose[body].Angle - s.Angle));
    }

    private void FindUnbalanced(ref StepMeasures m, BodyGroups groups, double dt)
    {
        int end = Math.Min(_bodies.Ids.End, _start.Capacity);
        for (int i = 1; i < end; i++)
        {
            int root = groups.Of(i);
            _inner[i].W = 0;
            if (root != i)
            {
                _inner[root].X += _inner[i].X;
                _inner[root].Y += _inner[i].Y;
            }
        }

        // The masses of the groups, where the turns are of no use any more.
        for (int i = 1; i < end; i++)
        {
            _inner[groups.Of(i)].W += Moves(i) ? _bodies.Mass[i].Mass : 0;
        }

        for (int i = 1; i < end; i++)
        {
            if (groups.Of(i) == i && Moves(i) && !groups.IsHeld(i))
            {
                VelocityChange c = _inner[i];
                double missing = Math.Sqrt((c.X * c.X) + (c.Y * c.Y));
                m.MomentumError = Math.Max(m.MomentumError, missing);
                ErrorMeter.Judge(ref m, ErrorCause.Momentum, dt * missing / c.W, 0, 0, i, -1);
            }
        }
    }

    private static double Work(in BodyMass mass, in VelocityChange change, in VelocityChange mean) =>
        (mass.Mass * ((change.X * mean.X) + (change.Y * mean.Y))) + (mass.InverseInertia > 0 ? mass.Inertia * change.W * mean.W : 0);

    /// <summary>Radius of gyration: what a turn moves the matter of a body by, for each radian.</summary>
    public static double Radius(in BodyMass mass) =>
        mass.InverseInertia > 0 && mass.Mass > 0 ? Math.Sqrt((double)mass.Inertia / mass.Mass) : 0;

    public bool Moves(int body)
    {
        const BodyFlags Here = BodyFlags.Alive | BodyFlags.Enabled;
        return (_bodies.Flags[body] & (Here | BodyFlags.Quarantined)) == Here && _bodies.Mass[body].InverseMass > 0;
    }

    private bool IsDragged(int body)
    {
        ref BodyDrag drag = ref _bodies.Drag[body];
        return drag.Linear != 0 || drag.Rotational != 0 || (drag.Quadratic != 0 && (_bodies.Flags[body] & BodyFlags.QuadraticDrag) != 0);
    }

    private VelocityChange Driven(int body) => DriveOf(body, _substep);

    /// <summary>Velocity change by gravity and forces alone.</summary>
    public VelocityChange DriveOf(int body, double seconds)
    {
        ref BodyMass mass = ref _bodies.Mass[body];
        bool pulled = (_bodies.Flags[body] & BodyFlags.IgnoreGravity) == 0;
        VelocityChange change;
        change.X = ((pulled ? _gravity.X : 0.0) + ((double)_start[body].Force.Force.X * mass.InverseMass)) * seconds;
        change.Y = ((pulled ? _gravity.Y : 0.0) + ((double)_start[body].Force.Force.Y * mass.InverseMass)) * seconds;
        change.W = (double)_start[body].Force.Torque * mass.InverseInertia * seconds;
        return change;
    }

    private VelocityChange Velocity(int body)
    {
        ref BodyState state = ref _bodies.State[body];
        VelocityChange v;
        v.X = state.LinearVelocity.X;
        v.Y = state.LinearVelocity.Y;
        v.W = state.AngularVelocity;
        return v;
    }

    public double Kinetic(int body)
    {
        if (!Moves(body))
        {
            return 0;
        }

        VelocityChange v = Velocity(body);
        return Work(_bodies.Mass[body], v, v) / 2;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_start);
        s.Column(_last);
        s.Column(_before);
        s.Column(_booked);
        s.Column(_inner);
        s.Array(_work);
        s.Value(ref _gravity);
        s.Value(ref _count);
        s.Value(ref _substep);
        s.Value(ref _dragWork);
        s.Value(ref _motorWork);
        s.Value(ref _supportX);
        s.Value(ref _supportY);
        Motion.Visit(s);
    }
}
