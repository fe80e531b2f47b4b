using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>Joints and springs: what they join, their errors, and what they hold with.</summary>
internal sealed class LinkTrack
{
    public const int Error = 0;
    public const int ForceX = 1;
    public const int ForceY = 2;
    public const int Torque = 3;
    public const int TargetX = 4;
    public const int TargetY = 5;
    public const int Flags = 6;

    // The page reads these bits: keep them as they are.
    private const int IsThere = 1;
    private const int IsEnabled = 2;

    private readonly References<object> _links = new References<object>();

    public Track Track { get; } = new Track(
        "link",
        new ColumnSpec("error", ColumnKind.Single, Digits.Length),
        new ColumnSpec("fx", ColumnKind.Single, Digits.Size),
        new ColumnSpec("fy", ColumnKind.Single, Digits.Size),
        new ColumnSpec("torque", ColumnKind.Single, Digits.Size),
        new ColumnSpec("tx", ColumnKind.Single, Digits.Place),
        new ColumnSpec("ty", ColumnKind.Single, Digits.Place),
        new ColumnSpec("flags", ColumnKind.Byte));

    public List<Ends> All { get; } = new List<Ends>();

    public int Find(object? link) => _links.Find(link);

    public void Record(JointList joints, SpringList springs, BodyTrack bodies)
    {
        Track.Begin(All.Count);
        Track.Clear(Flags);
        for (int i = 0; i < joints.Count; i++)
        {
            Joint joint = joints[i];
            int slot = Slot(joint, out bool isNew);
            if (isNew)
            {
                All.Add(EndsOf(joint, bodies));
            }

            Track.Set(slot, Error, joint.JointError);
            Vector2 force = joint.ReactionForce;
            Track.Set(slot, ForceX, force.X);
            Track.Set(slot, ForceY, force.Y);
            Track.Set(slot, Torque, joint.ReactionTorque);
            SetTarget(slot, joint is TargetJoint target ? target.Target : All[slot].InWorld);
            Track.Set(slot, Flags, IsThere | (joint.Enabled ? IsEnabled : 0));
        }

        for (int i = 0; i < springs.Count; i++)
        {
            Spring spring = springs[i];
            int slot = Slot(spring, out bool isNew);
            if (isNew)
            {
                All.Add(EndsOf(spring, bodies));
            }

            Track.Set(slot, Error, spring.SpringError);
            SetTarget(slot, spring is FixedLinearSpring fixedSpring ? fixedSpring.WorldAttachPoint : Vector2.Zero);
            Track.Set(slot, Flags, IsThere | (spring.Enabled ? IsEnabled : 0));
        }
    }

    private int Slot(object link, out bool isNew)
    {
        int slot = _links.Number(link, out isNew);
        Track.Grow(slot + 1);
        return slot;
    }

    private void SetTarget(int slot, Vector2 target)
    {
        Track.Set(slot, TargetX, target.X);
        Track.Set(slot, TargetY, target.Y);
    }

    private static Ends EndsOf(Joint joint, BodyTrack bodies)
    {
        Ends ends = new Ends(Kind(joint, "Joint"), Label.Of(null, joint.Tag));
        switch (joint)
        {
            case RevoluteJoint { Body1: { } one, Body2: { } two } hinge:
                Vector2 anchor = hinge.CurrentAnchor;
                return ends.Between(bodies.Find(one), one.GetLocalPosition(anchor), bodies.Find(two), two.GetLocalPosition(anchor));
            case AnchoredJoint { Body1: { } one, Body2: { } two } rod:
                ends.Between(
                    bodies.Find(one), one.GetLocalPosition(rod.WorldAnchor1), bodies.Find(two), two.GetLocalPosition(rod.WorldAnchor2));
                return rod is PulleyJoint pulley ? ends.Over(pulley.Ground1, pulley.Ground2) : ends;
            case PairJoint pair:
                return ends.Between(bodies.Find(pair.Body1), Vector2.Zero, bodies.Find(pair.Body2), Vector2.Zero);
            case FixedRevoluteJoint { Body: { } body } nail:
                return ends.ToWorld(bodies.Find(body), body.GetLocalPosition(nail.CurrentAnchor), nail.Anchor);
            case TargetJoint { Body: { } body } target:
                return ends.ToWorld(bodies.Find(body), Vector2.Zero, target.Target);
            case WorldJoint world:
                return ends.Alone(bodies.Find(world.Body));
            default:
                return ends;
        }
    }

    private static Ends EndsOf(Spring spring, BodyTrack bodies)
    {
        Ends ends = new Ends(Kind(spring, string.Empty), Label.Of(null, spring.Tag)) { IsSpring = true };
        return spring switch
        {
            LinearSpring s => ends.Between(bodies.Find(s.Body1), s.AttachPoint1, bodies.Find(s.Body2), s.AttachPoint2),
            FixedLinearSpring s => ends.ToWorld(bodies.Find(s.Body), s.BodyAttachPoint, s.WorldAttachPoint),
            AngleSpring s => ends.Between(bodies.Find(s.Body1), s.Anchor1, bodies.Find(s.Body2), s.Anchor2),
            FixedAngleSpring s => ends.Alone(bodies.Find(s.Body)),
            _ => ends,
        };
    }

    private static string Kind(object link, string end)
    {
        string name = link.GetType().Name;
        return end.Length > 0 && name.EndsWith(end, System.StringComparison.Ordinal) && name.Length > end.Length
            ? name.Substring(0, name.Length - end.Length)
            : name;
    }

    /// <summary>What a joint or spring joins: numbers of bodies, -1 for the world and for none, and points in their coordinates.</summary>
    internal sealed class Ends
    {
        public Ends(string kind, string? name)
        {
            Kind = kind;
            Name = name;
        }

        public string Kind { get; }

        public string? Name { get; }

        public bool IsSpring { get; set; }

        public int BodyA { get; private set; } = -1;

        public int BodyB { get; private set; } = -1;

        public Vector2 InA { get; private set; }

        public Vector2 InB { get; private set; }

        /// <summary>True: the other end is a point of the world, which may move.</summary>
        public bool IsToWorld { get; private set; }

        public Vector2 InWorld { get; private set; }

        /// <summary>True: by way of two points of the world.</summary>
        public bool IsOver { get; private set; }

        public Vector2 Over1 { get; private set; }

        public Vector2 Over2 { get; private set; }

        public Ends Between(int a, Vector2 inA, int b, Vector2 inB)
        {
            BodyA = a;
            InA = inA;
            BodyB = b;
            InB = inB;
            return this;
        }

        public Ends ToWorld(int body, Vector2 inBody, Vector2 inWorld)
        {
            BodyA = body;
            InA = inBody;
            IsToWorld = true;
            InWorld = inWorld;
            return this;
        }

        public Ends Alone(int body)
        {
            BodyA = body;
            return this;
        }

        public Ends Over(Vector2 one, Vector2 two)
        {
            IsOver = true;
            Over1 = one;
            Over2 = two;
            return this;
        }
    }
}
