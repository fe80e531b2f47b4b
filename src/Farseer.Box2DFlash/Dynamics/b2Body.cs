using System;
using System.Numerics;
using Box2D.Bridge;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics;

/// <summary>
/// A rigid body, made by <see cref="b2World.CreateBody"/>. Its origin is what shapes and joints are given by; its velocity is that of
/// the centre of mass. A body without mass is static.
/// </summary>
/// <example>
/// <code>
/// var def = new b2BodyDef();
/// def.position.Set(0, -5);
/// b2Body crate = world.CreateBody(def);
/// var box = new b2PolygonDef { density = 1 };
/// box.SetAsBox(0.5f, 0.5f);
/// crate.CreateShape(box);
/// crate.SetMassFromShapes();
/// </code>
/// </example>
public partial class b2Body
{
    /// <summary>Flag of frozen bodies in the original; for code that names it.</summary>
    public const uint e_frozenFlag = 0x0002;

    /// <summary>Flag of bodies in an island in the original.</summary>
    public const uint e_islandFlag = 0x0004;

    /// <summary>Flag of sleeping bodies in the original.</summary>
    public const uint e_sleepFlag = 0x0008;

    /// <summary>Flag of bodies that may sleep in the original.</summary>
    public const uint e_allowSleepFlag = 0x0010;

    /// <summary>Flag of bullets in the original.</summary>
    public const uint e_bulletFlag = 0x0020;

    /// <summary>Flag of bodies that do not turn in the original.</summary>
    public const uint e_fixedRotationFlag = 0x0040;

    /// <summary>A static body.</summary>
    public const uint e_staticType = 1;

    /// <summary>A dynamic body.</summary>
    public const uint e_dynamicType = 2;

    /// <summary>One more than the highest type.</summary>
    public const uint e_maxTypes = 3;

    private readonly bool _fixedRotation;
    [NotState(Why.Fixed)]
    private readonly PlaceView _position;
    [NotState(Why.Fixed)]
    private readonly PlaceView _worldCenter;
    [NotState(Why.Fixed)]
    private readonly PlaceView _localCenter;
    [NotState(Why.Fixed)]
    private readonly VelocityView _velocity;
    [NotState(Why.Fixed)]
    private readonly b2XForm _xf;
    [NotState(Why.Users)]
    private object? _userData;

    internal b2Body(b2World world, b2BodyDef def)
    {
        World = world;
        Link = new BodyLink(world.Engine.World, def);
        _fixedRotation = def.fixedRotation;
        _userData = def.userData;
        _position = new PlaceView(Link, Shown.Position);
        _worldCenter = new PlaceView(Link, Shown.WorldCenter);
        _localCenter = new PlaceView(Link, Shown.LocalCenter);
        _velocity = new VelocityView(this);
        var columns = new b2Mat22(new PlaceView(Link, Shown.FirstColumn), new PlaceView(Link, Shown.SecondColumn), true);
        _xf = new b2XForm(_position, columns, true);
    }

    internal b2World World { get; }

    internal BodyLink Link { get; }

    internal b2Body? Next { get; set; }

    internal b2Shape? Shapes { get; set; }

    internal b2JointEdge? Joints { get; set; }

    /// <summary>False once the body is destroyed.</summary>
    internal bool IsAlive { get; set; } = true;

    internal bool IsFixedRotation => _fixedRotation;

    /// <summary>Makes a shape. Call <see cref="SetMassFromShapes"/> once all are made.</summary>
    /// <param name="def">The definition of the shape; it is copied.</param>
    /// <returns>The shape.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="def"/> is null.</exception>
    /// <exception cref="ArgumentException">A value of it is out of its range, or a polygon is not convex and counter-clockwise.</exception>
    /// <exception cref="InvalidOperationException">The body is destroyed, or the call comes from a listener.</exception>
    public b2Shape CreateShape(b2ShapeDef def)
    {
        Require.NotNull(def, nameof(def));
        CheckAlive();
        if (World.IsLocked(nameof(CreateShape)))
        {
            return null!;
        }

        b2Shape shape = def is b2CircleDef circle ? new b2CircleShape(circle) : new b2PolygonShape((b2PolygonDef)def);
        shape.Body = this;
        shape.Next = Shapes;
        Shapes = shape;
        World.Engine.Attach(shape);
        return shape;
    }

    /// <summary>Destroys a shape of this body. The mass stays as it is until <see cref="SetMassFromShapes"/>.</summary>
    /// <param name="s">The shape.</param>
    /// <exception cref="ArgumentNullException"><paramref name="s"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="s"/> is not a shape of this body.</exception>
    /// <exception cref="InvalidOperationException">The call comes from a listener.</exception>
    public void DestroyShape(b2Shape s)
    {
        Require.NotNull(s, nameof(s));
        CheckAlive();
        if (!ReferenceEquals(s.Body, this))
        {
            throw new ArgumentException("The shape does not belong to this body.", nameof(s));
        }

        if (World.IsLocked(nameof(DestroyShape)))
        {
            return;
        }

        World.Lock();
        try
        {
            RemoveShape(s);
        }
        finally
        {
            World.Unlock();
        }
    }

    internal void RemoveShape(b2Shape s)
    {
        if (ReferenceEquals(Shapes, s))
        {
            Shapes = s.Next;
        }
        else
        {
            b2Shape before = Shapes!;
            while (!ReferenceEquals(before.Next, s))
            {
                before = before.Next!;
            }

            before.Next = s.Next;
        }

        World.Engine.Detach(s);
        s.Body = null;
        s.Next = null;
    }

    /// <summary>Sets mass, centre of mass and inertia. Origin, shapes and joints stay where they are.</summary>
    /// <param name="massData">The values; a mass of 0 makes the body static, whatever the inertia.</param>
    /// <exception cref="ArgumentNullException"><paramref name="massData"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A value is negative or not finite, or its inverse is not.</exception>
    /// <exception cref="InvalidOperationException">The body is destroyed, or the call comes from a listener.</exception>
    public void SetMass(b2MassData massData)
    {
        CheckMass(massData);
        CheckAlive();
        if (!World.IsLocked(nameof(SetMass)))
        {
            ApplyMass(massData.mass, _fixedRotation ? 0 : massData.I, massData.center.x, massData.center.y);
        }
    }

    /// <summary>
    /// Sets mass, centre of mass and inertia by the shapes and their densities. It costs time: call it once all shapes are made, or
    /// when one has gone.
    /// </summary>
    /// <exception cref="InvalidOperationException">
    /// The body is destroyed, the call comes from a listener, or the densities give a mass or an inertia that is too large or too small for
    /// a float.
    /// </exception>
    public void SetMassFromShapes()
    {
        CheckAlive();
        if (World.IsLocked(nameof(SetMassFromShapes)))
        {
            return;
        }

        double mass = 0;
        double x = 0;
        double y = 0;
        double inertia = 0;
        for (b2Shape? s = Shapes; s is not null; s = s.Next)
        {
            ShapeMass part = s.Mass();
            mass += part.Mass;
            x += part.Mass * part.X;
            y += part.Mass * part.Y;
            inertia += part.Inertia + (part.Mass * ((part.X * part.X) + (part.Y * part.Y)));
        }

        if (mass > 0)
        {
            x /= mass;
            y /= mass;
            inertia -= mass * ((x * x) + (y * y));
        }

        inertia = _fixedRotation || mass == 0 ? 0 : inertia;
        if (!Fits(mass) || !Fits(inertia))
        {
            throw new InvalidOperationException(FormattableString.Invariant(
                $"The density of the shapes makes a mass of {mass}, an inertia of {inertia}: beyond what a float can hold and divide by."));
        }

        ApplyMass((float)mass, (float)inertia, x, y);
    }

    /// <summary>Moves the body at once, without regard to what is in the way.</summary>
    /// <param name="position">The new position of its origin, metres.</param>
    /// <param name="angle">Its angle, radians; within ±9.2·10¹⁸.</param>
    /// <returns>
    /// False if a shape of it then lies outside the world: the body is frozen. False too, and nothing happens, if it is frozen already.
    /// </returns>
    /// <exception cref="ArgumentException">A value is null, not finite or out of its range.</exception>
    /// <exception cref="InvalidOperationException">The body is destroyed, or the call comes from a listener.</exception>
    public bool SetXForm(b2Vec2 position, float angle)
    {
        Require.Vector(position, nameof(position));
        Require.Turn(angle, nameof(angle));
        CheckAlive();
        if (World.IsLocked(nameof(SetXForm)))
        {
            return true;
        }

        if (Link.IsFrozen)
        {
            return false;
        }

        World.Engine.Moving(this);
        Link.SetTransform(position.x, position.y, angle);
        World.Lock();
        try
        {
            if (!World.Engine.IsInside(this))
            {
                Freeze();
                return false;
            }

            World.Engine.Moved(this);
            return true;
        }
        finally
        {
            World.Unlock();
        }
    }

    /// <summary>
    /// The position of the origin and the rotation. It follows the body: <see cref="b2Vec2.Copy"/> what you want to keep.
    /// </summary>
    /// <returns>The transform itself, which cannot be set.</returns>
    public b2XForm GetXForm() => _xf;

    /// <summary>The position of the origin in the world, metres. The vector follows the body.</summary>
    /// <returns>The position itself, which cannot be set: see <see cref="SetXForm"/>.</returns>
    public b2Vec2 GetPosition() => _position;

    /// <summary>The angle, radians, with all whole turns.</summary>
    /// <returns>The angle.</returns>
    public float GetAngle() => (float)Link.Angle;

    /// <summary>The centre of mass in the world, metres. The vector follows the body.</summary>
    /// <returns>The position itself, which cannot be set.</returns>
    public b2Vec2 GetWorldCenter() => _worldCenter;

    /// <summary>The centre of mass in body coordinates, metres. The vector follows the body.</summary>
    /// <returns>The position itself, which cannot be set: see <see cref="SetMass"/>.</returns>
    public b2Vec2 GetLocalCenter() => _localCenter;

    /// <summary>Mass, kg; 0 for a static body.</summary>
    /// <returns>0 or more.</returns>
    public float GetMass() => Link.Mass;

    /// <summary>Inertia about the centre of mass, kg·m²; 0 for a body that does not turn.</summary>
    /// <returns>0 or more.</returns>
    public float GetInertia() => Link.Inertia;

    /// <summary>The first shape: the one made last.</summary>
    /// <returns>The shape, or null.</returns>
    public b2Shape? GetShapeList() => Shapes;

    /// <summary>The first joint at this body: the one made last.</summary>
    /// <returns>Its edge, or null.</returns>
    public b2JointEdge? GetJointList() => Joints;

    /// <summary>The next body of the world: the one made before this one.</summary>
    /// <returns>The body, or null after the last.</returns>
    public b2Body? GetNext() => Next;

    /// <summary>The object that the user attached.</summary>
    /// <returns>The object, or null.</returns>
    public object? GetUserData() => _userData;

    /// <summary>Attaches an object.</summary>
    /// <param name="data">Any object, or null.</param>
    public void SetUserData(object? data) => _userData = data;

    /// <summary>The world of the body.</summary>
    /// <returns>The world.</returns>
    public b2World GetWorld() => World;

    /// <summary>Whether the body has no mass and does not move.</summary>
    /// <returns>True for a static body.</returns>
    public bool IsStatic() => Link.IsStatic;

    /// <summary>Whether the body has mass and moves.</summary>
    /// <returns>True for a dynamic body.</returns>
    public bool IsDynamic() => !Link.IsStatic;

    /// <summary>Whether the body left the box of the world, or its speed what the engine can hold; it then stands still for good.</summary>
    /// <returns>True for a frozen body.</returns>
    public bool IsFrozen() => Link.IsFrozen;

    /// <summary>Whether a joint that keeps its bodies from colliding joins this body to another.</summary>
    /// <param name="other">The other body.</param>
    /// <returns>True if there is one.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="other"/> is null.</exception>
    public bool IsConnected(b2Body other)
    {
        Require.NotNull(other, nameof(other));
        for (b2JointEdge? edge = Joints; edge is not null; edge = edge.next)
        {
            if (ReferenceEquals(edge.other, other) && !edge.joint.CollideConnected)
            {
                return true;
            }
        }

        return false;
    }

    internal void Freeze()
    {
        Link.Freeze();
        World.Engine.EndContacts(this);
    }

    internal static void CheckMass(b2MassData massData)
    {
        Require.NotNull(massData, nameof(massData));
        Require.Mass(massData.mass, nameof(massData.mass));
        Require.Mass(massData.I, nameof(massData.I));
        Require.Vector(massData.center, nameof(massData.center));
    }

    internal void ApplyMass(float mass, float inertia, double centerX, double centerY)
    {
        bool wasStatic = Link.IsStatic;

        // What has no mass to be moved by is not turned either: pushed through its centre it would have no response at all.
        inertia = mass == 0 ? 0 : inertia;
        Link.SetMass(mass, inertia, centerX, centerY, (World.Quirks & Box2DFlash202Quirks.StaticKeepsVelocity) != 0);
        if (Link.IsStatic != wasStatic)
        {
            World.Lock();
            try
            {
                World.Engine.KindChanged(this);
            }
            finally
            {
                World.Unlock();
            }
        }
    }

    private void CheckAlive()
    {
        if (!IsAlive)
        {
            throw new InvalidOperationException("The body is destroyed.");
        }
    }

    private static bool Fits(double value) => !(value > 0) || ((float)value > 0 && Require.IsMass((float)value));

    private static Vector2 Of(b2Vec2 v) => new Vector2(v.x, v.y);

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    internal void Visit(StateStream s)
    {
        Link.Visit(s);
        Next = s.Reference(Next);
        Shapes = s.Reference(Shapes);
        Joints = s.Reference(Joints);
        IsAlive = s.Value(IsAlive);
    }
}
