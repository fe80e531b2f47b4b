using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Accuracy;

/// <summary>
/// What impacts gave or took against their law, seen from outside: by the velocities before and after, and the impulses. A blow on one
/// contact takes (1 - e²)/2·m·v² with the mass m that the two bodies have at its point and the speed v of their approach; blows of
/// several contacts with one group of bodies take something between nothing and (1 - e⁴) of the energy there is (each of them may strike
/// twice in a step); none ever gives energy. Friction may take its bound times the fastest that surfaces can pass each other, besides.
/// </summary>
internal sealed unsafe class ImpactLaw
{
    /// <summary>Tangential share of an impulse up to which its arm tells where it acted.</summary>
    private const double Frictionless = 1e-3;

    [NotState(Why.OfOneStep)]
    private readonly Column<Group> _groups = new Column<Group>();
    private readonly BodyStore _bodies;
    private readonly ContactStore _contacts;
    private readonly ConstraintGraph _graph;
    private readonly JointStore _joints;
    private readonly ErrorMeter _meter;
    [NotState(Why.Elsewhere)]
    private EnergyAudit _audit = null!;
    [NotState(Why.OfOneStep)]
    private double _dt;

    public ImpactLaw(BodyStore bodies, ContactStore contacts, ConstraintGraph graph, JointStore joints, ErrorMeter meter)
    {
        _bodies = bodies;
        _contacts = contacts;
        _graph = graph;
        _joints = joints;
        _meter = meter;
    }

    public void Run(ref StepMeasures m, EnergyAudit audit, double dt)
    {
        _audit = audit;
        _dt = dt;
        int end = _bodies.Ids.End;
        _groups.EnsureCapacity(end);
        for (int i = 0; i < end; i++)
        {
            _groups[i] = new Group { Restitution = 1, Contact = -1 };
        }

        if (!FindImpacts())
        {
            return;
        }

        SumBodies(end);
        FindJoints();
        for (int i = 1; i < end; i++)
        {
            if (_groups[i].Impacts > 0 && !_groups[i].Unknown)
            {
                Judge(ref m, i);
            }
        }
    }

    private bool FindImpacts()
    {
        bool any = false;
        for (int i = 0; i < _contacts.End; i++)
        {
            ref ContactRecord record = ref _contacts.Records[i];
            if (record.PieceA < 0 || record.Color < 0 || record.IsDormant)
            {
                continue;
            }

            bool movesA = _audit.Moves(record.BodyA);
            bool movesB = _audit.Moves(record.BodyB);
            ContactBundle* row = _graph.BundleOf(record.Row);
            int lane = RowArena.LaneOf(record.Row);
            double struck = row->Struck[lane];
            bool pressed = row->Point0.Normal[lane] + row->Point1.Normal[lane] > 0;
            if (!(movesA || movesB) || !(struck > 0 || pressed))
            {
                continue;
            }

            ref Group group = ref _groups[_meter.Groups.Of(movesA ? record.BodyA : record.BodyB)];
            group.Unknown |= (!movesA && IsDriven(record.BodyA)) || (!movesB && IsDriven(record.BodyB));
            group.Contacts++;
            if (struck > 0)
            {
                any = true;
                group.Impacts++;
                group.Contact = i;
                group.Restitution = Math.Min(group.Restitution, Math.Abs(row->Restitution[lane]));
                group.Rub += row->Friction[lane] * struck * Passing(record);
            }
            else
            {
                group.Restitution = 0;
            }
        }

        return any;
    }

    /// <summary>At least as fast as any two points of the pair passed each other before.</summary>
    private double Passing(in ContactRecord record)
    {
        VelocityChange a = _audit.StartOf(record.BodyA).Velocity;
        VelocityChange b = _audit.StartOf(record.BodyB).Velocity;
        double x = b.X - a.X;
        double y = b.Y - a.Y;
        return Math.Sqrt((x * x) + (y * y)) + (Math.Abs(a.W) * _meter.Reach(record.PieceA)) + (Math.Abs(b.W) * _meter.Reach(record.PieceB));
    }

    private bool IsDriven(int body)
    {
        ref BodyState state = ref _bodies.State[body];
        return state.LinearVelocity != Vector2.Zero || state.AngularVelocity != 0;
    }

    private void SumBodies(int end)
    {
        for (int i = 1; i < end; i++)
        {
            if (!_audit.Moves(i))
            {
                continue;
            }

            ref Group group = ref _groups[_meter.Groups.Of(i)];
            ref BodyStart start = ref _audit.StartOf(i);
            double mass = _bodies.Mass[i].Mass;
            group.Mass += mass;
            group.Work += _audit.ConstrainedWork(i, out double driven);
            group.Before += start.AfterImpulses;
            group.Driven += driven;
            group.After += _audit.Kinetic(i);
            group.MomentumX += mass * start.Velocity.X;
            group.MomentumY += mass * start.Velocity.Y;
        }
    }

    private void FindJoints()
    {
        const JointFlags Acts = JointFlags.Alive | JointFlags.Enabled;
        for (int i = 0; i < _joints.Ids.End; i++)
        {
            ref JointLink link = ref _joints.Links[i];
            if ((_joints.Flags[i] & Acts) != Acts)
            {
                continue;
            }

            int body = _audit.Moves(link.BodyA) ? link.BodyA : link.BodyB;
            ref Group group = ref _groups[_meter.Groups.Of(body)];
            group.Joints++;
            group.Unknown |= (_joints.Flags[i] & (JointFlags.Motor | JointFlags.Spring)) != 0 || _joints.Settings[i].Softness > 0;
            group.Restitution = (_joints.Flags[i] & JointFlags.Limit) != 0 ? 0 : group.Restitution;
        }
    }

    private void Judge(ref StepMeasures m, int root)
    {
        ref Group group = ref _groups[root];
        double least = 0;
        double most;
        if (group.Contacts == 1 && group.Joints == 0 && FindLoss(group.Contact, out double first, out double second))
        {
            double share = (1 - (group.Restitution * group.Restitution)) / 2;
            least = share * Math.Min(first, second);
            most = share * Math.Max(first, second);
        }
        else
        {
            double free = _meter.Groups.IsHeld(root) || !(group.Mass > 0) ? 0
                : ((group.MomentumX * group.MomentumX) + (group.MomentumY * group.MomentumY)) / (2 * group.Mass);
            double e2 = group.Restitution * group.Restitution;
            most = (1 - (e2 * e2)) * Math.Max(0, group.Before + Math.Max(0, group.Driven) - free);
        }

        most += group.Rub;
        double lost = -group.Work;
        double gained = lost < least ? least - lost : lost > most ? most - lost : 0;
        if (Math.Abs(gained) > Math.Abs(m.ImpactEnergyError))
        {
            m.ImpactEnergyError = gained;
        }

        // As a length: how far off the speed that the energy is wrong by takes the group in a step.
        double lawful = Math.Max(0, group.After - gained);
        double length = _dt * Math.Abs(Math.Sqrt(2 * group.After / group.Mass) - Math.Sqrt(2 * lawful / group.Mass));
        ref ContactRecord record = ref _contacts.Records[group.Contact];
        m.LargestImpactError = Math.Max(m.LargestImpactError, length);
        ErrorMeter.Judge(ref m, ErrorCause.Impact, length, 0, _meter.SizeOf(record), record.BodyA, record.BodyB);
    }

    /// <summary>
    /// m·v² of a blow on one contact, with the velocities from before gravity and forces acted and with those after: when in between it
    /// struck, nobody knows. Its arms are those at which its impulse really acted.
    /// </summary>
    /// <returns>False if friction had a share in it that hides them, or there is no impulse.</returns>
    private bool FindLoss(int contact, out double first, out double second)
    {
        first = 0;
        second = 0;
        ref ContactRecord record = ref _contacts.Records[contact];
        int lane = RowArena.LaneOf(record.Row);
        ContactBundle* row = _graph.BundleOf(record.Row);
        double nx = row->NormalX[lane];
        double ny = row->NormalY[lane];
        double response = 0;
        double speed = 0;
        double later = 0;
        for (int side = 0; side < 2; side++)
        {
            int body = side == 0 ? record.BodyA : record.BodyB;
            double sign = side == 0 ? -1 : 1;
            if (!_audit.Moves(body))
            {
                continue;
            }

            ref BodyMass mass = ref _bodies.Mass[body];
            VelocityChange before = _audit.StartOf(body).Velocity;
            VelocityChange drive = _audit.DriveOf(body, _dt);
            ref BodyState state = ref _bodies.State[body];
            double px = mass.Mass * (state.LinearVelocity.X - before.X - drive.X);
            double py = mass.Mass * (state.LinearVelocity.Y - before.Y - drive.Y);
            double push = sign * ((nx * px) + (ny * py));
            if (!(push > 0) || Math.Abs((ny * px) - (nx * py)) > Frictionless * push)
            {
                return false;
            }

            double arm = 0;
            if (mass.InverseInertia > 0)
            {
                arm = mass.Inertia * (state.AngularVelocity - before.W - drive.W) / push;
                response += mass.InverseInertia * arm * arm;
            }

            response += mass.InverseMass;
            speed += (sign * ((nx * before.X) + (ny * before.Y))) + (before.W * arm);
            later += (sign * ((nx * drive.X) + (ny * drive.Y))) + (drive.W * arm);
        }

        double end = Math.Min(0, speed + later);
        speed = Math.Min(0, speed);
        first = response > 0 ? speed * speed / response : 0;
        second = response > 0 ? end * end / response : 0;
        return response > 0;
    }

    /// <summary>Bodies that contacts and joints connect, under the one that stands for them.</summary>
    private struct Group
    {
        public int Contacts;
        public int Impacts;
        public int Joints;

        /// <summary>Of the last blow.</summary>
        public int Contact;

        /// <summary>Something besides drives or takes energy, nobody knows how much.</summary>
        public bool Unknown;

        /// <summary>The least of what pushed.</summary>
        public double Restitution;
        public double Rub;
        public double Work;
        public double Before;
        public double Driven;
        public double After;
        public double Mass;
        public double MomentumX;
        public double MomentumY;
    }
}
