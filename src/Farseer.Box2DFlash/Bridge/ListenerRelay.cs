using System;
using System.Numerics;
using Box2D.Collision;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;

namespace Box2D.Bridge;

/// <summary>
/// Tells the contact listener. The engine hands over points while it finds contacts, in its own order; they are told when it has
/// found all, contact by contact from the newest to the oldest as in the original, before the solver.
/// </summary>
internal sealed class ListenerRelay
{
    private readonly b2World _world;
    private readonly EngineWorld _engine;
    [NotState(Why.OfOneStep)]
    private readonly b2ContactPoint _point = new b2ContactPoint();
    [NotState(Why.OfOneStep)]
    private readonly b2ContactResult _result = new b2ContactResult();

    public ListenerRelay(b2World world, EngineWorld engine)
    {
        _world = world;
        _engine = engine;
    }

    /// <summary>The last step whose points were told.</summary>
    public long ToldStep { get; private set; } = -1;

    /// <summary>Points that came, stayed or went in this step.</summary>
    public void Points(long step)
    {
        ToldStep = step;
        if (_world.ContactListener is null)
        {
            return;
        }

        for (b2Contact? contact = _engine.Contacts.First; contact is not null; contact = contact.Next)
        {
            if (contact.Points.Step == step)
            {
                PointsOf(contact);
            }
            else if (!IsAsleep(contact))
            {
                Removed(contact);
            }
        }
    }

    public void PointsOf(b2Contact contact)
    {
        ContactPoints points = contact.Points;
        for (int i = 0; i < points.Count; i++)
        {
            Tell(contact, ref points[i], points.WasThere(points[i].FeatureId) ? Happening.Persist : Happening.Add);
        }

        for (int i = 0; i < points.BeforeCount; i++)
        {
            if (!points.IsThere(points.Before(i).FeatureId))
            {
                Tell(contact, ref points.Before(i), Happening.Remove);
            }
        }
    }

    /// <summary>What the solver did. Then the present points become those before.</summary>
    public void Results()
    {
        if (_world.ContactListener is null)
        {
            return;
        }

        for (b2Contact? contact = _engine.Contacts.First; contact is not null; contact = contact.Next)
        {
            ContactPoints points = contact.Points;
            if (points.Step != ToldStep)
            {
                continue;
            }

            for (int i = 0; i < points.Count; i++)
            {
                if (contact.IsSolid())
                {
                    Tell(contact, ref points[i]);
                }
            }

            points.Turn();
        }
    }

    /// <summary>All points of a contact are gone.</summary>
    public void Removed(b2Contact contact)
    {
        ContactPoints points = contact.Points;
        for (int i = 0; i < points.BeforeCount; i++)
        {
            Tell(contact, ref points.Before(i), Happening.Remove);
        }

        points.Clear();
    }

    /// <summary>Nothing happens between bodies asleep, or one and a static one: what touched goes on touching.</summary>
    private static bool IsAsleep(b2Contact contact)
    {
        b2Body a = contact.Shape1.Body!;
        b2Body b = contact.Shape2.Body!;
        return (a.IsSleeping() || a.IsStatic()) && (b.IsSleeping() || b.IsStatic());
    }

    private void Tell(b2Contact contact, ref ContactPoint point, Happening happening)
    {
        b2ContactListener? listener = _world.ContactListener;
        if (listener is null)
        {
            return;
        }

        b2Body a = contact.Shape1.Body!;
        b2Body b = contact.Shape2.Body!;
        _point.shape1 = contact.Shape1;
        _point.shape2 = contact.Shape2;
        _point.position.Set((float)point.X, (float)point.Y);
        _point.normal.Set(point.Normal.X, point.Normal.Y);
        _point.separation = point.Separation;
        _point.id.key = point.FeatureId;
        _point.friction = (float)Math.Sqrt((double)contact.Shape1.GetFriction() * contact.Shape2.GetFriction());
        _point.restitution = Math.Max(contact.Shape1.GetRestitution(), contact.Shape2.GetRestitution());
        a.Link.Arm(point.X, point.Y, out double ax, out double ay);
        b.Link.Arm(point.X, point.Y, out double bx, out double by);
        Vector2 velocity = b.VelocityAtArm(bx, by) - a.VelocityAtArm(ax, ay);
        _point.velocity.Set(velocity.X, velocity.Y);
        try
        {
            switch (happening)
            {
                case Happening.Add:
                    listener.Add(_point);
                    break;
                case Happening.Persist:
                    listener.Persist(_point);
                    break;
                default:
                    listener.Remove(_point);
                    break;
            }
        }
        catch (Exception exception) when (_world.IsTelling)
        {
            _engine.Keep(exception);
        }
    }

    private void Tell(b2Contact contact, ref ContactPoint point)
    {
        // The one before may have taken the listener away.
        b2ContactListener? listener = _world.ContactListener;
        if (listener is null)
        {
            return;
        }

        _result.shape1 = contact.Shape1;
        _result.shape2 = contact.Shape2;
        _result.position.Set((float)point.X, (float)point.Y);
        _result.normal.Set(point.Normal.X, point.Normal.Y);
        _result.id.key = point.FeatureId;
        _engine.World.Reader.TryGetImpulses(
            contact.Shape1.Link.Collider, contact.Shape2.Link.Collider, point.FeatureId, out float normal, out float tangent);
        _result.normalImpulse = normal;
        _result.tangentImpulse = tangent;
        try
        {
            listener.Result(_result);
        }
        catch (Exception exception)
        {
            _engine.Keep(exception);
        }
    }

    private enum Happening
    {
        Add,
        Persist,
        Remove,
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s) => ToldStep = s.Value(ToldStep);
}
