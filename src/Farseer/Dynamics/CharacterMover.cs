using System;
using System.Numerics;
using Farseer.Engine.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Factories;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>
/// Moves a character as games want it and physics does not: an upright capsule that walks up slopes and steps, keeps to the ground
/// downhill, slides along walls, rides on moving and turning platforms, passes one-way platforms from below, and pushes only as hard as it
/// may. Its body is kinematic: others meet it as they meet a lift. (An addition to the original.)
/// </summary>
/// <remarks>
/// Set <see cref="Velocity"/> and call <see cref="Move"/> before each update, after the velocities of platforms are set. The character
/// finds its way by casts of its capsule (<see cref="PhysicsSimulator.ShapeCast"/>), so it passes through nothing, and equal calls give
/// equal bits.
/// </remarks>
/// <example>
/// <code>
/// var player = new CharacterMover(simulator, new Vector2(0, 2), height: 1.8f, radius: 0.4f);
/// // In each step:
/// player.Velocity = new Vector2(5 * input, player.IsGrounded &amp;&amp; jump ? 6 : player.Velocity.Y);
/// player.Move(dt);
/// simulator.Update(dt);
/// </code>
/// </example>
public sealed partial class CharacterMover
{
    private readonly PhysicsSimulator _simulator;
    private readonly float _radius;
    private readonly float _length;
    private Vector2 _up = new Vector2(0, 1);
    private Vector2 _velocity;
    private float _maxSlope = 0.87f;
    private float _stepHeight;
    private float _snapDistance;
    private float _pushForce;
    private float _mass;

    /// <summary>Makes a character with a kinematic body and a capsule geom, and adds both to the simulator.</summary>
    /// <param name="simulator">The simulator.</param>
    /// <param name="position">Its middle, in world coordinates; finite.</param>
    /// <param name="height">From feet to head; finite and above two radii.</param>
    /// <param name="radius">Half its width; finite and above 0.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the range given above.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public CharacterMover(PhysicsSimulator simulator, Vector2 position, float height, float radius)
    {
        _simulator = Require.NotNull(simulator, nameof(simulator));
        simulator.ThrowIfDisposed();
        Require.Place(position, nameof(position));
        _radius = Require.Length(radius, nameof(radius));
        Require.Finite(height, nameof(height));
        _length = height - (2 * radius);
        if (!(_length > 1e-3f * radius))
        {
            throw Require.Range(nameof(height), height, "must be above two radii");
        }

        _stepHeight = radius / 2;
        _snapDistance = radius;
        Body = BodyFactory.Instance.CreateCapsuleBody(_length, radius, 1);
        Body.IsKinematic = true;
        Body.FixedRotation = true;
        Body.Position = position;
        Geom = GeomFactory.Instance.CreateCapsuleGeom(Body, new Vector2(0, -_length / 2), new Vector2(0, _length / 2), radius);
        simulator.Add(Body);
        simulator.Add(Geom);
        Filter = new QueryFilter { IgnoredBody = Body };
        _filter = new QueryFilter { IgnoredBody = Body, Accept = IsMet };
    }

    /// <summary>The kinematic body. Set its position to put the character somewhere.</summary>
    public Body Body { get; }

    /// <summary>The capsule.</summary>
    public Geom Geom { get; }

    /// <summary>
    /// The filter of the geoms that stop the character: its <see cref="QueryFilter.Categories"/> and <see cref="QueryFilter.Accept"/>
    /// count. By default all geoms that push others away.
    /// </summary>
    public QueryFilter Filter { get; }

    /// <summary>
    /// Velocity of the character, length/s. Set it before <see cref="Move"/>, which takes out of it what walls, ground and ceiling stop. On
    /// the ground it is relative to the ground; a character that leaves the ground keeps the ground's velocity. Default (0, 0).
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Velocity
    {
        get => _velocity;
        set => _velocity = Require.Finite(value, nameof(Velocity));
    }

    /// <summary>
    /// The direction that is up, of any length; finite and not (0, 0). The capsule stands along it from the next <see cref="Move"/> on.
    /// Default (0, 1): y points up.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or (0, 0).</exception>
    public Vector2 Up
    {
        get => _up;
        set
        {
            _up = Require.Direction(value, nameof(Up));
            Body.SetTotalRotation(StableMath.Atan2(-_up.X, _up.Y));
        }
    }

    /// <summary>
    /// Steepest slope that it walks on and stands on, radians from level; from 0 to π/2. What is steeper is a wall. Default 0.87, 50
    /// degrees.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not from 0 to π/2.</exception>
    public float MaxSlope
    {
        get => _maxSlope;
        set => _maxSlope = value >= 0 && value <= (float)(Math.PI / 2)
            ? value
            : throw Require.Range(nameof(MaxSlope), value, "must be from 0 to π/2");
    }

    /// <summary>
    /// Highest step that it walks up, a length; at least 0. Its round feet roll over edges of up to r·(1 - cos(<see cref="MaxSlope"/>)) as
    /// over slopes in any case. Default half a radius.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float StepHeight
    {
        get => _stepHeight;
        set => _stepHeight = Require.NotNegative(value, nameof(StepHeight));
    }

    /// <summary>
    /// How far the ground may drop away under its feet in a step before the character leaves it, a length; at least 0. It keeps the
    /// character on the ground on slopes and steps downhill. Default one radius.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float SnapDistance
    {
        get => _snapDistance;
        set => _snapDistance = Require.NotNegative(value, nameof(SnapDistance));
    }

    /// <summary>
    /// Largest force with which the character pushes bodies that are in its way, at most up to its own speed; at least 0. Default 0: bodies
    /// stop it as walls do.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float PushForce
    {
        get => _pushForce;
        set => _pushForce = Require.NotNegative(value, nameof(PushForce));
    }

    /// <summary>Mass whose weight presses on the body that the character stands on; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Mass
    {
        get => _mass;
        set => _mass = Require.NotNegative(value, nameof(Mass));
    }

    /// <summary>True lets it fall by the gravity of the simulator while it is not on the ground. Default true.</summary>
    public bool UsesGravity { get; set; } = true;

    /// <summary>True lets it pass one-way platforms from above too: to drop down through them. Default false.</summary>
    public bool DropsThrough { get; set; }

    /// <summary>True if the last <see cref="Move"/> ended on ground that it can stand on.</summary>
    public bool IsGrounded => Ground is not null;

    /// <summary>The geom that the character stands on; null in the air.</summary>
    public Geom? Ground { get; private set; }

    /// <summary>Unit normal of the ground, pointing out of it; (0, 0) in the air.</summary>
    public Vector2 GroundNormal { get; private set; }

    /// <summary>Velocity of the ground under its feet, length/s; (0, 0) in the air.</summary>
    public Vector2 GroundVelocity { get; private set; }

    /// <summary>True if it met a wall in the last <see cref="Move"/>.</summary>
    public bool TouchesWall { get; private set; }

    /// <summary>Takes the character out of the simulator at its next update.</summary>
    public void Remove() => _simulator.RemoveWithParts(Body);
}
