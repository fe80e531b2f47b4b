using System;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>The grid of a geom.</content>
public sealed partial class Grid
{
    /// <summary>Works the grid out for a geom.</summary>
    /// <param name="geometry">The geom; its <see cref="Geom.LocalVertices"/> count.</param>
    /// <param name="gridCellSize">Cell size; finite and above 0.</param>
    /// <exception cref="ArgumentNullException"><paramref name="geometry"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="gridCellSize"/> is not finite or not above 0.</exception>
    public void ComputeGrid(Geom geometry, float gridCellSize)
    {
        Require.NotNull(geometry, nameof(geometry));
        Require.Positive(gridCellSize, nameof(gridCellSize));
        Compute(geometry.LocalVertices, gridCellSize, geometry.GetNearestDistance);
    }
}
