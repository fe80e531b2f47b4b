using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Solver;
using Farseer.Engine.Stepping;

namespace Farseer.Engine.Simulation;

/// <summary>The table of contents of a step: one line a phase.</summary>
internal sealed partial class World
{
    private int _substeps;

    private void RunStages(float dt)
    {
        Profile.Begin();
        PurgeNow();
        CollectBodies();
        _lists.Foresee(Bodies, dt);
        Profile.End(StepStage.DeferredChanges);

        _boxes.Update(this, dt);
        FindPairs();
        Profile.End(StepStage.BroadPhase);

        // Once for the whole step: a handler may turn the dial, and the substeps must add up to the step.
        _substeps = Settings.Substeps;
        float substep = dt / _substeps;
        ContactUpdateInput contacts = ContactInput(dt, substep);
        _contactStage.Update(contacts, _graph, Joints, UserJoints != null && UserJoints.Any);
        _events.Raise(this, _contacts, _graph, _contactStage.AnyHeard);
        Profile.End(StepStage.NarrowPhase);

        bool anyDeep = UpdateIslands(contacts.Coefficients);
        Profile.End(StepStage.GraphAndIslands);

        ApplyForces(dt);
        if (_contactStage.AnyHeard)
        {
            CollectStaticsAfterCallbacks();
        }

        Profile.End(StepStage.Forces);

        Solve(dt, anyDeep, contacts.Coefficients);
        Profile.End(StepStage.Solve);

        FinishBodiesOfStep();
        _lastSubstep = substep;
        Profile.End(StepStage.Finish);

        if (Settings.Continuous && _lists.Fast.Count > 0)
        {
            SweepFastBodies(dt, substep);
        }

        Profile.End(StepStage.Continuous);
    }

    private void ApplyForces(float dt)
    {
        _bodiesSwitched = false;
        _springs.Clear();
        Hooks?.ApplyForces(dt);
        if (_bodiesSwitched)
        {
            // A body that was enabled, disabled or made static by a hook moves, or stays, from this step on.
            int before = _lists.OutcastCount;
            _lists.CollectAgain(Bodies, dt);
            if (_lists.OutcastCount > before)
            {
                Isolate();
            }
        }
    }

    private unsafe ContactUpdateInput ContactInput(float dt, float substep)
    {
        ContactUpdateInput input;
        input.Shapes = Shapes;
        input.Bodies = Bodies;
        input.Contacts = _contacts;
        input.Fat = Proxies.Fat.Pointer;
        input.Proxies = Proxies.Info.Pointer;
        input.Sides = null;
        input.Pairs = null;
        input.Moves = _lists.Moves;
        input.Settings = Settings;
        input.Dt = dt;
        input.ImpulseScale = _lastSubstep > 0 ? substep / _lastSubstep : 1f;
        System.Numerics.Vector2 g = Settings.Gravity;
        float gravity = (float)Math.Sqrt(((double)g.X * g.X) + ((double)g.Y * g.Y));
        input.Coefficients = new ContactCoefficients(substep, gravity, Settings.AllowedPenetration);
        return input;
    }

    private unsafe bool UpdateIslands(in ContactCoefficients coefficients)
    {
        if (_graph.RowCount == 0)
        {
            return false;
        }

        if (_graph.Changed)
        {
            _islands.Build(_graph, Bodies.Ids.End, _lists.Moves);
            _graph.Changed = false;
        }

        return _feedForward.Apply(_islands, _graph, coefficients);
    }

    private unsafe void Solve(float dt, bool anyDeep, in ContactCoefficients coefficients)
    {
        float substep = coefficients.Substep;
        bool anyJoints = BeginJoints(dt, substep);
        bool anyUserJoints = UserJoints != null && UserJoints.Any;
        _springs.Prepare(Bodies, _lists.Moves, _graph.Degrees, anyJoints ? _jointSolver : null, anyUserJoints, substep);
        _lists.Split(Bodies, _graph, _springs, anyJoints ? _jointSolver : null, anyUserJoints);
        _lists.FlyFree(Bodies, Settings.Gravity, dt, substep);
        if (_lists.SolverCount == 0)
        {
            return;
        }

        _lists.PrepareDrives(Bodies, Settings.Gravity, substep);
        SolverInput input;
        input.Bodies = Bodies;
        input.Graph = _graph;
        input.List = _lists.Solver;
        input.PaddedCount = _lists.PaddedSolverCount;
        input.Substeps = _substeps;
        input.Substep = substep;
        input.Coefficients = coefficients;
        input.Recovery = Settings.Recovery;
        input.Springs = _springs;
        input.AnyDeep = anyDeep;
        input.AnyBounce = _contactStage.AnyBounce;
        input.ColdStart = _contactStage.ColdStart;
        input.Joints = anyJoints ? _jointSolver : null;
        input.UserJoints = anyUserJoints ? UserJoints : null;
        Queries.PosesChange = anyUserJoints;
        _solver.Solve(input);
        Queries.PosesChange = false;
    }
}
