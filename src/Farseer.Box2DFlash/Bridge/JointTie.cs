using Farseer.Engine.Joints;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;

namespace Box2D.Bridge;

/// <summary>A joint's equations in the engine: what they read, and what they gave.</summary>
internal sealed class JointTie
{
    /// <summary>Rows of a hinge or slider before its limits and motor.</summary>
    private const int FirstLimitRow = 2;

    private readonly World _engine;
    private readonly JointKind _kind;
    private Handle _handle;
    private bool _attached;
    private JointFlags _flags;

    public JointTie(World engine, JointKind kind, bool collideConnected)
    {
        _engine = engine;
        _kind = kind;
        _flags = JointFlags.Enabled | (collideConnected ? JointFlags.CollideConnected : JointFlags.None);
        Settings.MaxImpulse = double.PositiveInfinity;
        Settings.Breakpoint = double.PositiveInfinity;
        Settings.BreakForce = double.PositiveInfinity;
        Settings.BiasFactor = 1;
    }

    public JointSettings Settings;

    public bool Limit
    {
        get => (_flags & JointFlags.Limit) != 0;
        set => Set(JointFlags.Limit, value);
    }

    public bool Motor
    {
        get => (_flags & JointFlags.Motor) != 0;
        set => Set(JointFlags.Motor, value);
    }

    public bool Spring
    {
        get => (_flags & JointFlags.Spring) != 0;
        set => Set(JointFlags.Spring, value);
    }

    /// <summary>Force on the second body in the last step, newtons.</summary>
    public double ForceX => _attached ? _engine.JointState(_handle).ForceX : 0;

    public double ForceY => _attached ? _engine.JointState(_handle).ForceY : 0;

    /// <summary>Torque on the second body in the last step.</summary>
    public double Torque => _attached ? _engine.JointState(_handle).Torque : 0;

    /// <summary>What one row gave in the last substep.</summary>
    public double RowForce(int row) => _attached ? _engine.JointRowForce(_handle, row) : 0;

    /// <summary>What the motor gave.</summary>
    public double MotorForce => _attached && Motor ? _engine.JointRowForce(_handle, FirstLimitRow + (Limit ? 2 : 0)) : 0;

    /// <summary>What the limits gave, those of the lower one positive.</summary>
    public double LimitForce => _attached && Limit
        ? _engine.JointRowForce(_handle, FirstLimitRow) - _engine.JointRowForce(_handle, FirstLimitRow + 1)
        : 0;

    public void SetAnchors(BodyLink first, double x1, double y1, BodyLink second, double x2, double y2)
    {
        Settings.AnchorAX = x1 - first.CenterX;
        Settings.AnchorAY = y1 - first.CenterY;
        Settings.AnchorBX = x2 - second.CenterX;
        Settings.AnchorBY = y2 - second.CenterY;
    }

    public void Attach(BodyLink? first, BodyLink second)
    {
        _handle = _engine.CreateJoint(_kind, first?.Handle ?? World.WorldFrame, second.Handle, Settings, _flags);
        _attached = true;
    }

    public void Detach()
    {
        if (_attached)
        {
            _attached = false;
            _engine.DestroyJoint(_handle);
        }
    }

    public JointFlags Flags => _flags;

    /// <summary>All that the joint is made of, as the engine has it.</summary>
    public JointSettings Held => _attached ? _engine.Joints.Settings[_handle.Index] : Settings;

    /// <summary>Becomes what another one was.</summary>
    public void Put(in JointSettings settings, JointFlags flags)
    {
        Settings = settings;
        _flags = flags;
        if (_attached)
        {
            _engine.SetJoint(_handle, Settings, _flags);
        }
    }

    /// <summary>Hands changed settings to the engine, which keeps the anchors: they move with the centres of mass.</summary>
    public void Push(bool wakes, bool withAnchorA = false)
    {
        if (!_attached)
        {
            return;
        }

        JointSettings held = _engine.Joints.Settings[_handle.Index];
        if (!withAnchorA)
        {
            Settings.AnchorAX = held.AnchorAX;
            Settings.AnchorAY = held.AnchorAY;
        }

        Settings.AnchorBX = held.AnchorBX;
        Settings.AnchorBY = held.AnchorBY;
        _engine.SetJoint(_handle, Settings, _flags, wakes);
    }

    private void Set(JointFlags flag, bool value) => _flags = value ? _flags | flag : _flags & ~flag;

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Value(ref _handle);
        s.Value(ref _attached);
        s.Value(ref _flags);
        s.Value(ref Settings);
    }

    /// <summary>Lets go of a world that is about to be another one.</summary>
    public void TakeOut() => _attached = false;
}
