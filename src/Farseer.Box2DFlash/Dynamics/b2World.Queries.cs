using System;
using System.Collections.Generic;
using System.Numerics;
using Box2D.Bridge;
using Box2D.Collision;
using Box2D.Collision.Shapes;

namespace Box2D.Dynamics;

/// <content>Queries.</content>
public partial class b2World
{
    /// <summary>Finds the shapes whose boxes overlap a box. It looks at boxes only: the shapes themselves may lie beside it.</summary>
    /// <param name="aabb">The box, in the world.</param>
    /// <param name="shapes">The array to fill, from index 0 on.</param>
    /// <param name="maxCount">Largest number of shapes to find; 0 or more.</param>
    /// <returns>The number of shapes put into <paramref name="shapes"/>.</returns>
    /// <exception cref="ArgumentNullException">An argument, or a corner of the box, is null.</exception>
    /// <exception cref="ArgumentException">The corners of the box are not finite or not in order.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="maxCount"/> is negative or more than the array holds.</exception>
    public int Query(b2AABB aabb, b2Shape[] shapes, int maxCount)
    {
        Require.NotNull(shapes, nameof(shapes));
        CheckBox(aabb);
        if (maxCount < 0 || maxCount > shapes.Length)
        {
            throw new ArgumentOutOfRangeException(
                nameof(maxCount), maxCount, "The count must be 0 or more, and the array must have room for it.");
        }

        int count = 0;
        int found = Find(aabb);
        for (int i = 0; i < found && count < maxCount; i++)
        {
            if (Engine.Found(i) is { } shape)
            {
                shapes[count++] = shape;
            }
        }

        return count;
    }

    /// <summary>Finds the shapes whose boxes overlap a box, as the other overload.</summary>
    /// <param name="aabb">The box, in the world.</param>
    /// <param name="shapes">The list to add them to.</param>
    /// <param name="maxCount">Largest number of shapes to find; 0 or more.</param>
    /// <returns>The number of shapes added.</returns>
    /// <exception cref="ArgumentNullException">An argument, or a corner of the box, is null.</exception>
    /// <exception cref="ArgumentException">The corners of the box are not finite or not in order.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="maxCount"/> is negative.</exception>
    public int Query(b2AABB aabb, List<b2Shape> shapes, int maxCount)
    {
        Require.NotNull(shapes, nameof(shapes));
        CheckBox(aabb);
        if (maxCount < 0)
        {
            throw new ArgumentOutOfRangeException(nameof(maxCount), maxCount, "The count must be 0 or more.");
        }

        int count = 0;
        int found = Find(aabb);
        for (int i = 0; i < found && count < maxCount; i++)
        {
            if (Engine.Found(i) is { } shape)
            {
                shapes.Add(shape);
                count++;
            }
        }

        return count;
    }

    private static void CheckBox(b2AABB aabb)
    {
        Require.NotNull(aabb, nameof(aabb));
        Require.NotNull(aabb.lowerBound, nameof(aabb));
        Require.NotNull(aabb.upperBound, nameof(aabb));
        if (!aabb.IsValid())
        {
            throw new ArgumentException("The corners of the box must be finite and in order.", nameof(aabb));
        }
    }

    private int Find(b2AABB aabb) =>
        Engine.Find(new Vector2(aabb.lowerBound.x, aabb.lowerBound.y), new Vector2(aabb.upperBound.x, aabb.upperBound.y));
}
