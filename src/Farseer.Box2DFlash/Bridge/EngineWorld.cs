using System;
using System.Numerics;
using System.Runtime.ExceptionServices;
using Box2D.Collision.Shapes;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Queries;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;

namespace Box2D.Bridge;

/// <summary>
/// The engine's world with what the facade knows of it: which shape a collider is, which contacts there are, and who listens.
/// </summary>
internal sealed class EngineWorld : IStepHooks
{
    /// <summary>Depth of rest in slops: where bodies of the original come to rest at its usual settings.</summary>
    private const float RestShare = 0.5f;

    /// <summary>For small bodies that would be much: they rest no deeper than this share of their size.</summary>
    private const float UsualMostRestShare = 1f / 256;

    /// <summary>
    /// Share of half its size that a resting body may move: what the original's slowest speed makes of a body of a metre in the time to
    /// sleep.
    /// </summary>
    private const float RestTolerance = 2 * Box2D.Common.b2Settings.b2_linearSleepTolerance * Box2D.Common.b2Settings.b2_timeToSleep;

    private readonly b2World _world;
    private readonly ListenerRelay _relay;
    [NotState(Why.Derived)]
    private b2Shape?[] _shapes = new b2Shape?[16];
    [NotState(Why.OfOneStep)]
    private readonly IndexList _found = new IndexList();
    [NotState(Why.Calm)]
    private ExceptionDispatchInfo? _failure;
    private long _step;

    public EngineWorld(b2World world)
    {
        _world = world;
        _relay = new ListenerRelay(world, this);
        WorldSettings settings = World.Settings;
        settings.AllowedPenetration = RestShare * Box2D.Common.b2Settings.b2_linearSlop;
        settings.AllowedPenetrationShare = UsualMostRestShare;
        settings.BounceThreshold = Box2D.Common.b2Settings.b2_velocityThreshold;
        settings.FrictionMix = FrictionMix.GeometricMean;
        settings.RestitutionMix = RestitutionMix.Maximum;
        settings.MostDrivenSpeed = Box2D.Common.b2Settings.b2_maxLinearVelocity;
        settings.MostDrivenSpin = Box2D.Common.b2Settings.b2_maxAngularVelocity;
        settings.AllowSleep = true;
        settings.RestShare = RestTolerance;

        // A body can be put to sleep also in a world in which none falls asleep.
        settings.TimeToSleep = world.DoSleep ? Box2D.Common.b2Settings.b2_timeToSleep : float.MaxValue;
        World.Hooks = this;
    }

    public World World { get; } = new World();

    /// <summary>Share of their size that bodies rest in each other at most: half a slop, where that is less.</summary>
    public float MostRestShare
    {
        get => World.Settings.AllowedPenetrationShare;
        set => World.Settings.AllowedPenetrationShare = value;
    }

    public ContactBook Contacts { get; } = new ContactBook();

    public ulong MotionHash() => World.Bodies.MotionHash();

    public void SetGravityWakes(bool wakes) => World.Settings.GravityWakes = wakes;

    /// <summary>What ties a joint to this engine.</summary>
    public JointTie Tie(JointKind kind, bool collideConnected) => new JointTie(World, kind, collideConnected);

    public void SetContinuous(bool flag) => World.Settings.Continuous = flag;

    public void SetWarmStarting(bool flag) => World.Settings.KeepImpulses = flag;

    public void SetPositionCorrection(bool flag) => World.Settings.CorrectPositions = flag;

    public Vector2 Gravity => World.Settings.Gravity;

    public void SetGravity(float x, float y) => World.Settings.Gravity = new Vector2(x, y);

    public void Step(float dt, int iterations)
    {
        World.Settings.Substeps = iterations;
        _step++;
        SharedScratch.Step(World, dt);
        _relay.Results();
        EndDistantContacts();
    }

    /// <summary>Throws what a listener threw within the step.</summary>
    public void Rethrow()
    {
        ExceptionDispatchInfo? failure = _failure;
        _failure = null;
        failure?.Throw();
    }

    public void Keep(Exception exception) => _failure ??= ExceptionDispatchInfo.Capture(exception);

    public void Attach(b2Shape shape)
    {
        BodyLink body = shape.Body!.Link;
        if (body.IsFrozen)
        {
            return;
        }

        shape.Link.Collider = World.CreateCollider(body.Handle, shape.Geometry(), new ColliderDef
        {
            Flags = Flags(shape),
            Friction = shape.GetFriction(),
            Restitution = shape.GetRestitution(),
            Categories = uint.MaxValue,
            CollidesWith = uint.MaxValue,
            Offset = Offset(shape, body),
        });
        shape.Link.IsAttached = true;
        int index = shape.Link.Collider.Index;
        EnsurePlace(index);
        _shapes[index] = shape;
    }

    private void EnsurePlace(int index)
    {
        if (index >= _shapes.Length)
        {
            Array.Resize(ref _shapes, Math.Max(index + 1, _shapes.Length * 2));
        }
    }

    public void Detach(b2Shape shape)
    {
        if (shape.Link.IsAttached)
        {
            EndContacts(shape);
            _shapes[shape.Link.Collider.Index] = null;
            shape.Link.IsAttached = false;
            World.DestroyCollider(shape.Link.Collider);
        }
    }

    /// <summary>Ends the contacts of a shape: its points are removed, and bodies that it touched wake.</summary>
    public void EndContacts(b2Shape shape)
    {
        b2Contact? contact = Contacts.First;
        while (contact is not null)
        {
            b2Contact? next = contact.Next;
            if (ReferenceEquals(contact.Shape1, shape) || ReferenceEquals(contact.Shape2, shape))
            {
                End(contact);
            }

            contact = next;
        }
    }

    public void EndContacts(b2Body body)
    {
        for (b2Shape? s = body.Shapes; s is not null; s = s.Next)
        {
            EndContacts(s);
        }
    }

    /// <summary>Ends the contacts between two bodies that a joint keeps from colliding.</summary>
    public void EndContacts(b2Body body, b2Body other)
    {
        b2Contact? contact = Contacts.First;
        while (contact is not null)
        {
            b2Contact? next = contact.Next;
            b2Body? a = contact.Shape1.Body;
            b2Body? b = contact.Shape2.Body;
            if ((ReferenceEquals(a, body) && ReferenceEquals(b, other)) || (ReferenceEquals(a, other) && ReferenceEquals(b, body)))
            {
                End(contact);
            }

            contact = next;
        }
    }

    /// <summary>A body became static or dynamic: its pairs are judged anew.</summary>
    public void KindChanged(b2Body body)
    {
        for (b2Shape? s = body.Shapes; s is not null; s = s.Next)
        {
            Refilter(s);
        }
    }

    public void Refilter(b2Shape shape)
    {
        if (shape.Link.IsAttached)
        {
            EndContacts(shape);
            World.Pairs.Refilter(shape.Link.Collider);
        }
    }

    /// <summary>Before a teleport: notes which contacts of the body are there in the sense of the original, whose boxes overlap.</summary>
    public void Moving(b2Body body)
    {
        for (b2Contact? contact = Contacts.First; contact is not null; contact = contact.Next)
        {
            contact.WasNear = contact.Concerns(body) && BoxesMeet(contact.Shape1, contact.Shape2);
        }
    }

    /// <summary>
    /// After a teleport: contacts whose boxes have parted by it end at once, here and in the engine, and are judged anew where they meet
    /// again. What the engine only foresees goes on: a pose that is set to what it is ends nothing.
    /// </summary>
    public void Moved(b2Body body)
    {
        b2Contact? contact = Contacts.First;
        while (contact is not null)
        {
            b2Contact? next = contact.Next;
            if (contact.WasNear && !BoxesMeet(contact.Shape1, contact.Shape2))
            {
                End(contact);
                World.Pairs.EndPair(contact.Shape1.Link.Collider, contact.Shape2.Link.Collider);
            }

            contact = next;
        }
    }

    /// <summary>Whether no shape of the body lies wholly outside of the world.</summary>
    public bool IsInside(b2Body body)
    {
        for (b2Shape? s = body.Shapes; s is not null; s = s.Next)
        {
            if (s.Link.IsAttached)
            {
                World.Reader.GetColliderBox(s.Link.Collider, out Vector2 min, out Vector2 max);
                if (!_world.Overlaps(min, max))
                {
                    return false;
                }
            }
        }

        return true;
    }

    /// <summary>Finds what overlaps a box with its own box, in the order of the making: to be asked for by <see cref="Found"/>.</summary>
    /// <returns>How many there are.</returns>
    public int Find(Vector2 lower, Vector2 upper)
    {
        World.Queries.FindInBox(new Box { MinX = lower.X, MinY = lower.Y, MaxX = upper.X, MaxY = upper.Y }, QueryFilter.All, _found);
        return _found.Count;
    }

    /// <summary>The shape that a collider stands for, if there is one.</summary>
    public b2Shape? ShapeOf(int collider) => collider >= 0 && collider < _shapes.Length ? _shapes[collider] : null;

    /// <summary>What <see cref="Find"/> found at a place; null if it is no shape any more.</summary>
    public b2Shape? Found(int place) => _shapes[_found[place]];

    /// <summary>
    /// Calls for each pair of shapes whose boxes overlap now, whatever bodies they belong to; to within a slop, for what a
    /// listener has heard touch may be a little apart.
    /// </summary>
    public void VisitPairs(Action<b2Shape, b2Shape> visit)
    {
        foreach (b2Shape? shape in _shapes)
        {
            if (shape is null || shape.Body!.IsFrozen())
            {
                continue;
            }

            World.Reader.GetColliderBox(shape.Link.Collider, out Vector2 min, out Vector2 max);
            float near = Box2D.Common.b2Settings.b2_linearSlop;
            Box box = new Box { MinX = min.X - near, MinY = min.Y - near, MaxX = max.X + near, MaxY = max.Y + near };
            World.Queries.FindInBox(box, QueryFilter.All, _found);
            for (int i = 0; i < _found.Count; i++)
            {
                b2Shape? other = _shapes[_found[i]];
                if (other is not null && shape.Link.Collider.Index < other.Link.Collider.Index)
                {
                    visit(shape, other);
                }
            }
        }
    }

    /// <summary>Whether the filter has said that two shapes do not collide.</summary>
    public bool IsRefused(b2Shape a, b2Shape b) => Contacts.Find(a.Link.Collider.Index, b.Link.Collider.Index) is { IsAccepted: false };

    public void BoxOf(b2Shape shape, out Vector2 min, out Vector2 max) =>
        World.Reader.GetColliderBox(shape.Link.Collider, out min, out max);

    /// <summary>Whether the boxes of two shapes overlap, to within a slop: what a listener has heard touch may be a little apart.</summary>
    private bool BoxesMeet(b2Shape a, b2Shape b)
    {
        const float Near = Box2D.Common.b2Settings.b2_linearSlop;
        World.Reader.GetColliderBox(a.Link.Collider, out Vector2 minA, out Vector2 maxA);
        World.Reader.GetColliderBox(b.Link.Collider, out Vector2 minB, out Vector2 maxB);
        return minA.X - maxB.X <= Near && minB.X - maxA.X <= Near && minA.Y - maxB.Y <= Near && minB.Y - maxA.Y <= Near;
    }

    /// <summary>Friction, restitution or what it does to others changed.</summary>
    public void MaterialChanged(b2Shape shape)
    {
        if (shape.Link.IsAttached)
        {
            ref ColliderInfo info = ref World.Collider(shape.Link.Collider);
            info.Friction = shape.GetFriction();
            info.Restitution = shape.GetRestitution();
            info.Flags = Flags(shape);
            World.NoteChanged(shape.Link.Collider);
        }
    }

    /// <summary>Tells the engine whether somebody listens: pairs that nobody hears of cost nothing.</summary>
    public void ListenerChanged()
    {
        foreach (b2Shape? shape in _shapes)
        {
            if (shape is not null)
            {
                World.Collider(shape.Link.Collider).Flags = Flags(shape);
            }
        }
    }

    bool IStepHooks.JudgesPairs => true;

    bool IStepHooks.AcceptPair(int colliderA, int colliderB)
    {
        b2Shape? a = _shapes[colliderA];
        b2Shape? b = _shapes[colliderB];
        if (a is null || b is null)
        {
            return false;
        }

        b2Contact? known = Contacts.Find(colliderA, colliderB);
        if (known is null)
        {
            known = Contacts.Add(a, b, Ask(a, b));
        }

        return known.IsAccepted;
    }

    ContactAnswer IStepHooks.OnContact(int colliderA, int colliderB, ReadOnlySpan<ContactPoint> points, bool began)
    {
        b2Contact? contact = Contacts.Find(colliderA, colliderB);
        if (contact is not null)
        {
            contact.Points.Take(points, !ReferenceEquals(contact.Shape1, _shapes[colliderA]), _step);

            // An impact of a fast body is found while the step ends, after the other points were told.
            if (_relay.ToldStep == _step)
            {
                _relay.PointsOf(contact);
            }
        }

        return ContactAnswer.Respond;
    }

    void IStepHooks.OnSeparation(int colliderA, int colliderB)
    {
    }

    void IStepHooks.OnPush(int colliderA, int colliderB, in PushRecord push)
    {
    }

    void IStepHooks.ApplyForces(float dt) => _relay.Points(_step);

    private static Vector2 Offset(b2Shape shape, BodyLink body)
    {
        var center = new Vector2((float)-body.CenterX, (float)-body.CenterY);
        return shape is b2CircleShape circle ? center + circle.Center : center;
    }

    private ColliderFlags Flags(b2Shape shape)
    {
        ColliderFlags flags = ColliderFlags.Alive | ColliderFlags.CollisionEnabled;
        flags |= shape.IsSensor() ? ColliderFlags.None : ColliderFlags.ResponseEnabled;
        return _world.ContactListener is null ? flags : flags | ColliderFlags.WantsContact;
    }

    private bool Ask(b2Shape a, b2Shape b)
    {
        if (_world.ContactFilter is null)
        {
            return true;
        }

        try
        {
            return _world.ContactFilter.ShouldCollide(a, b);
        }
        catch (Exception exception)
        {
            Keep(exception);
            return true;
        }
    }

    private void End(b2Contact contact)
    {
        _relay.Removed(contact);
        Contacts.Remove(contact);
    }

    private void EndDistantContacts()
    {
        b2Contact? contact = Contacts.First;
        while (contact is not null)
        {
            b2Contact? next = contact.Next;
            if (!World.Reader.AreNear(contact.Shape1.Link.Collider, contact.Shape2.Link.Collider))
            {
                End(contact);
            }

            contact = next;
        }
    }

    /// <summary>Writes, or reads, what later steps read of it, but for the contacts.</summary>
    public void Visit(StateStream s)
    {
        World.Visit(s);
        s.Value(ref _step);
        _relay.Visit(s);
    }

    /// <summary>Forgets which shape has which collider.</summary>
    public void ClearShapes() => Array.Clear(_shapes, 0, _shapes.Length);

    /// <summary>Tells which collider a shape has.</summary>
    public void Enter(b2Shape shape)
    {
        if (shape.Link.IsAttached)
        {
            int index = shape.Link.Collider.Index;
            EnsurePlace(index);
            _shapes[index] = shape;
        }
    }
}
