using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Solver;
using Farseer.Engine.Springs;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Where a body was that flew to a place or at a speed that must be looked at.</summary>
internal struct FlightStart
{
    public BodyPose Pose;
    public BodyState State;
}

/// <summary>What 64 bodies are, a bit each.</summary>
internal struct BodySorts
{
    /// <summary>Can move.</summary>
    public ulong Active;

    /// <summary>Out of range, or driven.</summary>
    public ulong Special;
}

/// <summary>What may hold a body.</summary>
internal struct Holders
{
    public ConstraintGraph Graph;
    public SpringStore Springs;
    public JointSolver? Joints;

    /// <summary>All bodies count as held.</summary>
    public bool All;
}

/// <summary>
/// What a step does to each body by itself, in ranges of a list. Bodies that need more than that are marked, and seen to
/// afterwards by one thread in the order of the list.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class BodyWork : IStageWork
{
    /// <summary>Bodies that are worth another worker's while, some 1 µs.</summary>
    private const int LeastBodies = 128;

    /// <summary>Words of 64 bodies that are, some 1 µs.</summary>
    private const int LeastWords = 4;

    private readonly Column<BodySorts> _sorts = new Column<BodySorts>();
    private readonly Column<byte> _marks = new Column<byte>();
    private FlightStart* _starts;
    private FastMotion* _fast;
    private BodyStore _bodies = null!;
    private int* _list;
    private byte* _moves;
    private Part _part;
    private Holders _holders;
    private Vector2 _gravity;
    private float _time;
    private float _substep;
    private bool _found;

    private enum Part
    {
        Sort,
        Foresee,
        FindHeld,
        FlyFree,
        PrepareDrives,
        Finish,
        FinishFree,
        UseUpForces,
    }

    /// <summary>1 for each place of the list whose body was marked, else 0.</summary>
    public byte* Marks => _marks.Pointer;

    /// <summary>For each word of bodies after <see cref="Sort(StageRunner, BodyStore, byte*)"/>.</summary>
    public BodySorts* Sorts => _sorts.Pointer;

    /// <summary>Sorts the bodies, and writes down which of them contacts and joints may move.</summary>
    /// <returns>How many words of them there are.</returns>
    public int Sort(StageRunner runner, BodyStore bodies, byte* moves)
    {
        int words = (bodies.Ids.End + BitSet.WordBits - 1) / BitSet.WordBits;
        _sorts.EnsureCapacity(words);
        _moves = moves;
        RunWords(runner, bodies, words, Part.Sort);
        return words;
    }

    public void UseUpForces(StageRunner runner, BodyStore bodies) =>
        RunWords(runner, bodies, (bodies.Ids.End + BitSet.WordBits - 1) / BitSet.WordBits, Part.UseUpForces);

    public void Foresee(StageRunner runner, BodyStore bodies, int* list, int count, float dt) =>
        Run(runner, bodies, list, count, Part.Foresee, dt);

    /// <summary>Marks the bodies that rows, springs or joints hold.</summary>
    public void FindHeld(StageRunner runner, BodyStore bodies, int* list, int count, in Holders holders)
    {
        _holders = holders;
        Run(runner, bodies, list, count, Part.FindHeld, 0);
    }

    /// <summary>Flies the bodies, and writes down where those began that are marked.</summary>
    /// <returns>True if bodies were marked.</returns>
    public bool FlyFree(
        StageRunner runner, BodyStore bodies, int* list, int count, Vector2 gravity, float dt, float substep, FlightStart* starts)
    {
        _starts = starts;
        _gravity = gravity;
        _substep = substep;
        return Run(runner, bodies, list, count, Part.FlyFree, dt);
    }

    /// <returns>True if bodies were marked.</returns>
    public bool PrepareDrives(StageRunner runner, BodyStore bodies, int* list, int count, Vector2 gravity, float substep)
    {
        _gravity = gravity;
        return Run(runner, bodies, list, count, Part.PrepareDrives, substep);
    }

    /// <returns>True if bodies were marked.</returns>
    public bool Finish(StageRunner runner, BodyStore bodies, int* list, int count, FastMotion* starts)
    {
        _fast = starts;
        return Run(runner, bodies, list, count, Part.Finish, 0);
    }

    public void FinishFree(StageRunner runner, BodyStore bodies, int* list, int count) =>
        Run(runner, bodies, list, count, Part.FinishFree, 0);

    /// <summary>Lets go of the world.</summary>
    public void Forget()
    {
        _bodies = null!;
        _holders = default;
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        if (_part == Part.Sort || _part == Part.UseUpForces)
        {
            ulong* visited = _bodies.Visited.Words;
            for (int word = from; word < to; word++)
            {
                int end = visited[word] == 0 ? 0 : Math.Min((word + 1) * BitSet.WordBits, _bodies.Ids.End);
                RunWord(word, end);
            }

            return;
        }

        int* list = _list + from;
        byte* marks = _marks.Pointer + from;
        bool found = false;
        switch (_part)
        {
            case Part.Foresee:
                Foresight.Begin(_bodies, list, to - from, _time);
                break;
            case Part.PrepareDrives:
                found = DrivePreparation.Prepare(_bodies, list, to - from, _gravity, _time, marks);
                break;
            case Part.FindHeld:
                FindHeld(list, to - from, marks);
                break;
            case Part.FlyFree:
                found = FlyFree(list, to - from, marks, _starts + from);
                break;
            case Part.Finish:
                found = FinishBodies.Run(_bodies, list, to - from, marks, _fast + from);
                break;
            case Part.FinishFree:
                FinishFree(list, to - from);
                break;
        }

        if (found)
        {
            _found = true;
        }
    }

    /// <summary>
    /// The bodies of a word below <paramref name="end"/>; none of those asleep, which do not move, as when they fell asleep.
    /// </summary>
    private void RunWord(int word, int end)
    {
        if (_part == Part.UseUpForces)
        {
            int first = word * BitSet.WordBits;
            if (end > first)
            {
                Unsafe.InitBlock(_bodies.Force.Pointer + first, 0, (uint)((end - first) * sizeof(BodyForce)));
            }

            return;
        }

        BodySorts sorts = default;
        BodyFlags* flags = _bodies.Flags.Pointer;
        BodyState* states = _bodies.State.Pointer;
        BodyPose* poses = _bodies.Pose.Pointer;
        byte* moves = _moves;
        for (int body = word * BitSet.WordBits; body < end; body++)
        {
            BodyFlags f = flags[body];
            moves[body] = 0;
            if ((f & (BodyFlags.Alive | BodyFlags.Enabled | BodyFlags.Asleep)) != (BodyFlags.Alive | BodyFlags.Enabled))
            {
                continue;
            }

            ulong bit = 1UL << body;
            if (!StateRange.Holds(states[body], poses[body]))
            {
                sorts.Special |= bit;
                continue;
            }

            sorts.Special |= (f & (BodyFlags.Static | BodyFlags.Kinematic)) != 0 && IsDriven(states[body]) ? bit : 0;
            if ((f & BodyFlags.Static) == 0)
            {
                sorts.Active |= bit;
                moves[body] = (f & BodyFlags.Kinematic) == 0 ? (byte)1 : (byte)0;
            }
        }

        _sorts[word] = sorts;
    }

    private static bool IsDriven(in BodyState state) => state.LinearVelocity != Vector2.Zero || state.AngularVelocity != 0;

    private void FindHeld(int* list, int count, byte* marks)
    {
        Holders by = _holders;
        int* degrees = by.Graph.Degrees;
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            bool held = degrees[body] > 0 || by.Springs.Touches(body) || by.All || (by.Joints != null && by.Joints.Holds(body));
            marks[i] = held ? (byte)1 : (byte)0;
        }
    }

    private bool FlyFree(int* list, int count, byte* marks, FlightStart* starts)
    {
        bool found = false;
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            bool pulled = (_bodies.Flags[body] & (BodyFlags.IgnoreGravity | BodyFlags.Kinematic)) == 0;
            BodyPose before = _bodies.Pose[body];
            BodyState old = _bodies.State[body];
            FreeFlight.Advance(_bodies, body, pulled ? _gravity : Vector2.Zero, _time, _substep);
            marks[i] = 0;
            if (!StateRange.Holds(_bodies.State[body], _bodies.Pose[body]) || FastList.IsFast(_bodies, body, before))
            {
                starts[i].Pose = before;
                starts[i].State = old;
                marks[i] = 1;
                found = true;
            }
        }

        return found;
    }

    private void FinishFree(int* list, int count)
    {
        for (int i = 0; i < count; i++)
        {
            FinishBodies.UpdateRotor(ref _bodies.Pose[list[i]]);
            FinishBodies.ForgetTurn(_bodies, list[i]);
        }
    }

    private void RunWords(StageRunner runner, BodyStore bodies, int words, Part part)
    {
        _bodies = bodies;
        _part = part;
        runner.Run(this, words, LeastWords);
    }

    private bool Run(StageRunner runner, BodyStore bodies, int* list, int count, Part part, float time)
    {
        _marks.EnsureCapacity(bodies.State.Capacity + WideLanes.BundleLanes);
        _bodies = bodies;
        _list = list;
        _part = part;
        _time = time;
        _found = false;
        runner.Run(this, count, LeastBodies);
        return _found;
    }
}
