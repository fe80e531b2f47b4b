using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Making, changing and removing joints, outside of a step.</summary>
internal sealed partial class World
{
    // None before there is a joint.
    private JointSolver? _jointSolver;

    private JointSolver MadeJointSolver => _jointSolver ??= new JointSolver(Joints);

    /// <summary>Trees of joints go side by side where they can; both ways give the same bits, which tests compare.</summary>
    internal bool TreesOnLanes
    {
        get => MadeJointSolver.UsesLanes;
        set => MadeJointSolver.UsesLanes = value;
    }

    /// <summary>Trees that were side by side in the last step from its start to its end.</summary>
    internal int TreesSideBySide => _jointSolver?.TreesSideBySide ?? 0;

    /// <summary>Joints between single bodies that were iterated side by side in the last step.</summary>
    internal int JointsSideBySide => _jointSolver?.JointsSideBySide ?? 0;

    /// <summary>Trees that are chains of hinges are solved as such: other roundings than those of the passes for all trees.</summary>
    internal bool TreesAsChains
    {
        get => MadeJointSolver.UsesChains;
        set => MadeJointSolver.UsesChains = value;
    }

    /// <summary>The frame of the world: joints with a fixed point hold on to it.</summary>
    public static Handle WorldFrame => new Handle(0, 1);

    public JointStore Joints { get; } = new JointStore();

    /// <summary>Who hears of broken joints and solves those that a user wrote.</summary>
    [NotState(Why.Fixed)]
    public IUserJoints? UserJoints { get; set; }

    /// <param name="kind">Which equations it keeps.</param>
    /// <param name="bodyA">First body, or <see cref="WorldFrame"/>.</param>
    /// <param name="bodyB">Second body.</param>
    /// <param name="settings">What the kind reads.</param>
    /// <param name="flags">Enabled, limits, motor, spring, colliding.</param>
    public Handle CreateJoint(JointKind kind, Handle bodyA, Handle bodyB, in JointSettings settings, JointFlags flags)
    {
        RequireOutside();
        Require(bodyA);
        Require(bodyB);
        if (bodyA.Index == bodyB.Index)
        {
            throw new ArgumentException("A joint needs two different bodies.", nameof(bodyB));
        }

        Purge();
        DisturbByJoint(bodyA.Index);
        DisturbByJoint(bodyB.Index);
        Handle joint = Joints.Add(kind, bodyA.Index, bodyB.Index, settings, flags);
        NoteTies(bodyA.Index);
        NoteTies(bodyB.Index);
        Refilter(bodyA.Index, bodyB.Index, flags);
        return joint;
    }

    public void DestroyJoint(Handle joint)
    {
        RequireOutside();
        Require(joint, Joints.Ids, nameof(joint));
        JointLink link = Joints.Links[joint.Index];
        JointFlags flags = Joints.Flags[joint.Index];
        DisturbByJoint(link.BodyA);
        DisturbByJoint(link.BodyB);
        Joints.Remove(joint);
        NoteTies(link.BodyA);
        NoteTies(link.BodyB);
        Refilter(link.BodyA, link.BodyB, flags);
    }

    public void SetJoint(Handle joint, in JointSettings settings, JointFlags flags)
    {
        const JointFlags Filter = JointFlags.Enabled | JointFlags.CollideConnected;
        Require(joint, Joints.Ids, nameof(joint));
        JointFlags before = Joints.Flags[joint.Index];
        DisturbByJoint(Joints.Links[joint.Index].BodyA);
        DisturbByJoint(Joints.Links[joint.Index].BodyB);
        Joints.Settings[joint.Index] = settings;
        Joints.Flags[joint.Index] = flags | JointFlags.Alive;
        Joints.NoteEdit();
        Joints.NoteTie(joint.Index);
        NoteTies(Joints.Links[joint.Index].BodyA);
        NoteTies(Joints.Links[joint.Index].BodyB);
        if (((before ^ flags) & JointFlags.Enabled) != 0)
        {
            Joints.Changed = true;
            Joints.States[joint.Index] = default;
        }

        _jointSolver?.Nets.Edited(joint.Index, ((before ^ flags) & JointFlags.Enabled) != 0);

        if (((before ^ flags) & Filter) != 0)
        {
            JointLink link = Joints.Links[joint.Index];
            Refilter(link.BodyA, link.BodyB, before & flags);
        }
    }

    public ref JointState JointState(Handle joint)
    {
        Require(joint, Joints.Ids, nameof(joint));
        _jointSolver?.Nets.Report(joint.Index);
        return ref Joints.States[joint.Index];
    }

    /// <summary>Force or torque of one row of a joint in the last substep.</summary>
    public unsafe double JointRowForce(Handle joint, int row)
    {
        Require(joint, Joints.Ids, nameof(joint));
        _jointSolver?.Nets.Report(joint.Index);
        return _lastSubstep > 0 ? Joints.States[joint.Index].Impulse[row] / _lastSubstep : 0;
    }

    public JointFlags JointFlagsOf(Handle joint)
    {
        Require(joint, Joints.Ids, nameof(joint));
        return Joints.Flags[joint.Index];
    }

    /// <summary>A joint that keeps its bodies apart changed: their contacts are judged anew.</summary>
    private void Refilter(int bodyA, int bodyB, JointFlags flags)
    {
        if ((flags & JointFlags.CollideConnected) == 0 && bodyA != 0)
        {
            // A static body may carry the contacts of the whole scene; the other one has its own only.
            int body = (Bodies.Flags[bodyA] & BodyFlags.Static) != 0 ? bodyB : bodyA;
            MarkStale(body);
            Bodies.Flags[body] |= BodyFlags.Moved;
        }
    }

    /// <summary>Notes whether a body hangs on a joint that does not yield, when one of its joints has come, gone or changed.</summary>
    private void NoteTies(int body)
    {
        if (Joints.IsTied(body))
        {
            Bodies.Flags[body] |= BodyFlags.Tied;
        }
        else
        {
            Bodies.Flags[body] &= ~BodyFlags.Tied;
        }
    }

    private void DestroyJointsOf(int body)
    {
        for (int entry = Joints.First(body); entry >= 0; entry = Joints.First(body))
        {
            DestroyJoint(Joints.Ids.HandleOf(entry >> 1));
        }
    }

    private void RequireOutside()
    {
        if (IsStepping)
        {
            throw new InvalidOperationException("Joints come and go between steps only.");
        }
    }

    private unsafe bool BeginJoints(float dt, float substep)
    {
        if (Joints.Count == 0 && !Joints.Changed)
        {
            return false;
        }

        JointStep step;
        step.Runner = _runner;
        step.Bodies = Bodies;
        step.Moves = _lists.Moves;
        step.Touches = _graph.Degrees;
        step.ContactRoom = _contacts.Records.Capacity;
        step.Dt = dt;
        step.Substep = substep;
        step.Audited = Audit != null || Impulses != null || _contacts.Surfaces.AnySpecial;
        step.Impulses = Impulses;
        step.Watched = step.Audited || (UserJoints != null && UserJoints.Any) || _springs.Count > 0;
        step.BreaksLate = Settings.JointsBreakLate;
        step.ImpulseScale = !Settings.KeepImpulses ? 0 : _lastSubstep > 0 ? (double)substep / _lastSubstep : 1;
        step.Drifts = !Settings.CorrectPositions;
        JointSolver solver = MadeJointSolver;
        solver.Begin(step);
        for (int i = 0; i < solver.BrokenCount; i++)
        {
            UserJoints?.Broke(solver.Broken(i));
        }

        return solver.Any;
    }
}
