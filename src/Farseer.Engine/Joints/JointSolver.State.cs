using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <summary>What is remembered from step to step: the trees and what was found out about them, last impulses and errors.</summary>
internal sealed partial class JointSolver
{
    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _turns.Visit(s);
        s.Column(_moved);
        s.Value(ref _posed);
        s.Value(ref _armed);
        _chains.Visit(s);
        s.Column(_movers);
        UsesChains = s.Value(UsesChains);
        s.Column(_trees);
        s.Column(_nodes);
        s.Column(_joints);
        s.Value(ref _treeCount);
        s.Value(ref _nodeCount);
        s.Value(ref _jointCount);
        s.Value(ref _fineness);
        s.Value(ref _class);
        s.Column(_builtMoves);
        s.Column(_keys);
        s.Column(_order);
        s.Column(_broken);
        s.Value(ref _collected);
        s.Value(ref _bodiesChanged);
        BrokenCount = s.Value(BrokenCount);
        s.Column(_agendaKeys);
        s.Column(_agenda);
        s.Column(_gaps);
        s.Value(ref _contactCount);
        s.Value(ref _agendaCount);
        _forest.Visit(s);
        _loops.Visit(s);
        s.Column(_active);
        s.Column(_rows);
        _nets.Visit(s);
        s.Value(ref _count);
        s.Value(ref _pushRate);
        s.Value(ref _anyHeld);
        s.Value(ref _hitCount);
        s.Column(_laneTrees);
        s.Column(_laneAgenda);
        s.Value(ref _laneTreeCount);
        s.Value(ref _laneAgendaCount);
        _lanes.Visit(s);
        UsesLanes = s.Value(UsesLanes);
        s.Column(_own);
        s.Column(_below);
        s.Column(_above);
        s.Column(_sum);
        _loose.Visit(s);
        s.Value(ref _overruns);
        s.Value(ref _anyLimits);
        s.Value(ref _wheelContactCount);
        s.Value(ref _anyWheels);
        s.Value(ref _anyWishes);
        s.Value(ref _wishing);
    }
}
