using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Holds bodies together or to the world. Joints are attached to bodies, never to geoms, and their anchors need not lie inside a
/// geom. The joints of the library are solved by the engine. For a joint of your own derive from this class: each iteration of an
/// update calls <see cref="PreStep"/> once and then <see cref="Update"/> several times, joint after joint in the order in
/// which they were added, and they change the velocities of the bodies.
/// </summary>
/// <example>
/// <code>
/// hinge.Breakpoint = 0.1f;
/// hinge.Broke += (sender, args) =&gt; simulator.Remove(hinge);
/// </code>
/// </example>
public abstract class Joint : IDisposable, IItem
{
    internal readonly JointAttachment Link = new JointAttachment();

    private StateMark _mark;
    private bool _enabled = true;
    private float _breakpoint = float.MaxValue;
    private float _breakForce = float.MaxValue;
    private float _softness;
    private float _biasFactor = 0.2f;
    private bool _collideConnected = true;
    private float _jointError;
    private EventHandler<EventArgs>? _broke;

    /// <summary>Makes a joint; add it to a <see cref="PhysicsSimulator"/> to let it act.</summary>
    protected Joint()
    {
        IsUserWritten = GetType().Assembly != typeof(Joint).Assembly;
    }

    /// <summary>Raised when the joint breaks: its <see cref="Enabled"/> is false by then.</summary>
    public event EventHandler<EventArgs>? Broke
    {
        add
        {
            _broke += value;
            _mark.Change();
        }

        remove
        {
            _broke -= value;
            _mark.Change();
        }
    }

    /// <summary>False lets the bodies go until it is true again. A joint that breaks sets it to false. Default true.</summary>
    public bool Enabled
    {
        get => _enabled;
        set
        {
            if (_enabled != value)
            {
                _enabled = value;
                Changed();
            }
        }
    }

    /// <summary>True once <see cref="Dispose()"/> was called, also by <see cref="Validate"/>.</summary>
    public bool IsDisposed { get; private set => _mark.Set(ref field, value); }

    /// <summary>
    /// How far the bodies were from what the joint wants when the last update began: a length or an angle in radians, as the joint
    /// says. 0 before the first update; joints without an error always show 0. A joint of your own sets it in <see cref="PreStep"/>.
    /// </summary>
    public float JointError
    {
        get => Link.IsAttached ? Link.Error : _jointError;
        protected set => KeepError(value);
    }

    /// <summary>
    /// The joint breaks when the magnitude of <see cref="JointError"/> is above this; at least 0. Default <see cref="float.MaxValue"/>:
    /// it does not break. The joints of the library are so exact that they have hardly an error; while this is set,
    /// <see cref="JointError"/> is therefore what it would be if the bodies went straight on for each update, as in the original. That
    /// grows with the speed at which a joint swings its bodies round; to break by load use <see cref="BreakForce"/>.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Breakpoint
    {
        get => _breakpoint;
        set
        {
            _breakpoint = Require.NotNegative(value, nameof(Breakpoint));
            Changed();
        }
    }

    /// <summary>
    /// The joint breaks when it had to pull or push its second body harder than this in an update; at least 0. Default
    /// <see cref="float.MaxValue"/>: it does not break. (An addition to the original.)
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float BreakForce
    {
        get => _breakForce;
        set
        {
            _breakForce = Require.NotNegative(value, nameof(BreakForce));
            Changed();
        }
    }

    /// <summary>
    /// 0, the default, is the stiffest. Useful up to 1. Hinges and pins give way under a force by softness · force · dt² /
    /// <see cref="BiasFactor"/>; limits let go of as much; joints of angles leave out this share of each impulse.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Softness
    {
        get => _softness;
        set
        {
            _softness = Require.NotNegative(value, nameof(Softness));
            Changed();
        }
    }

    /// <summary>
    /// The share of an error that an update takes away, at least 0; values above 1 act as 1. Default 0.2. It sets the pace at which an
    /// angle joint turns to its target and at which bodies that were moved apart by hand come together; errors from the motion itself are
    /// always taken away at once.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float BiasFactor
    {
        get => _biasFactor;
        set
        {
            _biasFactor = Require.NotNegative(value, nameof(BiasFactor));
            Changed();
        }
    }

    /// <summary>
    /// False keeps the two bodies of the joint from colliding with each other. Default true. (An addition to the original.)
    /// </summary>
    public bool CollideConnected
    {
        get => _collideConnected;
        set
        {
            _collideConnected = value;
            Changed();
        }
    }

    /// <summary>Anything that you want to keep with the joint. Default null.</summary>
    [NotState(Why.Users)]
    public object? Tag { get; set; }

    /// <summary>
    /// The mean force with which the joint held its second body (a fixed joint: its body) in the last update; (0, 0) for joints of
    /// your own. (An addition to the original.)
    /// </summary>
    public Vector2 ReactionForce => Link.ReactionForce;

    /// <summary>
    /// The mean torque with which the joint turned its second body in the last update, beside that of its force at the anchor. (An addition
    /// to the original.)
    /// </summary>
    public float ReactionTorque => Link.ReactionTorque;

    internal PhysicsSimulator? Simulator { get; set => _mark.Set(ref field, value); }

    PhysicsSimulator? IItem.Simulator
    {
        get => Simulator;
        set => Simulator = value;
    }

    Membership IItem.Membership { get; set => _mark.Set(ref field, value); }

    ref StateMark IStatePart.Mark => ref _mark;

    /// <summary>The last round when something that a state has of it was set; of one of the user's own nobody tells.</summary>
    internal long ChangedIn => IsUserWritten ? long.MaxValue : _mark.ChangedIn;

    /// <summary>Something that a state has of it was set.</summary>
    internal void NoteSet() => _mark.Change();

    /// <summary>The class comes from outside: its <see cref="PreStep"/> and <see cref="Update"/> are called.</summary>
    internal bool IsUserWritten { get; }

    internal bool IsSolvedByEngine => Kind is not null;

    /// <summary>How the engine solves it; null: not at all.</summary>
    internal virtual JointKind? Kind => null;

    /// <summary>First body, or null for the world.</summary>
    internal virtual Body? FirstBody => null;

    internal virtual Body? SecondBody => null;

    /// <summary>Disposes the joint if one of its bodies is disposed. The simulator calls it at the start of each update.</summary>
    public abstract void Validate();

    /// <summary>
    /// Prepares the constraint. Called by the simulator in each iteration for joints of your own: work out masses and bias, apply the
    /// impulse of the last iteration as a start.
    /// </summary>
    /// <param name="inverseDt">1 / the time of the iteration, 1/s.</param>
    public abstract void PreStep(float inverseDt);

    /// <summary>
    /// Solves the constraint: changes velocities. An override should call the base method, which breaks the joint if its
    /// <see cref="JointError"/> is above its <see cref="Breakpoint"/>.
    /// </summary>
    public virtual void Update()
    {
        if (_enabled && Math.Abs(JointError) > _breakpoint)
        {
            Enabled = false;
            RaiseBroke();
        }
    }

    /// <summary>
    /// Disposes the joint: it lets go of its bodies and is swept out of the simulator at its next update. Calling it again does nothing.
    /// </summary>
    public void Dispose()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    /// <summary>Does the work of <see cref="Dispose()"/>.</summary>
    /// <param name="disposing">True when called by <see cref="Dispose()"/>.</param>
    protected virtual void Dispose(bool disposing)
    {
        if (IsDisposed)
        {
            return;
        }

        IsDisposed = true;
        if (disposing)
        {
            Simulator?.NoteDisposed(this);
            Changed();
        }
    }

    /// <summary>Writes what the kind of the joint reads.</summary>
    internal virtual void Fill(ref JointSettings settings, ref JointFlags flags)
    {
    }

    /// <summary>The engine broke the joint.</summary>
    internal void Break()
    {
        _mark.Change();
        _enabled = false;
        RaiseBroke();
    }

    internal void Describe(out JointSettings settings, out JointFlags flags)
    {
        // Some measure something as they are asked for the first time.
        _mark.Change();
        settings = default;
        settings.BiasFactor = Math.Min(1, _biasFactor);
        settings.Softness = _softness;
        settings.MaxImpulse = double.PositiveInfinity;
        settings.Breakpoint = Bound(_breakpoint);
        settings.BreakForce = Bound(_breakForce);
        flags = _enabled && !IsDisposed ? JointFlags.Enabled : JointFlags.None;
        flags |= _collideConnected ? JointFlags.CollideConnected : JointFlags.None;
        Fill(ref settings, ref flags);
    }

    /// <summary>Takes a changed property over into the engine.</summary>
    private protected void Changed()
    {
        _mark.Change();
        if (Link.IsAttached)
        {
            Link.Push(this);
        }
    }

    /// <summary>A body was exchanged: the joint is attached anew at the next update.</summary>
    private protected void BodiesChanged(Body taken)
    {
        _mark.Change();
        Simulator?.NoteChanged(this, taken);
    }

    /// <summary>A body that the joint may have: while it is in a simulator, none of another one.</summary>
    private protected Body Free(Body value, string name)
    {
        Require.NotNull(value, name);
        if (Simulator is not null && value.Simulator is not null && !ReferenceEquals(Simulator, value.Simulator))
        {
            throw new ArgumentException("The body belongs to another simulator than the joint.", name);
        }

        return value;
    }

    /// <summary>Kind, bodies and state, for a debugger.</summary>
    /// <returns>A line of text.</returns>
    public override string ToString() => GetType().Name + (Tag is null ? "" : " " + Tag)
        + (FirstBody is null ? "" : " of [" + FirstBody + "]")
        + (SecondBody is null ? "" : (FirstBody is null ? " of [" : " and [") + SecondBody + "]")
        + (IsDisposed ? ", disposed" : !Enabled ? ", off" : "");

    /// <summary>Keeps the error that the engine last found while the joint is out of it.</summary>
    internal void KeepError(float error)
    {
        _jointError = error;
        _mark.Change();
    }

    /// <summary>The largest float, and infinity, stand for no bound.</summary>
    internal static double Bound(float value) => value >= float.MaxValue ? double.PositiveInfinity : value;

    private void RaiseBroke()
    {
        Simulator?.Relay.Recorder.Broke(this);
        _broke?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Writes, or reads, what later updates read of it.</summary>
    internal virtual void Visit(StateStream s)
    {
        if (s.IsReading)
        {
            _mark.Change();
        }

        Link.Visit(s);
        s.Value(ref _enabled);
        s.Value(ref _breakpoint);
        s.Value(ref _breakForce);
        s.Value(ref _softness);
        s.Value(ref _biasFactor);
        s.Value(ref _collideConnected);
        s.Value(ref _jointError);
        s.Reference(ref _broke);
        IsDisposed = s.Value(IsDisposed);
        Simulator = s.Reference(Simulator);
        ((IItem)this).Membership = s.Value(((IItem)this).Membership);
    }

    /// <summary>It belongs to no simulator any more, by a state from before it was added.</summary>
    internal void TakeOut()
    {
        Link.TakeOut(this);
        Simulator = null;
        ((IItem)this).Membership = Membership.None;
    }

    /// <summary>Lets what no public property shows be saved or set.</summary>
    internal virtual void VisitHidden(IHiddenFields fields)
    {
    }
}
