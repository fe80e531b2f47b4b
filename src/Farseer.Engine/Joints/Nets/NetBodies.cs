using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Nets;

/// <summary>
/// What the pivots of a body share: its place at the step's start, its turn to the middle of the step, its inverse masses.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal struct NetPose
{
    public double X;
    public double Y;

    /// <summary>Where it is foreseen to have turned to in the middle of the step.</summary>
    public double Angle;
    public double Cos;
    public double Sin;
    public float InverseMass;
    public float InverseInertia;
}

/// <summary>The bodies of nets, and what their joints on lanes hold on to.</summary>
internal sealed unsafe class NetBodies
{
    private readonly Column<int> _degree = new Column<int>();
    private readonly Column<int> _list = new Column<int>();
    private readonly Column<float> _kicks = new Column<float>();
    private readonly Column<NetPose> _poses = new Column<NetPose>();
    private readonly Column<byte> _listed = new Column<byte>();
    private readonly Column<byte> _bound = new Column<byte>();
    [NotState(Why.Elsewhere)]
    private NetSearch _nets = new NetSearch();
    private int _end;
    private int _count;

    /// <summary>By body; valid for the bodies of nets and the ends of their joints, within a step.</summary>
    public NetPose* Poses => _poses.Pointer;

    public bool Any => _count > 0;

    public bool Holds(int body) => body < _end && _listed[body] != 0;

    /// <summary>Bodies, filled up to whole bundles with body 0.</summary>
    public int PaddedCount => (_count + WideLanes.BundleLanes - 1) / WideLanes.BundleLanes * WideLanes.BundleLanes;

    public void EnsureBodies(int end)
    {
        _degree.EnsureCapacity(end);
        _poses.EnsureCapacity(end);
        _listed.EnsureCapacity(end);
        _bound.EnsureCapacity(end);
        _end = Math.Max(_end, end);
    }

    public void Count(int body, int change) => _degree[body] += change;

    /// <summary>Lists the bodies anew: joints came or went.</summary>
    public void List(NetSearch nets)
    {
        _nets = nets;
        _list.EnsureCapacity(_end + WideLanes.BundleLanes);
        _kicks.EnsureCapacity(_end + WideLanes.BundleLanes);
        _count = 0;
        for (int i = 0; i < _end; i++)
        {
            bool listed = _degree[i] > 0 || nets.IsNet(i);
            _listed[i] = listed ? (byte)1 : (byte)0;
            if (listed)
            {
                _list[_count++] = i;
            }
        }

        for (int i = _count; i % WideLanes.BundleLanes != 0; i++)
        {
            _list[i] = 0;
            _kicks[i] = 0;
        }
    }

    /// <summary>All nets are free, until something binds them.</summary>
    public void Release()
    {
        for (int i = 0; i < _count; i++)
        {
            _bound[_list[i]] = 0;
        }
    }

    /// <summary>Something acts on the body's net in this step.</summary>
    public void Bind(int body)
    {
        if (_nets.IsNet(body))
        {
            _bound[_nets.RootOf(body)] = 1;
        }
    }

    /// <summary>Binds the nets of which a body touches something.</summary>
    public void BindTouched(int* touches)
    {
        for (int i = 0; i < _count; i++)
        {
            if (touches[_list[i]] > 0)
            {
                Bind(_list[i]);
            }
        }
    }

    /// <summary>
    /// Places at the start of the step, and which bodies take half of gravity and forces before they move and half after, as free
    /// trees do: those of nets that fly, as a whole. What a net hangs by would feel the halves in turn, one joint further away with
    /// each sweep, and all of it would show half of g·h as a speed at rest.
    /// </summary>
    public void Start(in JointStep step, int from, int to)
    {
        for (int i = from; i < Math.Min(to, _count); i++)
        {
            int body = _list[i];
            bool moves = step.Moves[body] != 0;
            bool free = moves && _nets.IsNet(body) && !_nets.IsAnchored(body) && _bound[_nets.RootOf(body)] == 0;
            _kicks[i] = free ? 0.5f : 0;
            ref BodyPose pose = ref step.Bodies.Pose[body];
            ref BodyState state = ref step.Bodies.State[body];
            NetPose* place = _poses.Pointer + body;
            place->X = pose.X;
            place->Y = pose.Y;
            bool still = (step.Bodies.Flags[body] & (BodyFlags.Enabled | BodyFlags.Kinematic)) != (BodyFlags.Enabled | BodyFlags.Kinematic);
            double angle = moves || !still ? pose.Angle + step.Bodies.Drive[body].Lead : pose.Angle;
            place->Angle = angle;
            place->InverseMass = moves ? step.Bodies.Mass[body].InverseMass : 0;
            place->InverseInertia = moves ? step.Bodies.Mass[body].InverseInertia : 0;
        }

        TurnPlaces(from, Math.Min(to, _count));
    }

    /// <summary>Sines and cosines of the places, four at a time.</summary>
    private void TurnPlaces(int from, int to)
    {
        double* angles = stackalloc double[3 * StableMath.Lanes];
        double* sin = angles + StableMath.Lanes;
        double* cos = sin + StableMath.Lanes;
        NetPose* poses = _poses.Pointer;
        for (int i = from; i < to; i += StableMath.Lanes)
        {
            int count = Math.Min(StableMath.Lanes, to - i);
            for (int k = 0; k < StableMath.Lanes; k++)
            {
                angles[k] = k < count ? poses[_list[i + k]].Angle : 0;
            }

            StableMath.SinCos(angles, sin, cos);
            for (int k = 0; k < count; k++)
            {
                poses[_list[i + k]].Sin = sin[k];
                poses[_list[i + k]].Cos = cos[k];
            }
        }
    }

    /// <summary>
    /// The noted change of velocity is dropped, so that positions move by plain h·v; and the bodies of free nets give back half of
    /// what gravity and forces gave them, until they have moved.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public void Enter(BodyStore bodies, int from, int to)
    {
        BodyState* states = bodies.State.Pointer;
        float* motions = (float*)bodies.Motion.Pointer;
        for (int i = from; i < to; i += Wide.Count)
        {
            int* index = _list.Pointer + i;
            BodyLanes.Scatter(motions + 4, index, Wide.Zero, Wide.Zero, Wide.Zero, Wide.Zero);
            Kick(states, bodies.Drive.Pointer, index, Wide.Zero - Wide.Load(_kicks.Pointer + i));
        }
    }

    /// <summary>
    /// The other half; and bodies that turned further than the integrator follows for the sake of contacts are turned in full.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public void Moved(BodyStore bodies, int from, int to)
    {
        BodyState* states = bodies.State.Pointer;
        Wide most = Wide.Splat(Integrator.LargestTurn);
        for (int i = from; i < to; i += Wide.Count)
        {
            int* index = _list.Pointer + i;
            Kick(states, bodies.Drive.Pointer, index, Wide.Load(_kicks.Pointer + i));
            BodyLanes.Gather((float*)bodies.Motion.Pointer, index, out _, out _, out _, out Wide turned);
            int far = WideLanes.Bits(Wide.Abs(turned) > most);
            for (int lane = 0; far != 0; lane++, far >>= 1)
            {
                if ((far & 1) != 0)
                {
                    StableMath.SinCos(bodies.Motion[index[lane]].Turned, out double sin, out double cos);
                    states[index[lane]].DeltaSin = (float)sin;
                    states[index[lane]].DeltaCos = (float)cos;
                }
            }
        }
    }

    /// <summary>
    /// Adds a share of what gravity and forces give in a substep. Of nets that hang, which have none, nothing is read or written.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Kick(BodyState* states, BodyDrive* drives, int* index, Wide share)
    {
        WideMask kicked = Wide.Abs(share) > Wide.Zero;
        if (!WideLanes.Any(kicked))
        {
            return;
        }

        BodyLanes.Gather((float*)states, index, (float*)drives, index, out FourColumns v, out FourColumns drive);
        BodyLanes.Scatter(
            (float*)states,
            index,
            Wide.Select(kicked, v.A + (share * drive.A), v.A),
            Wide.Select(kicked, v.B + (share * drive.B), v.B),
            Wide.Select(kicked, v.C + (share * drive.C), v.C),
            Wide.Zero);
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_degree);
        s.Column(_list);
        s.Column(_kicks);
        s.Column(_poses);
        s.Column(_listed);
        s.Column(_bound);
        s.Value(ref _end);
        s.Value(ref _count);
    }
}
