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

    private readonly Column<Start> _start = new Column<Start>();
    private readonly Column<Change> _last = new Column<Change>();
    private readonly Column<Change> _before = new Column<Change>();
    private readonly Column<Change> _booked = new Column<Change>();
    private readonly Column<Change> _inner = new Column<Change>();
    private readonly double[] _work = new double[Parts];
    private BodyStore _bodies = null!;
    private JointSolver? _joints;
    private Vector2 _gravity;
    private int* _list;
    private int _count;
    private double _substep;
    private double _dragWork;
    private double _motorWork;
    private double _supportX;
    private double _supportY;

    /// <summary>Keeps where all bodies are and how they move before anything of the step acts.</summary>
    public void BeginStep(BodyStore bodies)
    {
        _bodies = bodies;
        int end = bodies.Ids.End;
        _start.EnsureCapacity(end);
        _before.EnsureCapacity(end);
        _inner.EnsureCapacity(end);
        for (int i = 0; i < end; i++)
        {
            ref Start s = ref _start[i];
            s.X = bodies.Pose[i].X;
            s.Y = bodies.Pose[i].Y;
            s.Angle = bodies.Pose[i].Angle;
            s.Energy = Kinetic(i);
            s.Force = default;
            s.Solved = 0;
            s.Struck = 0;
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
            _start[i].Force = _bodies.Force[i];
        }
    }

    /// <summary>Before the substeps of a list of bodies with constraints; a step may have several, which share no body that moves.</summary>
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
            Change v = Velocity(_list[i]);
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
            Change now = Velocity(_list[i]);
            ref Change booked = ref _booked[(i * Parts) + (int)part];
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
            if (!Moves(body))
            {
                continue;
            }

            ref BodyMass mass = ref _bodies.Mass[body];
            Change now = Velocity(body);
            Change mean = _before[body];
            mean.X = (mean.X + now.X) / 2;
            mean.Y = (mean.Y + now.Y) / 2;
            mean.W = (mean.W + now.W) / 2;
            for (int k = 0; k < Parts; k++)
            {
                Change c = _booked[(i * Parts) + k];
                _work[k] += Work(mass, c, mean);
                if (k == (int)SolverPart.Contacts || k == (int)SolverPart.Joints || k == (int)SolverPart.Impacts)
                {
                    _inner[body].X += mass.Mass * c.X;
                    _inner[body].Y += mass.Mass * c.Y;
                    _supportX += mass.Mass * c.X;
                    _supportY += mass.Mass * c.Y;
                }
            }

            Change drag = _booked[(i * Parts) + (int)SolverPart.Drive];
            Change driven = Driven(body);
            drag.X -= driven.X;
            drag.Y -= driven.Y;
            drag.W -= driven.W;
            _dragWork += IsDragged(body) ? Work(mass, drag, mean) : 0;
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
        ref Start s = ref _start[body];
        s.Struck = 1;
        s.Dragged = Kinetic(body) - s.AfterImpulses - GravityWork(body, s) - ForceWork(body, s);
    }

    /// <summary>Sums up, at the poses that the step ended with.</summary>
    public void EndStep(ref StepMeasures m, BodyGroups groups)
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
            ref Start s = ref _start[i];
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
        m.MomentumError = Unbalanced(groups);
    }

    private double GravityWork(int body, in Start s)
    {
        double dx = _bodies.Pose[body].X - s.X;
        double dy = _bodies.Pose[body].Y - s.Y;
        bool pulled = (_bodies.Flags[body] & BodyFlags.IgnoreGravity) == 0;
        return pulled ? _bodies.Mass[body].Mass * ((_gravity.X * dx) + (_gravity.Y * dy)) : 0;
    }

    private double ForceWork(int body, in Start s)
    {
        double dx = _bodies.Pose[body].X - s.X;
        double dy = _bodies.Pose[body].Y - s.Y;
        return (s.Force.Force.X * dx) + (s.Force.Force.Y * dy) + (s.Force.Torque * (_bodies.Pose[body].Angle - s.Angle));
    }

    private double Unbalanced(BodyGroups groups)
    {
        int end = Math.Min(_bodies.Ids.End, _start.Capacity);
        for (int i = 1; i < end; i++)
        {
            int root = groups.Of(i);
            if (root != i)
            {
                _inner[root].X += _inner[i].X;
                _inner[root].Y += _inner[i].Y;
            }
        }

        double worst = 0;
        for (int i = 1; i < end; i++)
        {
            if (groups.Of(i) == i && Moves(i) && !groups.IsHeld(i))
            {
                Change c = _inner[i];
                worst = Math.Max(worst, Math.Sqrt((c.X * c.X) + (c.Y * c.Y)));
            }
        }

        return worst;
    }

    private static double Work(in BodyMass mass, in Change change, in Change mean) =>
        (mass.Mass * ((change.X * mean.X) + (change.Y * mean.Y))) + (mass.InverseInertia > 0 ? mass.Inertia * change.W * mean.W : 0);

    private bool Moves(int body)
    {
        const BodyFlags Here = BodyFlags.Alive | BodyFlags.Enabled;
        return (_bodies.Flags[body] & Here) == Here && _bodies.Mass[body].InverseMass > 0;
    }

    private bool IsDragged(int body)
    {
        ref BodyDrag drag = ref _bodies.Drag[body];
        return drag.Linear != 0 || drag.Rotational != 0 || (drag.Quadratic != 0 && (_bodies.Flags[body] & BodyFlags.QuadraticDrag) != 0);
    }

    /// <summary>Velocity change of a substep by gravity and forces alone.</summary>
    private Change Driven(int body)
    {
        ref BodyMass mass = ref _bodies.Mass[body];
        bool pulled = (_bodies.Flags[body] & BodyFlags.IgnoreGravity) == 0;
        Change change;
        change.X = ((pulled ? _gravity.X : 0.0) + ((double)_start[body].Force.Force.X * mass.InverseMass)) * _substep;
        change.Y = ((pulled ? _gravity.Y : 0.0) + ((double)_start[body].Force.Force.Y * mass.InverseMass)) * _substep;
        change.W = (double)_start[body].Force.Torque * mass.InverseInertia * _substep;
        return change;
    }

    private Change Velocity(int body)
    {
        ref BodyState state = ref _bodies.State[body];
        Change v;
        v.X = state.LinearVelocity.X;
        v.Y = state.LinearVelocity.Y;
        v.W = state.AngularVelocity;
        return v;
    }

    private double Kinetic(int body)
    {
        if (!Moves(body))
        {
            return 0;
        }

        Change v = Velocity(body);
        return Work(_bodies.Mass[body], v, v) / 2;
    }

    private struct Start
    {
        public double X;
        public double Y;
        public double Angle;
        public double Energy;
        public double AfterImpulses;
        public BodyForce Force;

        /// <summary>Energy that drag gave it in its flight, if it has been struck outside the solver since.</summary>
        public double Dragged;

        /// <summary>1 for such a body.</summary>
        public int Struck;

        /// <summary>1 for a body that went through substeps.</summary>
        public int Solved;
    }

    /// <summary>A velocity or a change of it.</summary>
    private struct Change
    {
        public double X;
        public double Y;
        public double W;
    }
}
