using System;
using System.Collections.Generic;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Serialization.States;

/// <summary>
/// A number for how a state lies in memory: names and places of all fields of a world that has one of everything. A version of the library
/// that adds or moves one has another number, and nobody has to think of it.
/// </summary>
internal static class StateLayout
{
    private static readonly Lazy<ulong> s_simulator = new Lazy<ulong>(static () => Sum(SampleWorlds.SimulatorTrace()));
    private static readonly Lazy<ulong> s_world = new Lazy<ulong>(static () => Sum(SampleWorlds.WorldTrace()));

    public static ulong OfSimulator => s_simulator.Value;

    public static ulong OfWorld => s_world.Value;

    private static ulong Sum(IReadOnlyList<StateNote> trace)
    {
        ulong sum = 14695981039346656037;
        foreach (StateNote note in trace)
        {
            Add((uint)note.At);
            Add((uint)note.ObjectAt);
            foreach (char c in note.Name)
            {
                Add(c);
            }
        }

        return sum;

        void Add(uint value) => sum = (sum ^ value) * 1099511628211;
    }
}
