using System.Collections.Generic;
using System.Globalization;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Compares states with the names of their fields, and tells whom a field concerns.</summary>
internal static class StateNames
{
    /// <summary>The state of a simulator, with the names of its fields.</summary>
    public static StateStream Named(PhysicsSimulator simulator)
    {
        var state = new PhysicsSimulatorState();
        state.BeginTrace();
        simulator.Capture(state);
        return state.Stream;
    }

    /// <summary>A state with the names of its fields: if it has none its simulator goes back to it for a moment.</summary>
    public static StateStream Named(PhysicsSimulatorState state)
    {
        if (state.Stream.Trace is not null)
        {
            return state.Stream;
        }

        PhysicsSimulator simulator = state.Owner!;
        PhysicsSimulatorState present = simulator.Capture();
        try
        {
            simulator.Restore(state);
            return Named(simulator);
        }
        finally
        {
            simulator.Restore(present);
        }
    }

    /// <param name="simulator">Whose bodies, geoms and joints are named.</param>
    /// <param name="one">A state with names.</param>
    /// <param name="other">Another one.</param>
    /// <param name="areOfOne">Both are of the same simulator: objects are the same only if they are the same instances.</param>
    /// <param name="most">Differences at most.</param>
    public static StateComparison Compare(PhysicsSimulator simulator, StateStream one, StateStream other, bool areOfOne, int most)
    {
        List<StateMismatch> found = new StateComparer(one, other, areOfOne ? AreSame : AreAlike, Label, most).Find();
        var differences = new List<StateDifference>(found.Count);
        foreach (StateMismatch mismatch in found)
        {
            differences.Add(new StateDifference(mismatch, Item(simulator, mismatch)));
        }

        return new StateComparison(differences);
    }

    /// <summary>Of one simulator: a part of the engine is made when it is first needed, and is compared by what it remembers.</summary>
    private static bool AreSame(object? one, object? other) =>
        Equals(one, other)
        || (one is not null && one.GetType() == other?.GetType()
            && one.GetType().Namespace?.StartsWith("Farseer.Engine", System.StringComparison.Ordinal) == true);

    /// <summary>Of two simulators: who was added as the same one in turn, and what calls the same method.</summary>
    private static bool AreAlike(object? one, object? other) => (one, other) switch
    {
        (null, _) or (_, null) => false,
        (IStatePart a, IStatePart b) => a.GetType() == b.GetType() && a.Mark.Place == b.Mark.Place,
        (string a, string b) => a == b,
        (System.Delegate a, System.Delegate b) => a.Method == b.Method,
        _ => one.GetType() == other.GetType(),
    };

    private static string Item(PhysicsSimulator simulator, in StateMismatch mismatch)
    {
        object? who = mismatch.Note.Who;
        int record = mismatch.Record;
        switch (mismatch.Note.Part)
        {
            case "Bodies":
                who = simulator.BodyOf(record);
                break;
            case "Joints":
                who = simulator.JointOf(record);
                break;
            case "Shapes" when mismatch.Note.Name == nameof(Farseer.Engine.Shapes.ShapeStore.Colliders):
                who = simulator.GeomOf(record);
                break;
            case "Contacts" when mismatch.Note.Name == nameof(Farseer.Engine.Contacts.ContactStore.Records):
                return Pair(simulator, record);
            case "Contact":
                return Pair(simulator, mismatch.Note.Item);
        }

        return who is null ? "" : Label(who);
    }

    private static string Pair(PhysicsSimulator simulator, int contact) => simulator.World.Reader.TryGetPair(contact, out int a, out int b)
        ? Label(simulator.GeomOf(a)) + " and " + Label(simulator.GeomOf(b)) : "";

    private static string Label(object? item) => item switch
    {
        null => "null",
        Body body => Label("body", Place(body.Simulator?.BodyList, body), body.Name ?? body.Tag?.ToString()),
        Geom geom => Label("geom", Place(geom.Simulator?.GeomList, geom), geom.Name ?? geom.Tag?.ToString()),
        Joint joint => Label(joint.GetType().Name, Place(joint.Simulator?.JointList, joint), joint.Tag?.ToString()),
        string text => text,
        System.Delegate handler => handler.Method.Name,
        _ => item.GetType().Name,
    };

    private static string Label(string kind, int place, string? name) =>
        kind + (place < 0 ? "" : " " + place.ToString(CultureInfo.InvariantCulture))
        + (string.IsNullOrEmpty(name) ? "" : " '" + name + "'");

    private static int Place<T>(List<T>? list, T item) => list is null ? -1 : list.IndexOf(item);
}
