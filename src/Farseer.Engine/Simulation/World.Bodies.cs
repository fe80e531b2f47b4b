using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Solver;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Making, changing and removing bodies and colliders.</summary>
internal sealed partial class World
{
    private readonly Column<int> _firstCollider = new Column<int>();
    private readonly Column<int> _nextCollider = new Column<int>();
    private readonly Column<Handle> _deadBodies = new Column<Handle>();
    private readonly Column<Handle> _deadColliders = new Column<Handle>();
    private int _deadBodyCount;
    private int _deadColliderCount;
    private int _colliderOrder;

    /// <summary>
    /// Makes room for so many more bodies and colliders at once: columns that grow one by one have up to a quarter to spare in the end.
    /// </summary>
    /// <returns>One past the highest indices that these will have.</returns>
    public (int BodyEnd, int ColliderEnd) Expect(int bodies, int colliders)
    {
        int bodyEnd = Bodies.Ids.EndAfter(bodies);
        int colliderEnd = Shapes.ColliderIds.EndAfter(colliders);
        EnsureBodies(bodyEnd);
        if (Settings.AllowSleep)
        {
            _rest.EnsureBodies(bodyEnd);
        }

        EnsureColliders(colliderEnd);
        int pieceEnd = Shapes.PieceIds.EndAfter(colliders);
        Shapes.PieceSet.EnsureCapacity(pieceEnd);
        Proxies.Set.EnsureCapacity(pieceEnd);
        return (bodyEnd, colliderEnd);
    }

    public Handle CreateBody(in BodyDef def)
    {
        Purge();
        Handle handle = Bodies.Ids.Take();
        int body = handle.Index;
        EnsureBodies(Bodies.Ids.End);
        Bodies.State[body] = new BodyState { LinearVelocity = def.LinearVelocity, AngularVelocity = def.AngularVelocity, DeltaCos = 1 };
        Bodies.Pose[body] = new BodyPose { X = def.X, Y = def.Y, Angle = def.Angle };
        FinishBodies.UpdateRotor(ref Bodies.Pose[body]);
        Bodies.Force[body] = default;
        Bodies.Drag[body] = def.Drag;
        Bodies.Flags[body] = (def.Flags & ~(BodyFlags.Asleep | BodyFlags.Tied)) | BodyFlags.Alive | BodyFlags.Moved;
        Bodies.Visited.Set(body);
        _rest.Restart(body);
        Bodies.UserIndex[body] = def.UserIndex;
        Bodies.Motion[body] = new BodyMotion
        {
            StartX = def.LinearVelocity.X, StartY = def.LinearVelocity.Y, StartW = def.AngularVelocity,
        };
        Bodies.ClearResidual(body);
        _firstCollider[body] = -1;
        SetMass(handle, def.Mass, def.Inertia);
        if ((def.Flags & BodyFlags.Asleep) != 0)
        {
            PutToSleep(handle);
        }

        return handle;
    }

    /// <summary>Removes the body with its colliders and contacts; within a step the removal takes effect after it.</summary>
    public void DestroyBody(Handle body)
    {
        Require(body);
        for (int collider = _firstCollider[body.Index]; collider >= 0; collider = _nextCollider[collider])
        {
            if ((Shapes.Colliders[collider].Flags & ColliderFlags.Alive) != 0)
            {
                DestroyCollider(Shapes.ColliderIds.HandleOf(collider));
            }
        }

        WakeUp(body);
        DestroyJointsOf(body.Index);
        Bodies.Flags[body.Index] &= ~(BodyFlags.Alive | BodyFlags.Enabled);
        _deadBodies.EnsureCapacity(_deadBodyCount + 1);
        _deadBodies[_deadBodyCount++] = body;
    }

    public Handle CreateCollider(Handle body, ShapeGeometry shape, in ColliderDef def)
    {
        Require(body);
        Purge();
        if ((Bodies.Flags[body.Index] & BodyFlags.Moved) == 0)
        {
            Disturb(body.Index);
        }

        Handle handle = Shapes.ColliderIds.Take();
        int collider = handle.Index;
        _makesEnergy |= def.Restitution > 1;
        EnsureColliders(Shapes.ColliderIds.End);
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
        _roomIsDue = true;
        int piece = Shapes.AttachPieces(shape, body.Index, collider, def.Offset, StableMath.FromAngle(def.RotationOffset));
        _nextCollider[collider] = _firstCollider[body.Index];
        _firstCollider[body.Index] = collider;
        Bodies.Flags[body.Index] |= BodyFlags.Moved;
        Proxies.End = Shapes.PieceIds.End;
        Proxies.Set.EnsureCapacity(Proxies.End);
        for (; piece >= 0; piece = Shapes.NextPiece[piece])
        {
            Proxies.Info[piece] = default;
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
        Require(collider, Shapes.ColliderIds, nameof(collider));
        ref ColliderInfo info = ref Shapes.Colliders[collider.Index];
        Disturb(info.Body);
        info.Flags &= ~ColliderFlags.Alive;
        for (int piece = info.FirstPiece; piece >= 0; piece = Shapes.NextPiece[piece])
        {
            RemoveProxy(piece);
        }

        _deadColliders.EnsureCapacity(_deadColliderCount + 1);
        _deadColliders[_deadColliderCount++] = collider;
        _events.ColliderRemoved(this, collider.Index);
    }

    /// <summary>Teleports a body; legal at any time, also from hooks.</summary>
    public void SetPosition(Handle body, double x, double y)
    {
        Require(body);
        Bodies.Pose[body.Index].X = x;
        Bodies.Pose[body.Index].Y = y;
        NotePlaced(body.Index);
    }

    public void SetAngle(Handle body, double angle)
    {
        Require(body);
        ref BodyPose pose = ref Bodies.Pose[body.Index];
        pose.Angle = angle;
        FinishBodies.UpdateRotor(ref pose);
        NotePlaced(body.Index);
    }

    /// <summary>Mass and inertia, both above 0; the inverses follow from them and the body's kind.</summary>
    public void SetMass(Handle body, float mass, float inertia)
    {
        Require(body);
        Disturb(body.Index);
        bool moves = (Bodies.Flags[body.Index] & (BodyFlags.Static | BodyFlags.Kinematic)) == 0;
        BodyMass before = Bodies.Mass[body.Index];
        if (_graph.Degree(body.Index) > 0 && (mass < before.Mass || inertia < before.Inertia))
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
        const BodyFlags Sleep = BodyFlags.Asleep | BodyFlags.Handled;
        const BodyFlags Structural = BodyFlags.Static | BodyFlags.Kinematic | BodyFlags.Enabled;
        Require(body);
        BodyFlags old = Bodies.Flags[body.Index];
        BodyFlags now = (old & ~clear) | set;
        if ((set & BodyFlags.Enabled) != 0)
        {
            now &= ~BodyFlags.Quarantined;
        }

        if (((old ^ now) & Structural) != 0)
        {
            Wake(body.Index);
        }
        else if (old != now)
        {
            Disturb(body.Index);
        }

        now = (now & ~Sleep) | (Bodies.Flags[body.Index] & Sleep);
        Bodies.Flags[body.Index] = now;
        if (((old ^ now) & Structural) == 0)
        {
            return;
        }

        _bodiesSwitched = true;
        Bodies.Flags[body.Index] |= BodyFlags.Moved;
        BodyMass mass = Bodies.Mass[body.Index];
        SetMass(body, mass.Mass, mass.Inertia);
        if ((now & BodyFlags.Static) != 0)
        {
            Bodies.State[body.Index].LinearVelocity = Vector2.Zero;
            Bodies.State[body.Index].AngularVelocity = 0;
        }

        MarkStale(body.Index);
    }

    public bool IsLive(Handle body) => Bodies.Ids.IsLive(body) && (Bodies.Flags[body.Index] & BodyFlags.Alive) != 0;

    public ref ColliderInfo Collider(Handle collider)
    {
        Require(collider, Shapes.ColliderIds, nameof(collider));
        return ref Shapes.Colliders[collider.Index];
    }

    /// <summary>First collider of a body, -1: none.</summary>
    public int FirstCollider(int body) => _firstCollider[body];

    public int NextCollider(int collider) => _nextCollider[collider];

    private static void Require(Handle handle, IdPool ids, string name)
    {
        if (!ids.IsLive(handle))
        {
            throw new ArgumentException($"The handle {handle.Index}/{handle.Generation} names nothing in this world.", name);
        }
    }

    private void Require(Handle body) => Require(body, Bodies.Ids, nameof(body));

    private void EnsureBodies(int end)
    {
        Bodies.Set.EnsureCapacity(end);
        _graph.EnsureBodies(end);
        _firstCollider.EnsureCapacity(end);
    }

    private void EnsureColliders(int end)
    {
        Shapes.Colliders.EnsureCapacity(end);
        Shapes.Order.EnsureCapacity(end);
        _nextCollider.EnsureCapacity(end);
    }

    private void Unlink(int collider)
    {
        int body = Shapes.Colliders[collider].Body;
        if (_firstCollider[body] == collider)
        {
            _firstCollider[body] = _nextCollider[collider];
            return;
        }

        int at = _firstCollider[body];
        while (at >= 0 && _nextCollider[at] != collider)
        {
            at = _nextCollider[at];
        }

        System.Diagnostics.Debug.Assert(at >= 0, "a collider is in the list of its body");
        if (at >= 0)
        {
            _nextCollider[at] = _nextCollider[collider];
        }
    }
}
