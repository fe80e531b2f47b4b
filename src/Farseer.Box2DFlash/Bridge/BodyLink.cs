using System.Numerics;
using Box2D.Dynamics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;

namespace Box2D.Bridge;

/// <summary>
/// A body's state: in the columns of the engine while it is there, in fields of its own otherwise. The engine keeps the centre of
/// mass; the origin of the body, about which all shapes and joints are given, is found from it.
/// </summary>
internal sealed class BodyLink
{
    private readonly World _engine;
    private Handle _handle;
    private BodyPose _pose;
    private BodyState _state;
    private float _linearDamping;
    private float _angularDamping;
    private bool _keeps;
    private bool _sleepsAtFirst;

    public BodyLink(World engine, b2BodyDef def)
    {
        _engine = engine;
        _linearDamping = def.linearDamping;
        _angularDamping = def.angularDamping;
        _pose = new BodyPose { X = def.position.x, Y = def.position.y, Angle = def.angle };
        StableMath.SinCos(_pose.Angle, out double sin, out double cos);
        _pose.Cos = (float)cos;
        _pose.Sin = (float)sin;
        _state = new BodyState { DeltaCos = 1 };
    }

    public bool IsAttached { get; private set; }

    /// <summary>Whether it is in this slot of the engine.</summary>
    public bool IsIn(int slot) => IsAttached && _handle.Index == slot;

    /// <summary>Rates by which speed and spin die away, 1/s.</summary>
    public float LinearDamping
    {
        get => _linearDamping;
        set
        {
            _linearDamping = value;
            PushDamping();
        }
    }

    public float AngularDamping
    {
        get => _angularDamping;
        set
        {
            _angularDamping = value;
            PushDamping();
        }
    }

    /// <summary>Centre of mass in the body.</summary>
    public double CenterX { get; private set; }

    public double CenterY { get; private set; }

    public float Mass { get; private set; }

    /// <summary>About the centre of mass; 0: does not turn.</summary>
    public float Inertia { get; private set; }

    public bool IsStatic => Mass == 0 && Inertia == 0;

    public bool IsFrozen { get; private set; }

    public Handle Handle
    {
        get
        {
            Attach();
            return _handle;
        }
    }

    public int Index => _handle.Index;

    public double Angle => PoseRef.Angle;

    public double Sin => PoseRef.Sin;

    public double Cos => PoseRef.Cos;

    public double WorldCenterX => PoseRef.X;

    public double WorldCenterY => PoseRef.Y;

    public double OriginX => PoseRef.X - ((Cos * CenterX) - (Sin * CenterY));

    public double OriginY => PoseRef.Y - ((Sin * CenterX) + (Cos * CenterY));

    public Vector2 Velocity
    {
        get => _keeps ? _state.LinearVelocity : StateRef.LinearVelocity;
        set
        {
            _state.LinearVelocity = value;
            if (!_keeps)
            {
                StateRef.LinearVelocity = value;
            }
        }
    }

    public float Spin
    {
        get => _keeps ? _state.AngularVelocity : StateRef.AngularVelocity;
        set
        {
            _state.AngularVelocity = value;
            if (!_keeps)
            {
                StateRef.AngularVelocity = value;
            }
        }
    }

    private ref BodyPose PoseRef
    {
        get
        {
            if (IsAttached)
            {
                return ref _engine.Bodies.Pose[_handle.Index];
            }

            return ref _pose;
        }
    }

    private ref BodyState StateRef
    {
        get
        {
            if (IsAttached)
            {
                return ref _engine.Bodies.State[_handle.Index];
            }

            return ref _state;
        }
    }

    /// <summary>Takes the body into the engine if it is not there.</summary>
    public void Attach()
    {
        if (IsAttached)
        {
            return;
        }

        _handle = _engine.CreateBody(new BodyDef
        {
            X = _pose.X,
            Y = _pose.Y,
            Angle = _pose.Angle,
            LinearVelocity = _state.LinearVelocity,
            AngularVelocity = _state.AngularVelocity,
            Mass = 1,
            Inertia = 1,
            Flags = BodyFlags.Enabled | BodyFlags.Static,
        });
        IsAttached = true;
    }

    /// <summary>Takes the body out; what it was last stays to be read.</summary>
    public void Detach()
    {
        if (IsAttached)
        {
            _pose = PoseRef;
            _state = StateRef;
            IsAttached = false;
            _engine.DestroyBody(_handle);
        }
    }

    /// <summary>Sets mass, centre and inertia; the origin stays where it is. No mass and no inertia make the body static.</summary>
    public void SetMass(float mass, float inertia, double centerX, double centerY, bool keepVelocity)
    {
        Attach();
        if (centerX != CenterX || centerY != CenterY)
        {
            _engine.MoveCentre(_handle, centerX - CenterX, centerY - CenterY);
            CenterX = centerX;
            CenterY = centerY;
        }

        bool wasStatic = IsStatic;
        Mass = mass;
        Inertia = inertia;
        if (IsStatic)
        {
            if (!wasStatic)
            {
                if (keepVelocity)
                {
                    _state = StateRef;
                    _keeps = true;
                }

                _engine.SetFlags(_handle, BodyFlags.Static, BodyFlags.None);
            }

            return;
        }

        float engineMass = mass > 0 ? mass : float.PositiveInfinity;
        float engineInertia = inertia > 0 ? inertia : float.PositiveInfinity;
        _engine.SetMass(_handle, engineMass, engineInertia);
        PushDamping();
        if (wasStatic)
        {
            _engine.SetFlags(_handle, BodyFlags.None, BodyFlags.Static);
            if (_keeps)
            {
                _keeps = false;
                StateRef.LinearVelocity = _state.LinearVelocity;
                StateRef.AngularVelocity = _state.AngularVelocity;
            }

            if (_sleepsAtFirst)
            {
                _sleepsAtFirst = false;
                PutToSleep();
            }
        }
    }

    private void PushDamping()
    {
        if (IsAttached && !IsStatic)
        {
            _engine.Bodies.Drag[_handle.Index] = new BodyDrag
            {
                Linear = Mass > 0 ? _linearDamping * Mass : 0,
                Angular = Inertia > 0 ? _angularDamping * Inertia : 0,
            };
        }
    }

    /// <summary>A body that is not dynamic yet keeps that it is to sleep until it is.</summary>
    public bool IsSleeping => IsStatic ? _sleepsAtFirst : IsAttached && !_engine.Sleep.IsAwake(_handle);

    public void WakeUp()
    {
        _sleepsAtFirst = false;
        if (IsAttached && !IsStatic)
        {
            _engine.Sleep.WakeUp(_handle);
        }
    }

    public void PutToSleep()
    {
        if (IsStatic)
        {
            _sleepsAtFirst = true;
        }
        else if (!IsFrozen)
        {
            Velocity = default;
            Spin = 0;
            _engine.Sleep.PutToSleep(Handle);
        }
    }

    public void AllowSleep(bool allow) =>
        _engine.SetFlags(Handle, allow ? BodyFlags.None : BodyFlags.NeverSleeps, allow ? BodyFlags.NeverSleeps : BodyFlags.None);

    public bool MaySleep => !IsAttached || (_engine.Bodies.Flags[_handle.Index] & BodyFlags.NeverSleeps) == 0;

    /// <summary>Whether the body is kept from passing through moving bodies too.</summary>
    public bool IsBullet
    {
        get => IsAttached && (_engine.Bodies.Flags[_handle.Index] & BodyFlags.Bullet) != 0;
        set => _engine.SetFlags(Handle, value ? BodyFlags.Bullet : BodyFlags.None, value ? BodyFlags.None : BodyFlags.Bullet);
    }

    /// <summary>Moves the origin.</summary>
    public void SetTransform(double x, double y, double angle)
    {
        Attach();
        _engine.SetAngle(_handle, angle);
        _engine.SetPosition(_handle, x + ((Cos * CenterX) - (Sin * CenterY)), y + ((Sin * CenterX) + (Cos * CenterY)));
    }

    /// <summary>Stops the body and takes it out of all collision, for good.</summary>
    public void Freeze()
    {
        IsFrozen = true;
        StateRef.LinearVelocity = default;
        StateRef.AngularVelocity = 0;
        _engine.SetFlags(Handle, BodyFlags.None, BodyFlags.Enabled);
    }

    public void AddForce(double x, double y, double torque)
    {
        // A body that is destroyed, or not in the engine because it is static, has nothing to be moved: it must not come back for this.
        if (!IsAttached)
        {
            return;
        }

        ref BodyForce force = ref _engine.Bodies.Force[Handle.Index];
        force.Force += new Vector2((float)x, (float)y);
        force.Torque += (float)torque;
    }

    /// <summary>
    /// Cuts the speeds that a step of the original would begin with: what is above the limit after gravity and forces. The engine
    /// will add gravity again, so it is taken off here.
    /// </summary>
    public void CutSpeed(Vector2 gravity, float dt, float most, float mostSpin)
    {
        ref BodyForce force = ref _engine.Bodies.Force[Handle.Index];
        ref BodyState state = ref StateRef;
        float inverseMass = Mass > 0 ? 1f / Mass : 0;
        Vector2 next = state.LinearVelocity + (dt * (gravity + (inverseMass * force.Force)));
        float speed = next.Length();
        if (speed > most)
        {
            state.LinearVelocity = (next * (most / speed)) - (dt * gravity);
            force.Force = default;
        }

        float spin = state.AngularVelocity + (Inertia > 0 ? dt * force.Torque / Inertia : 0);
        if (System.Math.Abs(spin) > mostSpin)
        {
            state.AngularVelocity = spin > 0 ? mostSpin : -mostSpin;
            force.Torque = 0;
        }
    }

    public void AddImpulse(double x, double y, double angular)
    {
        ref BodyState state = ref StateRef;
        double inverseMass = Mass > 0 ? 1.0 / Mass : 0;
        double inverseInertia = Inertia > 0 ? 1.0 / Inertia : 0;
        state.LinearVelocity += new Vector2((float)(inverseMass * x), (float)(inverseMass * y));
        state.AngularVelocity += (float)(inverseInertia * angular);
    }

    /// <summary>Arm from the centre of mass to a point of the world.</summary>
    public void Arm(double x, double y, out double rx, out double ry)
    {
        rx = x - PoseRef.X;
        ry = y - PoseRef.Y;
    }

    public void ToWorld(double x, double y, out double worldX, out double worldY)
    {
        worldX = OriginX + ((Cos * x) - (Sin * y));
        worldY = OriginY + ((Sin * x) + (Cos * y));
    }

    public void ToLocal(double worldX, double worldY, out double x, out double y)
    {
        double dx = worldX - OriginX;
        double dy = worldY - OriginY;
        x = (Cos * dx) + (Sin * dy);
        y = (Cos * dy) - (Sin * dx);
    }

    /// <summary>Static, it keeps the velocity that it had before, and does not move by it.</summary>
    public bool KeepsVelocity => _keeps;

    /// <summary>Forces that wait for the next step.</summary>
    public BodyForce Force
    {
        get => IsAttached ? _engine.Bodies.Force[_handle.Index] : default;
        set
        {
            if (IsAttached)
            {
                _engine.Bodies.Force[_handle.Index] = value;
            }
        }
    }

    /// <summary>Puts the centre of mass to a place, in full precision.</summary>
    public void Put(double worldCenterX, double worldCenterY, double angle)
    {
        if (angle != Angle)
        {
            Attach();
            _engine.SetAngle(_handle, angle);
        }

        if (worldCenterX != WorldCenterX || worldCenterY != WorldCenterY)
        {
            Attach();
            _engine.SetPosition(_handle, worldCenterX, worldCenterY);
        }
    }

    /// <summary>Keeps a velocity from a time when it was not static.</summary>
    public void KeepVelocity(Vector2 velocity, float spin)
    {
        _keeps = true;
        _state.LinearVelocity = velocity;
        _state.AngularVelocity = spin;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Value(ref _handle);
        s.Value(ref _pose);
        s.Value(ref _state);
        s.Value(ref _linearDamping);
        s.Value(ref _angularDamping);
        s.Value(ref _keeps);
        s.Value(ref _sleepsAtFirst);
        IsAttached = s.Value(IsAttached);
        CenterX = s.Value(CenterX);
        CenterY = s.Value(CenterY);
        Mass = s.Value(Mass);
        Inertia = s.Value(Inertia);
        IsFrozen = s.Value(IsFrozen);
    }

    /// <summary>Takes the state out of a world that is about to be another one.</summary>
    public void TakeOut()
    {
        if (IsAttached)
        {
            _pose = PoseRef;
            _state = StateRef;
            IsAttached = false;
        }
    }
}
