using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Which resting bodies others are about to meet, touch, or hold by a joint or spring, and which hang together with those again. What is
/// disabled has no contacts and no joints, so a body that rests on it or hangs at it would fall.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed class IdleNeighbors
{
    /// <summary>Surfaces closer than this share of a geom's shorter side touch.</summary>
    private const float TouchShare = 1f / 64;

    private readonly List<Place> _awake = new List<Place>();
    private readonly List<Place> _resting = new List<Place>();
    private readonly List<Body> _marked = new List<Body>();
    private int _left;

    /// <summary>The resting bodies that were reached.</summary>
    public List<Body> Reached { get; } = new List<Body>();

    /// <summary>A body that reaches others.</summary>
    /// <param name="body">The body.</param>
    /// <param name="gravity">Acceleration by gravity.</param>
    /// <param name="dt">The time for which it may go on, seconds.</param>
    public void AddAwake(Body body, Vector2 gravity, float dt)
    {
        Mark(body, IdleState.Awake);
        float inverseMass = body.InverseMass;
        Vector2 velocity = body.LinearVelocity;
        float speedUp = ((body.IgnoreGravity ? 0 : gravity.Length()) * dt)
            + (inverseMass * ((body.Force.Length() * dt) + body.Impulse.Length()));
        Add(_awake, body, velocity * dt, speedUp * dt, Math.Abs(body.AngularVelocity) * dt);
    }

    /// <summary>A body that may be reached.</summary>
    public void AddResting(Body body)
    {
        Mark(body, IdleState.Resting);
        _left++;
        Add(_resting, body, Vector2.Zero, 0, 0);
    }

    /// <summary>Finds what the bodies reach, and what that reaches.</summary>
    public void Spread(JointList joints, SpringList springs)
    {
        int next = 0;
        bool any = true;
        while (any && _left > 0)
        {
            for (; next < _awake.Count && _left > 0; next++)
            {
                Meet(_awake[next]);
            }

            any = false;
            foreach (Joint joint in joints)
            {
                any |= joint.Enabled && !joint.IsDisposed && Tie(joint.FirstBody, joint.SecondBody);
            }

            foreach (Spring spring in springs)
            {
                any |= spring.Enabled && !spring.IsDisposed && Tie(spring.FirstBody, spring.SecondBody);
            }
        }
    }

    /// <summary>Forgets all bodies.</summary>
    public void Clear()
    {
        foreach (Body body in _marked)
        {
            body.Idle &= ~(IdleState.Awake | IdleState.Resting);
        }

        _marked.Clear();
        _awake.Clear();
        _resting.Clear();
        Reached.Clear();
        _left = 0;
    }

    private void Mark(Body body, IdleState state)
    {
        body.Idle |= state;
        _marked.Add(body);
    }

    private static void Add(List<Place> places, Body body, Vector2 way, float more, float turn)
    {
        for (int i = 0; i < body.GeomCount; i++)
        {
            Geom geom = body.GeomAt(i);
            if (geom.Membership == Membership.None || geom.IsDisposed || !geom.CollisionEnabled)
            {
                continue;
            }

            AABB box = geom.AABB;
            Vector2 centre = body.Position;
            float reach = turn > 0 ? Math.Max(Vector2.Distance(centre, box.Min), Vector2.Distance(centre, box.Max)) : 0;
            Vector2 around = new Vector2(more + (turn * reach) + (TouchShare * box.GetShortestSide()));
            places.Add(new Place
            {
                Body = body,
                Min = box.Min - around + Vector2.Min(way, Vector2.Zero),
                Max = box.Max + around + Vector2.Max(way, Vector2.Zero),
            });
        }
    }

    private void Meet(Place place)
    {
        for (int i = _resting.Count - 1; i >= 0; i--)
        {
            // Taking a body shortens the list by its places.
            if (i < _resting.Count && place.Meets(_resting[i]))
            {
                Take(_resting[i].Body);
            }
        }
    }

    private bool Tie(Body? first, Body? second)
    {
        if (first is null || second is null)
        {
            return false;
        }

        if (IsAwake(first) && IsResting(second))
        {
            Take(second);
            return true;
        }

        if (IsAwake(second) && IsResting(first))
        {
            Take(first);
            return true;
        }

        return false;
    }

    private static bool IsAwake(Body body) => (body.Idle & IdleState.Awake) != 0;

    private static bool IsResting(Body body) => (body.Idle & IdleState.Resting) != 0;

    /// <summary>A resting body is reached, and reaches others from now on.</summary>
    private void Take(Body body)
    {
        body.Idle = (body.Idle & ~IdleState.Resting) | IdleState.Awake;
        Reached.Add(body);
        _left--;
        int kept = 0;
        for (int i = 0; i < _resting.Count; i++)
        {
            Place place = _resting[i];
            if (ReferenceEquals(place.Body, body))
            {
                _awake.Add(place);
            }
            else
            {
                _resting[kept++] = place;
            }
        }

        _resting.RemoveRange(kept, _resting.Count - kept);
    }

    /// <summary>The box that a geom may be in.</summary>
    private struct Place
    {
        public Body Body;
        public Vector2 Min;
        public Vector2 Max;

        public readonly bool Meets(in Place other) =>
            Min.X <= other.Max.X && other.Min.X <= Max.X && Min.Y <= other.Max.Y && other.Min.Y <= Max.Y;
    }
}
