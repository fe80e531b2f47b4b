using System;
using System.Collections.Generic;
using System.Globalization;
using System.Numerics;
using Farseer.Engine.Bodies;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>
/// Rectangular bodies, the links, in a row along a smooth curve through control points: chains, ropes, bridges, tracks. Add control
/// points, call <see cref="Update"/> for the bodies, <see cref="CreateGeoms()"/> for their geoms,
/// <see cref="LinkBodies"/> for what holds them together, and
/// <see cref="AddToPhysicsSimulator"/>. <see cref="ComplexFactory"/> does all of that in one call. Joints make a stiff path, springs a
/// soft one. Everything is plain bodies, geoms, joints and springs in lists of the path, for you to change.
/// </summary>
/// <example>
/// <code>
/// var track = new Path(width: 0.4f, height: 0.2f, mass: 1, endless: true);
/// track.Add(new Vector2(-4, 0));
/// track.Add(new Vector2(0, 3));
/// track.Add(new Vector2(4, 0));
/// track.Update();
/// track.LinkBodies(LinkType.RevoluteJoint, 0, 0, 0, 0);
/// track.AddToPhysicsSimulator(simulator);
/// </code>
/// </example>
public partial class Path
{
    /// <summary>Most links of one path.</summary>
    internal const int MostLinks = 65536;

    private const float ControlPointSize = 6;

    private readonly float _width;
    private readonly float _height;
    private readonly float _mass;
    private readonly bool _endless;
    private readonly HashSet<object> _made = new HashSet<object>();
    private Vertices _placed = new Vertices();

    /// <summary>Makes a path without control points.</summary>
    /// <param name="width">Length of a link along the path; finite and above 0.</param>
    /// <param name="height">Thickness of a link; finite and above 0.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="endless">True links the last body with the first one.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public Path(float width, float height, float mass, bool endless)
    {
        _width = Require.Length(width, nameof(width));
        _height = Require.Length(height, nameof(height));
        _mass = mass;
        _endless = endless;

        // Refuses now the mass that would be refused at each link.
        BodyFactory.Instance.CreateRectangleBody(width, height, mass);
    }

    /// <summary>The links, in order from the first control point to the last.</summary>
    public BodyList Bodies { get; } = new BodyList();

    /// <summary>The geoms of the links.</summary>
    public GeomList Geoms { get; } = new GeomList();

    /// <summary>The joints between the links, in order, and those that were added.</summary>
    public JointList Joints { get; } = new JointList();

    /// <summary>The springs between the links, in order, and those that were added.</summary>
    public SpringList Springs { get; } = new SpringList();

    /// <summary>
    /// The points through which the path goes. <see cref="Update"/> moves the last one to where it looked for the end of the path: at
    /// most a width away.
    /// </summary>
    public Vertices ControlPoints { get; } = new Vertices();

    internal float Width => _width;

    internal float Height => _height;

    internal float Mass => _mass;

    internal bool IsEndless => _endless;

    /// <summary>What the path made itself, and makes anew when its control points change.</summary>
    internal HashSet<object> Made => _made;

    /// <summary>The control points along which the links lie.</summary>
    internal Vertices Placed
    {
        get => _placed;
        set => _placed = value;
    }

    /// <summary>The point halfway between two.</summary>
    /// <param name="firstVector">One point.</param>
    /// <param name="secondVector">The other.</param>
    /// <returns>The middle.</returns>
    public static Vector2 FindMidpoint(Vector2 firstVector, Vector2 secondVector) => (firstVector * 0.5f) + (secondVector * 0.5f);

    /// <summary>Adds a control point at the end; <see cref="Update"/> takes it up.</summary>
    /// <param name="controlPoint">The point, in world coordinates; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="controlPoint"/> is not finite or too far away to compute
    /// with.</exception>
    public void Add(Vector2 controlPoint) => ControlPoints.Add(Require.Place(controlPoint, nameof(controlPoint)));

    /// <summary>Adds a body of your own to <see cref="Bodies"/>.</summary>
    /// <param name="body">The body.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    public void Add(Body body) => Bodies.Add(Require.NotNull(body, nameof(body)));

    /// <summary>Adds a geom of your own to <see cref="Geoms"/>.</summary>
    /// <param name="geom">The geom.</param>
    /// <exception cref="ArgumentNullException"><paramref name="geom"/> is null.</exception>
    public void Add(Geom geom) => Geoms.Add(Require.NotNull(geom, nameof(geom)));

    /// <summary>Adds a joint of your own to <see cref="Joints"/>, such as one that holds an end.</summary>
    /// <param name="joint">The joint.</param>
    /// <exception cref="ArgumentNullException"><paramref name="joint"/> is null.</exception>
    public void Add(Joint joint) => Joints.Add(Require.NotNull(joint, nameof(joint)));

    /// <summary>Adds a spring of your own to <see cref="Springs"/>.</summary>
    /// <param name="spring">The spring.</param>
    /// <exception cref="ArgumentNullException"><paramref name="spring"/> is null.</exception>
    public void Add(Spring spring) => Springs.Add(Require.NotNull(spring, nameof(spring)));

    /// <summary>Takes a control point away; one that is not there is ignored. <see cref="Update"/> takes it up.</summary>
    /// <param name="controlPoint">The point.</param>
    public void Remove(Vector2 controlPoint) => ControlPoints.Remove(controlPoint);

    /// <summary>Takes a control point away; <see cref="Update"/> takes it up.</summary>
    /// <param name="index">Its number, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such point.</exception>
    public void Remove(int index) => ControlPoints.RemoveAt(Known(index));

    /// <summary>Moves a control point; <see cref="Update"/> takes it up.</summary>
    /// <param name="position">The new position, in world coordinates; finite.</param>
    /// <param name="index">Its number, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such point, or the position is not finite or too far away to compute
    /// with.</exception>
    public void MoveControlPoint(Vector2 position, int index)
    {
        Require.Place(position, nameof(position));
        ControlPoints[Known(index)] = position;
    }

    /// <summary>The control point at a position: the first one within 3 units in x and in y. For editors that work in pixels.</summary>
    /// <param name="point">The position, in world coordinates.</param>
    /// <returns>The number of the control point, or -1 if there is none.</returns>
    public int PointInControlPoint(Vector2 point)
    {
        for (int i = 0; i < ControlPoints.Count; i++)
        {
            Vector2 away = Vector2.Abs(point - ControlPoints[i]);
            if (away.X <= ControlPointSize / 2 && away.Y <= ControlPointSize / 2)
            {
                return i;
            }
        }

        return -1;
    }

    /// <summary>
    /// Makes the bodies along the curve, if the control points have changed since the last time. The first is half a width from the start,
    /// each next one a width from the one before, or up to two thousandths of the path more: as many as fit are made. They
    /// are turned along the curve, by -90 to 90 degrees; where it goes to the left they face backwards. What the path itself had made of
    /// other control points (bodies, geoms, joints, springs) leaves its lists.
    /// </summary>
    /// <exception cref="InvalidOperationException">
    /// There are less than 2 control points, one is not finite, the path does not get half a width away from its start or has more than
    /// 65,536 links, or something that the path had made is in a simulator.
    /// </exception>
    public void Update()
    {
        if (IsPlaced())
        {
            return;
        }

        if (Place(ComplexFactory.Instance.Quirks) is { } fault)
        {
            throw new InvalidOperationException(fault);
        }
    }

    /// <summary>
    /// Gives each body that has no geom in this path yet a rectangle of its size. Links are closer than they are wide where the path
    /// bends: unless they share a group that is not 0, as with <see cref="CreateGeoms(int)"/>, they will push each other.
    /// </summary>
    /// <exception cref="ObjectDisposedException">A body is disposed.</exception>
    public void CreateGeoms() => CreateGeoms(0);

    /// <summary>
    /// As <see cref="CreateGeoms()"/>, in a group whose members do not collide with each other. (An addition to the original.)
    /// </summary>
    /// <param name="collisionGroup">See <see cref="Geom.CollisionGroup"/>; 0 for none.</param>
    /// <exception cref="ObjectDisposedException">A body is disposed.</exception>
    public void CreateGeoms(int collisionGroup)
    {
        var clothed = new HashSet<Body>();
        foreach (Geom geom in Geoms)
        {
            clothed.Add(geom.Body);
        }

        var created = new List<Geom>();
        foreach (Body body in Bodies)
        {
            if (!clothed.Contains(body))
            {
                Geom geom = GeomFactory.Instance.CreateRectangleGeom(body, _width, _height);
                geom.CollisionGroup = collisionGroup;
                created.Add(geom);
            }
        }

        foreach (Geom geom in created)
        {
            _made.Add(geom);
            Geoms.Add(geom);
        }
    }

    /// <summary>Makes the bodies anew, or tells why it cannot; then nothing has changed.</summary>
    internal string? Place(Farseer201Quirks quirks)
    {
        if (Obstacle() is { } obstacle)
        {
            return obstacle;
        }

        PathWalk walk = PathWalk.Along(ControlPoints, _width, MostLinks + 1, (quirks & Farseer201Quirks.UprightPathsLieAcross) != 0);
        if (walk.Links.Count == 0 || walk.Links.Count > MostLinks)
        {
            return walk.Links.Count == 0
                ? "The path does not get half the width of a link away from its start."
                : "The path has more than 65536 links.";
        }

        ForgetMade();
        foreach ((Vector2 position, float rotation) in walk.Links)
        {
            Body body = BodyFactory.Instance.CreateRectangleBody(_width, _height, _mass);
            body.Position = position;
            body.Rotation = rotation;
            _made.Add(body);
            Bodies.Add(body);
        }

        ControlPoints[ControlPoints.Count - 1] = walk.End;
        _placed = new Vertices(ControlPoints);
        return null;
    }

    private int Known(int index) => Require.Within(index, 0, ControlPoints.Count - 1, nameof(index));

    private bool IsPlaced()
    {
        if (_placed.Count != ControlPoints.Count || _placed.Count == 0)
        {
            return false;
        }

        for (int i = 0; i < _placed.Count; i++)
        {
            if (_placed[i] != ControlPoints[i])
            {
                return false;
            }
        }

        return true;
    }

    private string? Obstacle()
    {
        if (ControlPoints.Count < 2)
        {
            return "A path needs at least 2 control points; it has " + ControlPoints.Count.ToString(CultureInfo.InvariantCulture) + ".";
        }

        foreach (Vector2 point in ControlPoints)
        {
            if (!StateRange.Holds(point.X, point.Y, 0))
            {
                return "The control point " + point.ToString("G", CultureInfo.InvariantCulture) + " is no place to compute with.";
            }
        }

        foreach (object item in _made)
        {
            if (item is Body { Membership: not Membership.None } or Geom { Membership: not Membership.None }
                or IItem { Membership: not Membership.None })
            {
                return "The path is in a simulator: remove it before it is made anew.";
            }
        }

        return null;
    }

    private void ForgetMade()
    {
        Drop(Bodies, Bodies.Remove);
        Drop(Geoms, Geoms.Remove);
        Drop(Joints, Joints.Remove);
        Drop(Springs, Springs.Remove);
        _made.Clear();
    }

    private void Drop<T>(List<T> list, Action<T> remove)
        where T : class
    {
        foreach (T item in list.FindAll(_made.Contains))
        {
            remove(item);
        }
    }
}
