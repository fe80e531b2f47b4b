using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Accuracy;

/// <summary>
/// Measures what a step left: depths of contacts, distances of joints, speeds that ought to be none. It looks at the poses that
/// the step ended with, as anybody outside does, and not at what the solver believes.
/// </summary>
internal sealed unsafe class ErrorMeter
{
    /// <summary>The side of a square whose radius of gyration is 1: the size of a body that the error of its way is a share of.</summary>
    private const double SideOfRadius = 2.449489742783178;

    private readonly JointKinds _kinds = new JointKinds();
    private readonly PolygonDepth _polygons = new PolygonDepth();
    private readonly SagPaths _sags = new SagPaths();
    private readonly SlipMeter _slips;
    private readonly BodyStore _bodies;
    private readonly ShapeStore _shapes;
    private readonly ContactStore _contacts;
    private readonly ConstraintGraph _graph;
    private readonly JointStore _joints;
    [NotState(Why.Elsewhere)]
    private EnergyAudit _audit = null!;

    public ErrorMeter(BodyStore bodies, ShapeStore shapes, ContactStore contacts, ConstraintGraph graph, JointStore joints)
    {
        _bodies = bodies;
        _shapes = shapes;
        _contacts = contacts;
        _graph = graph;
        _joints = joints;
        _slips = new SlipMeter(bodies, shapes);
    }

    public BodyGroups Groups { get; } = new BodyGroups();

    /// <param name="m">Receives the errors; those of energy and momentum are others' to find.</param>
    /// <param name="settings">How deep contacts may rest.</param>
    /// <param name="audit">Where the step found the bodies, and how they went.</param>
    public void Measure(ref StepMeasures m, WorldSettings settings, EnergyAudit audit)
    {
        _audit = audit;
        m.WorstBody = -1;
        m.WorstPartner = -1;
        m.WorstJoint = -1;
        m.MotionBody = -1;
        Groups.Begin(_bodies.Ids.End);
        _sags.Begin(_bodies.Ids.End);
        _slips.Begin(_contacts.End);
        MeasureContacts(ref m, settings);
        MeasureJoints(ref m);
        MeasureMotion(ref m);
    }

    /// <summary>The group of the largest error, when all are known.</summary>
    public void NameGroup(ref StepMeasures m)
    {
        m.WorstIsland = m.WorstBody < 0 ? 0 : Groups.Size(m.WorstPartner < 0 || Moves(m.WorstBody) ? m.WorstBody : m.WorstPartner);
    }

    /// <summary>Greatest distance of a point of a piece from its body's centre.</summary>
    public double Reach(int piece) => _shapes.Pieces[piece].Reach;

    /// <summary>Shorter side of the smaller piece of a pair.</summary>
    public double SizeOf(in ContactRecord record) =>
        2.0 * Math.Min(_shapes.Pieces[record.PieceA].Extent, _shapes.Pieces[record.PieceB].Extent);

    /// <summary>Takes an error into account.</summary>
    /// <param name="m">The measures.</param>
    /// <param name="cause">What it is an error of.</param>
    /// <param name="error">A length.</param>
    /// <param name="curable">What of it finer substeps would make less.</param>
    /// <param name="size">Of what it is an error of; 0: unknown.</param>
    /// <param name="bodyA">Where it is.</param>
    /// <param name="bodyB">The other body, or -1.</param>
    /// <param name="joint">Of a joint, else -1.</param>
    public static void Judge(
        ref StepMeasures m, ErrorCause cause, double error, double curable, double size, int bodyA, int bodyB, int joint = -1)
    {
        if (cause != ErrorCause.Motion)
        {
            m.ConstraintError = Math.Max(m.ConstraintError, error);
        }

        if (error > m.Error)
        {
            m.Error = error;
            m.Cause = cause;
            m.WorstBody = bodyA;
            m.WorstPartner = bodyB;
            m.WorstJoint = joint;
        }

        m.Curable = Math.Max(m.Curable, curable);
        if (size > 0)
        {
            m.ErrorShare = Math.Max(m.ErrorShare, error / size);
            m.CurableShare = Math.Max(m.CurableShare, curable / size);
        }
    }

    private bool Moves(int body)
    {
        const BodyFlags Here = BodyFlags.Alive | BodyFlags.Enabled;
        return (_bodies.Flags[body] & Here) == Here && _bodies.Mass[body].InverseMass > 0;
    }

    private void Connect(int a, int b)
    {
        bool movesA = Moves(a);
        bool movesB = Moves(b);
        if (movesA && movesB)
        {
            Groups.Join(a, b);
        }
        else if (movesA || movesB)
        {
            Groups.Hold(movesA ? a : b);
        }
    }

    private void MeasureContacts(ref StepMeasures m, WorldSettings settings)
    {
        double squares = 0;
        for (int i = 0; i < _contacts.End; i++)
        {
            ref ContactRecord record = ref _contacts.Records[i];
            if (record.PieceA < 0 || (record.Flags & ContactFlags.Solid) == 0)
            {
                continue;
            }

            ContactProbe.Collide(_bodies, _shapes, record, out Manifold manifold);
            double depth = 0;
            for (int k = 0; k < manifold.Count; k++)
            {
                ManifoldPoint point = k == 0 ? manifold.Point0 : manifold.Point1;
                if (point.Separation <= 0)
                {
                    depth = Math.Max(depth, -(double)point.Separation);
                    m.ContactSpeed = Math.Max(m.ContactSpeed, -NormalSpeed(record, manifold.Normal, point.Anchor));
                }
            }

            ref Piece pieceA = ref _shapes.Pieces[record.PieceA];
            ref Piece pieceB = ref _shapes.Pieces[record.PieceB];
            if (PolygonDepth.Applies(pieceA, pieceB))
            {
                depth = _polygons.Measure(_shapes, _bodies, pieceA, pieceB);
            }

            // A pair may overlap that the step did not see coming.
            if (depth == 0 && (record.Flags & ContactFlags.Touching) == 0)
            {
                continue;
            }

            Connect(record.BodyA, record.BodyB);
            m.Contacts++;
            squares += depth * depth;
            m.LargestPenetration = Math.Max(m.LargestPenetration, depth);
            double size = SizeOf(record);
            double rest = Math.Min(settings.AllowedPenetration, settings.AllowedPenetrationShare * size);
            double beyond = Math.Max(0, depth - rest);
            Judge(ref m, ErrorCause.Overlap, depth, beyond, size, record.BodyA, record.BodyB);
            NoteSag(record, depth, beyond, rest);
            MeasureSlip(ref m, i, record, manifold, size);
        }

        m.RmsPenetration = m.Contacts > 0 ? Math.Sqrt(squares / m.Contacts) : 0;
    }

    /// <summary>
    /// Where finer substeps would have put the pair: out to the depth of rest, or, on its way down to it, anywhere between.
    /// </summary>
    private void NoteSag(in ContactRecord record, double depth, double beyond, double rest)
    {
        bool movesA = Moves(record.BodyA);
        bool movesB = Moves(record.BodyB);
        if (movesA || movesB)
        {
            double sinking = Math.Max(0, Math.Min(depth, rest - depth));
            _sags.Add(record.BodyA, record.BodyB, movesA, movesB, beyond + sinking);
        }
    }

    private void MeasureSlip(ref StepMeasures m, int index, in ContactRecord record, in Manifold manifold, double size)
    {
        if (record.Color < 0 || record.IsDormant)
        {
            return;
        }

        ContactBundle* row = _graph.BundleOf(record.Row);
        double slip = _slips.Measure(index, record, row, RowArena.LaneOf(record.Row), manifold, _audit, out double creep);
        m.LargestSlip = Math.Max(m.LargestSlip, slip);
        m.LargestCreep = Math.Max(m.LargestCreep, creep);
        Judge(ref m, ErrorCause.Slip, slip, slip, size, record.BodyA, record.BodyB);
    }

    /// <summary>
    /// The way of each body against the way with ever finer substeps: what <see cref="MotionMeter"/> estimates, and its sag.
    /// </summary>
    private void MeasureMotion(ref StepMeasures m)
    {
        _sags.Run();
        for (int i = 1; i < _bodies.Ids.End; i++)
        {
            if (!Moves(i) || !_audit.Motion.WasFollowed(i))
            {
                continue;
            }

            ref BodyStart start = ref _audit.StartOf(i);
            ref BodyPose pose = ref _bodies.Pose[i];
            double radius = EnergyAudit.Radius(_bodies.Mass[i]);
            VelocityChange way;
            way.X = pose.X - start.X;
            way.Y = pose.Y - start.Y;
            way.W = pose.Angle - start.Angle;
            double error = _audit.Motion.ErrorOf(i, way, radius, out bool struck) + _sags.Of(i);
            if (error > m.MotionError)
            {
                m.MotionError = error;
                m.MotionBody = i;
            }

            Judge(ref m, ErrorCause.Motion, error, struck ? 0 : error, SideOfRadius * radius, i, -1);
        }
    }

    private double NormalSpeed(in ContactRecord record, Vector2 n, Vector2 anchor)
    {
        ref BodyState a = ref _bodies.State[record.BodyA];
        ref BodyState b = ref _bodies.State[record.BodyB];
        double bx = anchor.X - (_bodies.Pose[record.BodyB].X - _bodies.Pose[record.BodyA].X);
        double by = anchor.Y - (_bodies.Pose[record.BodyB].Y - _bodies.Pose[record.BodyA].Y);
        double vx = b.LinearVelocity.X - (b.AngularVelocity * by) - (a.LinearVelocity.X - (a.AngularVelocity * anchor.Y));
        double vy = b.LinearVelocity.Y + (b.AngularVelocity * bx) - (a.LinearVelocity.Y + (a.AngularVelocity * anchor.X));
        return (n.X * vx) + (n.Y * vy);
    }

    private void MeasureJoints(ref StepMeasures m)
    {
        const JointFlags Acts = JointFlags.Alive | JointFlags.Enabled;
        double squares = 0;
        JointRows rows = default;
        for (int i = 0; i < _joints.Ids.End; i++)
        {
            ref JointLink link = ref _joints.Links[i];
            if ((_joints.Flags[i] & Acts) != Acts || !(Moves(link.BodyA) || Moves(link.BodyB)))
            {
                continue;
            }

            Connect(link.BodyA, link.BodyB);
            Write(i, ref rows);
            m.Joints++;
            double sum = 0;
            double speeds = 0;
            for (int k = 0; k < rows.Count; k++)
            {
                bool rigid = rows.Type[k] == (byte)RowType.Hard;
                double error = rigid ? Math.Abs(rows.Error[k])
                    : rows.Type[k] == (byte)RowType.Limit ? Math.Max(0, -rows.Error[k] - rows.Share[k]) : 0;
                if (IsTurn(rows, k))
                {
                    m.LargestTurn = Math.Max(m.LargestTurn, error);
                    continue;
                }

                sum += error * error;
                double speed = rigid ? Speed(rows, k, link) : 0;
                speeds += speed * speed;
            }

            double separation = Math.Sqrt(sum);
            squares += sum;
            m.LargestSeparation = Math.Max(m.LargestSeparation, separation);

            // Of a body whose numbers left their range there is no speed: that it is out of action is an error of its own.
            m.JointSpeed = double.IsNaN(speeds) ? m.JointSpeed : Math.Max(m.JointSpeed, Math.Sqrt(speeds));
            Judge(ref m, ErrorCause.Separation, separation, separation, rows.Size, link.BodyA, link.BodyB, i);
            _sags.Add(link.BodyA, link.BodyB, Moves(link.BodyA), Moves(link.BodyB), separation);
        }

        m.RmsSeparation = m.Joints > 0 ? Math.Sqrt(squares / m.Joints) : 0;
    }

    private static bool IsTurn(in JointRows rows, int k) =>
        rows.A[k * 3] == 0 && rows.A[(k * 3) + 1] == 0 && rows.B[k * 3] == 0 && rows.B[(k * 3) + 1] == 0;

    private double Speed(in JointRows rows, int k, in JointLink link)
    {
        ref BodyState a = ref _bodies.State[link.BodyA];
        ref BodyState b = ref _bodies.State[link.BodyB];
        return (rows.A[k * 3] * a.LinearVelocity.X) + (rows.A[(k * 3) + 1] * a.LinearVelocity.Y) + (rows.A[(k * 3) + 2] * a.AngularVelocity)
            + (rows.B[k * 3] * b.LinearVelocity.X) + (rows.B[(k * 3) + 1] * b.LinearVelocity.Y) + (rows.B[(k * 3) + 2] * b.AngularVelocity);
    }

    /// <summary>The rows of a joint at the poses of now.</summary>
    private void Write(int joint, ref JointRows rows)
    {
        ref JointLink link = ref _joints.Links[joint];
        ref JointSettings settings = ref _joints.Settings[joint];
        ref BodyPose a = ref _bodies.Pose[link.BodyA];
        ref BodyPose b = ref _bodies.Pose[link.BodyB];
        JointFrame frame = default;
        frame.AX = a.X;
        frame.AY = a.Y;
        frame.AAngle = a.Angle;
        StableMath.SinCos(a.Angle, out frame.ASin, out frame.ACos);
        frame.BX = b.X;
        frame.BY = b.Y;
        frame.BAngle = b.Angle;
        StableMath.SinCos(b.Angle, out frame.BSin, out frame.BCos);
        frame.PullTime = 1;
        frame.H = 1;
        frame.SetAnchors(settings);
        rows.Count = 0;
        rows.Hard = 0;
        rows.Size =
            Math.Sqrt((frame.RAX * frame.RAX) + (frame.RAY * frame.RAY)) + Math.Sqrt((frame.RBX * frame.RBX) + (frame.RBY * frame.RBY));
        _kinds.Of(link.Kind).Write(frame, settings, _joints.Flags[joint], ref rows);
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s) => _slips.Visit(s);
}
