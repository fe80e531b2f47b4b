using System;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Scenes.Performance;

/// <summary>
/// A world for timing whole steps. Metres; y up; gravity (0, -10); density 1, friction 0.6, no restitution; the collider for large scenes.
/// </summary>
public abstract class PerformanceScene
{
    /// <summary>Name of the scene in the published comparison.</summary>
    public abstract string Name { get; }

    /// <summary>What the size counts.</summary>
    public abstract string SizeMeaning { get; }

    /// <summary>The published size.</summary>
    public abstract int DefaultSize { get; }

    public abstract int LargestSize { get; }

    /// <summary>Updates of a run; the first one, which finds every pair, is not timed.</summary>
    public abstract int Steps { get; }

    public float Dt => 1f / 60f;

    /// <summary>Fills an empty simulator.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The size is below 1 or above <see cref="LargestSize"/>.</exception>
    public void Build(PhysicsSimulator simulator, int size)
    {
        if (size < 1 || size > LargestSize)
        {
            throw new ArgumentOutOfRangeException(nameof(size), size, $"{Name}: the size must lie in 1..{LargestSize}.");
        }

        simulator.Gravity = new System.Numerics.Vector2(0f, -10f);
        simulator.Iterations = 4;
        simulator.BroadPhaseCollider = new GridCollider(simulator);
        Fill(new Bricks(simulator), size);
    }

    /// <summary>
    /// Moves what the scene drives by hand, before update <paramref name="step"/> (0 is the first). Nothing in most scenes.
    /// </summary>
    public virtual void Drive(int step)
    {
    }

    private protected abstract void Fill(Bricks bricks, int size);
}
