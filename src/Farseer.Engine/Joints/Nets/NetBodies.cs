using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.Joints.Nets;

/// <summary>What the pivots of a body share: its place at the step's start, its turn to the middle of the step, its inverse masses.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct NetPose
{
    public double X;
    public double Y;
    public double Cos;
    public double Sin;
    public float InverseMass;
    public float InverseInertia;
}

/// <summary>The bodies that have pivots on lanes.</summary>
internal sealed unsafe class NetBodies
{
    private readonly Column<int> _degree = new Column<int>();
    private readonly Column<int> _list = new Column<int>();
    private readonly Column<float> _kicks = new Column<float>();
    private readonly Column<NetPose> _poses = new Column<NetPose>();
    private int _end;
    private int _count;

    /// <summary>By body; valid for the ends of pivots, within a step.</summary>
    public NetPose* Poses => _poses.Pointer;

    public bool Holds(int body) => body < _end && _degree[body] > 0;

    /// <summary>Bodies, filled up to whole bundles with body 0.</summary>
    public int PaddedCount => (_count + WideLanes.BundleLanes - 1) / WideLanes.BundleLanes * WideLanes.BundleLanes;

    public void EnsureBodies(int end)
    {
        _degree.EnsureCapacity(end);
        _poses.EnsureCapacity(end);
        _end = Math.Max(_end, end);
    }

    public void Count(int body, int change) => _degree[body] += change;

    /// <summary>Lists the bodies anew: pivots came or went.</summary>
    public void List()
    {
        _list.EnsureCapacity(_end + WideLanes.BundleLanes);
        _kicks.EnsureCapacity(_end + WideLanes.BundleLanes);
        _count = 0;
        for (int i = 0; i < _end; i++)
        {
            if (_degree[i] > 0)
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

    /// <summary>Places at the start of the step, and which bodies take half of their forces before they move; see the joint solver.</summary>
    public void Start(in JointStep step, JointForest forest, int from, int to)
    {
        for (int i = from; i < Math.Min(to, _count); i++)
        {
            int body = _list[i];
            bool moves = step.Moves[body] != 0;
            bool free = moves && step.Touches[body] == 0 && forest.NodeOf(body) < 0;
            _kicks[i] = free ? 0.5f : 0;
            ref BodyPose pose = ref step.Bodies.Pose[body];
            ref BodyState state = ref step.Bodies.State[body];
            NetPose* place = _poses.Pointer + body;
            place->X = pose.X;
            place->Y = pose.Y;
            bool still = (step.Bodies.Flags[body] & (BodyFlags.Enabled | BodyFlags.Kinematic)) != (BodyFlags.Enabled | BodyFlags.Kinematic);
            double angle = moves || !still ? pose.Angle + step.Bodies.Drive[body].Lead : pose.Angle;
            StableMath.SinCos(angle, out place->Sin, out place->Cos);
            place->InverseMass = moves ? step.Bodies.Mass[body].InverseMass : 0;
            place->InverseInertia = moves ? step.Bodies.Mass[body].InverseInertia : 0;
        }
    }

    /// <summary>
    /// The noted change of velocity is dropped, so that positions move by plain h·v; and bodies that nothing touches give back half of
    /// what gravity and forces gave them, until they have moved. See <see cref="JointSolver"/>.
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

    /// <summary>The other half; and bodies that turned further than the integrator follows for the sake of contacts are turned in full.</summary>
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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Kick(BodyState* states, BodyDrive* drives, int* index, Wide share)
    {
        BodyLanes.GatherVelocity(states, index, out WideVelocity v);
        BodyLanes.Gather((float*)drives, index, out Wide x, out Wide y, out Wide w, out _);
        v.X = v.X + (share * x);
        v.Y = v.Y + (share * y);
        v.W = v.W + (share * w);
        BodyLanes.ScatterVelocity(states, index, v);
    }
}
