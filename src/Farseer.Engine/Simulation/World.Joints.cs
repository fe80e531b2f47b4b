using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <content>Making, changing and removing joints, outside of a step.</content>
internal sealed partial class World
{
    /// <summary>Trees of joints go side by side where they can; both ways give the same bits, which tests compare.</summary>
    internal bool TreesOnLanes
    {
        get => _stores.MadeJointSolver.Lanes.UsesLanes;
        set => _stores.MadeJointSolver.Lanes.UsesLanes = value;
    }

    /// <summary>Trees that were side by side in the last step from its start to its end.</summary>
    internal int TreesSideBySide => _stores.JointSolver?.Lanes.TreesSideBySide ?? 0;

    /// <summary>Joints between single bodies that were iterated side by side in the last step.</summary>
    internal int JointsSideBySide => _stores.JointSolver?.Lanes.JointsSideBySide ?? 0;

    /// <summary>Trees that are chains of hinges are solved as such: other roundings than those of the passes for all trees.</summary>
    internal bool TreesAsChains
    {
        get => _stores.MadeJointSolver.Chains.UsesChains;
        set => _stores.MadeJointSolver.Chains.UsesChains = value;
    }

    /// <summary>The frame of the world: joints with a fixed point hold on to it.</summary>
    public static Handle WorldFrame => new Handle(0, 1);

    /// <param name="kind">Which equations it keeps.</param>
    /// <param name="bodyA">First body, or <see cref="WorldFrame"/>.</param>
    /// <param name="bodyB">Second body.</param>
    /// <param name="settings">What the kind reads.</param>
    /// <param name="flags">Enabled, limits, motor, spring, colliding.</param>
    public Handle CreateJoint(JointKind kind, Handle bodyA, Handle bodyB, in JointSettings settings, JointFlags flags)
    {
        RequireOutside();
        Bodies.Ids.Require(bodyA, nameof(bodyA));
        Bodies.Ids.Require(bodyB, nameof(bodyB));
        if (bodyA.Index == bodyB.Index)
        {
            throw new ArgumentException("A joint needs two different bodies.", nameof(bodyB));
        }

        _removals.Purge();
        Sleep.DisturbByJoint(bodyA.Index);
        Sleep.DisturbByJoint(bodyB.Index);
        Handle joint = Joints.Add(kind, bodyA.Index, bodyB.Index, settings, flags);
        NoteTies(bodyA.Index);
        NoteTies(bodyB.Index);
        Refilter(bodyA.Index, bodyB.Index, flags);
        return joint;
    }

    public void DestroyJoint(Handle joint)
    {
        RequireOutside();
        Joints.Ids.Require(joint, nameof(joint));
        JointLink link = Joints.Links[joint.Index];
        JointFlags flags = Joints.Flags[joint.Index];
        Sleep.DisturbByJoint(link.BodyA);
        Sleep.DisturbByJoint(link.BodyB);
        Joints.Remove(joint);
        NoteTies(link.BodyA);
        NoteTies(link.BodyB);
        Refilter(link.BodyA, link.BodyB, flags);
    }

    /// <summary>Changes a joint.</summary>
    /// <param name="joint">The joint.</param>
    /// <param name="settings">What it is made of from now on.</param>
    /// <param name="flags">Its flags from now on.</param>
    /// <param name="wakes">False lets its bodies sleep on.</param>
    public void SetJoint(Handle joint, in JointSettings settings, JointFlags flags, bool wakes = true)
    {
        const JointFlags Filter = JointFlags.Enabled | JointFlags.CollideConnected;
        Joints.Ids.Require(joint, nameof(joint));
        JointFlags before = Joints.Flags[joint.Index];
        if (wakes)
        {
            Sleep.DisturbByJoint(Joints.Links[joint.Index].BodyA);
            Sleep.DisturbByJoint(Joints.Links[joint.Index].BodyB);
        }

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

        _stores.JointSolver?.Nets.Edited(joint.Index, ((before ^ flags) & JointFlags.Enabled) != 0);

        if (((before ^ flags) & Filter) != 0)
        {
            JointLink link = Joints.Links[joint.Index];
            Refilter(link.BodyA, link.BodyB, before & flags);
        }
    }

    public ref JointState JointState(Handle joint)
    {
        Joints.Ids.Require(joint, nameof(joint));
        _stores.JointSolver?.Nets.Report(joint.Index);
        return ref Joints.States[joint.Index];
    }

    /// <summary>Force or torque of one row of a joint in the last substep.</summary>
    public unsafe double JointRowForce(Handle joint, int row)
    {
        Joints.Ids.Require(joint, nameof(joint));
        _stores.JointSolver?.Nets.Report(joint.Index);
        return _stores.LastSubstep > 0 ? Joints.States[joint.Index].Impulse[row] / _stores.LastSubstep : 0;
    }

    public JointFlags JointFlagsOf(Handle joint)
    {
        Joints.Ids.Require(joint, nameof(joint));
        return Joints.Flags[joint.Index];
    }

    /// <summary>A joint that keeps its bodies apart changed: their contacts are judged anew.</summary>
    private void Refilter(int bodyA, int bodyB, JointFlags flags)
    {
        if ((flags & JointFlags.CollideConnected) == 0 && bodyA != 0)
        {
            // A static body may carry the contacts of the whole scene; the other one has its own only.
            int body = (Bodies.Flags[bodyA] & BodyFlags.Static) != 0 ? bodyB : bodyA;
            _removals.MarkStale(body);
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
}
