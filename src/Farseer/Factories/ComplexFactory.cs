using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Factories;

/// <summary>
/// Makes chains, ropes and tracks: see <see cref="Path"/> for how their links are placed and held together. Each method but that for ropes
/// exists with and without a simulator as its first argument. With a simulator the links get its <see cref="PhysicsSimulator.Defaults"/>,
/// and all parts are added. What only some links need, the limits of sliders and the constants of springs, are properties: set them before
/// the call.
/// </summary>
/// <example>
/// <code>
/// Path rope = ComplexFactory.Instance.CreateChain(simulator, new Vector2(0, 0), new Vector2(5, 0), 10, 1, 1, LinkType.RevoluteJoint);
/// </code>
/// </example>
public class ComplexFactory
{
    /// <summary>What chains need: they give way a little and come together slowly, so that they look like chains.</summary>
    private const float ChainBias = 0.01f;
    private const float ChainSoftness = 0.05f;

    private float _min;
    private float _max;
    private float _springConstant;
    private float _dampingConstant;
    private Farseer201Quirks _quirks;

    private ComplexFactory()
    {
    }

    /// <summary>The shared instance.</summary>
    public static ComplexFactory Instance { get; } = new ComplexFactory();

    /// <summary>Smallest distance of two ends at a <see cref="LinkType.SliderJoint"/>; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Min
    {
        get => _min;
        set => _min = Require.NotNegative(value, nameof(Min));
    }

    /// <summary>Largest distance of two ends at a <see cref="LinkType.SliderJoint"/>; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Max
    {
        get => _max;
        set => _max = Require.NotNegative(value, nameof(Max));
    }

    /// <summary>Force per length of a <see cref="LinkType.LinearSpring"/>; at least 0. Default 0: a spring that does not pull.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float SpringConstant
    {
        get => _springConstant;
        set => _springConstant = Require.NotNegative(value, nameof(SpringConstant));
    }

    /// <summary>Force per speed of a <see cref="LinkType.LinearSpring"/>; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float DampingConstant
    {
        get => _dampingConstant;
        set => _dampingConstant = Require.NotNegative(value, nameof(DampingConstant));
    }

    /// <summary>
    /// Quirks of linking that the overloads without a simulator and <see cref="Path.LinkBodies"/> use too; those with a simulator use the
    /// quirks of both. Default <see cref="Farseer201Quirks.None"/>. (An addition to the original.)
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value has a bit that is no member of the enum.</exception>
    public Farseer201Quirks Quirks
    {
        get => _quirks;
        set => _quirks = (value & ~Farseer201Quirks.All) == 0
            ? value
            : throw Require.Range(nameof(Quirks), value, "must be made of members of the enum Farseer201Quirks");
    }

    /// <summary>Makes a chain of so many links, a third as thick as they are long, whose ends are free, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="start">The start, in world coordinates; finite.</param>
    /// <param name="end">The end, in world coordinates; finite.</param>
    /// <param name="links">The number of links; at least 1 and at most 65,536.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="collisionGroup">Group of the geoms, see <see cref="Geom.CollisionGroup"/>; 0 lets neighbours collide.</param>
    /// <param name="type">The kind of joint or spring between two links.</param>
    /// <returns>The path.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentException">Start and end are closer than half a link, or so far apart that there would be more than 65,536
    /// links.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public Path CreateChain(
        PhysicsSimulator physicsSimulator, Vector2 start, Vector2 end, int links, float mass, int collisionGroup, LinkType type) =>
        Added(physicsSimulator, Chain(QuirksOf(physicsSimulator), start, end, links, null, mass, collisionGroup, type));

    /// <summary>Makes a chain of so many links, a third as thick as they are long, whose ends are free.</summary>
    /// <param name="start">The start, in world coordinates; finite.</param>
    /// <param name="end">The end, in world coordinates; finite.</param>
    /// <param name="links">The number of links; at least 1 and at most 65,536.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="collisionGroup">Group of the geoms, see <see cref="Geom.CollisionGroup"/>; 0 lets neighbours collide.</param>
    /// <param name="type">The kind of joint or spring between two links.</param>
    /// <returns>The path.</returns>
    /// <exception cref="ArgumentException">Start and end are closer than half a link, or so far apart that there would be more than 65,536
    /// links.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    public Path CreateChain(Vector2 start, Vector2 end, int links, float mass, int collisionGroup, LinkType type) =>
        Chain(_quirks, start, end, links, null, mass, collisionGroup, type);

    /// <summary>Makes a chain of so many links whose ends are free, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="start">The start, in world coordinates; finite.</param>
    /// <param name="end">The end, in world coordinates; finite.</param>
    /// <param name="links">The number of links; at least 1 and at most 65,536.</param>
    /// <param name="height">Thickness of a link; finite and above 0.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="collisionGroup">Group of the geoms, see <see cref="Geom.CollisionGroup"/>; 0 lets neighbours collide.</param>
    /// <param name="type">The kind of joint or spring between two links.</param>
    /// <returns>The path.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentException">Start and end are closer than half a link, or so far apart that there would be more than 65,536
    /// links.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public Path CreateChain(
        PhysicsSimulator physicsSimulator,
        Vector2 start,
        Vector2 end,
        int links,
        float height,
        float mass,
        int collisionGroup,
        LinkType type) =>
        Added(physicsSimulator, Chain(QuirksOf(physicsSimulator), start, end, links, height, mass, collisionGroup, type));

    /// <summary>Makes a chain of so many links whose ends are free.</summary>
    /// <param name="start">The start, in world coordinates; finite.</param>
    /// <param name="end">The end, in world coordinates; finite.</param>
    /// <param name="links">The number of links; at least 1 and at most 65,536.</param>
    /// <param name="height">Thickness of a link; finite and above 0.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="collisionGroup">Group of the geoms, see <see cref="Geom.CollisionGroup"/>; 0 lets neighbours collide.</param>
    /// <param name="type">The kind of joint or spring between two links.</param>
    /// <returns>The path.</returns>
    /// <exception cref="ArgumentException">Start and end are closer than half a link, or so far apart that there would be more than 65,536
    /// links.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    public Path CreateChain(Vector2 start, Vector2 end, int links, float height, float mass, int collisionGroup, LinkType type) =>
        Chain(_quirks, start, end, links, height, mass, collisionGroup, type);

    /// <summary>Makes a chain of links of one size, as many as fit, whose ends are free, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="start">The start, in world coordinates; finite.</param>
    /// <param name="end">The end, in world coordinates; finite.</param>
    /// <param name="width">Length of a link along the chain; finite and above 0.</param>
    /// <param name="height">Thickness of a link; finite and above 0.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="collisionGroup">Group of the geoms, see <see cref="Geom.CollisionGroup"/>; 0 lets neighbours collide.</param>
    /// <param name="type">The kind of joint or spring between two links.</param>
    /// <returns>The path.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentException">Start and end are closer than half a link, or so far apart that there would be more than 65,536
    /// links.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public Path CreateChain(
        PhysicsSimulator physicsSimulator,
        Vector2 start,
        Vector2 end,
        float width,
        float height,
        float mass,
        int collisionGroup,
        LinkType type) =>
        CreateChain(physicsSimulator, start, end, width, height, mass, false, false, collisionGroup, type);

    /// <summary>Makes a chain of links of one size, as many as fit, whose ends are free.</summary>
    /// <param name="start">The start, in world coordinates; finite.</param>
    /// <param name="end">The end, in world coordinates; finite.</param>
    /// <param name="width">Length of a link along the chain; finite and above 0.</param>
    /// <param name="height">Thickness of a link; finite and above 0.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="collisionGroup">Group of the geoms, see <see cref="Geom.CollisionGroup"/>; 0 lets neighbours collide.</param>
    /// <param name="type">The kind of joint or spring between two links.</param>
    /// <returns>The path.</returns>
    /// <exception cref="ArgumentException">Start and end are closer than half a link, or so far apart that there would be more than 65,536
    /// links.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    public Path CreateChain(Vector2 start, Vector2 end, float width, float height, float mass, int collisionGroup, LinkType type) =>
        CreateChain(start, end, width, height, mass, false, false, collisionGroup, type);

    /// <summary>Makes a chain of links of one size, as many as fit, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="start">The start, in world coordinates; finite.</param>
    /// <param name="end">The end, in world coordinates; finite.</param>
    /// <param name="width">Length of a link along the chain; finite and above 0.</param>
    /// <param name="height">Thickness of a link; finite and above 0.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="pinStart">True nails the first link to <paramref name="start"/>.</param>
    /// <param name="pinEnd">True nails the last link to the end of the path.</param>
    /// <param name="collisionGroup">Group of the geoms, see <see cref="Geom.CollisionGroup"/>; 0 lets neighbours collide.</param>
    /// <param name="type">The kind of joint or spring between two links.</param>
    /// <returns>The path.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentException">Start and end are closer than half a link, or so far apart that there would be more than 65,536
    /// links.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public Path CreateChain(
        PhysicsSimulator physicsSimulator,
        Vector2 start,
        Vector2 end,
        float width,
        float height,
        float mass,
        bool pinStart,
        bool pinEnd,
        int collisionGroup,
        LinkType type) =>
        Added(
            physicsSimulator,
            Chain(
                QuirksOf(physicsSimulator),
                start,
                end,
                new Link(width, height, mass, collisionGroup, type),
                pinStart,
                pinEnd,
                nameof(width)));

    /// <summary>Makes a chain of links of one size, as many as fit.</summary>
    /// <param name="start">The start, in world coordinates; finite.</param>
    /// <param name="end">The end, in world coordinates; finite.</param>
    /// <param name="width">Length of a link along the chain; finite and above 0.</param>
    /// <param name="height">Thickness of a link; finite and above 0.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="pinStart">True nails the first link to <paramref name="start"/>.</param>
    /// <param name="pinEnd">True nails the last link to the end of the path.</param>
    /// <param name="collisionGroup">Group of the geoms, see <see cref="Geom.CollisionGroup"/>; 0 lets neighbours collide.</param>
    /// <param name="type">The kind of joint or spring between two links.</param>
    /// <returns>The path.</returns>
    /// <exception cref="ArgumentException">Start and end are closer than half a link, or so far apart that there would be more than 65,536
    /// links.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    public Path CreateChain(
        Vector2 start, Vector2 end, float width, float height, float mass, bool pinStart, bool pinEnd, int collisionGroup, LinkType type) =>
        Chain(_quirks, start, end, new Link(width, height, mass, collisionGroup, type), pinStart, pinEnd, nameof(width));

    /// <summary>Makes a rope: the same as a chain of links of one size, as many as fit.</summary>
    /// <param name="start">The start, in world coordinates; finite.</param>
    /// <param name="end">The end, in world coordinates; finite.</param>
    /// <param name="width">Length of a link along the rope; finite and above 0.</param>
    /// <param name="height">Thickness of a link; finite and above 0.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="pinStart">True nails the first link to <paramref name="start"/>.</param>
    /// <param name="pinEnd">True nails the last link to the end of the path.</param>
    /// <param name="collisionGroup">Group of the geoms, see <see cref="Geom.CollisionGroup"/>; 0 lets neighbours collide.</param>
    /// <param name="type">The kind of joint or spring between two links.</param>
    /// <returns>The path.</returns>
    /// <exception cref="ArgumentException">Start and end are closer than half a link, or so far apart that there would be more than 65,536
    /// links.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    public Path CreateRope(
        Vector2 start, Vector2 end, float width, float height, float mass, bool pinStart, bool pinEnd, int collisionGroup, LinkType type) =>
        Chain(_quirks, start, end, new Link(width, height, mass, collisionGroup, type), pinStart, pinEnd, nameof(width));

    /// <summary>Makes a track: links of one size along a smooth curve through points, and adds it.</summary>
    /// <param name="physicsSimulator">The simulator to add it to.</param>
    /// <param name="points">Points through which the track goes, at least 2; finite.</param>
    /// <param name="width">Length of a link along the track; finite and above 0.</param>
    /// <param name="height">Thickness of a link; finite and above 0.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="endless">True links the last body with the first: let the points lead nearly around.</param>
    /// <param name="collisionGroup">Group of the geoms, see <see cref="Geom.CollisionGroup"/>; 0 lets neighbours collide.</param>
    /// <param name="type">The kind of joint or spring between two links.</param>
    /// <returns>The path.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">There are less than 2 points, one is not finite, or the track is shorter than half a link or has
    /// more than 65,536 links.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public Path CreateTrack(
        PhysicsSimulator physicsSimulator,
        Vertices points,
        float width,
        float height,
        float mass,
        bool endless,
        int collisionGroup,
        LinkType type) =>
        Added(physicsSimulator, Track(QuirksOf(physicsSimulator), points, width, height, mass, endless, collisionGroup, type));

    /// <summary>
    /// Makes a track: links of one size along a smooth curve through points. Its joints keep the values that
    /// <see cref="Path.LinkBodies"/> gives them.
    /// </summary>
    /// <param name="points">Points through which the track goes, at least 2; finite.</param>
    /// <param name="width">Length of a link along the track; finite and above 0.</param>
    /// <param name="height">Thickness of a link; finite and above 0.</param>
    /// <param name="mass">Mass of a link; finite and above 0.</param>
    /// <param name="endless">True links the last body with the first: let the points lead nearly around.</param>
    /// <param name="collisionGroup">Group of the geoms, see <see cref="Geom.CollisionGroup"/>; 0 lets neighbours collide.</param>
    /// <param name="type">The kind of joint or spring between two links.</param>
    /// <returns>The path.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="points"/> is null.</exception>
    /// <exception cref="ArgumentException">There are less than 2 points, one is not finite, or the track is shorter than half a link or has
    /// more than 65,536 links.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    public Path CreateTrack(Vertices points, float width, float height, float mass, bool endless, int collisionGroup, LinkType type) =>
        Track(_quirks, points, width, height, mass, endless, collisionGroup, type);

    private static Path Added(PhysicsSimulator physicsSimulator, Path path)
    {
        foreach (Body body in path.Bodies)
        {
            physicsSimulator.Defaults.Applied(body);
        }

        foreach (Geom geom in path.Geoms)
        {
            physicsSimulator.Defaults.Applied(geom);
        }

        path.AddToPhysicsSimulator(physicsSimulator);
        return path;
    }

    private Farseer201Quirks QuirksOf(PhysicsSimulator physicsSimulator)
    {
        Require.NotNull(physicsSimulator, nameof(physicsSimulator)).ThrowIfDisposed();
        return physicsSimulator.Quirks | _quirks;
    }

    private Path Chain(
        Farseer201Quirks quirks, Vector2 start, Vector2 end, int links, float? height, float mass, int collisionGroup, LinkType type)
    {
        Require.Place(start, nameof(start));
        Require.Place(end, nameof(end));
        Require.Within(links, 1, Path.MostLinks, nameof(links));
        float width = Vector2.Distance(start, end) / links;
        if (!(width > 0))
        {
            throw new ArgumentException("The end of a chain must not be its start.", nameof(end));
        }

        var link = new Link(width, height ?? width / 3, mass, collisionGroup, type);
        return Chain(quirks, start, end, link, false, false, nameof(links));
    }

    private Path Chain(Farseer201Quirks quirks, Vector2 start, Vector2 end, in Link link, bool pinStart, bool pinEnd, string sizedBy)
    {
        Require.Place(start, nameof(start));
        Require.Place(end, nameof(end));
        Path path = new Path(link.Width, link.Height, link.Mass, false);

        // The curve needs a third point: through two alone it would not be even.
        path.ControlPoints.Add(start);
        path.ControlPoints.Add(Path.FindMidpoint(start, end));
        path.ControlPoints.Add(end);
        if (path.Place(quirks) is { } fault)
        {
            throw new ArgumentException(fault, sizedBy);
        }

        Finish(path, quirks, link.CollisionGroup, link.Type);
        if (pinStart)
        {
            path.Add(JointFactory.Instance.CreateFixedRevoluteJoint(path.Bodies[0], start));
        }

        if (pinEnd)
        {
            path.Add(JointFactory.Instance.CreateFixedRevoluteJoint(path.Bodies[path.Bodies.Count - 1], path.ControlPoints[2]));
        }

        foreach (Joint joint in path.Joints)
        {
            joint.BiasFactor = ChainBias;
            joint.Softness = ChainSoftness;
        }

        return path;
    }

    private Path Track(
        Farseer201Quirks quirks, Vertices points, float width, float height, float mass, bool endless, int collisionGroup, LinkType type)
    {
        Require.NotNull(points, nameof(points));
        Path path = new Path(width, height, mass, endless);
        foreach (Vector2 point in points)
        {
            path.ControlPoints.Add(Require.Place(point, nameof(points)));
        }

        if (path.Place(quirks) is { } fault)
        {
            throw new ArgumentException(fault, nameof(points));
        }

        Finish(path, quirks, collisionGroup, type);
        return path;
    }

    private void Finish(Path path, Farseer201Quirks quirks, int collisionGroup, LinkType type)
    {
        path.CreateGeoms(collisionGroup);
        path.Join(type, _min, _max, _springConstant, _dampingConstant, quirks);
    }

    /// <summary>What each link of a chain is, and what holds it to the next.</summary>
    private readonly struct Link
    {
        public readonly float Width;
        public readonly float Height;
        public readonly float Mass;
        public readonly int CollisionGroup;
        public readonly LinkType Type;

        public Link(float width, float height, float mass, int collisionGroup, LinkType type)
        {
            Width = width;
            Height = height;
            Mass = mass;
            CollisionGroup = collisionGroup;
            Type = type;
        }
    }
}
