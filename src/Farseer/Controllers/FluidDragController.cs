using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Bodies;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Interfaces;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// Lets geoms float: each one that was added with <see cref="AddGeom"/> is lifted by the weight of the fluid that it displaces and
/// slowed by the fluid. The part of a geom in the fluid is the polygon of its vertices that are inside: give geoms enough vertices
/// for a smooth surface.
/// </summary>
public class FluidDragController : Controller
{
    /// <summary>Share of its vertices that a geom must have in the fluid to feel it.</summary>
    private const float LeastShareOfVertices = 0.05f;

    /// <summary>Share of its area below which what is in the fluid counts for nothing.</summary>
    private const float LeastShareOfArea = 1e-6f;

    private readonly List<Geom> _geoms = new List<Geom>();
    private readonly List<bool> _entered = new List<bool>();
    private readonly Vertices _inside = new Vertices();
    private IFluidContainer? _container;
    private Vector2 _gravity;
    private float _density;
    private float _linearDragCoefficient;
    private float _rotationalDragCoefficient;

    internal IFluidContainer? Container => _container;

    /// <summary>Makes a controller that does nothing until <see cref="Initialize"/> is called.</summary>
    public FluidDragController()
    {
    }

    /// <summary>Handles the entry of a geom into the fluid.</summary>
    /// <param name="geom">The geom.</param>
    public delegate void EntryEventHandler(Geom geom);

    /// <summary>Called when a geom enters the fluid: once for each until <see cref="Reset"/>. Use with +=. Default null.</summary>
    public EntryEventHandler? Entry { get; set; }

    /// <summary>Mass of the fluid per area; finite and at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Density
    {
        get => _density;
        set => _density = Require.NotNegative(value, nameof(Density));
    }

    /// <summary>
    /// Strength of the drag on the motion: the velocity decays at the rate ½ · density · width across the motion · coefficient · (share
    /// of the geom in the fluid). Finite and at least 0. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float LinearDragCoefficient
    {
        get => _linearDragCoefficient;
        set => _linearDragCoefficient = Require.NotNegative(value, nameof(LinearDragCoefficient));
    }

    /// <summary>Torque per angular velocity and mass in the fluid; finite and at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float RotationalDragCoefficient
    {
        get => _rotationalDragCoefficient;
        set => _rotationalDragCoefficient = Require.NotNegative(value, nameof(RotationalDragCoefficient));
    }

    /// <summary>Tells what the fluid is and where. Call it before the first update.</summary>
    /// <param name="fluidContainer">Where the fluid is.</param>
    /// <param name="density">See <see cref="Density"/>.</param>
    /// <param name="linearDragCoefficient">See <see cref="LinearDragCoefficient"/>.</param>
    /// <param name="rotationalDragCoefficient">See <see cref="RotationalDragCoefficient"/>.</param>
    /// <param name="gravity">The gravity that the fluid is under, usually that of the simulator; finite. Lift is against it.</param>
    /// <exception cref="ArgumentNullException"><paramref name="fluidContainer"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public void Initialize(
        IFluidContainer fluidContainer, float density, float linearDragCoefficient, float rotationalDragCoefficient, Vector2 gravity)
    {
        Require.NotNull(fluidContainer, nameof(fluidContainer));
        Require.NotNegative(density, nameof(density));
        Require.NotNegative(linearDragCoefficient, nameof(linearDragCoefficient));
        Require.NotNegative(rotationalDragCoefficient, nameof(rotationalDragCoefficient));
        _gravity = Require.Finite(gravity, nameof(gravity));
        _container = fluidContainer;
        _density = density;
        _linearDragCoefficient = linearDragCoefficient;
        _rotationalDragCoefficient = rotationalDragCoefficient;
    }

    /// <summary>Lets a geom feel the fluid, once it has a body. One that was added before is ignored.</summary>
    /// <param name="geom">The geom.</param>
    /// <exception cref="ArgumentNullException"><paramref name="geom"/> is null.</exception>
    public void AddGeom(Geom geom)
    {
        if (!_geoms.Contains(Require.NotNull(geom, nameof(geom))))
        {
            _geoms.Add(geom);
            _entered.Add(false);
        }
    }

    /// <summary>Lets a geom feel the fluid no more; one that does not is ignored. (An addition to the original.)</summary>
    /// <param name="geom">The geom.</param>
    /// <exception cref="ArgumentNullException"><paramref name="geom"/> is null.</exception>
    public void RemoveGeom(Geom geom)
    {
        int index = _geoms.IndexOf(Require.NotNull(geom, nameof(geom)));
        if (index >= 0)
        {
            RemoveAt(index);
        }
    }

    /// <summary>Forgets which geoms have entered the fluid: <see cref="Entry"/> is called for each of them once more.</summary>
    public void Reset()
    {
        for (int i = 0; i < _entered.Count; i++)
        {
            _entered[i] = false;
        }
    }

    /// <inheritdoc />
    public override void Validate()
    {
        for (int i = _geoms.Count - 1; i >= 0; i--)
        {
            if (_geoms[i].IsDisposed || _geoms[i].Body is { IsDisposed: true })
            {
                RemoveAt(i);
            }
        }
    }

    /// <inheritdoc />
    public override void Update(float dt)
    {
        Require.NotNegative(dt, nameof(dt));
        if (_container is null)
        {
            return;
        }

        for (int i = 0; i < _geoms.Count; i++)
        {
            Geom geom = _geoms[i];
            if (!geom.IsDisposed && geom.Body is { Enabled: true } && _container.Intersect(geom.AABB) && GatherInside(geom, _container, dt / 2, out float share))
            {
                Act(geom, share, dt);
                if (!_entered[i])
                {
                    _entered[i] = true;
                    Entry?.Invoke(geom);
                }
            }
        }
    }

    /// <summary>
    /// The vertices that are in the fluid in the middle of the step: a force found at its start would lag behind by half a step, and what
    /// falls in would come out higher.
    /// </summary>
    private bool GatherInside(Geom geom, IFluidContainer container, float ahead, out float share)
    {
        Body body = geom.Body;
        Vector2 way = ahead * body.LinearVelocity;
        float turn = ahead * body.AngularVelocity;
        Vector2 origin = body.Position;
        share = 0;
        _inside.Clear();
        Vertices vertices = geom.WorldVertices;
        for (int i = 0; i < vertices.Count; i++)
        {
            Vector2 arm = vertices[i] - origin;
            Vector2 vertex = vertices[i] + way + new Vector2(-turn * arm.Y, turn * arm.X);
            if (container.Contains(ref vertex))
            {
                _inside.Add(vertex);
            }
        }

        if (_inside.Count < 3 || _inside.Count < vertices.Count * LeastShareOfVertices)
        {
            return false;
        }

        share = _inside.GetArea() / vertices.GetArea();
        return share > LeastShareOfArea;
    }

    private void Act(Geom geom, float share, float dt)
    {
        Body body = geom.Body;
        float area = _inside.GetArea();
        Vector2 centre = _inside.GetCentroid(area) - (dt / 2 * body.LinearVelocity);
        Vector2 lift = -_density * area * _gravity;
        body.GetVelocityAtWorldPoint(ref centre, out Vector2 velocity);
        float speed = velocity.Length();
        Vector2 drag = Vector2.Zero;
        float mass = body.Mass * share;
        if (speed > 0)
        {
            var across = new Vector2(-velocity.Y / speed, velocity.X / speed);
            _inside.ProjectToAxis(ref across, out float min, out float max);
            float rate = 0.5f * _density * (max - min) * _linearDragCoefficient;
            drag = -Steady(rate * mass, body.InverseMass, dt) * velocity;
        }

        body.ApplyForceAtWorldPoint(lift + drag, centre);
        body.ApplyTorque(-Steady(_rotationalDragCoefficient * mass, body.InverseMomentOfInertia, dt) * body.AngularVelocity);
    }

    /// <summary>
    /// The coefficient whose force, steady over the step, does what the decaying force of <paramref name="coefficient"/> does: (1 − e^−x)/x of
    /// it, x = coefficient / mass · dt. Thick fluids stop a body instead of throwing it back.
    /// </summary>
    private static float Steady(float coefficient, float inverseMass, float dt) =>
        (float)(coefficient * new DragLaw((double)coefficient * inverseMass * dt, 1).First);

    private void RemoveAt(int index)
    {
        _geoms.RemoveAt(index);
        _entered.RemoveAt(index);
    }
}
