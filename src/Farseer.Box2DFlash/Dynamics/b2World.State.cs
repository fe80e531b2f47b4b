using System;
using Box2D.Collision.Shapes;
using Box2D.Dynamics.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics;

/// <content>Saving and restoring in place.</content>
public partial class b2World
{
    // Only while a state is written or read.
    [NotState(Why.OfOneStep)]
    private Bridge.StateRoster? _roster;

    // What a hash is made of: filled each time.
    [NotState(Why.OfOneStep)]
    private StateStream? _hashed;

    /// <summary>For <see cref="Write"/> and <see cref="Read"/> to fill: empty between calls.</summary>
    internal Bridge.StateRoster Roster => _roster ??= new Bridge.StateRoster();

    /// <summary>Captures the state into a new object: see <see cref="Capture(b2WorldState)"/>.</summary>
    /// <returns>The state.</returns>
    /// <exception cref="InvalidOperationException">A step runs.</exception>
    public b2WorldState Capture()
    {
        var state = new b2WorldState();
        Capture(state);
        return state;
    }

    /// <summary>
    /// Captures everything that influences a later step or event: poses, velocities, impulses from which the next step starts,
    /// sleep, joints, filters, listeners and settings. After <see cref="Restore"/> the same calls give the same bits.
    /// </summary>
    /// <remarks>Not captured: user data, the debug drawing, and the state of listeners.</remarks>
    /// <param name="state">The state to fill; what it held is lost.</param>
    /// <exception cref="ArgumentNullException"><paramref name="state"/> is null.</exception>
    /// <exception cref="InvalidOperationException">A step runs.</exception>
    public void Capture(b2WorldState state)
    {
        Bridge.Require.NotNull(state, nameof(state));
        RequireOutside(nameof(Capture));
        state.Owner = null;
        Write(state.Stream, Roster);
        state.Owner = this;
    }

    /// <summary>
    /// Goes back to a state. Bodies, shapes and joints stay the same instances: what was made since is destroyed, without a listener
    /// being told; what was destroyed since is back. Contacts are views, and others than before.
    /// </summary>
    /// <param name="state">A state of this world.</param>
    /// <exception cref="ArgumentNullException"><paramref name="state"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="state"/> holds nothing, or is of another world.</exception>
    /// <exception cref="InvalidOperationException">A step runs.</exception>
    public void Restore(b2WorldState state)
    {
        Bridge.Require.NotNull(state, nameof(state));
        RequireOutside(nameof(Restore));
        if (!ReferenceEquals(state.Owner, this))
        {
            throw new ArgumentException(state.Owner is null ? "The state holds nothing." : "The state is of another world.", nameof(state));
        }

        Read(state.Stream, Roster);
    }

    /// <summary>
    /// A 64-bit hash of all that <see cref="Capture(b2WorldState)"/> captures: two worlds that were made by the same program and have the
    /// same hash go on alike. It is the same on every processor and with every number of workers, and takes as long as two or
    /// three captures. (An addition to the original.)
    /// </summary>
    /// <remarks>
    /// References count by whom they refer to, counted in the order of the lists; of listeners it counts only whether there is one.
    /// </remarks>
    /// <returns>The hash.</returns>
    /// <exception cref="InvalidOperationException">A step runs.</exception>
    public ulong StateHash()
    {
        Bridge.StateNames names = Names(this);
        StateStream s = _hashed ??= new StateStream();
        Write(s, Roster);
        ulong hash = names.Hash(s);
        s.ForgetObjects();
        return hash;
    }

    /// <summary>Compares the state with that of another world that was made by the same program. (An addition to the original.)</summary>
    /// <param name="other">The other one.</param>
    /// <param name="most">The search ends when it has found so many differences; at least 1. Default 100.</param>
    /// <returns>The differences, by body, shape, joint or pair and by field, with both values and their bits.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="other"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="most"/> is less than 1.</exception>
    /// <exception cref="InvalidOperationException">A step runs.</exception>
    public b2StateComparison Compare(b2World other, int most = 100)
    {
        Bridge.Require.NotNull(other, nameof(other));
        Bridge.Require.Positive(most, nameof(most));
        return Names(other).Compare(this, Bridge.StateNames.Named(this), Bridge.StateNames.Named(other), false, most);
    }

    /// <summary>Numbers of all that are in this world and in another one.</summary>
    internal Bridge.StateNames Names(b2World other)
    {
        var names = new Bridge.StateNames();
        Enter(names);
        if (!ReferenceEquals(other, this))
        {
            other.Enter(names);
        }

        return names;
    }

    /// <summary>The body in a slot of the engine, if there is one.</summary>
    internal b2Body? BodyOf(int slot)
    {
        b2Body? body = _bodies;
        while (body is not null && !body.Link.IsIn(slot))
        {
            body = body.Next;
        }

        return body;
    }

    private void Enter(Bridge.StateNames names)
    {
        Gather(Roster);
        names.Enter(Roster);
        Roster.Clear();
    }

    /// <summary>Captures into a stream.</summary>
    internal void Write(StateStream s, Bridge.StateRoster roster)
    {
        RequireOutside(nameof(Capture));
        Gather(roster);
        s.BeginWriting();
        Visit(s, roster);
        s.EndWriting();
        roster.Clear();
    }

    /// <summary>Restores from a stream.</summary>
    internal void Read(StateStream s, Bridge.StateRoster roster)
    {
        RequireOutside(nameof(Restore));
        TakeOutAll();
        s.BeginReading();
        Visit(s, roster);
        s.EndReading();
        roster.Clear();
    }

    private void RequireOutside(string call)
    {
        if (_locked || Engine.World.IsStepping)
        {
            throw new InvalidOperationException(call + " must not be called while the world is in a step.");
        }
    }

    // All are as destroyed; those that are in the state are set to it next.
    private void TakeOutAll()
    {
        while (_joints is { } joint)
        {
            _joints = joint.Next;
            joint.Next = null;
            joint.Link.TakeOut();
        }

        while (_bodies is { } body)
        {
            _bodies = body.Next;
            body.Link.TakeOut();
            body.IsAlive = false;
            body.Next = null;
            body.Joints = null;
            while (body.Shapes is { } shape)
            {
                body.Shapes = shape.Next;
                shape.Next = null;
                shape.Body = null;
                shape.Link.IsAttached = false;
            }
        }
    }

    private void Gather(Bridge.StateRoster roster)
    {
        roster.Clear();
        for (b2Body? body = _bodies; body is not null; body = body.Next)
        {
            roster.Bodies.Add(body);
            for (b2Shape? shape = body.Shapes; shape is not null; shape = shape.Next)
            {
                roster.Shapes.Add(shape);
            }
        }

        for (b2Joint? joint = _joints; joint is not null; joint = joint.Next)
        {
            roster.Joints.Add(joint);
        }
    }

    private void Visit(StateStream s, Bridge.StateRoster roster)
    {
        roster.Visit(s);
        Engine.Visit(s);
        s.Section();
        s.Of(nameof(b2World)).Reference(ref _bodies);
        s.Reference(ref _joints);
        s.Value(ref _bodyCount);
        s.Value(ref _jointCount);
        s.Value(ref _quirks);
        ContactFilter = s.Reference(ContactFilter);
        ContactListener = s.Reference(ContactListener);
        DestructionListener = s.Reference(DestructionListener);
        BoundaryListener = s.Reference(BoundaryListener);
        s.Section();
        for (int i = 0; i < roster.Bodies.Count; i++)
        {
            b2Body body = roster.Bodies[i];
            body.Visit(s.Of(nameof(b2Body), i, body));
        }

        s.Section();
        for (int i = 0; i < roster.Shapes.Count; i++)
        {
            b2Shape shape = roster.Shapes[i];
            shape.Visit(s.Of(nameof(b2Shape), i, shape));
        }

        s.Section();
        for (int i = 0; i < roster.Joints.Count; i++)
        {
            b2Joint joint = roster.Joints[i];
            joint.Visit(s.Of(nameof(b2Joint), i, joint));
        }

        if (s.IsReading)
        {
            Engine.ClearShapes();
            foreach (b2Shape shape in roster.Shapes)
            {
                Engine.Enter(shape);
            }
        }

        Engine.Contacts.Visit(s.Of("Contacts"));
    }
}
