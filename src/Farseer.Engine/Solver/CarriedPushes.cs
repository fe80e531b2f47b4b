using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Islands;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// 16 bytes in the order of a velocity: how far a body was pushed out of overlaps in the substep before, and the share of it that it goes
/// on with.
/// </summary>
internal struct CarriedPush
{
    public float X;
    public float Y;

    /// <summary>Angle, radians.</summary>
    public float W;

    /// <summary>0: the body carries nothing.</summary>
    public float Keep;
}

/// <summary>
/// The memory of pushes against overlap in deep islands of many levels. A sweep that remembers nothing pushes no further than some levels:
/// an overlap spreads through n levels in n² sweeps, and a high heap sank under its weight faster than it came apart. When each body goes
/// on by most of what it was pushed in the substep before, overlaps run through the heap as a wave does, some half of a level a substep. It
/// is a way, not a speed: no velocity comes of it, and steps of changing length go on with it alike.
/// </summary>
internal sealed unsafe class CarriedPushes
{
    /// <summary>
    /// The share that is lost in a substep, times the levels. The slowest wave of n levels would swing back below some 2 over n, but
    /// nothing draws the heap together again, and half of that lets a heap of forty rise by 6.1 m in four seconds instead of 5.2.
    /// </summary>
    private const float LossOfLevels = 1f;

    private readonly Column<CarriedPush> _pushes = new Column<CarriedPush>();
    private bool _carried;

    /// <summary>Makes room for so many bodies: a heap may get deep late.</summary>
    public void Reserve(int bodyEnd) => _pushes.EnsureCapacity(bodyEnd);

    /// <summary>Finds who carries pushes on in this step.</summary>
    /// <param name="anyDeep">An island is deep.</param>
    /// <param name="feedForward">Tells which.</param>
    /// <param name="islands">The islands.</param>
    /// <param name="bodyEnd">One past the highest body.</param>
    /// <returns>By body; null: nobody does.</returns>
    public CarriedPush* Begin(bool anyDeep, FeedForwardSettings feedForward, IslandStore islands, int bodyEnd)
    {
        if (!anyDeep || !IsAny(feedForward, islands))
        {
            _carried = false;
            return null;
        }

        _pushes.EnsureCapacity(bodyEnd);
        CarriedPush* pushes = _pushes.Pointer;
        int last = -1;
        float keep = 0;
        for (int body = 0; body < bodyEnd; body++)
        {
            // Neighbours in number are mostly of one island.
            int island = body < islands.BodyEnd ? islands.Of(body) : -1;
            if (island != last)
            {
                last = island;
                keep = island >= 0 && island < islands.Count && IsHigh(feedForward, islands, island)
                    ? 1 - (LossOfLevels / Levels(islands, island))
                    : 0;
            }

            if (keep == 0 || !_carried)
            {
                pushes[body] = default;
            }

            pushes[body].Keep = keep;
        }

        _carried = true;
        return _pushes.Pointer;
    }

    /// <summary>Adds what the bodies carry to their velocities; those that they had are saved.</summary>
    public static void Add(CarriedPush* pushes, int* list, int count, BodyState* states, Vector4* saved, float substep)
    {
        float rate = 1 / substep;
        for (int i = 0; i < count; i++)
        {
            Vector4* velocity = BodyState.VelocityOf(states + list[i]);
            saved[i] = *velocity;
            CarriedPush* push = pushes + list[i];
            float share = push->Keep * rate;
            *velocity += new Vector4(share, share, share, 0) * *(Vector4*)push;
        }
    }

    /// <summary>Gives the bodies back what was saved, and remembers how much their velocities differed from it.</summary>
    public static void Remember(CarriedPush* pushes, int* list, int count, BodyState* states, Vector4* saved, float substep)
    {
        for (int i = 0; i < count; i++)
        {
            Vector4* velocity = BodyState.VelocityOf(states + list[i]);
            CarriedPush* push = pushes + list[i];
            float keep = push->Keep;
            if (keep > 0)
            {
                *(Vector4*)push = new Vector4(substep) * (*velocity - saved[i]);
                push->Keep = keep;
            }

            *velocity = saved[i];
        }
    }

    private static bool IsAny(FeedForwardSettings feedForward, IslandStore islands)
    {
        bool any = false;
        for (int island = 0; island < islands.Count; island++)
        {
            any |= IsHigh(feedForward, islands, island);
        }

        return any;
    }

    private static bool IsHigh(FeedForwardSettings feedForward, IslandStore islands, int island) =>
        DeepStacks.IsHigh(islands, island) && feedForward.IsDeep(island);

    private static int Levels(IslandStore islands, int island) => islands.FirstSlot[island + 1] - islands.FirstSlot[island];

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_pushes);
        s.Value(ref _carried);
    }
}
