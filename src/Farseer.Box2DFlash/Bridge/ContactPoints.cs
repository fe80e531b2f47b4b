using System;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;

namespace Box2D.Bridge;

/// <summary>The points of a contact: those of the last step in which it touched, and those before.</summary>
internal sealed class ContactPoints
{
    private ContactPoint[] _now = new ContactPoint[2];
    private ContactPoint[] _before = new ContactPoint[2];

    public int Count { get; private set; }

    public int BeforeCount { get; private set; }

    /// <summary>There are points, of this step or of the last one.</summary>
    public bool Any => Count > 0 || BeforeCount > 0;

    /// <summary>The step in which points last came.</summary>
    public long Step { get; private set; } = -1;

    public ref ContactPoint this[int index] => ref _now[index];

    public ref ContactPoint Before(int index) => ref _before[index];

    public void Take(ReadOnlySpan<ContactPoint> points, bool flip, long step)
    {
        Step = step;
        if (_now.Length < points.Length)
        {
            Array.Resize(ref _now, points.Length);
        }

        Count = points.Length;
        for (int i = 0; i < points.Length; i++)
        {
            _now[i] = points[i];
            if (flip)
            {
                _now[i].Normal = -_now[i].Normal;
            }
        }
    }

    /// <summary>The present points become those before; there are none until some come.</summary>
    public void Turn()
    {
        (_now, _before) = (_before, _now);
        BeforeCount = Count;
        Count = 0;
    }

    public bool WasThere(uint feature) => Find(_before, BeforeCount, feature);

    public bool IsThere(uint feature) => Find(_now, Count, feature);

    /// <summary>As if nothing had touched yet.</summary>
    public void Begin()
    {
        Clear();
        Step = -1;
    }

    public void Clear()
    {
        Count = 0;
        BeforeCount = 0;
    }

    private static bool Find(ContactPoint[] points, int count, uint feature)
    {
        for (int i = 0; i < count; i++)
        {
            if (points[i].FeatureId == feature)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        Count = s.Value(Count);
        BeforeCount = s.Value(BeforeCount);
        Step = s.Value(Step);
        Visit(s, ref _now, Count);
        Visit(s, ref _before, BeforeCount);
    }

    private static void Visit(StateStream s, ref ContactPoint[] points, int count)
    {
        if (points.Length < count)
        {
            Array.Resize(ref points, count);
        }

        for (int i = 0; i < count; i++)
        {
            s.Value(ref points[i]);
        }
    }
}
