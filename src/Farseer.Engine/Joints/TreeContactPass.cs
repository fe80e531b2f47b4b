using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <summary>
/// The passes of <see cref="ContactKernel"/> over contacts with trees, one at a time, in double, against the trees' inverse mass.
/// What differs beyond that: the arms of a substep's poses serve velocities and impulses alike, since responses are found anew in each
/// substep anyway.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe partial class TreeContactPass
{
    private const double DeterminantShare = 1e-3;

    /// <summary>Static sags up to which a contact is as deep as its load makes it.</summary>
    private const double OrdinarySags = 3;

    /// <summary>Share of its bodies' own response below which a contact within a tree counts as bound by the tree's joints.</summary>
    private const double Bound = 0.25;

    private BodyStore _bodies = null!;
    private JointForestView _view;
    private ContactCoefficients _c;
    private double _slowness = 1;

    /// <summary>The largest change of a speed that the normals of the contact solved last made, m/s.</summary>
    public double Changed { get; set; }

    /// <summary>What gravity brings in a substep, m/s.</summary>
    public double Fall => (double)_c.Gravity * _c.Substep;

    /// <param name="view">The trees.</param>
    /// <param name="bodies">The bodies.</param>
    /// <param name="coefficients">Those of the class's substep.</param>
    /// <param name="fineness">How many of its substeps make one of the step's.</param>
    public void Enter(in JointForestView view, BodyStore bodies, in ContactCoefficients coefficients, double fineness)
    {
        _slowness = 1 / fineness;
        _view = view;
        _bodies = bodies;
        _c = coefficients;
    }

    /// <summary>Separations, arms and responses at the present poses.</summary>
    public void Prepare(TreeContact* contact)
    {
        if (contact->Ends.Coupled)
        {
            TreeCross.Write(_view.Nodes, contact->Ends.NodeA, contact->Ends.NodeB, contact->Ends.Cross);
        }

        PlacePoints(contact);
        double* n0A = stackalloc double[3];
        double* n0B = stackalloc double[3];
        double* n1A = stackalloc double[3];
        double* n1B = stackalloc double[3];
        TreeNode* nodes = _view.Nodes;
        RowEnds* ends = &contact->Ends;
        double dead = ends->Coupled ? RowEnds.DeadWithin : RowEnds.Dead;
        NormalRow(contact, &contact->Point0, n0A, n0B);
        contact->K11 = WithinReach(contact, &contact->Point0, RowEnds.Response(nodes, ends, n0A, n0B, dead), n0A, n0B);
        contact->K22 = contact->K11;
        contact->K12 = 0;
        contact->InverseDeterminant = 0;
        contact->RubCoupling = 0;
        if (contact->Points > 1)
        {
            NormalRow(contact, &contact->Point1, n1A, n1B);
            contact->K22 = WithinReach(contact, &contact->Point1, RowEnds.Response(nodes, ends, n1A, n1B, dead), n1A, n1B);
            contact->K12 = RowEnds.Response(nodes, ends, n0A, n0B, n1A, n1B);
            double product = contact->K11 * contact->K22;
            double determinant = product - (contact->K12 * contact->K12);
            contact->InverseDeterminant = determinant > DeterminantShare * product ? 1 / determinant : 0;
        }

        TangentRow(contact, &contact->Point0, n0A, n0B);
        contact->Point0.RubResponse = RowEnds.Response(nodes, ends, n0A, n0B, dead);
        if (contact->Points > 1)
        {
            TangentRow(contact, &contact->Point1, n1A, n1B);
            contact->Point1.RubResponse = RowEnds.Response(nodes, ends, n1A, n1B, dead);
            contact->RubCoupling = RowEnds.Response(nodes, ends, n0A, n0B, n1A, n1B);
        }
    }

    public void SolveBiased(TreeContact* contact)
    {
        RowEnds.Visit(_view, &contact->Ends);
        Speeds(contact, out double v0, out double v1);
        TreeContactPoint* p0 = &contact->Point0;
        TreeContactPoint* p1 = &contact->Point1;
        double load0 = p0->Normal * contact->K11;
        double load1 = p1->Normal * contact->K22;
        double load = contact->Points == 1 ? load0 : Math.Min(load0, load1);
        double r0 = Residual(contact, p0, contact->K11, v0, load);
        double r1 = contact->Points == 1 ? 0 : Residual(contact, p1, contact->K22, v1, load);
        SolveBlock(contact, r0, r1, out double x0, out double x1);
        Change(contact, x0, x1);
    }

    public void Relax(TreeContact* contact, bool rub)
    {
        RowEnds.Visit(_view, &contact->Ends);
        Speeds(contact, out double v0, out double v1);
        TreeContactPoint* p0 = &contact->Point0;
        TreeContactPoint* p1 = &contact->Point1;
        double gap0 = p0->Separation - p0->Rest;
        double gap1 = p1->Separation - p1->Rest;
        if (contact->Points > 1 && Math.Abs(gap0 - gap1) <= p0->Rest)
        {
            gap0 = 0.5 * (gap0 + gap1);
            gap1 = gap0;
        }

        double r0 = v0 + (Math.Max(gap0, 0) * _c.InverseSubstep);
        double r1 = v1 + (Math.Max(gap1, 0) * _c.InverseSubstep);
        SolveBlock(contact, r0, r1, out double x0, out double x1);
        Change(contact, x0, x1);
        if (rub)
        {
            Rub(contact, x0, x1);
        }

        LoadsOf(contact, x0, x1, gap0, gap1, out double load0, out double load1);
        p0->Feed = Math.Min(x0, p0->Feed + (contact->FeedRate * ((contact->FeedShare * load0) - p0->Feed)));
        p1->Feed = Math.Min(x1, p1->Feed + (contact->FeedRate * ((contact->FeedShare * load1) - p1->Feed)));
    }

    /// <summary>
    /// The loads that are fed forward. Between bodies that both move it is what both points bear: with each point's own, piles creep. Where
    /// joints hold a body askew its points never bear alike, and what is not fed sags ten to a thousand times as deep: a limb lay
    /// 1.4 mm in the floor. So on what cannot move each point has its own load; and within a tree a point that bears alone, the other
    /// being off the surface, has all of it.
    /// </summary>
    private void LoadsOf(TreeContact* contact, double x0, double x1, double gap0, double gap1, out double load0, out double load1)
    {
        load0 = x0;
        load1 = x1;
        RowEnds* ends = &contact->Ends;
        if (contact->Points > 1 && !IsFixed(ends->NodeA, ends->BodyA) && !IsFixed(ends->NodeB, ends->BodyB))
        {
            bool alone = ends->Coupled && ((x0 <= 0 && gap0 > 0) || (x1 <= 0 && gap1 > 0));
            load0 = alone ? Math.Max(x0, x1) : Math.Min(x0, x1);
            load1 = load0;
        }
    }

    private bool IsFixed(int node, int body) => node < 0 && _bodies.Mass[body].InverseMass == 0;

    /// <summary>In the position correction: surfaces that press on each other stay as they are, as long as they press at all.</summary>
    public void Hold(TreeContact* contact)
    {
        bool press0 = contact->Point0.Normal > 0;
        bool press1 = contact->Points > 1 && contact->Point1.Normal > 0;
        if (!press0 && !press1)
        {
            return;
        }

        RowEnds.Visit(_view, &contact->Ends);
        Speeds(contact, out double v0, out double v1);
        double x0 = contact->Point0.Normal;
        double x1 = contact->Point1.Normal;
        if (press0 && press1)
        {
            SolveBlock(contact, v0, v1, out x0, out x1);
        }
        else if (press0)
        {
            x0 = Math.Max(0, x0 - (v0 / contact->K11));
        }
        else
        {
            x1 = Math.Max(0, x1 - (v1 / contact->K22));
        }

        Change(contact, x0, x1);
    }

    /// <summary>Moves the surfaces of a deep contact apart by velocities that move the bodies and are then forgotten.</summary>
    public void PushOut(TreeContact* contact, double rate)
    {
        if (!contact->Deep)
        {
            return;
        }

        RowEnds.Visit(_view, &contact->Ends);
        Speeds(contact, out double v0, out double v1);
        double x0 = Push(contact->Point0, v0, contact->K11, rate);
        double x1 = contact->Points > 1 ? Push(contact->Point1, v1 + (contact->K12 * x0), contact->K22, rate) : 0;
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        Normals(contact, x0, x1, a, b);
        RowEnds.Apply(_view, &contact->Ends, a, b);
    }

    private double Push(in TreeContactPoint point, double v, double k, double rate)
    {
        double depth = point.Rest - point.Separation;
        return depth > 0 ? Math.Max(0, ((depth * rate) - v) / k) : 0;
    }

    /// <summary>Separations and arms at the present poses.</summary>
    private void PlacePoints(TreeContact* contact)
    {
        Place(contact->Ends.NodeA, contact->Ends.BodyA, out double ax, out double ay, out double aCos, out double aSin);
        Place(contact->Ends.NodeB, contact->Ends.BodyB, out double bx, out double by, out double bCos, out double bSin);
        double moved = (contact->NormalX * (bx - ax)) + (contact->NormalY * (by - ay));
        Place(contact, &contact->Point0, moved, aCos, aSin, bCos, bSin);
        if (contact->Points > 1)
        {
            Place(contact, &contact->Point1, moved, aCos, aSin, bCos, bSin);
        }
    }

    private void Place(int node, int body, out double x, out double y, out double cos, out double sin)
    {
        if (node >= 0)
        {
            TreeNode* n = _view.Nodes + node;
            x = n->Move[0];
            y = n->Move[1];
            cos = n->TurnCos;
            sin = n->TurnSin;
            return;
        }

        ref BodyState state = ref _bodies.State[body];
        x = state.DeltaPosition.X;
        y = state.DeltaPosition.Y;
        cos = state.DeltaCos;
        sin = state.DeltaSin;
    }

    private static void Place(TreeContact* contact, TreeContactPoint* p, double moved, double aCos, double aSin, double bCos, double bSin)
    {
        double turnedA = (aCos * p->NormalArmA) + (aSin * p->TangentArmA);
        double turnedB = (bCos * p->NormalArmB) + (bSin * p->TangentArmB);
        p->Separation = p->Base + moved + (turnedB - turnedA);
        p->NormalA = (aCos * p->TangentArmA) - (aSin * p->NormalArmA);
        p->NormalB = (bCos * p->TangentArmB) - (bSin * p->NormalArmB);
        p->RubA = turnedA + contact->RadiusA;
        p->RubB = turnedB - contact->RadiusB;
    }

    // n·(vB - vA) + wB·atB - wA·atA.
    private static void NormalRow(TreeContact* contact, TreeContactPoint* p, double* a, double* b)
    {
        a[0] = -contact->NormalX;
        a[1] = -contact->NormalY;
        a[2] = -p->NormalA;
        b[0] = contact->NormalX;
        b[1] = contact->NormalY;
        b[2] = p->NormalB;
    }

    // t·(vB - vA) - wB·anB + wA·anA with t = (ny, -nx).
    private static void TangentRow(TreeContact* contact, TreeContactPoint* p, double* a, double* b)
    {
        a[0] = -contact->NormalY;
        a[1] = contact->NormalX;
        a[2] = p->RubA;
        b[0] = contact->NormalY;
        b[1] = -contact->NormalX;
        b[2] = -p->RubB;
    }

    private static void Normals(TreeContact* contact, double p0, double p1, double* a, double* b)
    {
        double sum = p0 + p1;
        b[0] = contact->NormalX * sum;
        b[1] = contact->NormalY * sum;
        b[2] = (contact->Point0.NormalB * p0) + (contact->Point1.NormalB * p1);
        a[0] = -b[0];
        a[1] = -b[1];
        a[2] = -((contact->Point0.NormalA * p0) + (contact->Point1.NormalA * p1));
    }

    private static void Tangents(TreeContact* contact, double p0, double p1, double* a, double* b)
    {
        double sum = p0 + p1;
        b[0] = contact->NormalY * sum;
        b[1] = -contact->NormalX * sum;
        b[2] = -((contact->Point0.RubB * p0) + (contact->Point1.RubB * p1));
        a[0] = -b[0];
        a[1] = -b[1];
        a[2] = (contact->Point0.RubA * p0) + (contact->Point1.RubA * p1);
    }

    /// <summary>What the biased pass brings to 0: see <see cref="ContactKernel.SolveBiased"/>.</summary>
    private double Residual(TreeContact* contact, TreeContactPoint* p, double k, double v, double load)
    {
        double gap = p->Separation - p->Rest;
        if (contact->Deep)
        {
            return v + (Math.Max(gap, 0) * _c.InverseSubstep);
        }

        double sink = _c.SettleShare * load;
        if (gap > 0)
        {
            return v + (gap * _c.InverseSubstep) + Math.Min(_c.BiasRate * p->Rest, sink);
        }

        // What is deeper than the load accounts for goes as slowly as in the islands of the step's own substep: stiff contacts of
        // many substeps would make speed of it.
        double sag = OrdinarySags * _c.Sag((float)(p->Normal * k));
        double depth = Math.Max(0, -p->Separation - sag);
        double bias = _c.MassScale * _c.BiasRate * (p->Separation + (depth * (1 - _slowness)));
        return (_c.MassScale * v) + Math.Min(bias, sink)
            + (k * _c.ImpulseScale * (p->Normal - p->Feed));
    }

    /// <summary>
    /// The response of surfaces that joints bind, out of reach if what they overlap by would go only with a large turn: about a hinge that
    /// lies within both of its bodies no turn undoes their overlap, and the arm that is left of it is a few hundredths of the depth. Pushed
    /// against it the links of a rope spun at hundreds of radians a second, a wrecking ball was thrown as high as thirty metres, and two
    /// boxes pinned to the world in each other threw what hung on them at 400 km/h. Impulses fade alike, or what is out of reach would push
    /// on.
    /// </summary>
    private double WithinReach(TreeContact* contact, TreeContactPoint* p, double k, double* a, double* b)
    {
        p->Reach = 1;
        if (p->Separation < 0 && k > 0)
        {
            RowEnds* ends = &contact->Ends;
            double bound = 1 - (k / (Bound * RowEnds.Own(_view.Nodes, ends, a, b)));
            double turn2 = p->Separation * p->Separation * (InverseInertia(ends->NodeA) + InverseInertia(ends->NodeB)) / k;
            double beyond = (turn2 / (TreePositions.LargestBend * TreePositions.LargestBend)) - 1;
            double share = Math.Max(0, bound) * Math.Max(0, beyond);
            p->Reach = 1 / (1 + (share * share));
        }

        return k / p->Reach;
    }

    private double InverseInertia(int node) => node < 0 ? 0 : _view.Nodes[node].InverseInertia;

    /// <summary>The velocity of a body of the trees where it is, that of another in the room given.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private double* VelocityOf(int node, int body, double* room)
    {
        if (node >= 0)
        {
            return _view.Nodes[node].Velocity;
        }

        BodyState* state = _bodies.State.Pointer + body;
        room[0] = state->LinearVelocity.X;
        room[1] = state->LinearVelocity.Y;
        room[2] = state->AngularVelocity;
        return room;
    }

    private void Speeds(TreeContact* contact, out double v0, out double v1)
    {
        double* room = stackalloc double[6];
        double* a = VelocityOf(contact->Ends.NodeA, contact->Ends.BodyA, room);
        double* b = VelocityOf(contact->Ends.NodeB, contact->Ends.BodyB, room + 3);
        double un = (contact->NormalX * (b[0] - a[0])) + (contact->NormalY * (b[1] - a[1]));
        v0 = un + ((b[2] * contact->Point0.NormalB) - (a[2] * contact->Point0.NormalA));
        v1 = un + ((b[2] * contact->Point1.NormalB) - (a[2] * contact->Point1.NormalA));
    }

    private void Rub(TreeContact* contact, double normal0, double normal1)
    {
        double* room = stackalloc double[6];
        double* a = VelocityOf(contact->Ends.NodeA, contact->Ends.BodyA, room);
        double* b = VelocityOf(contact->Ends.NodeB, contact->Ends.BodyB, room + 3);
        double ut = (contact->NormalY * (b[0] - a[0])) - (contact->NormalX * (b[1] - a[1]));
        TreeContactPoint* p0 = &contact->Point0;
        TreeContactPoint* p1 = &contact->Point1;
        double v0 = ut + ((a[2] * p0->RubA) - (b[2] * p0->RubB));
        double change0 = Rub(p0, v0, contact->Friction * normal0);
        double change1 = 0;
        if (contact->Points > 1)
        {
            double v1 = ut + ((a[2] * p1->RubA) - (b[2] * p1->RubB)) + (contact->RubCoupling * change0);
            change1 = Rub(p1, v1, contact->Friction * normal1);
        }

        if (change0 != 0 || change1 != 0)
        {
            double* impulseA = stackalloc double[3];
            double* impulseB = stackalloc double[3];
            Tangents(contact, change0, change1, impulseA, impulseB);
            RowEnds.Apply(_view, &contact->Ends, impulseA, impulseB);
        }
    }

    private static double Rub(TreeContactPoint* p, double v, double bound)
    {
        double old = p->Tangent;
        double now = p->RubResponse > 0 ? old - (v / p->RubResponse) : 0;
        p->Tangent = Math.Max(-bound, Math.Min(bound, now));
        return p->Tangent - old;
    }

    private void Change(TreeContact* contact, double x0, double x1)
    {
        double change0 = x0 - contact->Point0.Normal;
        double change1 = x1 - contact->Point1.Normal;
        if (change0 == 0 && change1 == 0)
        {
            return;
        }

        Changed = Math.Max(contact->K11 * Math.Abs(change0), contact->K22 * Math.Abs(change1));
        contact->Point0.Normal = x0;
        contact->Point1.Normal = x1;
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        Normals(contact, change0, change1, a, b);
        RowEnds.Apply(_view, &contact->Ends, a, b);
    }

    /// <summary>The complementarity problem of <see cref="ContactKernel.SolveBlock"/> from the present impulses.</summary>
    private static void SolveBlock(TreeContact* contact, double r0, double r1, out double x0, out double x1)
    {
        double lambda0 = contact->Point0.Normal;
        double lambda1 = contact->Point1.Normal;
        double k11 = contact->K11;
        double k22 = contact->K22;
        double k12 = contact->K12;
        if (contact->Points == 1)
        {
            x0 = k11 > 0 ? Math.Max(0, lambda0 - (r0 / k11)) : 0;
            x1 = 0;
            return;
        }

        double b0 = r0 - ((k11 * lambda0) + (k12 * lambda1));
        double b1 = r1 - ((k12 * lambda0) + (k22 * lambda1));
        if (contact->InverseDeterminant > 0)
        {
            x0 = contact->InverseDeterminant * ((k12 * b1) - (k22 * b0));
            x1 = contact->InverseDeterminant * ((k12 * b0) - (k11 * b1));
            if (x0 >= 0 && x1 >= 0)
            {
                return;
            }

            x0 = 0;
            x1 = 0;
            if (b0 >= 0 && b1 >= 0)
            {
                return;
            }

            double only0 = Math.Max(0, -b0 / k11);
            if (b1 + (k12 * only0) >= 0)
            {
                x0 = only0;
                return;
            }

            double only1 = Math.Max(0, -b1 / k22);
            if (b0 + (k12 * only1) >= 0)
            {
                x1 = only1;
                return;
            }
        }

        x0 = k11 > 0 ? Math.Max(0, -(b0 + (k12 * lambda1)) / k11) : 0;
        x1 = k22 > 0 ? Math.Max(0, -(b1 + (k12 * x0)) / k22) : 0;
    }
}
