using System;
using System.Numerics;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// A table of the distances from the nodes of a square lattice to the outline of a geom, made once, from which the distance and
/// the normal at any point within are interpolated (manual: "Grid").
/// </summary>
/// <remarks>
/// <para>
/// The lattice covers the box around the geom, in the geom's own coordinates, from its lower corner on. Distances are exact at the
/// nodes and bilinear between them, so a small cell is precise and a large one quick to make: the work grows with the number
/// of nodes times the number of vertices. Make geoms beforehand, not while the game runs. A tenth of the shorter side of
/// the geom is a good cell to begin with.
/// </para>
/// <para>
/// With cells that are large against the details of the geom, points just inside a corner can be missed, and normals near
/// corners are rounded off. The collisions of the simulation do not come from this table, and a geom makes it only when it is
/// asked for.
/// </para>
/// </remarks>
/// <example>
/// <code>
/// var grid = new Grid();
/// grid.ComputeGrid(geom, 0.1f);
/// var point = new Vector2(0.2f, 0.1f);
/// bool inside = grid.Intersect(ref point, out Feature nearest);
/// </code>
/// </example>
[NotState(Why.Users)]
public sealed partial class Grid
{
    /// <summary>64 MB of distances: beyond this the cell size is surely a mistake.</summary>
    private const double MostNodes = 1 << 24;

    private float[]? _distances;
    private Vector2[]? _points;
    private AABB _box = new AABB();
    private float _cellSize;
    private int _columns;
    private int _rows;

    /// <summary>Makes a grid without content; compute it before use.</summary>
    public Grid()
    {
    }

    /// <summary>
    /// The nodes of the lattice, in the coordinates of the geom, column by column (the y coordinate runs first). Null until
    /// the grid is computed. For drawing; changing the array changes nothing else.
    /// </summary>
    public Vector2[]? Points => _points;

    /// <summary>Makes a grid of the same content, for a geom of the same shape.</summary>
    /// <returns>The copy; computing one of the two again leaves the other as it is.</returns>
    public Grid Clone() => new Grid
    {
        _distances = _distances,
        _points = (Vector2[]?)_points?.Clone(),
        _box = new AABB(_box),
        _cellSize = _cellSize,
        _columns = _columns,
        _rows = _rows,
    };

    /// <summary>Looks up a point.</summary>
    /// <param name="vector">The point, in the coordinates of the geom; not changed.</param>
    /// <param name="feature">For a point inside the geom: the point, the distance to the outline (0 or negative) and the unit
    /// normal, which points outwards; otherwise the default.</param>
    /// <returns>True if the point is inside the geom, as far as the grid can tell, and there is a way out: false, as in version
    /// 2.0.1, also in the middle of a geom where the distances on the two sides of a large cell are the same.</returns>
    /// <exception cref="InvalidOperationException">The grid has not been computed.</exception>
    public bool Intersect(ref Vector2 vector, out Feature feature)
    {
        if (_distances is null)
        {
            throw new InvalidOperationException("The grid is empty: call ComputeGrid first.");
        }

        feature = default;
        if (!_box.Contains(ref vector))
        {
            return false;
        }

        var x = Cell(vector.X - _box.Min.X, _columns, out var xPart);
        var y = Cell(vector.Y - _box.Min.Y, _rows, out var yPart);
        var node = (x * _rows) + y;
        var lowLow = _distances[node];
        var lowHigh = _distances[node + 1];
        var highLow = _distances[node + _rows];
        var highHigh = _distances[node + _rows + 1];
        var bottom = lowLow + ((highLow - lowLow) * xPart);
        var top = lowHigh + ((highHigh - lowHigh) * xPart);
        var distance = bottom + ((top - bottom) * yPart);

        // The gradient of the interpolated distance within the cell.
        var left = lowLow + ((lowHigh - lowLow) * yPart);
        var right = highLow + ((highHigh - highLow) * yPart);
        var gradient = new Vector2(right - left, top - bottom);
        var length = gradient.Length();
        if (!(distance <= 0f && length > 0f))
        {
            return false;
        }

        feature = new Feature(vector, gradient / length, distance);
        return true;
    }

    /// <summary>Fills the table.</summary>
    /// <param name="outline">The points that the grid must cover, at least one.</param>
    /// <param name="cellSize">The distance between nodes.</param>
    /// <param name="distance">The signed distance of a point from the outline, negative inside.</param>
    internal void Compute(Vertices outline, float cellSize, Func<Vector2, float> distance)
    {
        Require.Positive(cellSize, "gridCellSize");
        var box = new AABB(outline);
        var columns = Math.Max(Math.Ceiling(box.Width / (double)cellSize), 1d) + 1d;
        var rows = Math.Max(Math.Ceiling(box.Height / (double)cellSize), 1d) + 1d;
        if (columns * rows > MostNodes)
        {
            throw new ArgumentOutOfRangeException(
                "gridCellSize",
                cellSize,
                $"A geom of {box.Width} by {box.Height} would need {columns * rows:0} nodes; at most {MostNodes:0} are allowed.");
        }

        _box = box;
        _cellSize = cellSize;
        _columns = (int)columns;
        _rows = (int)rows;
        var distances = new float[_columns * _rows];
        var points = new Vector2[distances.Length];
        for (var x = 0; x < _columns; x++)
        {
            for (var y = 0; y < _rows; y++)
            {
                var point = box.Min + (new Vector2(x, y) * cellSize);
                points[(x * _rows) + y] = point;
                distances[(x * _rows) + y] = distance(point);
            }
        }

        _distances = distances;
        _points = points;
    }

    /// <summary>The cell that holds an offset from the lower side; the upper side belongs to the last cell.</summary>
    private int Cell(float offset, int nodes, out float part)
    {
        var cells = offset / _cellSize;
        var cell = Math.Min((int)cells, nodes - 2);
        part = cells - cell;
        return cell;
    }
}
