using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Interfaces;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// Lets geoms float: each one that was added with <see cref="AddGeom"/> is lifted by the weight of the fluid that it displaces and
/// slowed by the fluid. The part of a geom in the fluid is exact, of circles and rounded shapes as well, for the fluids of this library. Of
/// a container of your own only points can be asked for: the outline is looked at in four parts a side and eight a quarter turn, and where
/// it passes the surface is found between them. Chains count as the outline of their points; what has no area does not float.
/// </summary>
/// <example>
/// <code>
/// var water = new FluidDragController();
/// water.Initialize(new AABBFluidContainer(new AABB(new Vector2(-10, -4), new Vector2(10, 0))), 1, 0.5f, 0.2f, simulator.Gravity);
/// water.AddGeom(geom);
/// simulator.Add(water);
/// </code>
/// </example>
public class FluidDragController : Controller
{
    /// <summary>Share of its area below which what is in the fluid counts for nothing.</summary>
    private const double LeastShareOfArea = 1e-6;

    private readonly List<Geom> _geoms = new List<Geom>();
    [NotState(Why.Derived)]
    private readonly HashSet<Geom> _known = new HashSet<Geom>();
    private readonly List<bool> _entered = new List<bool>();
    private readonly SubmergedPart _inside = new SubmergedPart();
    private IFluidContainer? _container;
    private Vector2 _gravity;
    private float _density;
    private float _linearDragCoefficient;
    private float _rotationalDragCoefficient;

    internal IFluidContainer? Container => _container;

    internal Vector2 Gravity => _gravity;

    internal List<Geom> Geoms => _geoms;

    /// <summary>Of each of <see cref="Geoms"/>, whether it has been in the fluid.</summary>
    internal List<bool> Entered => _entered;

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
    /// <param name="fluidContainer">The region that the fluid fills.</param>
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
        if (_known.Add(Require.NotNull(geom, nameof(geom))))
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
        if (_known.Remove(Require.NotNull(geom, nameof(geom))))
        {
            int index = _geoms.IndexOf(geom);
            _geoms.RemoveAt(index);
            _entered.RemoveAt(index);
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
        int kept = 0;
        for (int i = 0; i < _geoms.Count; i++)
        {
            Geom geom = _geoms[i];
            if (geom.IsDisposed || geom.Body is { IsDisposed: true })
            {
                _known.Remove(geom);
                continue;
            }

            _geoms[kept] = geom;
            _entered[kept++] = _entered[i];
        }

        _geoms.RemoveRange(kept, _geoms.Count - kept);
        _entered.RemoveRange(kept, _entered.Count - kept);
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
            try
            {
                Lift(i, _container, dt);
            }
            catch (Exception exception) when (Simulator is { IsUpdating: true })
            {
                // One geom does not keep the others from their share.
                Simulator.Relay.Keep(exception);
            }
        }
    }

    private void Lift(int index, IFluidContainer container, float dt)
    {
        Geom geom = _geoms[index];
        if (!geom.IsDisposed && geom.Body is { Enabled: true } && geom.Form is not null && container.Intersect(geom.AABB)
            && IsInside(geom, container, dt))
        {
            Act(geom.Body, dt);
            if (!_entered[index])
            {
                _entered[index] = true;
                Entry?.Invoke(geom);
            }
        }
    }

    /// <summary>
    /// Looks where the geom is in the middle of the step: a force found at its start would lag behind by half a step, and what falls in
    /// would come out higher.
    /// </summary>
    private bool IsInside(Geom geom, IFluidContainer container, float dt)
    {
        if (Simulator is not null && (Simulator.Quirks & Farseer201Quirks.BuoyancyOfVertices) != 0)
        {
            _inside.FindByVertices(geom, container, 0.5 * dt);
        }
        else
        {
            _inside.Find(geom, container, 0.5 * dt);
        }

        return _inside.Area > LeastShareOfArea * _inside.WholeArea;
    }

    private void Act(Body body, float dt)
    {
        var arm = new Vector2((float)_inside.ArmX, (float)_inside.ArmY);
        Vector2 force = -_density * (float)_inside.Area * _gravity;
        Vector2 velocity = body.LinearVelocity + (body.AngularVelocity * new Vector2(-arm.Y, arm.X));
        float speed = velocity.Length();
        float mass = body.Mass * (float)(_inside.Area / _inside.WholeArea);
        if (speed > 0)
        {
            float width = (float)_inside.Width(-velocity.Y / speed, velocity.X / speed);
            float rate = 0.5f * _density * width * _linearDragCoefficient;
            force -= Steady(rate * mass, body.InverseMass, dt) * velocity;
        }

        body.ApplyForce(force);
        body.ApplyTorque((arm.X * force.Y) - (arm.Y * force.X)
            - (Steady(_rotationalDragCoefficient * mass, body.InverseMomentOfInertia, dt) * body.AngularVelocity));
    }

    /// <summary>
    /// The coefficient whose force, steady over the step, does what the decaying force of <paramref name="coefficient"/> does: (1 − e^−x)/x
    /// of it, x = coefficient / mass · dt. Thick fluids stop a body instead of throwing it back.
    /// </summary>
    private static float Steady(float coefficient, float inverseMass, float dt) =>
        (float)(coefficient * new DragLaw((double)coefficient * inverseMass * dt, 1).First);

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Reference(ref _container);
        s.Value(ref _gravity);
        s.Value(ref _density);
        s.Value(ref _linearDragCoefficient);
        s.Value(ref _rotationalDragCoefficient);
        (_container as AABBFluidContainer)?.Visit(s);
        s.References(_geoms);
        s.List(_entered);
        if (s.IsReading)
        {
            _known.Clear();
            _known.UnionWith(_geoms);
        }

        Entry = s.Reference(Entry);
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("gravity", ref _gravity);
    }
}
