using System;
using System.Numerics;
using Box2D.Bridge;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Farseer.Engine.Storage;

namespace Box2D.Collision.Shapes;

/// <summary>
/// Collision geometry of a body, with friction and restitution. Shapes are made by <see cref="b2Body.CreateShape"/> and go with
/// their body or by <see cref="b2Body.DestroyShape"/>.
/// </summary>
/// <example>
/// <code>
/// for (b2Shape s = body.GetShapeList(); s != null; s = s.GetNext())
/// {
///     s.SetFriction(0.2f);
/// }
/// </code>
/// </example>
public abstract partial class b2Shape
{
    /// <summary>No kind of shape.</summary>
    public const int e_unknownShape = -1;

    /// <summary>A circle.</summary>
    public const int e_circleShape = 0;

    /// <summary>A polygon.</summary>
    public const int e_polygonShape = 1;

    /// <summary>The number of kinds.</summary>
    public const int e_shapeTypeCount = 2;

    private readonly int _type;
    private float _friction;
    private float _restitution;
    private bool _isSensor;
    private b2FilterData _filter;
    [NotState(Why.Users)]
    private object? _userData;

    internal b2Shape(b2ShapeDef def)
    {
        _type = def.type;
        _friction = Require.NotNegative(def.friction, nameof(def.friction));
        _restitution = Require.NotNegative(def.restitution, nameof(def.restitution));
        Density = Require.NotNegative(def.density, nameof(def.density));
        _filter = Require.NotNull(def.filter, nameof(def.filter)).Copy();
        _isSensor = def.isSensor;
        _userData = def.userData;
    }

    internal ShapeLink Link { get; } = new ShapeLink();

    internal b2Body? Body { get; set; }

    internal b2Shape? Next { get; set; }

    internal float Density { get; private set; }

    /// <summary>
    /// The kind of shape: <see cref="e_circleShape"/> or <see cref="e_polygonShape"/>. It hides the type of the object, as the name is that
    /// of the original.
    /// </summary>
    /// <returns>The kind.</returns>
    public new int GetType() => _type;

    /// <summary>Whether the shape only notices overlaps.</summary>
    /// <returns>True for a sensor.</returns>
    public bool IsSensor() => _isSensor;

    /// <summary>Makes the shape a sensor, or solid. (An addition to the original, whose field was written to.)</summary>
    /// <param name="flag">True lets it only notice overlaps.</param>
    public void SetSensor(bool flag)
    {
        _isSensor = flag;
        Body?.World.Engine.MaterialChanged(this);
    }

    /// <summary>Changes which shapes it collides with. Pairs that exist are judged anew only by <see cref="b2World.Refilter"/>.</summary>
    /// <param name="filter">The filter; it is copied.</param>
    /// <exception cref="ArgumentNullException"><paramref name="filter"/> is null.</exception>
    public void SetFilterData(b2FilterData filter) => _filter = Require.NotNull(filter, nameof(filter)).Copy();

    /// <summary>The filter: the shapes that it collides with.</summary>
    /// <returns>A copy: change it and hand it to <see cref="SetFilterData"/>.</returns>
    public b2FilterData GetFilterData() => _filter.Copy();

    /// <summary>The body that carries the shape.</summary>
    /// <returns>The body; null once the shape is destroyed.</returns>
    public b2Body? GetBody() => Body;

    /// <summary>The next shape of the body: the one made before this one.</summary>
    /// <returns>The shape, or null after the last.</returns>
    public b2Shape? GetNext() => Next;

    /// <summary>The object that the user attached.</summary>
    /// <returns>The object, or null.</returns>
    public object? GetUserData() => _userData;

    /// <summary>Attaches an object.</summary>
    /// <param name="data">Any object, or null.</param>
    public void SetUserData(object? data) => _userData = data;

    /// <summary>Whether a point is inside the shape.</summary>
    /// <param name="xf">Where the body is: <see cref="b2Body.GetXForm"/>.</param>
    /// <param name="p">The point, in the world.</param>
    /// <returns>True if it is inside or on the rim.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public abstract bool TestPoint(b2XForm xf, b2Vec2 p);

    /// <summary>Where a line first meets the shape. A line that starts inside does not meet it.</summary>
    /// <param name="xf">The transform of the body.</param>
    /// <param name="lambda">Its first item becomes the position on the line: 0 its start, 1 its end. Untouched on a miss.</param>
    /// <param name="normal">Set to the normal of the shape there. Untouched on a miss.</param>
    /// <param name="segment">The line, in the world.</param>
    /// <param name="maxLambda">The share of the line to search, 0 to 1.</param>
    /// <returns>True if it meets the shape.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="lambda"/> has no room.</exception>
    public abstract bool TestSegment(b2XForm xf, float[] lambda, b2Vec2 normal, b2Segment segment, float maxLambda);

    /// <summary>The box around the shape.</summary>
    /// <param name="aabb">Set to the box.</param>
    /// <param name="xf">The transform of the body.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public abstract void ComputeAABB(b2AABB aabb, b2XForm xf);

    /// <summary>The box around the shape at two positions.</summary>
    /// <param name="aabb">Set to the box.</param>
    /// <param name="xf1">The transform at the beginning.</param>
    /// <param name="xf2">The transform at the end.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public void ComputeSweptAABB(b2AABB aabb, b2XForm xf1, b2XForm xf2)
    {
        Require.NotNull(aabb, nameof(aabb));
        Require.NotNull(xf1, nameof(xf1));
        Require.NotNull(xf2, nameof(xf2));
        var second = new b2AABB();
        ComputeAABB(aabb, xf1);
        ComputeAABB(second, xf2);
        aabb.lowerBound.MinV(second.lowerBound);
        aabb.upperBound.MaxV(second.upperBound);
    }

    /// <summary>Mass by the density, centre of mass, and inertia about the origin of the body.</summary>
    /// <param name="massData">Becomes the result.</param>
    /// <exception cref="ArgumentNullException"><paramref name="massData"/> is null.</exception>
    public void ComputeMass(b2MassData massData)
    {
        Require.NotNull(massData, nameof(massData));
        ShapeMass mass = Mass();
        massData.mass = (float)mass.Mass;
        massData.center.Set((float)mass.X, (float)mass.Y);
        massData.I = (float)(mass.Inertia + (mass.Mass * ((mass.X * mass.X) + (mass.Y * mass.Y))));
    }

    /// <summary>Largest distance of the shape's core from the centre of mass of the body.</summary>
    /// <returns>The distance, metres.</returns>
    public float GetSweepRadius() => (float)SweepRadius(Body?.GetLocalCenter() ?? new b2Vec2());

    /// <summary>Coefficient of friction.</summary>
    /// <returns>0 or more.</returns>
    public float GetFriction() => _friction;

    /// <summary>
    /// Sets the coefficient of friction, also of contacts that exist. (An addition to the original, whose field was written to.)
    /// </summary>
    /// <param name="friction">Finite and 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="friction"/> is negative or not finite.</exception>
    public void SetFriction(float friction)
    {
        _friction = Require.NotNegative(friction, nameof(friction));
        Body?.World.Engine.MaterialChanged(this);
    }

    /// <summary>Restitution.</summary>
    /// <returns>0 or more.</returns>
    public float GetRestitution() => _restitution;

    /// <summary>Sets the restitution, also of contacts that exist. (An addition to the original, whose field was written to.)</summary>
    /// <param name="restitution">0 no bounce, 1 perfectly elastic; finite and 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="restitution"/> is negative or not finite.</exception>
    public void SetRestitution(float restitution)
    {
        _restitution = Require.NotNegative(restitution, nameof(restitution));
        Body?.World.Engine.MaterialChanged(this);
    }

    /// <summary>Density, kg/m². (An addition to the original.)</summary>
    /// <returns>0 or more.</returns>
    public float GetDensity() => Density;

    /// <summary>
    /// Sets the density; the body's mass follows at <see cref="b2Body.SetMassFromShapes"/>. (An addition to the original, whose field was
    /// written to.)
    /// </summary>
    /// <param name="density">kg/m²; finite and 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="density"/> is negative or not finite.</exception>
    public void SetDensity(float density) => Density = Require.NotNegative(density, nameof(density));

    internal abstract Farseer.Engine.Shapes.ShapeGeometry Geometry();

    /// <summary>Mass, centre, and inertia about that centre.</summary>
    internal abstract ShapeMass Mass();

    internal abstract double SweepRadius(b2Vec2 center);

    internal b2FilterData Filter => _filter;

    private protected static Vector2 Local(b2XForm xf, b2Vec2 p)
    {
        double x = (double)p.x - xf.position.x;
        double y = (double)p.y - xf.position.y;
        b2Mat22 r = xf.R;
        return new Vector2((float)((x * r.col1.x) + (y * r.col1.y)), (float)((x * r.col2.x) + (y * r.col2.y)));
    }

    /// <summary>Sets a vector to one of the body, turned into the world.</summary>
    private protected static void SetTurned(b2Vec2 target, b2XForm xf, float x, float y)
    {
        b2Mat22 r = xf.R;
        target.Set((r.col1.x * x) + (r.col2.x * y), (r.col1.y * x) + (r.col2.y * y));
    }

    private protected static void CheckSegment(b2XForm xf, float[] lambda, b2Vec2 normal, b2Segment segment, float maxLambda)
    {
        Require.NotNull(xf, nameof(xf));
        b2Segment.Check(lambda, normal, segment, maxLambda);
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    internal void Visit(StateStream s)
    {
        s.Value(ref _friction);
        s.Value(ref _restitution);
        s.Value(ref _isSensor);
        _filter = s.Reference(_filter)!;
        _filter.Visit(s);
        Link.Visit(s);
        Body = s.Reference(Body);
        Next = s.Reference(Next);
        Density = s.Value(Density);
    }
}
