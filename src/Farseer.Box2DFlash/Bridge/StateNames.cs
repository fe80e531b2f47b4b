using System;
using System.Collections.Generic;
using System.Globalization;
using Box2D.Collision.Shapes;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Bridge;

/// <summary>Compares states with the names of their fields, and tells whom a field concerns.</summary>
internal sealed class StateNames
{
    // Places of those of both worlds, counted from 0 in each list.
    private readonly Dictionary<object, int> _places = new Dictionary<object, int>();

    /// <summary>The state of a world, with the names of its fields.</summary>
    public static StateStream Named(b2World world)
    {
        var state = new b2WorldState();
        state.BeginTrace();
        world.Capture(state);
        return state.Stream;
    }

    /// <summary>A state with the names of its fields: if it has none its world goes back to it for a moment.</summary>
    public static StateStream Named(b2WorldState state)
    {
        if (state.Stream.Trace is not null)
        {
            return state.Stream;
        }

        b2World world = state.Owner!;
        b2WorldState present = world.Capture();
        try
        {
            world.Restore(state);
            return Named(world);
        }
        finally
        {
            world.Restore(present);
        }
    }

    /// <summary>What a reference of a state is told by: a number that is the same in every world that was made in the same way.</summary>
    public ulong Number(object? item)
    {
        const ulong Others = 2;
        return item is null ? 0 : _places.TryGetValue(item, out int place) ? Others + (ulong)place : 1;
    }

    /// <summary>The hash of a state, references by their numbers.</summary>
    public ulong Hash(StateStream s)
    {
        ulong hash = StateHasher.Add(StateHasher.Start, s);
        for (int i = 0; i < s.ObjectCount; i++)
        {
            hash = StateHasher.Add(hash, Number(s.Objects[i]));
        }

        return hash;
    }

    /// <summary>Numbers those of a world.</summary>
    public void Enter(StateRoster roster)
    {
        Enter(roster.Bodies);
        Enter(roster.Shapes);
        Enter(roster.Joints);
    }

    /// <param name="world">Whose bodies, shapes and joints are named.</param>
    /// <param name="one">A state with names.</param>
    /// <param name="other">Another one.</param>
    /// <param name="areOfOne">Both are of the same world: objects are the same only if they are the same instances.</param>
    /// <param name="most">Differences at most.</param>
    public b2StateComparison Compare(b2World world, StateStream one, StateStream other, bool areOfOne, int most)
    {
        List<StateMismatch> found = new StateComparer(one, other, areOfOne ? AreSame : AreAlike, Label, most).Find();
        var differences = new List<b2StateDifference>(found.Count);
        foreach (StateMismatch mismatch in found)
        {
            differences.Add(new b2StateDifference(mismatch, Item(world, mismatch)));
        }

        return new b2StateComparison(differences);
    }

    private void Enter<T>(List<T> items)
        where T : class
    {
        for (int i = 0; i < items.Count; i++)
        {
            _places[items[i]] = i;
        }
    }

    /// <summary>Of one world: a part of the engine is made when it is first needed, and is compared by what it remembers.</summary>
    private static bool AreSame(object? one, object? other) =>
        ReferenceEquals(one, other)
        || (one is not null && one.GetType() == other?.GetType()
            && one.GetType().Namespace?.StartsWith("Farseer.Engine", StringComparison.Ordinal) == true);

    private bool AreAlike(object? one, object? other) =>
        one is not null && other is not null && one.GetType() == other.GetType() && Number(one) == Number(other);

    private string Item(b2World world, in StateMismatch mismatch) => mismatch.Note.Part switch
    {
        "Bodies" => Label(world.BodyOf(mismatch.Record)),
        "Contact" => Pair(world, mismatch.Note.Item),
        "Contacts" when mismatch.Note.Name == nameof(Farseer.Engine.Contacts.ContactStore.Records) => Pair(world, mismatch.Record),
        _ => mismatch.Note.Who is null ? "" : Label(mismatch.Note.Who),
    };

    private string Pair(b2World world, int contact) => world.Engine.World.Reader.TryGetPair(contact, out int a, out int b)
        ? Label(world.Engine.ShapeOf(a)) + " and " + Label(world.Engine.ShapeOf(b)) : "";

    private string Label(object? item)
    {
        string kind = item switch
        {
            null => "",
            b2Body => "body",
            b2Shape => "shape",
            b2Joint => "joint",
            _ => item.GetType().Name,
        };
        return item is not null && _places.TryGetValue(item, out int place)
            ? kind + " " + place.ToString(CultureInfo.InvariantCulture)
            : kind;
    }
}
