using System;
using System.Collections.Generic;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Tests.BroadPhase;

/// <summary>What a scene of boxes is made of; every kind has its own way to be hard.</summary>
public enum BoxKind
{
    /// <summary>Boxes of like size, about four neighbours each.</summary>
    Gas,

    /// <summary>Sizes over five powers of ten, some boxes as large as the world.</summary>
    Mixed,

    /// <summary>Identical boxes on a lattice, whose edges all coincide.</summary>
    Lattice,

    /// <summary>Points and lines, many in the same place.</summary>
    Degenerate,

    /// <summary>Far from the origin, where the spacing of floats is about the size of a box.</summary>
    Far,

    /// <summary>Two heaps far apart, so that cells cannot be numbered directly.</summary>
    Scattered,

    /// <summary>Boxes of finite and infinite extent.</summary>
    Enormous,
}

/// <summary>Boxes that are added, removed, moved and thrown about at random, as the world would report them.</summary>
internal sealed class BoxScene
{
    private readonly Random _random;
    private readonly BoxKind _kind;
    private readonly int _target;
    private readonly IBroadPhase[] _finders;
    private readonly List<int> _live = new List<int>();
    private readonly Stack<int> _free = new Stack<int>();

    public BoxScene(int seed, BoxKind kind, int target, params IBroadPhase[] finders)
    {
        _random = new Random(seed);
        _kind = kind;
        _target = target;
        _finders = finders;
        for (int i = 0; i < target; i++)
        {
            Add();
        }
    }

    public ProxyStore Proxies { get; } = new ProxyStore();

    /// <summary>One step's worth of changes: moves with the given chance, and now and then an add, a removal or a teleport.</summary>
    public void Change(double moveChance, bool population = true)
    {
        if (population)
        {
            for (int k = _random.Next(4); k > 0 && _live.Count > 0; k--)
            {
                Remove(_random.Next(_live.Count));
            }

            for (int k = _random.Next(5); k > 0 && _live.Count < _target + 50; k--)
            {
                Add();
            }
        }

        foreach (int proxy in _live)
        {
            double chance = _random.NextDouble();
            if (chance < moveChance)
            {
                bool teleport = population && chance < moveChance * 0.02;
                Proxies.Fat[proxy] = teleport ? NewBox() : Shifted(Proxies.Fat[proxy]);
                Proxies.Info[proxy].Flags |= ProxyFlags.Moved;
            }
        }
    }

    /// <param name="sought">The present boxes are known to be those around which pairs were found.</param>
    public void ClearMoved(bool sought = false)
    {
        for (int i = 0; i < Proxies.End; i++)
        {
            if (sought && (Proxies.Info[i].Flags & ProxyFlags.Moved) != 0)
            {
                Proxies.Sought[i] = Proxies.Fat[i];
            }

            Proxies.Info[i].Flags &= ~ProxyFlags.Moved;
        }
    }

    public static ulong[] Sorted(PairBuffer pairs)
    {
        var result = new ulong[pairs.Count];
        for (int i = 0; i < result.Length; i++)
        {
            result[i] = pairs[i];
        }

        Array.Sort(result);
        return result;
    }

    private void Add()
    {
        int proxy = _free.Count > 0 ? _free.Pop() : Proxies.End++;
        Proxies.Set.EnsureCapacity(Proxies.End);
        Proxies.Fat[proxy] = NewBox();
        Proxies.Info[proxy] = new ProxyInfo
        {
            // Some bodies have several pieces, which must not pair.
            Body = proxy / 3 * 2,
            Flags = ProxyFlags.Alive | ProxyFlags.Moved | (_random.Next(5) == 0 ? ProxyFlags.Static : ProxyFlags.None),
        };
        _live.Add(proxy);
        foreach (IBroadPhase finder in _finders)
        {
            finder.Added(Proxies, proxy);
        }
    }

    private void Remove(int position)
    {
        int proxy = _live[position];
        _live.RemoveAt(position);
        Proxies.Info[proxy].Flags = ProxyFlags.None;
        foreach (IBroadPhase finder in _finders)
        {
            finder.Removed(Proxies, proxy);
        }

        _free.Push(proxy);
    }

    private Box NewBox()
    {
        float side = MathF.Sqrt(_target);
        float x = Next(side);
        float y = Next(side);
        switch (_kind)
        {
            case BoxKind.Gas:
                return At(x, y, 0.5f + Next(0.7f), 0.5f + Next(0.7f));
            case BoxKind.Mixed:
                float size = _random.Next(40) == 0 ? side * 1.5f : 0.001f * MathF.Pow(10, Next(4));
                return At(x, y, size, size * (0.1f + Next(1)));
            case BoxKind.Lattice:
                return At(MathF.Floor(x), MathF.Floor(y), 1, 1);
            case BoxKind.Degenerate:
                return At(MathF.Floor(x * 0.3f), MathF.Floor(y * 0.3f), _random.Next(3) * 0.5f, _random.Next(2));
            case BoxKind.Far:
                return At(1e7f + x, -1e7f - y, 1 + Next(1), Next(2));
            case BoxKind.Scattered:
                return At((_random.Next(2) * 3e8f) + x, (_random.Next(2) * 1e6f) - y, 1, 1);
            default:
                return _random.Next(6) switch
                {
                    0 => At(-1e38f * Next(1), -1e38f, 3e38f, 3e38f * Next(1)),
                    1 => new Box(float.NegativeInfinity, y, float.PositiveInfinity, y + 1),
                    2 => new Box(x, float.NegativeInfinity, float.PositiveInfinity, y),
                    _ => At(x, y, 1, 1),
                };
        }
    }

    private Box Shifted(Box box)
    {
        float step = _kind == BoxKind.Lattice ? _random.Next(3) - 1 : (Next(2) - 1) * 0.2f;
        return _random.Next(2) == 0
            ? new Box(box.MinX + step, box.MinY, box.MaxX + step, box.MaxY)
            : new Box(box.MinX, box.MinY + step, box.MaxX, box.MaxY + step);
    }

    private float Next(float range) => (float)_random.NextDouble() * range;

    private static Box At(float x, float y, float width, float height) => new Box(x, y, x + width, y + height);
}
