using System.Numerics;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Bodies;

/// <summary>All bodies, in columns grouped by who reads them together. A slot keeps its index for the life of the body.</summary>
internal sealed class BodyStore
{
    private readonly ColumnSet _set = new ColumnSet();

    public BodyStore()
    {
        State = _set.Add<BodyState>();
        Pose = _set.Add<BodyPose>();
        Mass = _set.Add<BodyMass>();
        Force = _set.Add<BodyForce>();
        Drag = _set.Add<BodyDrag>();
        Flags = _set.Add<BodyFlags>();
        UserIndex = _set.Add<int>();
        Motion = _set.Add<BodyMotion>();
        Drive = _set.Add<BodyDrive>();
        Size = _set.Add<BodySize>();
    }

    public IdPool Ids { get; } = new IdPool();

    /// <summary>The bodies that a step looks at: all but those asleep. It skips whole words of them.</summary>
    public BitSet Visited { get; } = new BitSet();

    public ColumnSet Set => _set;

    public Column<BodyState> State { get; }

    public Column<BodyPose> Pose { get; }

    public Column<BodyMass> Mass { get; }

    public Column<BodyForce> Force { get; }

    public Column<BodyDrag> Drag { get; }

    public Column<BodyFlags> Flags { get; }

    public Column<int> UserIndex { get; }

    public Column<BodyMotion> Motion { get; }

    public Column<BodyDrive> Drive { get; }

    public Column<BodySize> Size { get; }

    /// <summary>
    /// Of bodies that have flown freely: see <see cref="EnsureResiduals"/>. Those of others, and what lies beyond its end, are 0.
    /// </summary>
    public Column<BodyResidual> Residual { get; } = new Column<BodyResidual>();

    /// <summary>Makes room for the residuals of all bodies, before one flies: in a pile none does.</summary>
    public void EnsureResiduals() => Residual.EnsureCapacity(State.Capacity);

    public bool IsMovable(int body) => (Flags[body] & (BodyFlags.Static | BodyFlags.Kinematic)) == 0;

    public bool IsBullet(int body) => (Flags[body] & BodyFlags.Bullet) != 0;

    public bool IsAsleep(int body) => (Flags[body] & BodyFlags.Asleep) != 0;

    /// <summary>Whether nothing moves a body: it sleeps, or is static or kinematic and has no velocity.</summary>
    public bool IsStill(int body)
    {
        BodyFlags flags = Flags[body];
        if ((flags & (BodyFlags.Static | BodyFlags.Kinematic)) != 0)
        {
            ref BodyState state = ref State[body];
            return state.LinearVelocity == Vector2.Zero && state.AngularVelocity == 0;
        }

        return (flags & BodyFlags.Asleep) != 0 || (flags & BodyFlags.Enabled) == 0;
    }

    /// <summary>A body begins anew, or was stopped.</summary>
    public void ClearResidual(int body)
    {
        if (body < Residual.Capacity)
        {
            Residual[body] = default;
        }
    }

    /// <summary>64-bit hash (FNV-1a) of the poses and velocities of all live bodies, in order; equal on every platform.</summary>
    public unsafe ulong MotionHash()
    {
        ulong hash = 14695981039346656037UL;
        for (int body = 1; body < Ids.End; body++)
        {
            if ((Flags[body] & BodyFlags.Alive) != 0)
            {
                BodyPose pose = Pose[body];
                BodyState state = State[body];
                hash = Hash(hash, *(ulong*)&pose.X);
                hash = Hash(hash, *(ulong*)&pose.Y);
                hash = Hash(hash, *(ulong*)&pose.Angle);
                hash = Hash(hash, (uint)FloatBits.ToInt(state.LinearVelocity.X));
                hash = Hash(hash, (uint)FloatBits.ToInt(state.LinearVelocity.Y));
                hash = Hash(hash, (uint)FloatBits.ToInt(state.AngularVelocity));
            }
        }

        return hash;
    }

    private static ulong Hash(ulong hash, ulong value)
    {
        for (int i = 0; i < 8; i++)
        {
            hash = (hash ^ (value & 0xFF)) * 1099511628211UL;
            value >>= 8;
        }

        return hash;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        Ids.Visit(s);
        Visited.Visit(s);
        s.Column(State);
        s.Column(Pose);
        s.Column(Mass);
        s.Column(Force);
        s.Column(Drag);
        s.Column(Flags);
        s.Column(UserIndex);
        s.Column(Motion);
        s.Column(Drive);
        s.Column(Size);
        s.Column(Residual);
    }
}
