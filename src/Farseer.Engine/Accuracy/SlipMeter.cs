using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Accuracy;

/// <summary>
/// How far contacts that stick by Coulomb's law went along their tangent all the same. A contact counts from the second measured step on in
/// which the same point sticks; what it slid before, it may.
/// </summary>
internal sealed unsafe class SlipMeter
{
    /// <summary>Share of the friction's bound from which on a contact slides: the solver reaches the bound to rounding.</summary>
    private const float Sliding = 0.999f;

    private readonly Column<Memory> _memory = new Column<Memory>();
    private readonly BodyStore _bodies;
    private readonly ShapeStore _shapes;
    private int _step;

    public SlipMeter(BodyStore bodies, ShapeStore shapes)
    {
        _bodies = bodies;
        _shapes = shapes;
    }

    public void Begin(int contactEnd)
    {
        _step++;
        _memory.EnsureCapacity(contactEnd);
    }

    /// <summary>Looks at a pair with a row.</summary>
    /// <param name="index">Its record.</param>
    /// <param name="record">The same.</param>
    /// <param name="row">Its bundle.</param>
    /// <param name="lane">Its lane.</param>
    /// <param name="manifold">Its points at the poses of now.</param>
    /// <param name="audit">Where the step found the bodies.</param>
    /// <param name="creep">The way since it began to stick.</param>
    /// <returns>The way in this step.</returns>
    public double Measure(
        int index, in ContactRecord record, ContactBundle* row, int lane, in Manifold manifold, EnergyAudit audit, out double creep)
    {
        creep = 0;
        ref Memory memory = ref _memory[index];
        float normal = row->Point0.Normal[lane] + row->Point1.Normal[lane];
        float tangent = Math.Abs(row->Point0.Tangent[lane] + row->Point1.Tangent[lane]);
        if (!(normal > 0) || !(tangent < Sliding * row->Friction[lane] * normal))
        {
            memory.Step = 0;
            return 0;
        }

        bool known = memory.Step == _step - 1 && memory.PieceA == record.PieceA && memory.PieceB == record.PieceB;
        Memory now = default;
        now.Step = _step;
        now.PieceA = record.PieceA;
        now.PieceB = record.PieceB;
        double slip = 0;
        for (int k = 0; k < manifold.Count; k++)
        {
            ManifoldPoint point = k == 0 ? manifold.Point0 : manifold.Point1;
            bool first = known && memory.Points > 0 && memory.Id0 == point.Id;
            bool second = known && memory.Points > 1 && memory.Id1 == point.Id;
            double way = first || second ? Way(record, manifold.Normal, point, audit) : 0;
            double sum = way + (first ? memory.Way0 : second ? memory.Way1 : 0);
            slip = Math.Max(slip, Math.Abs(way));
            creep = Math.Max(creep, Math.Abs(sum));
            if (k == 0)
            {
                now.Id0 = point.Id;
                now.Way0 = sum;
            }
            else
            {
                now.Id1 = point.Id;
                now.Way1 = sum;
            }
        }

        now.Points = manifold.Count;
        memory = now;
        return slip;
    }

    /// <summary>By how much the matter that touches now went apart along the tangent in this step.</summary>
    private double Way(in ContactRecord record, Vector2 normal, in ManifoldPoint point, EnergyAudit audit)
    {
        double bx = point.Anchor.X - (_bodies.Pose[record.BodyB].X - _bodies.Pose[record.BodyA].X);
        double by = point.Anchor.Y - (_bodies.Pose[record.BodyB].Y - _bodies.Pose[record.BodyA].Y);
        float radiusA = _shapes.Pieces[record.PieceA].Radius;
        float radiusB = _shapes.Pieces[record.PieceB].Radius;
        Move(record.BodyA, audit, point.Anchor.X, point.Anchor.Y, normal, radiusA, out double ax, out double ay);
        Move(record.BodyB, audit, bx, by, -normal, radiusB, out bx, out by);
        return (normal.Y * (bx - ax)) - (normal.X * (by - ay));
    }

    /// <summary>
    /// The way of a point of a body. The rounding of a piece rolls: what touches there changes, and goes the turn times the radius; its
    /// core turns as a body does.
    /// </summary>
    private void Move(int body, EnergyAudit audit, double armX, double armY, Vector2 outward, double radius, out double x, out double y)
    {
        ref BodyStart start = ref audit.StartOf(body);
        ref BodyPose pose = ref _bodies.Pose[body];
        double turn = pose.Angle - start.Angle;
        double coreX = armX - (radius * outward.X);
        double coreY = armY - (radius * outward.Y);
        StableMath.SinCos(-turn, out double sin, out double cos);
        x = pose.X - start.X + coreX - ((cos * coreX) - (sin * coreY)) - (turn * radius * outward.Y);
        y = pose.Y - start.Y + coreY - ((sin * coreX) + (cos * coreY)) + (turn * radius * outward.X);
    }

    private struct Memory
    {
        public int Step;
        public int PieceA;
        public int PieceB;
        public int Points;
        public uint Id0;
        public uint Id1;
        public double Way0;
        public double Way1;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_memory);
        s.Value(ref _step);
    }
}
