using System;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// Acts on the simulation once per update, at the moment at which forces act and before the springs. Derive from this class to
/// write your own: override <see cref="Update"/> and <see cref="Validate"/>.
/// </summary>
/// <example>
/// <code>
/// Controller wind = new WindController(new Vector2(3, 0), 0.5f);
/// simulator.Add(wind);
/// wind.Enabled = false;
/// </code>
/// </example>
public abstract class Controller : IDisposable, IItem
{
    private StateMark _mark;

    /// <summary>Makes an enabled controller.</summary>
    protected Controller()
    {
    }

    /// <summary>False lets the controller rest. Default true; false for the inactivity controller of a simulator.</summary>
    public bool Enabled { get; set; } = true;

    /// <summary>True once <see cref="Dispose()"/> was called.</summary>
    public bool IsDisposed { get; private set; }

    /// <summary>Anything that you want to keep with the controller. Default null.</summary>
    [NotState(Why.Users)]
    public object? Tag { get; set; }

    PhysicsSimulator? IItem.Simulator
    {
        get => Simulator;
        set => Simulator = value;
    }

    Membership IItem.Membership { get; set; }

    ref StateMark IStatePart.Mark => ref _mark;

    internal PhysicsSimulator? Simulator { get; private set; }

    /// <summary>
    /// Checks what the controller needs, and disposes it or parts of it that are gone. The simulator calls it in every update.
    /// </summary>
    public abstract void Validate();

    /// <summary>
    /// Lets the controller act for one update. The simulator calls it for each enabled controller, in the order of its list.
    /// </summary>
    /// <param name="dt">The step, seconds.</param>
    public abstract void Update(float dt);

    /// <summary>
    /// Disposes the controller: it acts no more and leaves the simulator at its next update. Calling it again does nothing.
    /// </summary>
    public void Dispose()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    /// <summary>Does the work of <see cref="Dispose()"/>.</summary>
    /// <param name="disposing">True when called by <see cref="Dispose()"/>.</param>
    protected virtual void Dispose(bool disposing) => IsDisposed = true;

    /// <summary>Writes, or reads, what later updates read of it.</summary>
    internal virtual void Visit(StateStream s)
    {
        Enabled = s.Value(Enabled);
        IsDisposed = s.Value(IsDisposed);
        Simulator = s.Reference(Simulator);
        ((IItem)this).Membership = s.Value(((IItem)this).Membership);
    }

    /// <summary>It belongs to no simulator any more, by a state from before it was added.</summary>
    internal void TakeOut()
    {
        Simulator = null;
        ((IItem)this).Membership = Membership.None;
    }

    /// <summary>Lets what no public property shows be saved or set.</summary>
    internal virtual void VisitHidden(IHiddenFields fields)
    {
    }
}
