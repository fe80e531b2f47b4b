using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Where a body's state is: in its own fields while it belongs to no world, otherwise in the columns of the world. The
/// references are formed anew on every use, since columns move when they grow. A part of the body: it is never copied.
/// </summary>
internal struct BodyLink
{
    /// <summary>Whether it is in a state, and since when it has been as it is.</summary>
    public StateMark Mark;

    /// <summary>Null while the body is simulated: then all of it is in the columns.</summary>
    private LooseBody? _loose = new LooseBody();
    private World? _world;
    private Handle _handle;

    public BodyLink()
    {
    }

    /// <summary>The body is to be put to sleep as soon as it is in a world.</summary>
    public bool StartsAsleep { get; private set; }

    public bool IsAwake => _world is null ? !StartsAsleep : _world.Sleep.IsAwake(_handle);

    /// <summary>The state, for somebody who may set the velocity: that wakes a body.</summary>
    public ref BodyState MotionRef
    {
        get
        {
            _world?.Sleep.NoteHandled(_handle.Index);
            return ref StateRef;
        }
    }

    /// <summary>What the user asked for; the world may hold the body as static on top while it is not simulated itself.</summary>
    public BodyFlags UserFlags { get; set; }

    /// <summary>False while only geoms of the body are in the simulator: then it is an obstacle that nothing moves.</summary>
    public bool IsSimulated { get; private set; }

    /// <summary>How many colliders the body carries in the world.</summary>
    public int Colliders { get; set => Mark.Set(ref field, value); }

    /// <summary>How many joints hold the body in the world.</summary>
    public int Joints { get; set => Mark.Set(ref field, value); }

    /// <summary>The engine's joint that keeps the body on a line or at a point; none: the default.</summary>
    public Handle Rail { get; set => Mark.Set(ref field, value); }

    /// <summary>Since when a state has of it what it has now; it never has where there are columns of its own.</summary>
    public long ChangedIn => _loose is null ? Mark.ChangedIn : long.MaxValue;

    /// <summary>Something in the world needs the body.</summary>
    public bool IsUsed => Colliders > 0 || Joints > 0;

    public World? World => _world;

    /// <summary>It has a place in a world.</summary>
    public bool IsAttached => _world is not null;

    /// <summary>That place.</summary>
    public int Place => _handle.Index;

    public Handle Handle => _handle;

    /// <summary>State outside of a world; of an obstacle that nothing moves, that to which it comes back.</summary>
    public ref BodyState State => ref _loose!.State;

    public ref BodyPose Pose => ref _loose!.Pose;

    public ref BodyMass Mass => ref _loose!.Mass;

    public ref BodyForce Force => ref _loose!.Force;

    public ref BodyDrag Drag => ref _loose!.Drag;

    public ref BodyState StateRef => ref (_world is null ? ref State : ref _world.Bodies.State[_handle.Index]);

    public ref BodyPose PoseRef => ref (_world is null ? ref Pose : ref _world.Bodies.Pose[_handle.Index]);

    public ref BodyMass MassRef => ref (_world is null ? ref Mass : ref _world.Bodies.Mass[_handle.Index]);

    public ref BodyForce ForceRef => ref (_world is null ? ref Force : ref _world.Bodies.Force[_handle.Index]);

    public ref BodyDrag DragRef => ref (_world is null ? ref Drag : ref _world.Bodies.Drag[_handle.Index]);

    /// <summary>Gravity pulls otherwise at the body: by a force, and not by itself.</summary>
    public bool IsPulledApart { get; set => Mark.Set(ref field, value); }

    private BodyFlags EngineFlags =>
        (IsSimulated ? UserFlags : UserFlags | BodyFlags.Static) | (IsPulledApart ? BodyFlags.IgnoreGravity : BodyFlags.None);

    /// <summary>Moves the state into the columns of <paramref name="world"/>.</summary>
    public void Attach(World world, bool isSimulated)
    {
        Mark.Change();
        IsSimulated = isSimulated;
        _handle = world.CreateBody(new BodyDef
        {
            X = Pose.X,
            Y = Pose.Y,
            Angle = Pose.Angle,
            LinearVelocity = State.LinearVelocity,
            AngularVelocity = State.AngularVelocity,
            Mass = Mass.Mass,
            Inertia = Mass.Inertia,
            Drag = Drag,
            Flags = EngineFlags | (StartsAsleep ? BodyFlags.Asleep : BodyFlags.None),
        });
        StartsAsleep = false;
        _world = world;
        if (!isSimulated)
        {
            StateRef.LinearVelocity = default;
            StateRef.AngularVelocity = 0;
        }

        ForceRef = Force;
        if (isSimulated)
        {
            _loose = null;
        }
    }

    /// <summary>Moves the state back out of the columns and gives the slot up.</summary>
    public void Detach()
    {
        World world = _world!;
        Handle handle = _handle;
        LeaveColumns();
        world.DestroyBody(handle);
    }

    public void SetSimulated(bool value)
    {
        if (IsSimulated == value)
        {
            return;
        }

        Mark.Change();

        if (value)
        {
            IsSimulated = true;
            PushFlags();
            StateRef.LinearVelocity = State.LinearVelocity;
            StateRef.AngularVelocity = State.AngularVelocity;
            _loose = null;
        }
        else
        {
            // As an obstacle the body stands still; it takes its velocity up again when it comes back.
            _loose = new LooseBody();
            State = StateRef;
            IsSimulated = false;
            PushFlags();
        }
    }

    public void SetUserFlags(BodyFlags flags)
    {
        Mark.Change();
        UserFlags = flags;
        PushFlags();
    }

    public void SetMass(float mass, float inertia)
    {
        if (_world is null)
        {
            Mass.Mass = mass;
            Mass.Inertia = inertia;
        }
        else
        {
            _world.SetMass(_handle, mass, inertia);
        }
    }

    public void SetPosition(double x, double y)
    {
        if (_world is null)
        {
            Pose.X = x;
            Pose.Y = y;
        }
        else
        {
            _world.SetPosition(_handle, x, y);
        }
    }

    public void SetAngle(double angle)
    {
        if (_world is null)
        {
            Pose.Angle = angle;
            StableMath.SinCos(angle, out double sin, out double cos);
            Pose.Cos = (float)cos;
            Pose.Sin = (float)sin;
        }
        else
        {
            _world.SetAngle(_handle, angle);
        }
    }

    public void WakeUp()
    {
        Mark.Change();
        StartsAsleep = false;
        _world?.Sleep.WakeUp(_handle);
    }

    public void PutToSleep()
    {
        if (_world is null)
        {
            Mark.Change();
            StartsAsleep = true;
        }
        else
        {
            _world.Sleep.PutToSleep(_handle);
        }
    }

    private void PushFlags()
    {
        if (_world is not null)
        {
            const BodyFlags Owned =
                BodyFlags.Enabled | BodyFlags.Static | BodyFlags.Kinematic | BodyFlags.IgnoreGravity | BodyFlags.QuadraticDrag
                | BodyFlags.NeverSleeps | BodyFlags.Bullet | BodyFlags.Discrete | BodyFlags.Substeps;
            BodyFlags flags = EngineFlags;
            _world.SetFlags(_handle, flags & Owned, Owned & ~flags);
        }
    }

    /// <summary>A body that is in no world.</summary>
    private sealed class LooseBody
    {
        public BodyState State;
        public BodyPose Pose;
        public BodyMass Mass;
        public BodyForce Force;
        public BodyDrag Drag;
    }

    /// <summary>Writes, or reads, what later updates read of it.</summary>
    public void Visit(StateStream s)
    {
        if (s.IsReading)
        {
            Mark.Change();
        }

        s.Reference(ref _world);
        s.Value(ref _handle);
        StartsAsleep = s.Value(StartsAsleep);
        UserFlags = s.Value(UserFlags);
        IsSimulated = s.Value(IsSimulated);
        Colliders = s.Value(Colliders);
        Joints = s.Value(Joints);
        Rail = s.Value(Rail);
        IsPulledApart = s.Value(IsPulledApart);
        if (!s.Value(_loose is not null))
        {
            _loose = null;
            return;
        }

        _loose ??= new LooseBody();
        s.Value(ref _loose.State);
        s.Value(ref _loose.Pose);
        s.Value(ref _loose.Mass);
        s.Value(ref _loose.Force);
        s.Value(ref _loose.Drag);
    }

    /// <summary>Takes the state out of the columns of a world that is about to be another one.</summary>
    public void TakeOut()
    {
        LeaveColumns();
        Colliders = 0;
        Joints = 0;
    }

    private void LeaveColumns()
    {
        Mark.Change();
        if (_world is not null)
        {
            _loose ??= new LooseBody();
            if (IsSimulated)
            {
                State = StateRef;
            }

            Pose = PoseRef;
            Mass = MassRef;
            Force = ForceRef;
            Drag = DragRef;
        }

        Rail = default;
        _world = null;
        _handle = default;
        IsSimulated = false;
    }
}
