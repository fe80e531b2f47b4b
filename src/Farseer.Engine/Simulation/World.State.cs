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

        Settings.Visit(s.Of(nameof(Settings)));
        Bodies.Visit(s.Of(nameof(Bodies)));
        Shapes.Visit(s.Of(nameof(Shapes)));
        Proxies.Visit(s.Of(nameof(Proxies)));
        _contacts.Visit(s.Of(nameof(_contacts)));
        _graph.Visit(s.Of(nameof(_graph)));
        _islands.Visit(s.Of(nameof(_islands)));
        Joints.Visit(s.Of(nameof(Joints)));
        _jointSolver.Visit(s.Of(nameof(_jointSolver)));
        _springs.Visit(s.Of(nameof(_springs)));
        VisitMemories(s);
        VisitItems(s);
        VisitSleep(s);
        VisitAccuracy(s);
        VisitImpulses(s);
        BroadPhase = s.Of(nameof(World)).Reference(BroadPhase)!;
        BroadPhase.Visit(s.Of(nameof(BroadPhase)));
        Queries.Visit(s.Of(nameof(Queries)));
        if (s.IsReading)
        {
            _immovableListed = false;
            _queriesSeeStep = false;
            _roomIsDue |= s.Room is not null;
        }
    }

    /// <summary>The colliders of a pair, by its number; false if there is no such pair.</summary>
    public bool TryGetPair(int contact, out int colliderA, out int colliderB)
    {
        bool exists = contact >= 0 && contact < _contacts.End && _contacts.Records[contact].PieceA >= 0;
        colliderA = exists ? Shapes.ColliderOf(_contacts.Records[contact].PieceA) : -1;
        colliderB = exists ? Shapes.ColliderOf(_contacts.Records[contact].PieceB) : -1;
        return exists;
    }

    /// <summary>What the phases of a step remember of the step before.</summary>
    private void VisitMemories(StateStream s)
    {
        _lightened.Visit(s.Of(nameof(_lightened)));
        _feedForward.Visit(s.Of(nameof(_feedForward)));
        _sagForecast.Visit(s.Of(nameof(_sagForecast)));
        _contactStage.Visit(s.Of(nameof(_contactStage)));
        _events.Visit(s.Of(nameof(_events)));
        _boxes.Visit(s.Of(nameof(_boxes)));
        _lists.Visit(s.Of(nameof(_lists)));
        _classes.Visit(s.Of(nameof(_classes)));
        _carriedPushes.Visit(s.Of(nameof(_carriedPushes)));
        IslandGroups.Visit(s.Of(nameof(IslandGroups)));
        RowOrder.Visit(s.Of(nameof(RowOrder)));
        RowHalves.Visit(s.Of(nameof(RowHalves)));
        s.Of(nameof(World)).Value(ref _makesEnergy);
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
        s.Of(nameof(World)).Column(_firstCollider);
        s.Column(_nextCollider);
        s.Value(ref _deadBodyCount);
        s.Value(ref _deadColliderCount);
        s.Column(_deadBodies, _deadBodyCount);
        s.Column(_deadColliders, _deadColliderCount);
        s.Value(ref _colliderOrder);
        _verdicts.Visit(s.Of(nameof(_verdicts)));
        s.Of(nameof(World)).Column(_staleBodies);
        _movedProxies.VisitUnordered(s.Of(nameof(_movedProxies)));
        s.Of(nameof(World)).Value(ref _anyStale);
        s.Value(ref _alwaysCollect);
        s.Value(ref _allFound);
        s.Value(ref _roomIsDue);
        s.Value(ref _bodiesCollected);
    }

    private void VisitSleep(StateStream s)
    {
        _rest.Visit(s.Of(nameof(_rest)));
        _dormant.Visit(s.Of(nameof(_dormant)));
        _put.Visit(s.Of(nameof(_put)));
        _putInStep.Visit(s.Of(nameof(_putInStep)));
        _handled.Visit(s.Of(nameof(_handled)));
        _layDown.Visit(s.Of(nameof(_layDown)));
        s.Of(nameof(World)).Value(ref _stepsUngrouped);
        s.Value(ref _groupsChanged);
        s.Value(ref _gravityAsleep);
        AsleepCount = s.Value(AsleepCount);
    }

    /// <summary>What readers of contacts see, and what is to be summed.</summary>
    private void VisitImpulses(StateStream s)
    {
        SumsImpulses = s.Of(nameof(World)).Value(SumsImpulses);
        TellsPushes = s.Value(TellsPushes);
        HitSpeed = s.Value(HitSpeed);
        s.Value(ref _sums);
        s.Value(ref _tellsPushes);
        if (s.Lacks(_impulses))
        {
            MakeImpulses();
        }

        s.Reference(ref _impulses);
        _impulses?.Visit(s.Of(nameof(_impulses)));
    }

    private void VisitAccuracy(StateStream s)
    {
        ReportEnabled = s.Of(nameof(World)).Value(ReportEnabled);
        HasMeasured = s.Value(HasMeasured);
        Budget.Visit(s.Of(nameof(Budget)));
        s.Of(nameof(World)).Value(ref _measures);
        s.Value(ref _reports);
        s.Value(ref _budgeted);
        if (s.Lacks(_audit))
        {
            MakeAudit();
        }

        s.Reference(ref _audit);
        _audit?.Visit(s.Of(nameof(_audit)));
        if (s.Lacks(_meter))
        {
            MakeMeter();
        }

        s.Of(nameof(World)).Reference(ref _meter);
        _meter?.Visit(s.Of(nameof(_meter)));
        if (s.Lacks(_impactLaw))
        {
            MakeImpactLaw();
        }

        s.Of(nameof(World)).Reference(ref _impactLaw);
    }
}
