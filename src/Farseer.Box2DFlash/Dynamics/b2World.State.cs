using System;
using Box2D.Collision.Shapes;
using Box2D.Dynamics.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics;

/// <content>Saving and restoring in place.</content>
public partial class b2World
{
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
    /// <param name="state">Where to; what it held is lost.</param>
    /// <exception cref="ArgumentNullException"><paramref name="state"/> is null.</exception>
    /// <exception cref="InvalidOperationException">A step runs.</exception>
    public void Capture(b2WorldState state)
    {
        Bridge.Require.NotNull(state, nameof(state));
        RequireOutside(nameof(Capture));
        state.Owner = null;
        Gather(state);
        StateStream s = state.Stream;
        s.BeginWriting();
        Visit(s, state);
        s.EndWriting();
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

        TakeOutAll();
        StateStream s = state.Stream;
        s.BeginReading();
        Visit(s, state);
        s.EndReading();
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

    private void Gather(b2WorldState state)
    {
        state.Bodies.Clear();
        state.Shapes.Clear();
        state.Joints.Clear();
        for (b2Body? body = _bodies; body is not null; body = body.Next)
        {
            state.Bodies.Add(body);
            for (b2Shape? shape = body.Shapes; shape is not null; shape = shape.Next)
            {
                state.Shapes.Add(shape);
            }
        }

        for (b2Joint? joint = _joints; joint is not null; joint = joint.Next)
        {
            state.Joints.Add(joint);
        }
    }

    private void Visit(StateStream s, b2WorldState state)
    {
        Engine.Visit(s);
        s.Reference(ref _bodies);
        s.Reference(ref _joints);
        s.Value(ref _bodyCount);
        s.Value(ref _jointCount);
        s.Value(ref _quirks);
        ContactFilter = s.Reference(ContactFilter);
        ContactListener = s.Reference(ContactListener);
        DestructionListener = s.Reference(DestructionListener);
        BoundaryListener = s.Reference(BoundaryListener);
        foreach (b2Body body in state.Bodies)
        {
            body.Visit(s);
        }

        foreach (b2Shape shape in state.Shapes)
        {
            shape.Visit(s);
        }

        foreach (b2Joint joint in state.Joints)
        {
            joint.Visit(s);
        }

        if (s.IsReading)
        {
            Engine.ClearShapes();
            foreach (b2Shape shape in state.Shapes)
            {
                Engine.Enter(shape);
            }
        }

        Engine.Contacts.Visit(s);
    }
}
