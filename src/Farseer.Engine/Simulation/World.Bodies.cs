using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Solver;
using Farseer.Engine.Springs;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <content>Making, changing and removing bodies and colliders.</content>
internal sealed partial class World
{
    private int _colliderOrder;

    /// <summary>
    /// Makes room for so many more bodies and colliders at once: columns that grow one by one have up to a quarter to spare in the end.
    /// </summary>
    /// <returns>One past the highest indices that these will have.</returns>
    public (int BodyEnd, int ColliderEnd) Expect(int bodies, int colliders)
    {
        int bodyEnd = Bodies.Ids.EndAfter(bodies);
        int colliderEnd = Shapes.ColliderIds.EndAfter(colliders);
        _stores.EnsureBodies(bodyEnd);
        Sleep.EnsureBodies(bodyEnd);
        _stores.EnsureColliders(colliderEnd);
        int pieceEnd = Shapes.PieceIds.EndAfter(colliders);
        Shapes.PieceSet.EnsureCapacity(pieceEnd);
        _stores.Proxies.Set.EnsureCapacity(pieceEnd);
        return (bodyEnd, colliderEnd);
    }

    public Handle CreateBody(in BodyDef def)
    {
        _removals.Purge();
        Handle handle = Bodies.Ids.Take();
        int body = handle.Index;
        _stores.EnsureBodies(Bodies.Ids.End);
        Bodies.State[body] = new BodyState { LinearVelocity = def.LinearVelocity, AngularVelocity = def.AngularVelocity, DeltaCos = 1 };
        Bodies.Pose[body] = new BodyPose { X = def.X, Y = def.Y, Angle = def.Angle };
        FinishBodies.UpdateRotor(ref Bodies.Pose[body]);
        Bodies.Force[body] = default;
        Bodies.Drag[body] = def.Drag;
        Bodies.Flags[body] = (def.Flags & ~(BodyFlags.Asleep | BodyFlags.Tied)) | BodyFlags.Alive | BodyFlags.Moved;
        Bodies.Visited.Set(body);
        Sleep.Restart(body);
        Bodies.UserIndex[body] = def.UserIndex;
        Bodies.Motion[body] = new BodyMotion
        {
            StartX = def.LinearVelocity.X, StartY = def.LinearVelocity.Y, StartW = def.AngularVelocity,
        };
        Bodies.ClearResidual(body);
        Colliders.Begin(body);
        SetMass(handle, def.Mass, def.Inertia);
        if ((def.Flags & BodyFlags.Asleep) != 0)
        {
            Sleep.PutToSleep(handle);
        }

        return handle;
    }

    /// <summary>Removes the body with its colliders and contacts; within a step the removal takes effect after it.</summary>
    public void DestroyBody(Handle body)
    {
        Bodies.Ids.Require(body, nameof(body));
        for (int collider = Colliders.First(body.Index); collider >= 0; collider = Colliders.Next(collider))
        {
            if ((Shapes.Colliders[collider].Flags & ColliderFlags.Alive) != 0)
            {
                DestroyCollider(Shapes.ColliderIds.HandleOf(collider));
            }
        }

        Sleep.WakeUp(body);
        DestroyJointsOf(body.Index);
        Bodies.Flags[body.Index] &= ~(BodyFlags.Alive | BodyFlags.Enabled);
        _removals.Add(body);
    }

    public Handle CreateCollider(Handle body, ShapeGeometry shape, in ColliderDef def)
    {
        Bodies.Ids.Require(body, nameof(body));
        _removals.Purge();
        if ((Bodies.Flags[body.Index] & BodyFlags.Moved) == 0)
        {
            Sleep.Disturb(body.Index);
        }

        Handle handle = Shapes.ColliderIds.Take();
        int collider = handle.Index;
        _stores.MakesEnergy |= def.Restitution > 1;
        _stores.EnsureColliders(Shapes.ColliderIds.End);
        Shapes.Colliders[collider] = new ColliderInfo
        {
            Body = body.Index,
            Flags = def.Flags | ColliderFlags.Alive,
            Friction = def.Friction,
            Restitution = def.Restitution,
            Group = def.Group,
            Categories = def.Categories,
            CollidesWith = def.CollidesWith,
            UserIndex = def.UserIndex,
        };
        Shapes.Order[collider] = _colliderOrder++;
        _room.NoteDue();
        int piece = Shapes.AttachPieces(shape, body.Index, collider, def.Offset, StableMath.FromAngle(def.RotationOffset));
        Colliders.Add(body.Index, collider);
        Bodies.Flags[body.Index] |= BodyFlags.Moved;
        _stores.Proxies.End = Shapes.PieceIds.End;
        _stores.Proxies.Set.EnsureCapacity(_stores.Proxies.End);
        for (; piece >= 0; piece = Shapes.NextPiece[piece])
        {
            _stores.Proxies.Info[piece] = default;
            if (Queries.IsUsed)
            {
                Queries.Changed(piece);
            }
        }

        return handle;
    }

    /// <summary>Removes a collider; a pair of it that touched separates now.</summary>
    public void DestroyCollider(Handle collider)
    {
        Shapes.ColliderIds.Require(collider, nameof(collider));
        ref ColliderInfo info = ref Shapes.Colliders[collider.Index];
        Sleep.Disturb(info.Body);
        info.Flags &= ~ColliderFlags.Alive;
        for (int piece = info.FirstPiece; piece >= 0; piece = Shapes.NextPiece[piece])
        {
            Pairs.RemoveProxy(piece);
        }

        _removals.AddCollider(collider);
        _events.ColliderRemoved(collider.Index);
    }

    /// <summary>Teleports a body; legal at any time, also from hooks.</summary>
    public void SetPosition(Handle body, double x, double y)
    {
        Bodies.Ids.Require(body, nameof(body));
        Bodies.Pose[body.Index].X = x;
        Bodies.Pose[body.Index].Y = y;
        NotePlaced(body.Index);
    }

    public void SetAngle(Handle body, double angle)
    {
        Bodies.Ids.Require(body, nameof(body));
        ref BodyPose pose = ref Bodies.Pose[body.Index];
        pose.Angle = angle;
        FinishBodies.UpdateRotor(ref pose);
        NotePlaced(body.Index);
    }

    /// <summary>Mass and inertia, both above 0; the inverses follow from them and the body's kind.</summary>
    public void SetMass(Handle body, float mass, float inertia)
    {
        Bodies.Ids.Require(body, nameof(body));
        Sleep.Disturb(body.Index);
        bool moves = (Bodies.Flags[body.Index] & (BodyFlags.Static | BodyFlags.Kinematic)) == 0;
        BodyMass before = Bodies.Mass[body.Index];
        if (_stores.Graph.Degree(body.Index) > 0 && (mass < before.Mass || inertia < before.Inertia))
        {
            _lightened.Note(body.Index, Math.Min(mass / before.Mass, inertia < before.Inertia ? inertia / before.Inertia : 1));
        }

        Bodies.Mass[body.Index] = new BodyMass
        {
            Mass = mass,
            Inertia = inertia,
            InverseMass = moves ? 1f / mass : 0,
            InverseInertia = moves && !float.IsInfinity(inertia) ? 1f / inertia : 0,
        };
    }

    /// <summary>Sets and clears flags (static, kinematic, enabled, ...) with everything that follows from them.</summary>
    public void SetFlags(Handle body, BodyFlags set, BodyFlags clear)
    {
        const BodyFlags OfSleep = BodyFlags.Asleep | BodyFlags.Handled;
        const BodyFlags Structural = BodyFlags.Static | BodyFlags.Kinematic | BodyFlags.Enabled;
        Bodies.Ids.Require(body, nameof(body));
        BodyFlags old = Bodies.Flags[body.Index];
        BodyFlags now = (old & ~clear) | set;
        if ((set & BodyFlags.Enabled) != 0)
        {
            now &= ~BodyFlags.Quarantined;
        }

        if (((old ^ now) & Structural) != 0)
        {
            Sleep.Wake(body.Index);
        }
        else if (old != now)
        {
            Sleep.Disturb(body.Index);
        }

        now = (now & ~OfSleep) | (Bodies.Flags[body.Index] & OfSleep);
        Bodies.Flags[body.Index] = now;
        if (((old ^ now) & Structural) == 0)
        {
            return;
        }

        BodyStage.NoteSwitched();
        Bodies.Flags[body.Index] |= BodyFlags.Moved;
        BodyMass mass = Bodies.Mass[body.Index];
        SetMass(body, mass.Mass, mass.Inertia);
        if ((now & BodyFlags.Static) != 0)
        {
            Bodies.State[body.Index].LinearVelocity = Vector2.Zero;
            Bodies.State[body.Index].AngularVelocity = 0;
        }

        _removals.MarkStale(body.Index);
    }

    public bool IsLive(Handle body) => Bodies.Ids.IsLive(body) && (Bodies.Flags[body.Index] & BodyFlags.Alive) != 0;

    /// <summary>Material or listeners of a collider changed: its body wakes, and so does what rests on it.</summary>
    public void NoteChanged(Handle collider)
    {
        Shapes.ColliderIds.Require(collider, nameof(collider));
        ref ColliderInfo info = ref Shapes.Colliders[collider.Index];
        _stores.MakesEnergy |= info.Restitution > 1;
        Sleep.Disturb(info.Body);
    }

    /// <summary>
    /// The centre of mass moves by (<paramref name="x"/>, <paramref name="y"/>) in body axes; colliders and joints stay where they
    /// are in the world. The velocity is from now on that of the new centre: callers that want the body to go on turning as it
    /// did set it.
    /// </summary>
    public void MoveCentre(Handle body, double x, double y)
    {
        Bodies.Ids.Require(body, nameof(body));
        ref BodyPose pose = ref Bodies.Pose[body.Index];
        pose.X += (pose.Cos * x) - (pose.Sin * y);
        pose.Y += (pose.Sin * x) + (pose.Cos * y);
        for (int collider = Colliders.First(body.Index); collider >= 0; collider = Colliders.Next(collider))
        {
            Shapes.MovePieces(collider, -x, -y);
        }

        for (int entry = Joints.First(body.Index); entry >= 0; entry = Joints.Next(entry))
        {
            ref JointSettings settings = ref Joints.Settings[entry >> 1];
            if ((entry & 1) == 0)
            {
                settings.AnchorAX -= x;
                settings.AnchorAY -= y;
            }
            else
            {
                settings.AnchorBX -= x;
                settings.AnchorBY -= y;
            }

            Joints.NoteEdit();
            _stores.JointSolver?.Nets.Edited(entry >> 1, afresh: false);
        }

        NotePlaced(body.Index);
    }

    private void NotePlaced(int body)
    {
        Sleep.Disturb(body);
        Bodies.Flags[body] |= BodyFlags.Moved;
        Pairs.NoteAltered(body);
        if (!Queries.IsUsed)
        {
            return;
        }

        for (int collider = Colliders.First(body); collider >= 0; collider = Colliders.Next(collider))
        {
            for (int piece = Shapes.Colliders[collider].FirstPiece; piece >= 0; piece = Shapes.NextPiece[piece])
            {
                Queries.Changed(piece);
            }
        }
    }

    /// <summary>Lets a spring act in the step under way; only from <see cref="IStepHooks.ApplyForces"/>.</summary>
    public void ApplySpring(in SpringDef def)
    {
        if (Sleep.AsleepCount == 0 || Sleep.WakesBySpring(def.BodyA, def.BodyB))
        {
            _stores.Springs.Add(def);
        }
    }

    public ref ColliderInfo Collider(Handle collider) => ref Shapes.Require(collider, nameof(collider));
}
