using System;
using System.Diagnostics;
using System.Numerics;
using System.Threading;
using System.Threading.Tasks;
using Orleans;
using Orleans.Runtime;
using Orleans.Runtime.Placement;

namespace Farseer.Rooms;

/// <summary>
/// A room's life on a server. One call runs at a time, so the world needs no lock. What leaves memory is saved first, and whatever the
/// reason (nobody called for a while, the server stops, the room moves) it goes on elsewhere with the same bits.
/// </summary>
[GrainType("room")]
public sealed class RoomGrain : Grain, IRoom
{
    // Timers fire late, never early: the driver makes the steps that are due by then.
    private static readonly TimeSpan _tick = TimeSpan.FromSeconds(1.0 / 60);

    /// <summary>With the clock a room is saved after so many steps, ten seconds: more is never lost with a server that is killed.</summary>
    private const long StepsBetweenSaves = 600;

    private readonly ILocalSiloDetails _silo;
    private readonly IPersistentState<RoomState> _saved;
    private RoomWorld? _world;
    private IGrainTimer? _clock;
    private long _lastTick;

    /// <param name="silo">The server.</param>
    /// <param name="saved">Also goes along with a room that moves, so that the new server need not read it.</param>
    public RoomGrain(ILocalSiloDetails silo, [PersistentState("world", RoomHosting.Storage)] IPersistentState<RoomState> saved)
    {
        _silo = silo;
        _saved = saved;
    }

    private RoomWorld World => _world ?? throw new InvalidOperationException("The room is not active.");

    public override Task OnActivateAsync(CancellationToken cancellationToken)
    {
        RoomState saved = _saved.State;
        _world = saved.File.Length > 0 ? RoomWorld.Load(saved.File, saved.Steps) : RoomWorld.Build(this.GetPrimaryKeyLong());
        if (saved.IsRunning)
        {
            StartClock();
        }

        return Task.CompletedTask;
    }

    public override async Task OnDeactivateAsync(DeactivationReason reason, CancellationToken cancellationToken)
    {
        if (_world is null)
        {
            // It could not be loaded: what was saved stays as it is.
            return;
        }

        StopClock();
        await Save(_world, cancellationToken);
    }

    public Task Push(int player, float x, float y)
    {
        World.Push(player, new Vector2(x, y));
        return Task.CompletedTask;
    }

    public Task<RoomView> Step(int count)
    {
        World.Step(count);
        return Look();
    }

    public Task Run(bool isRunning)
    {
        _saved.State.IsRunning = isRunning;
        StopClock();
        if (isRunning)
        {
            StartClock();
        }

        return Task.CompletedTask;
    }

    public Task<RoomView> Look()
    {
        Vector2 ball = World.BallPosition;
        return Task.FromResult(new RoomView(_silo.SiloAddress, World.Steps, World.Hash, ball.X, ball.Y, _saved.State.File.Length));
    }

    public Task Save() => Save(World, CancellationToken.None);

    public Task MoveTo(SiloAddress silo)
    {
        ArgumentNullException.ThrowIfNull(silo);
        RequestContext.Set(IPlacementDirector.PlacementHintKey, silo);
        MigrateOnIdle();
        return Task.CompletedTask;
    }

    private async Task Save(RoomWorld world, CancellationToken cancellationToken)
    {
        _saved.State.File = world.Save();
        _saved.State.Steps = world.Steps;
        await _saved.WriteStateAsync(cancellationToken);
    }

    private void StartClock()
    {
        _lastTick = Stopwatch.GetTimestamp();

        // A running clock does not keep a room in memory: one that nobody calls is saved and stands still until somebody does.
        _clock = this.RegisterGrainTimer(Tick, new GrainTimerCreationOptions(_tick, _tick) { KeepAlive = false });
    }

    private void StopClock()
    {
        _clock?.Dispose();
        _clock = null;
    }

    private async Task Tick(CancellationToken cancellationToken)
    {
        long now = Stopwatch.GetTimestamp();
        World.Advance(Stopwatch.GetElapsedTime(_lastTick, now).TotalSeconds);
        _lastTick = now;
        if (World.Steps - _saved.State.Steps >= StepsBetweenSaves)
        {
            await Save(World, cancellationToken);
        }
    }
}
