using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>The passes over the solver's bodies, cut into ranges of whole bundles for the workers. The list holds each body once.</summary>
internal sealed unsafe class BodyPasses : IStageWork
{
    /// <summary>Bundles that are worth another worker's while, some 0.5 µs of a pass.</summary>
    private const int LeastBundles = 32;

    private StageRunner _runner = null!;
    private Vector4* _saved;
    private CarriedPush* _pushes;
    private BodyState* _states;
    private BodyMotion* _motions;
    private BodyDrive* _drives;
    private int* _list;
    private int _bundles;
    private int _middleBody;
    private int _middle;
    private float _substep;
    private Pass _pass;

    private enum Pass
    {
        Velocities,
        Positions,
        Save,
        Stop,
        Restore,
        AddPushes,
        RememberPushes,
    }

    public void Begin(in SolverInput input)
    {
        _saved = input.Saved;
        _pushes = input.Pushes;
        _runner = input.Runner;
        _states = input.Bodies.State.Pointer;
        _motions = input.Bodies.Motion.Pointer;
        _drives = input.Bodies.Drive.Pointer;
        _substep = input.Substep;
        _middleBody = input.MiddleBody;
        Use(input.List, input.PaddedCount);
    }

    /// <summary>Lets go of the world.</summary>
    public void Forget() => _runner = null!;

    /// <summary>Goes on with another list, padded as well.</summary>
    public void Use(int* list, int paddedCount)
    {
        _list = list;
        _bundles = paddedCount / WideLanes.BundleLanes;
        _middle = FindMiddle();
    }

    public void IntegrateVelocities() => Run(Pass.Velocities);

    public void IntegratePositions() => Run(Pass.Positions);

    /// <summary>Keeps the velocities for <see cref="RestoreVelocities"/>.</summary>
    public void SaveVelocities() => Run(Pass.Save);

    /// <summary>Velocities of 0, and from here on they move the bodies plainly in this substep.</summary>
    public void Stop() => Run(Pass.Stop);

    public void RestoreVelocities() => Run(Pass.Restore);

    /// <summary>The same as <see cref="SaveVelocities"/>, and then the bodies go on with what pushed them in the substep before.</summary>
    public void AddPushes() => Run(_pushes != null ? Pass.AddPushes : Pass.Save);

    /// <summary>The same as <see cref="RestoreVelocities"/>, but what the velocities differed by is kept for the next substep.</summary>
    public void RememberPushes() => Run(_pushes != null ? Pass.RememberPushes : Pass.Restore);

    void IStageWork.Run(int worker, int from, int to) => Run(from, to);

    private void Run(int from, int to)
    {
        int first = from * WideLanes.BundleLanes;
        int end = to * WideLanes.BundleLanes;
        switch (_pass)
        {
            case Pass.Velocities:
                Integrator.IntegrateVelocities(_list + first, end - first, _states, _motions, _drives);
                break;
            case Pass.Positions:
                Integrator.IntegratePositions(_list + first, end - first, _states, _motions, _substep);
                break;
            case Pass.Save:
                for (int i = first; i < end; i++)
                {
                    _saved[i] = *BodyState.VelocityOf(_states + _list[i]);
                }

                break;
            case Pass.Stop:
                for (int i = first; i < end; i++)
                {
                    _states[_list[i]].LinearVelocity = Vector2.Zero;
                    _states[_list[i]].AngularVelocity = 0;
                    BodyMotion* motion = _motions + _list[i];
                    motion->ChangeX = 0;
                    motion->ChangeY = 0;
                    motion->ChangeW = 0;
                }

                break;
            case Pass.Restore:
                for (int i = first; i < end; i++)
                {
                    *BodyState.VelocityOf(_states + _list[i]) = _saved[i];
                }

                break;
            case Pass.AddPushes:
                CarriedPushes.Add(_pushes, _list + first, end - first, _states, _saved + first, _substep);
                break;
            case Pass.RememberPushes:
                CarriedPushes.Remember(_pushes, _list + first, end - first, _states, _saved + first, _substep);
                break;
        }
    }

    /// <summary>The bundle in which the second half of the bodies begins: the list is in their order, but for the padding.</summary>
    private int FindMiddle()
    {
        if (_middleBody == 0)
        {
            return _bundles / 2;
        }

        int from = 0;
        int end = _bundles;
        while (from < end)
        {
            int middle = (from + end) / 2;
            int first = _list[middle * WideLanes.BundleLanes];
            bool isBelow = first != 0 && first < _middleBody;
            from = isBelow ? middle + 1 : from;
            end = isBelow ? end : middle;
        }

        return from;
    }

    private void Run(Pass pass)
    {
        _pass = pass;
        if (_bundles < 2 * LeastBundles)
        {
            // Too few to share: not even asked.
            Run(0, _bundles);
            return;
        }

        _runner.Run(this, _bundles, _middle, LeastBundles);
    }
}
