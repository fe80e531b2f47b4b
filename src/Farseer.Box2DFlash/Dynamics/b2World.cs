using System;
using System.Globalization;
using System.Numerics;
using Box2D.Bridge;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics;

/// <summary>Bodies, shapes and joints, and the step that moves them. There may be several worlds.</summary>
/// <example>
/// <code>
/// var area = new b2AABB();
/// area.lowerBound.Set(-100, -100);
/// area.upperBound.Set(100, 100);
/// var made = new b2World(area, new b2Vec2(0, 10), doSleep: true);
/// made.Step(1f / 60, 10);
/// </code>
/// </example>
public partial class b2World
{
    private readonly Vector2 _lower;
    private readonly Vector2 _upper;
    [NotState(Why.Fixed)]
    private readonly b2Body _ground;
    [NotState(Why.Fixed)]
    private readonly GravityView _gravity;
    private b2Body? _bodies;
    private b2Joint? _joints;
    private int _bodyCount;
    private int _jointCount;
    [NotState(Why.Calm)]
    private bool _locked;
    private Box2DFlash202Quirks _quirks;

    /// <summary>Makes a world.</summary>
    /// <param name="worldAABB">The region of the bodies, metres; it is copied. A body that leaves it is frozen.</param>
    /// <param name="gravity">Acceleration of all bodies, m/s²; it is copied.</param>
    /// <param name="doSleep">True lets bodies at rest fall asleep.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A value is not finite, or the corners of the region are not in order.</exception>
    /// <exception cref="PlatformNotSupportedException"><c>DOTNET_MaxVectorTBitWidth</c> asks for vectors of 512 bits, and the processor has
    /// them.</exception>
    public b2World(b2AABB worldAABB, b2Vec2 gravity, bool doSleep)
    {
        Require.NotNull(worldAABB, nameof(worldAABB));
        Require.Vector(worldAABB.lowerBound, nameof(worldAABB));
        Require.Vector(worldAABB.upperBound, nameof(worldAABB));
        if (!worldAABB.IsValid())
        {
            throw new ArgumentException(
                $"The lower corner {worldAABB.lowerBound} of the world must lie below and left of the upper one {worldAABB.upperBound}.",
                nameof(worldAABB));
        }

        Require.Vector(gravity, nameof(gravity));
        _lower = new Vector2(worldAABB.lowerBound.x, worldAABB.lowerBound.y);
        _upper = new Vector2(worldAABB.upperBound.x, worldAABB.upperBound.y);
        DoSleep = doSleep;
        Engine = new EngineWorld(this);
        Engine.SetGravity(gravity.x, gravity.y);
        _gravity = new GravityView(this);
        _ground = new b2Body(this, new b2BodyDef());
        _bodies = _ground;
        _bodyCount = 1;
    }

    /// <summary>The deviations of version 2.0.2 that are switched on. Default none.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value has a bit that is no member of the enum.</exception>
    public Box2DFlash202Quirks Quirks
    {
        get => _quirks;
        set
        {
            const Box2DFlash202Quirks All = (Box2DFlash202Quirks)(((int)Box2DFlash202Quirks.MouseJointStiffness << 1) - 1);
            if ((value & ~All) != 0)
            {
                throw new ArgumentOutOfRangeException(
                    nameof(Quirks), value, "The value must be made of members of the enum Box2DFlash202Quirks.");
            }

            _quirks = value;
            Engine.SetGravityWakes((value & Box2DFlash202Quirks.SettersWakeNobody) == 0);
        }
    }

    internal Vector2 Lower => _lower;

    internal Vector2 Upper => _upper;

    internal EngineWorld Engine { get; }

    internal bool DoSleep { get; }

    internal bool IsTelling => _locked;

    internal b2ContactFilter? ContactFilter { get; private set; } = b2ContactFilter.b2_defaultFilter;

    internal b2ContactListener? ContactListener { get; private set; }

    internal b2DestructionListener? DestructionListener { get; private set; }

    internal b2BoundaryListener? BoundaryListener { get; private set; }

    /// <summary>Registers who hears of joints and shapes that go with their body.</summary>
    /// <param name="listener">The listener, or null for none.</param>
    public void SetDestructionListener(b2DestructionListener? listener) => DestructionListener = listener;

    /// <summary>Registers who hears of bodies that leave the world.</summary>
    /// <param name="listener">The listener, or null for none.</param>
    public void SetBoundaryListener(b2BoundaryListener? listener) => BoundaryListener = listener;

    /// <summary>
    /// Registers the filter that decides which shapes collide. Pairs that exist are judged anew only by <see cref="Refilter"/>.
    /// </summary>
    /// <param name="filter">The filter; null lets all shapes collide.</param>
    public void SetContactFilter(b2ContactFilter? filter) => ContactFilter = filter;

    /// <summary>Registers who hears of contact points.</summary>
    /// <param name="listener">The listener, or null for none.</param>
    public void SetContactListener(b2ContactListener? listener)
    {
        ContactListener = listener;
        Engine.ListenerChanged();
    }

    /// <summary>Makes a body.</summary>
    /// <param name="def">The definition; it is copied.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="def"/> is null.</exception>
    /// <exception cref="ArgumentException">A value of it is out of its range.</exception>
    /// <exception cref="InvalidOperationException">The call comes from a listener.</exception>
    public b2Body CreateBody(b2BodyDef def)
    {
        Require.NotNull(def, nameof(def));
        Require.Vector(def.position, nameof(def.position));
        Require.Turn(def.angle, nameof(def.angle));
        Require.NotNegative(def.linearDamping, nameof(def.linearDamping));
        Require.NotNegative(def.angularDamping, nameof(def.angularDamping));
        b2Body.CheckMass(def.massData);
        if (IsLocked(nameof(CreateBody)))
        {
            return null!;
        }

        var body = new b2Body(this, def) { Next = _bodies };
        _bodies = body;
        _bodyCount++;
        body.Link.Attach();
        float inertia = def.fixedRotation ? 0 : def.massData.I;
        body.ApplyMass(def.massData.mass, inertia, def.massData.center.x, def.massData.center.y);
        body.Link.IsBullet = def.isBullet;
        body.AllowSleeping(def.allowSleep);
        if (def.isSleeping)
        {
            body.PutToSleep();
        }

        return body;
    }

    /// <summary>Destroys a body with its shapes and joints, of which the destruction listener is told first.</summary>
    /// <param name="b">The body.</param>
    /// <exception cref="ArgumentNullException"><paramref name="b"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="b"/> is of another world, destroyed already, or the ground body.</exception>
    /// <exception cref="InvalidOperationException">The call comes from a listener.</exception>
    public void DestroyBody(b2Body b)
    {
        CheckMine(b, nameof(b));
        if (ReferenceEquals(b, _ground))
        {
            throw new ArgumentException("The ground body belongs to the world.", nameof(b));
        }

        if (IsLocked(nameof(DestroyBody)))
        {
            return;
        }

        Lock();
        try
        {
            while (b.Joints is { } edge)
            {
                Destroy(edge.joint, true);
            }

            while (b.Shapes is { } shape)
            {
                SayGoodbye(shape);
                b.RemoveShape(shape);
            }

            Unlist(b);
        }
        finally
        {
            Unlock();
        }
    }

    private void Unlist(b2Body b)
    {
        if (ReferenceEquals(_bodies, b))
        {
            _bodies = b.Next;
        }
        else
        {
            b2Body before = _bodies!;
            while (!ReferenceEquals(before.Next, b))
            {
                before = before.Next!;
            }

            before.Next = b.Next;
        }

        _bodyCount--;
        b.IsAlive = false;
        b.Next = null;
        b.Link.Detach();
    }

    /// <summary>The body that belongs to the world: static, at the origin, without shapes at first.</summary>
    /// <returns>The body; it counts in <see cref="GetBodyCount"/> and is the last of the list.</returns>
    public b2Body GetGroundBody() => _ground;

    /// <summary>The first body: the one made last.</summary>
    /// <returns>The body.</returns>
    public b2Body? GetBodyList() => _bodies;

    /// <summary>The first joint: the one made last.</summary>
    /// <returns>The joint, or null.</returns>
    public b2Joint? GetJointList() => _joints;

    /// <summary>The first contact: the one made last.</summary>
    /// <returns>The contact, or null.</returns>
    public b2Contact? GetContactList() => Engine.Contacts.First;

    /// <summary>The number of shapes, without those of frozen bodies.</summary>
    /// <returns>0 or more.</returns>
    public int GetProxyCount()
    {
        int count = 0;
        for (b2Body? body = _bodies; body is not null; body = body.Next)
        {
            for (b2Shape? shape = body.IsFrozen() ? null : body.Shapes; shape is not null; shape = shape.Next)
            {
                count++;
            }
        }

        return count;
    }

    /// <summary>
    /// How many pairs of shapes have boxes that overlap now, whether or not they may collide. It looks at all shapes.
    /// </summary>
    /// <returns>0 or more.</returns>
    public int GetPairCount()
    {
        int count = 0;
        Engine.VisitPairs((_, _) => count++);
        return count;
    }

    /// <summary>The number of bodies, the ground body included.</summary>
    /// <returns>1 or more.</returns>
    public int GetBodyCount() => _bodyCount;

    /// <summary>The number of joints.</summary>
    /// <returns>0 or more.</returns>
    public int GetJointCount() => _jointCount;

    /// <summary>
    /// How many contacts there are: pairs whose boxes overlap now and which may collide, whether or not they touch. It looks at all
    /// shapes, and does not ask the filter.
    /// </summary>
    /// <returns>0 or more.</returns>
    public int GetContactCount()
    {
        int count = 0;
        Engine.VisitPairs((a, b) =>
        {
            bool none = ReferenceEquals(a.Body, b.Body) || (a.Body!.IsStatic() && b.Body!.IsStatic()) || a.Body.IsConnected(b.Body!);
            count += none || Engine.IsRefused(a, b) ? 0 : 1;
        });
        return count;
    }

    /// <summary>Judges the pairs of a shape anew, after <see cref="b2Shape.SetFilterData"/>.</summary>
    /// <param name="shape">The shape.</param>
    /// <exception cref="ArgumentNullException"><paramref name="shape"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="shape"/> is destroyed or of another world.</exception>
    /// <exception cref="InvalidOperationException">The call comes from a listener.</exception>
    public void Refilter(b2Shape shape)
    {
        Require.NotNull(shape, nameof(shape));
        if (shape.Body is null || !ReferenceEquals(shape.Body.World, this))
        {
            throw new ArgumentException("The shape does not belong to this world.", nameof(shape));
        }

        if (!IsLocked(nameof(Refilter)))
        {
            shape.Body.WakeUp();
            Lock();
            try
            {
                Engine.Refilter(shape);
            }
            finally
            {
                Unlock();
            }
        }
    }

    /// <summary>
    /// Whether a step is under way, or something is being destroyed or moved: nothing may be made or destroyed then. (An addition to the
    /// original, whose field <c>m_lock</c> was read.)
    /// </summary>
    /// <returns>True while listeners are told.</returns>
    public bool IsLocked() => _locked;

    /// <summary>
    /// Gravity, m/s²: the vector itself, so that setting a component of it sets that of the world. (An addition to the original.)
    /// </summary>
    /// <returns>The vector, which follows the world.</returns>
    public b2Vec2 GetGravity() => _gravity;

    /// <summary>Changes gravity.</summary>
    /// <param name="gravity">m/s², finite; it is copied.</param>
    /// <exception cref="ArgumentException"><paramref name="gravity"/> is null or not finite.</exception>
    public void SetGravity(b2Vec2 gravity)
    {
        Require.Vector(gravity, nameof(gravity));
        Engine.SetGravity(gravity.x, gravity.y);
    }

    internal bool Overlaps(Vector2 min, Vector2 max) =>
        min.X <= _upper.X && max.X >= _lower.X && min.Y <= _upper.Y && max.Y >= _lower.Y;

    internal void CheckMine(b2Body? body, string name)
    {
        Require.NotNull(body, name);
        if (!body!.IsAlive || !ReferenceEquals(body.World, this))
        {
            throw new ArgumentException("The body is destroyed or belongs to another world.", name);
        }
    }

    /// <summary>
    /// Begins a change that listeners hear of. Until its end they find the world locked as in a step, and what they throw waits: a body
    /// half destroyed is in no state to be changed again.
    /// </summary>
    internal void Lock() => _locked = true;

    /// <summary>Ends the change; what a listener threw comes out.</summary>
    internal void Unlock()
    {
        _locked = false;
        Engine.Rethrow();
    }

    /// <summary>Within a step, and while something is destroyed or moved, nothing may be made or destroyed.</summary>
    /// <returns>True if the call is to do nothing, which is a quirk.</returns>
    internal bool IsLocked(string call)
    {
        if (!_locked)
        {
            return false;
        }

        if ((Quirks & Box2DFlash202Quirks.LockedCallsDoNothing) != 0)
        {
            return true;
        }

        throw new InvalidOperationException(string.Format(
            CultureInfo.InvariantCulture,
            "The world is locked: {0} must not be called by a listener or filter. Keep what you need and act after the call that told you.",
            call));
    }
}
