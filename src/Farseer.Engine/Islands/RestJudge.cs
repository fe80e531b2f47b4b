using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Settings;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>What the judgement of a step needs to know.</summary>
[NotState(Why.OfOneStep)]
internal unsafe struct RestInput
{
    public BodyStore Bodies;
    public WorldSettings Settings;

    /// <summary>Bodies that can move, and whether contacts and joints may move them.</summary>
    public int* Active;
    public int ActiveCount;
    public byte* Moves;

    /// <summary>Contacts of each body, and the islands that these make.</summary>
    public int* Degrees;
    public IslandStore Islands;
    public float Dt;
}

/// <summary>
/// Finds out which groups of bodies rest. A body rests as long as it stays where it was, within a small share of its size: that asks
/// nothing of its velocity, which trembles, and lets no slow but steady motion pass. What trembles more, as in a heap in which corners
/// slip, or rolls to and fro, rests as well if it stays within a larger share for longer. Under gravity the share is also one of the
/// way that a body falls in the time to sleep: at the top of its flight it is in no case long enough within that, however large it is.
/// </summary>
internal sealed unsafe class RestJudge : IStageWork
{
    /// <summary>A body flying freely goes through at least 1/8 of g·T² in the time to sleep; it rests within this share of it.</summary>
    private const float FallShare = 1f / 1024;

    /// <summary>
    /// The longer watch: so many times to sleep, within so many times the share, and at most within what nobody sees. What dies away within
    /// a second has gone through almost all of its way by then, so the larger share costs nothing of where it ends.
    /// </summary>
    private const float LongTimes = 8f;
    private const float LongShares = 64f;
    private const float LargestLongShare = 1f / 256;

    /// <summary>Share of the room that is rounding: a thousand million times the time to sleep would be needed to leave it.</summary>
    private const float RoundingShare = 1f / (1 << 30);

    /// <summary>Bodies that are worth another worker's while, some 1 µs.</summary>
    private const int LeastBodies = 128;

    private readonly Column<RestRecord> _records = new Column<RestRecord>();
    private readonly Column<int> _parent = new Column<int>();
    private readonly Column<int> _firstOfIsland = new Column<int>();
    private readonly Column<float> _least = new Column<float>();
    private readonly IndexList _resting = new IndexList();
    private RestInput _input;
    private bool _anyReady;

    /// <summary>What may fall asleep, after <see cref="Close"/>.</summary>
    public IndexList Resting => _resting;

    /// <summary>A body has rested long enough, in the last step or before.</summary>
    public bool AnyRested { get; private set; }

    /// <summary>Makes room for groups of so many bodies.</summary>
    public void Reserve(int bodies)
    {
        _parent.EnsureCapacity(bodies);
        _least.EnsureCapacity(bodies);
        _firstOfIsland.EnsureCapacity(bodies);
        _resting.Reserve(bodies);
    }

    public void EnsureBodies(int end) => _records.EnsureCapacity(end);

    /// <summary>The body was disturbed: it must rest anew.</summary>
    public void Restart(int body)
    {
        if (body < _records.Capacity)
        {
            _records[body].Near.Time = 0;
            _records[body].Far.Time = 0;
        }
    }

    /// <summary>Follows the bodies of a step.</summary>
    /// <returns>True if one of them has, in this step, rested long enough: a group can be ready only then, or if it has changed.</returns>
    public bool Watch(StageRunner runner, in RestInput input)
    {
        EnsureBodies(input.Bodies.Ids.End);
        _input = input;
        _anyReady = false;
        AnyRested = false;
        runner.Run(this, input.ActiveCount, LeastBodies);
        return _anyReady;
    }

    [MethodImpl(KernelMethod.Optimized)]
    void IStageWork.Run(int worker, int from, int to)
    {
        RestInput input = _input;
        BodyStore bodies = input.Bodies;
        Vector2 g = input.Settings.Gravity;
        float gravity = (float)Math.Sqrt(((double)g.X * g.X) + ((double)g.Y * g.Y));
        float time = input.Settings.TimeToSleep;
        float fall = FallShare * gravity * time * time;
        float share = input.Settings.RestShare;
        float longShare = Math.Min(LongShares * share, LargestLongShare);
        float longFall = fall * LongTimes * LongTimes;
        float dt = input.Dt;
        bool anyReady = false;
        bool anyRested = false;
        int* active = input.Active;
        byte* moves = input.Moves;
        RestRecord* records = _records.Pointer;
        BodyPose* poses = bodies.Pose.Pointer;
        BodySize* sizes = bodies.Size.Pointer;
        for (int i = from; i < to; i++)
        {
            int body = active[i];
            RestRecord* record = records + body;
            BodyPose* pose = poses + body;
            BodySize size = sizes[body].Reach > 0 ? sizes[body] : Spread(bodies.Mass[body]);
            float extent = size.Extent;
            bool pulled = gravity > 0 && (bodies.Flags[body] & BodyFlags.IgnoreGravity) == 0;
            bool free = !pulled && input.Degrees[body] == 0;
            float before = record->Rested;
            float room = pulled ? Math.Min(share * extent, fall) : share * extent;
            bool mayRest = moves[body] != 0 && !IsHeld(bodies, body);
            Watch(ref record->Near, pose, size.Reach, room, mayRest && (!free || WillStop(bodies, body, size.Reach, room, time)), dt);
            Watch(
                ref record->Far,
                pose,
                size.Reach,
                pulled ? Math.Min(longShare * extent, longFall) : longShare * extent,
                mayRest && !free,
                dt);
            bool rested = record->Rested >= time;
            anyRested |= rested;
            anyReady |= rested && before < time;
        }

        if (anyRested)
        {
            AnyRested = true;
        }

        if (anyReady)
        {
            _anyReady = true;
        }
    }

    /// <summary>Forms the groups of bodies in contact; what else hangs together is joined afterwards.</summary>
    public void Open(in RestInput input)
    {
        Reserve(input.Bodies.State.Capacity);
        for (int i = 0; i < input.Islands.Count; i++)
        {
            _firstOfIsland[i] = -1;
        }

        for (int i = 0; i < input.ActiveCount; i++)
        {
            int body = input.Active[i];
            _parent[body] = body;
            _least[body] = float.MaxValue;
            if (input.Moves[body] != 0 && input.Degrees[body] > 0)
            {
                ref int first = ref _firstOfIsland[input.Islands.Of(body)];
                first = first < 0 ? body : first;
                _parent[body] = first;
            }
        }
    }

    /// <summary>Two bodies that can move hang together.</summary>
    public void Join(int a, int b)
    {
        a = Find(a);
        b = Find(b);
        if (a != b)
        {
            _parent[b] = a;
        }
    }

    /// <summary>Lists the bodies of the groups that have rested as a whole.</summary>
    public void Close(in RestInput input)
    {
        for (int i = 0; i < input.ActiveCount; i++)
        {
            int body = input.Active[i];
            if (input.Moves[body] != 0)
            {
                ref float least = ref _least[Find(body)];
                least = Math.Min(least, _records[body].Rested);
            }
        }

        _resting.Clear();
        for (int i = 0; i < input.ActiveCount; i++)
        {
            int body = input.Active[i];
            if (input.Moves[body] != 0 && _least[Find(body)] >= input.Settings.TimeToSleep)
            {
                _resting.Add(body);
            }
        }
    }

    /// <summary>A body without a shape is as large as its mass is spread.</summary>
    private static BodySize Spread(in BodyMass mass)
    {
        float spread = mass.InverseInertia > 0 ? (float)Math.Sqrt((double)mass.InverseMass / mass.InverseInertia) : 0;
        return new BodySize { Extent = spread, Reach = spread };
    }

    /// <summary>Follows a body from the place where it came to rest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Watch(ref RestPlace place, BodyPose* pose, float reach, float room, bool mayRest, float dt)
    {
        double moved = Math.Abs(pose->X - place.X) + Math.Abs(pose->Y - place.Y) + (Math.Abs(pose->Angle - place.Angle) * reach);
        if (mayRest && moved <= room)
        {
            place.Time += dt;
            return;
        }

        place.X = pose->X;
        place.Y = pose->Y;
        place.Angle = pose->Angle;
        place.Time = 0;
    }

    private static bool IsHeld(BodyStore bodies, int body)
    {
        ref BodyForce force = ref bodies.Force[body];
        return (bodies.Flags[body] & BodyFlags.NeverSleeps) != 0 || force.Force != Vector2.Zero || force.Torque != 0;
    }

    /// <summary>
    /// A body that nothing touches and nothing pulls goes on for ever, be it ever so slowly: it rests if it stands still, or if drag
    /// stops it before it has gone anywhere. What a joint has stopped may be left with the rounding of the speed that it had.
    /// </summary>
    private static bool WillStop(BodyStore bodies, int body, float reach, float room, float time)
    {
        ref BodyState state = ref bodies.State[body];
        double speed = Math.Abs((double)state.LinearVelocity.X) + Math.Abs((double)state.LinearVelocity.Y);
        double spin = Math.Abs((double)state.AngularVelocity) * reach;
        if (Math.Max(speed, spin) * time <= RoundingShare * room)
        {
            return true;
        }

        double rate = (double)bodies.Drag[body].Linear * bodies.Mass[body].InverseMass;
        return rate > 0 && speed <= room * rate && spin * time <= room;
    }

    private int Find(int body)
    {
        while (_parent[body] != body)
        {
            _parent[body] = _parent[_parent[body]];
            body = _parent[body];
        }

        return body;
    }

    [StructLayout(LayoutKind.Sequential)]
    private struct RestRecord
    {
        /// <summary>By the usual watch and by the longer one.</summary>
        public RestPlace Near;
        public RestPlace Far;

        /// <summary>Seconds of rest, those of the longer watch at its rate.</summary>
        public readonly float Rested => Math.Max(Near.Time, Far.Time * (1f / LongTimes));
    }

    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    private struct RestPlace
    {
        /// <summary>Where the body came to rest.</summary>
        public double X;
        public double Y;
        public double Angle;

        /// <summary>Seconds since then.</summary>
        public float Time;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_records);
        s.Column(_parent);
        s.Column(_firstOfIsland);
        s.Column(_least);
        _resting.Visit(s);
        s.Value(ref _anyReady);
        AnyRested = s.Value(AnyRested);
    }
}
