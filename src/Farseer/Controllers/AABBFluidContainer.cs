using System;
using System.Numerics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Interfaces;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>A fluid at rest in a box.</summary>
/// <example>
/// <code>
/// var water = new AABBFluidContainer(new AABB(new Vector2(-10, -4), new Vector2(10, 0)));
/// var buoyancy = new FluidDragController();
/// buoyancy.Initialize(water, 1, 0.5f, 0.2f, simulator.Gravity);
/// </code>
/// </example>
public class AABBFluidContainer : IFluidContainer, IStraightFluid
{
    private AABB? _aabb;

    /// <summary>Makes a container without a box, which holds nothing until it has one.</summary>
    public AABBFluidContainer()
    {
    }

    /// <summary>Makes a container.</summary>
    /// <param name="aabb">Its box.</param>
    /// <exception cref="ArgumentNullException"><paramref name="aabb"/> is null.</exception>
    public AABBFluidContainer(AABB aabb)
    {
        _aabb = Require.NotNull(aabb, nameof(aabb));
    }

    /// <summary>The box of the fluid, in the world. Default null.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    public AABB? AABB
    {
        get => _aabb;
        set => _aabb = Require.NotNull(value, nameof(AABB));
    }

    /// <inheritdoc />
    public bool Intersect(AABB aabb)
    {
        Require.NotNull(aabb, nameof(aabb));
        return _aabb is not null && Collisions.AABB.Intersect(aabb, _aabb);
    }

    /// <inheritdoc />
    public bool Contains(ref Vector2 vector) => _aabb is not null && _aabb.Contains(ref vector);

    void IStraightFluid.PartsWithin(double minX, double maxX, out int first, out int end)
    {
        first = 0;
        end = _aabb is null ? 0 : 1;
    }

    FluidPart IStraightFluid.Part(int index)
    {
        Vector2 min = _aabb!.Min;
        Vector2 max = _aabb.Max;
        return new FluidPart(min.X, max.X, max.Y, OutlineEdge.Line(min.X, min.Y, max.X, min.Y));
    }

    /// <summary>Writes, or reads, what later updates read of it.</summary>
    internal void Visit(StateStream s)
    {
        s.Reference(ref _aabb);
        _aabb?.Visit(s);
    }
}
