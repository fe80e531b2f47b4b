using System;
using System.Collections.Generic;
using Box2D.Bridge;
using Box2D.Collision.Shapes;
using Box2D.Dynamics.Joints;

namespace Box2D.Dynamics;

/// <content>Joints.</content>
public partial class b2World
{
    /// <summary>Makes a joint.</summary>
    /// <param name="def">The definition; it is copied.</param>
    /// <returns>The joint.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="def"/> is null or has no bodies.</exception>
    /// <exception cref="ArgumentException">A value of it is out of its range, or the bodies are the same or not of this world.</exception>
    /// <exception cref="InvalidOperationException">The call comes from a listener.</exception>
    public b2Joint CreateJoint(b2JointDef def)
    {
        Require.NotNull(def, nameof(def));
        def.CheckBodies(this);
        if (IsLocked(nameof(CreateJoint)))
        {
            return null!;
        }

        b2Joint joint = def.Make(this);
        List<b2Body>? asleep = (Quirks & Box2DFlash202Quirks.SettersWakeNobody) != 0 ? Sleeping() : null;
        joint.Next = _joints;
        _joints = joint;
        _jointCount++;
        Link(joint.GetBody1(), joint.Edge1);
        Link(joint.GetBody2(), joint.Edge2);
        joint.Attach();
        Lock();
        try
        {
            Settle(joint, asleep);
        }
        finally
        {
            Unlock();
        }

        return joint;
    }

    /// <summary>Destroys a joint and wakes its bodies. A gear that ties it goes first, of which the destruction listener is told.</summary>
    /// <param name="j">The joint.</param>
    /// <exception cref="ArgumentNullException"><paramref name="j"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="j"/> is destroyed or of another world.</exception>
    /// <exception cref="InvalidOperationException">The call comes from a listener.</exception>
    public void DestroyJoint(b2Joint j)
    {
        Require.NotNull(j, nameof(j));
        if (!Holds(j))
        {
            throw new ArgumentException("The joint is destroyed or belongs to another world.", nameof(j));
        }

        if (!IsLocked(nameof(DestroyJoint)))
        {
            Lock();
            try
            {
                Destroy(j, false);
            }
            finally
            {
                Unlock();
            }
        }
    }

    internal bool Holds(b2Joint joint)
    {
        for (b2Joint? j = _joints; j is not null; j = j.Next)
        {
            if (ReferenceEquals(j, joint))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Ends the contacts that a new joint forbids, and wakes its bodies.</summary>
    /// <param name="joint">The joint.</param>
    /// <param name="asleep">Bodies that are to go on sleeping; null: the joint's bodies wake.</param>
    private void Settle(b2Joint joint, List<b2Body>? asleep)
    {
        if (!joint.CollideConnected)
        {
            Engine.EndContacts(joint.GetBody1(), joint.GetBody2());
        }

        if (asleep is null)
        {
            joint.GetBody1().WakeUp();
            joint.GetBody2().WakeUp();
        }
        else
        {
            PutBack(asleep);
        }
    }

    /// <summary>The engine wakes what a new joint reaches; with the quirk it goes on sleeping.</summary>
    private static void PutBack(List<b2Body> asleep)
    {
        foreach (b2Body body in asleep)
        {
            if (!body.IsSleeping())
            {
                body.Link.PutToSleep();
            }
        }
    }

    private void SayGoodbye(b2Joint joint)
    {
        try
        {
            DestructionListener?.SayGoodbyeJoint(joint);
        }
        catch (Exception exception)
        {
            Engine.Keep(exception);
        }
    }

    private void SayGoodbye(b2Shape shape)
    {
        try
        {
            DestructionListener?.SayGoodbyeShape(shape);
        }
        catch (Exception exception)
        {
            Engine.Keep(exception);
        }
    }

    private List<b2Body> Sleeping()
    {
        var bodies = new List<b2Body>();
        for (b2Body? body = _bodies; body is not null; body = body.Next)
        {
            if (body.IsDynamic() && body.IsSleeping())
            {
                bodies.Add(body);
            }
        }

        return bodies;
    }

    private static void Link(b2Body body, b2JointEdge edge)
    {
        edge.next = body.Joints;
        if (body.Joints is not null)
        {
            body.Joints.prev = edge;
        }

        body.Joints = edge;
    }

    private static void Unlink(b2Body body, b2JointEdge edge)
    {
        if (edge.prev is null)
        {
            body.Joints = edge.next;
        }
        else
        {
            edge.prev.next = edge.next;
        }

        if (edge.next is not null)
        {
            edge.next.prev = edge.prev;
        }

        edge.prev = null;
        edge.next = null;
    }

    private void Destroy(b2Joint joint, bool implicitly)
    {
        for (b2Joint? gear = _joints; gear is not null;)
        {
            b2Joint? next = gear.Next;
            if (gear.DependsOn(joint))
            {
                Destroy(gear, true);
            }

            gear = next;
        }

        if (implicitly)
        {
            SayGoodbye(joint);
        }

        if (ReferenceEquals(_joints, joint))
        {
            _joints = joint.Next;
        }
        else
        {
            b2Joint before = _joints!;
            while (!ReferenceEquals(before.Next, joint))
            {
                before = before.Next!;
            }

            before.Next = joint.Next;
        }

        _jointCount--;
        joint.GetBody1().WakeUp();
        joint.GetBody2().WakeUp();
        Unlink(joint.GetBody1(), joint.Edge1);
        Unlink(joint.GetBody2(), joint.Edge2);
        joint.Next = null;
        joint.Link.Detach();
    }
}
