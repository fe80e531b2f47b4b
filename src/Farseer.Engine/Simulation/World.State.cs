using System;
using Farseer.Engine.Accuracy;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Saving and restoring: all that influences a later step, event or reading.</summary>
internal sealed partial class World
{
    /// <summary>
    /// Writes the state, or sets it to what was written of this world. Who hears of its steps, and what is only memory of one
    /// step, is no part of it.
    /// </summary>
    /// <exception cref="InvalidOperationException">A step runs.</exception>
    public void Visit(StateStream s)
    {
        if (IsStepping)
        {
            throw new InvalidOperationException("The world is in a step: its state can be saved and restored only between steps.");
        }

        Settings.Visit(s);
        Bodies.Visit(s);
        Shapes.Visit(s);
        Proxies.Visit(s);
        _contacts.Visit(s);
        _graph.Visit(s);
        _islands.Visit(s);
        Joints.Visit(s);
        s.Reference(ref _jointSolver);
        _jointSolver?.Visit(s);
        _springs.Visit(s);
        VisitMemories(s);
        VisitItems(s);
        VisitSleep(s);
        VisitAccuracy(s);
        VisitImpulses(s);
        BroadPhase = s.Reference(BroadPhase)!;
        BroadPhase.Visit(s);
        Queries.Visit(s);
        if (s.IsReading)
        {
            _immovableListed = false;
            _queriesSeeStep = false;
            _roomIsDue |= s.Room is not null;
        }
    }

    /// <summary>What the phases of a step remember of the step before.</summary>
    private void VisitMemories(StateStream s)
    {
        _lightened.Visit(s);
        _feedForward.Visit(s);
        _sagForecast.Visit(s);
        _contactStage.Visit(s);
        _events.Visit(s);
        _boxes.Visit(s);
        _lists.Visit(s);
        _classes.Visit(s);
        _carriedPushes.Visit(s);
        IslandGroups.Visit(s);
        RowOrder.Visit(s);
        RowHalves.Visit(s);
        s.Value(ref _makesEnergy);
        s.Value(ref _bodiesSwitched);
        s.Value(ref _switchedWithin);
        s.Value(ref _lastSubstep);
        s.Value(ref _recovery);
        s.Value(ref _recoveryAge);
        s.Value(ref _dt);
        s.Value(ref _substeps);
        s.Value(ref _mostSubsteps);
        s.Value(ref _mostSwept);
    }

    /// <summary>Which colliders a body has, what waits to be removed, and what changed since the last step.</summary>
    private void VisitItems(StateStream s)
    {
        s.Column(_firstCollider);
        s.Column(_nextCollider);
        s.Value(ref _deadBodyCount);
        s.Value(ref _deadColliderCount);
        s.Column(_deadBodies, _deadBodyCount);
        s.Column(_deadColliders, _deadColliderCount);
        s.Value(ref _colliderOrder);
        _verdicts.Visit(s);
        s.Column(_staleBodies);
        _movedProxies.Visit(s);
        s.Value(ref _anyStale);
        s.Value(ref _alwaysCollect);
        s.Value(ref _allFound);
        s.Value(ref _roomIsDue);
        s.Value(ref _bodiesCollected);
    }

    private void VisitSleep(StateStream s)
    {
        _rest.Visit(s);
        _dormant.Visit(s);
        _put.Visit(s);
        _putInStep.Visit(s);
        _handled.Visit(s);
        _layDown.Visit(s);
        s.Value(ref _stepsUngrouped);
        s.Value(ref _groupsChanged);
        s.Value(ref _gravityAsleep);
        AsleepCount = s.Value(AsleepCount);
    }

    /// <summary>What readers of contacts see, and what is to be summed.</summary>
    private void VisitImpulses(StateStream s)
    {
        SumsImpulses = s.Value(SumsImpulses);
        TellsPushes = s.Value(TellsPushes);
        HitSpeed = s.Value(HitSpeed);
        s.Value(ref _sums);
        s.Value(ref _tellsPushes);
        if (s.Lacks(_impulses))
        {
            MakeImpulses();
        }

        s.Reference(ref _impulses);
        _impulses?.Visit(s);
    }

    private void VisitAccuracy(StateStream s)
    {
        ReportEnabled = s.Value(ReportEnabled);
        HasMeasured = s.Value(HasMeasured);
        Budget.Visit(s);
        s.Value(ref _measures);
        s.Value(ref _reports);
        s.Value(ref _budgeted);
        if (s.Lacks(_audit))
        {
            MakeAudit();
        }

        s.Reference(ref _audit);
        _audit?.Visit(s);
        if (s.Lacks(_meter))
        {
            MakeMeter();
        }

        s.Reference(ref _meter);
        _meter?.Visit(s);
        if (s.Lacks(_impactLaw))
        {
            MakeImpactLaw();
        }

        s.Reference(ref _impactLaw);
    }
}
