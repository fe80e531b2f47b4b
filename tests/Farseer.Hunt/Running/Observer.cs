using System;
using System.Collections.Generic;
using System.Globalization;

namespace Farseer.Hunt.Running;

/// <summary>A body, as invariants see it.</summary>
internal readonly record struct BodyFact(double X, double Y, double Vx, double Vy, double Spin, double Mass, double Inertia, bool Moves)
{
    public double Kinetic => 0.5 * ((Mass * ((Vx * Vx) + (Vy * Vy))) + (Inertia * Spin * Spin));
}

/// <summary>What a facade shows of a running world. It changes nothing.</summary>
internal abstract class Observer
{
    private readonly List<object> _kept = new();

    /// <summary>Problems of events, found while they are told: (kind, values).</summary>
    public List<(string Kind, string Text)> Problems { get; } = new();

    /// <summary>Bodies that were taken out because their state was none.</summary>
    public List<string> Quarantined { get; } = new();

    /// <summary>What is told now is of a detour, which is taken back.</summary>
    public bool IsMuted { get; set; }

    /// <summary>Differences of two states that are told at most.</summary>
    protected const int MostDifferences = 10;

    /// <summary>A hash of all events that were told, in their order.</summary>
    public ulong Events { get; private set; } = 14695981039346656037;

    /// <summary>Detours that were taken.</summary>
    public int Detours { get; private set; }

    /// <summary>Captures a world, goes on with it in some other way, and restores it.</summary>
    public void Detour(object world, Random random)
    {
        IsMuted = true;
        try
        {
            Detours += TakeDetour(world, random) ? 1 : 0;
        }
        finally
        {
            IsMuted = false;
        }
    }

    /// <summary>Remembers a state, to look for the first difference later.</summary>
    public void Keep(object world)
    {
        if (Traced(world) is { } state)
        {
            _kept.Add(state);
        }
    }

    /// <returns>The fields that differ in the states of two observers, of the first step after which any does.</returns>
    public string FirstDifference(Observer other)
    {
        for (int i = 0; i < Math.Min(_kept.Count, other._kept.Count); i++)
        {
            string text = string.Join("; ", Differences(_kept[i], other._kept[i]));
            if (text.Length > 0)
            {
                return "state " + (i + 1).ToString(CultureInfo.InvariantCulture) + ": " + text;
            }
        }

        return "";
    }

    /// <returns>A state that knows the names of its fields; null: the world cannot be captured.</returns>
    protected abstract object? Traced(object world);

    protected abstract IEnumerable<string> Differences(object state, object other);

    /// <returns>False if the world cannot be captured.</returns>
    protected abstract bool TakeDetour(object world, Random random);

    public void Told(ulong what) => Events = (Events ^ what) * 1099511628211;

    /// <summary>An item was made: whoever wants to hear its events says so now.</summary>
    public abstract void Made(object item, object?[] arguments);

    /// <summary>After each step: who was taken out, where no event tells it.</summary>
    public virtual void Stepped(object world)
    {
    }

    /// <summary>Whether anything touches in a world.</summary>
    public abstract bool HasContacts(object world);

    public abstract void SetWorkers(object world, int count);

    public abstract ulong Hash(object world);

    public abstract List<BodyFact> Bodies(object world);

    public abstract (double X, double Y) Gravity(object world);

    /// <summary>Lists of a world after a step without handlers: owners, members and contacts agree.</summary>
    /// <returns>What is wrong, or null.</returns>
    public abstract string? Lists(object world);

    /// <summary>After the last call a plain body falls as it should.</summary>
    public abstract string? FallOfANewBody(object world);

    /// <summary>Looked at after every step, beside the items that calls made.</summary>
    public virtual IEnumerable<object> MoreItems(object world)
    {
        yield break;
    }

    /// <summary>
    /// Whether an item's values have been made by a step of a world: what was only set may be what nobody refuses until then.
    /// </summary>
    public virtual bool IsStepped(object world, object item) => true;

    /// <summary>Values that are documented to be infinite now.</summary>
    public virtual bool MayBeInfinite(object item, string member) => false;
}
