using System;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Springs;

/// <summary>
/// Pulls at bodies without holding them. Springs are stable at any constant. Derive from this class to write your own: override
/// <see cref="Update"/>, in which bodies are given forces, and <see cref="Validate"/>.
/// </summary>
/// <example>
/// <code>
/// spring.Breakpoint = 10;
/// spring.Broke += (sender, args) =&gt; simulator.Remove(spring);
/// </code>
/// </example>
public abstract class Spring : IDisposable, IItem
{
    private StateMark _mark;
    private float _springConstant;
    private float _dampingConstant;
    private float _breakpoint = float.MaxValue;
    private bool _enabled = true;

    /// <summary>Makes a spring without strength.</summary>
    protected Spring()
    {
    }

    /// <summary>Raised when the spring breaks.</summary>
    public event EventHandler<EventArgs>? Broke;

    /// <summary>False lets the spring rest without force. Breaking sets it to false. Default true.</summary>
    public bool Enabled
    {
        get => _enabled;
        set
        {
            if (_enabled != value)
            {
                _enabled = value;
                Memory.WakeEnds();
            }
        }
    }

    /// <summary>True once <see cref="Dispose()"/> was called.</summary>
    public bool IsDisposed { get; private set; }

    /// <summary>Anything that you want to keep with the spring. Default null.</summary>
    [NotState(Why.Users)]
    public object? Tag { get; set; }

    /// <summary>
    /// Strength of the spring: force per length, or torque per radian; finite and at least 0. Default 0; the factories and
    /// constructors take it as an argument.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float SpringConstant
    {
        get => _springConstant;
        set => _springConstant = Require.NotNegative(value, nameof(SpringConstant));
    }

    /// <summary>
    /// Damping of the spring, as of a shock absorber: force per speed, or torque per angular velocity; finite and at least 0.
    /// Default 0; the factories and constructors take it as an argument.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float DampingConstant
    {
        get => _dampingConstant;
        set => _dampingConstant = Require.NotNegative(value, nameof(DampingConstant));
    }

    /// <summary>The same as <see cref="DampingConstant"/>, in the spelling of the manual.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float DampningConstant
    {
        get => DampingConstant;
        set => _dampingConstant = Require.NotNegative(value, nameof(DampningConstant));
    }

    /// <summary>
    /// Size of <see cref="SpringError"/> above which the spring breaks; finite and at least 0. Default the largest float: it never breaks.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Breakpoint
    {
        get => _breakpoint;
        set => _breakpoint = Require.NotNegative(value, nameof(Breakpoint));
    }

    /// <summary>How far the spring was from its rest when it last acted: a length or an angle, with its sign. Default 0.</summary>
    public float SpringError { get; protected set; }

    PhysicsSimulator? IItem.Simulator
    {
        get => Simulator;
        set => Simulator = value;
    }

    Membership IItem.Membership { get; set; }

    ref StateMark IStatePart.Mark => ref _mark;

    internal PhysicsSimulator? Simulator { get; private set; }

    /// <summary>The bodies that the spring holds together; null: none.</summary>
    internal virtual Body? FirstBody => null;

    internal virtual Body? SecondBody => null;

    internal SpringMemory Memory { get; } = new SpringMemory();

    /// <summary>
    /// Disposes the spring if a body of it is disposed. The simulator calls it in every update; writers of springs override it.
    /// </summary>
    public abstract void Validate();

    /// <summary>
    /// Lets the spring act for one update. The simulator calls it for each enabled spring, in the order in which the springs were
    /// added, at the moment at which forces act; writers of springs apply their forces here. The base method breaks the spring if
    /// the size of <see cref="SpringError"/> is above <see cref="Breakpoint"/>: it sets <see cref="Enabled"/> to false and raises
    /// <see cref="Broke"/>. Call it first, or after setting the error.
    /// </summary>
    /// <param name="dt">The step, seconds; finite and at least 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> is negative or not finite.</exception>
    public virtual void Update(float dt)
    {
        Require.NotNegative(dt, nameof(dt));
        Judge();
    }

    /// <summary>Disposes the spring: it acts no more and leaves the simulator at its next update. Calling it again does nothing.</summary>
    public void Dispose()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    /// <summary>Does the work of <see cref="Dispose()"/>.</summary>
    /// <param name="disposing">True when called by <see cref="Dispose()"/>.</param>
    protected virtual void Dispose(bool disposing) => IsDisposed = true;

    /// <summary>Notes the error found now and judges it; false if the spring does not pull in this update.</summary>
    private protected bool Survives(float error)
    {
        if (Simulator is not null && (Simulator.Quirks & Farseer201Quirks.SpringBreaksLate) != 0)
        {
            // The original judged the error of the update before, and pulled once more.
            Judge();
            SpringError = error;
            return !IsDisposed;
        }

        SpringError = error;
        Judge();
        return Enabled && !IsDisposed;
    }

    private void Judge()
    {
        if (Enabled && Math.Abs(SpringError) > Breakpoint)
        {
            Enabled = false;
            Simulator?.Relay.Recorder.Broke(this);
            Broke?.Invoke(this, EventArgs.Empty);
        }
    }

    /// <summary>Writes, or reads, what later updates read of it.</summary>
    internal virtual void Visit(StateStream s)
    {
        s.Value(ref _springConstant);
        s.Value(ref _dampingConstant);
        s.Value(ref _breakpoint);
        s.Value(ref _enabled);
        s.Reference(ref Broke);
        IsDisposed = s.Value(IsDisposed);
        SpringError = s.Value(SpringError);
        Simulator = s.Reference(Simulator);
        ((IItem)this).Membership = s.Value(((IItem)this).Membership);
        Memory.Visit(s);
    }

    /// <summary>It belongs to no simulator any more, by a state from before it was added.</summary>
    internal void TakeOut()
    {
        Memory.Forget();
        Simulator = null;
        ((IItem)this).Membership = Membership.None;
    }

    /// <summary>Lets what no public property shows be saved or set.</summary>
    internal virtual void VisitHidden(IHiddenFields fields)
    {
        float error = SpringError;
        fields.Value("springError", ref error);
        SpringError = error;
    }
}
