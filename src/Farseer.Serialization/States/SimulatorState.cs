using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Serialization.Documents;

namespace FarseerGames.FarseerPhysics.Serialization.States;

/// <summary>The exact state of a simulator as a part of its file.</summary>
internal static class SimulatorState
{
    /// <summary>A time that a step may have; it is gone back from.</summary>
    public const float AnyStep = 1f / 64;

    /// <summary>Captures a simulator for a file.</summary>
    public static StateStream Capture(PhysicsSimulator simulator)
    {
        var stream = new StateStream { Room = new List<int>(), StaysWithReader = StaysWithReader };
        List<Geom> attached = Attached(simulator);
        try
        {
            // The order of making is told by numbers that this process has given out: a file has the ranks.
            for (int i = 0; i < attached.Count; i++)
            {
                simulator.World.Shapes.Order[attached[i].Link.Handle.Index] = i + 1;
            }

            simulator.Write(stream, new Bridge.StateRoster());
        }
        finally
        {
            NumberByMaking(simulator, attached);
        }

        return stream;
    }

    public static StatePart ToPart(StateStream stream, SceneContents contents) =>
        StatePart.Of(stream, Places(contents), StateLayout.OfSimulator, contents.Simulator, contents.Simulator.World);

    /// <summary>
    /// Lets a simulator run for once, with all that is in it: parts of the engine that are made with the first step are there then, and
    /// have room. What else comes of it the state replaces.
    /// </summary>
    public static void Prepare(PhysicsSimulator simulator)
    {
        simulator.Enabled = true;
        simulator.Update(AnyStep);
    }

    /// <summary>Sets a simulator and the objects of its file to the state.</summary>
    /// <param name="part">The state.</param>
    /// <param name="contents">The simulator and the objects.</param>
    /// <param name="fault">What to throw if the state does not fit them.</param>
    public static void Restore(StatePart part, SceneContents contents, Func<string, Exception?, Exception> fault)
    {
        PhysicsSimulator simulator = contents.Simulator;
        StateStream stream = part.ToStream(Places(contents), fault, simulator, simulator.World);
        try
        {
            simulator.Read(stream, new Bridge.StateRoster(), new Bridge.StateRoster())?.Throw();
        }
        catch (Exception exception) when (exception is InvalidOperationException or InvalidCastException or ArgumentException
            or NullReferenceException or IndexOutOfRangeException)
        {
            throw fault("does not fit the scene", exception);
        }

        NumberByMaking(simulator, Attached(simulator));
    }

    /// <summary>The geoms that the engine has, in the order of their making.</summary>
    private static List<Geom> Attached(PhysicsSimulator simulator)
    {
        List<Geom> geoms = simulator.ListAttached();
        geoms.Sort(static (a, b) => a.Id.CompareTo(b.Id));
        return geoms;
    }

    private static void NumberByMaking(PhysicsSimulator simulator, List<Geom> geoms)
    {
        foreach (Geom geom in geoms)
        {
            simulator.World.Shapes.Order[geom.Link.Handle.Index] = geom.Id;
        }
    }

    /// <summary>Handlers, and what is worked out when it is asked for.</summary>
    private static bool StaysWithReader(Type type) =>
        typeof(Delegate).IsAssignableFrom(type) || type == typeof(Delegate[]) || type == typeof(string)
        || type == typeof(Grid) || type == typeof(Vertices) || type == typeof(Bridge.GeomForm);

    private static IEnumerable<object> Places(SceneContents contents) =>
        contents.BodyItems.AsEnumerable<object>().Concat(contents.GeomItems).Concat(contents.JointItems).Concat(contents.SpringItems)
            .Concat(contents.ControllerItems);
}
