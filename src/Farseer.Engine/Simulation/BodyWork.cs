using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Solver;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Where a body was that flew to a place or at a speed that must be looked at.</summary>
internal struct FlightStart
{
    public BodyPose Pose;
    public BodyState State;
}

/// <summary>
/// What a step does to each body by itself, in ranges of a list. Bodies that need more than that are marked, and seen to
/// afterwards by one thread in the order of the list.
/// </summary>
internal sealed unsafe class BodyWork : IStageWork
{
    /// <summary>Bodies that are worth another worker's while, some 1 µs.</summary>
    private const int LeastBodies = 128;

    private readonly Column<byte> _marks = new Column<byte>();
    private readonly Column<FlightStart> _starts = new Column<FlightStart>();
    private BodyStore _bodies = null!;
    private int* _list;
    private Part _part;
    private Vector2 _gravity;
    private float _time;
    private float _substep;
    private bool _found;

    private enum Part
    {
        Foresee,
        FlyFree,
        PrepareDrives,
        Finish,
        FinishFree,
    }

    /// <summary>1 for each place of the list whose body was marked, else 0.</summary>
    public byte* Marks => _marks.Pointer;

    /// <summary>For each marked place of bodies that flew.</summary>
    public FlightStart* Starts => _starts.Pointer;

    public void Foresee(StageRunner runner, BodyStore bodies, int* list, int count, float dt) =>
        Run(runner, bodies, list, count, Part.Foresee, dt);

    /// <returns>True if bodies were marked.</returns>
    public bool FlyFree(StageRunner runner, BodyStore bodies, int* list, int count, Vector2 gravity, float dt, float substep)
    {
        _starts.EnsureCapacity(count);
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
    public bool Finish(StageRunner runner, BodyStore bodies, int* list, int count) =>
        Run(runner, bodies, list, count, Part.Finish, 0);

    public void FinishFree(StageRunner runner, BodyStore bodies, int* list, int count) =>
        Run(runner, bodies, list, count, Part.FinishFree, 0);

    void IStageWork.Run(int worker, int from, int to)
    {
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
            case Part.FlyFree:
                found = FlyFree(list, to - from, marks, _starts.Pointer + from);
                break;
            case Part.Finish:
                found = FinishBodies.Run(_bodies, list, to - from, marks);
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

    private bool Run(StageRunner runner, BodyStore bodies, int* list, int count, Part part, float time)
    {
        _marks.EnsureCapacity(count);
        _bodies = bodies;
        _list = list;
        _part = part;
        _time = time;
        _found = false;
        runner.Run(this, count, LeastBodies);
        return _found;
    }
}
