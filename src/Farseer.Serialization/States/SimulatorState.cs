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
        var stream = new StateStream { Room = new List<int>() };
        simulator.Write(stream, new Bridge.StateRoster());
        return stream;
    }

    public static StatePart ToPart(StateStream stream, SceneContents contents) =>
        StatePart.Of(stream, Places(contents), StateLayout.OfSimulator, contents.Simulator, contents.Simulator.World);

    /// <summary>
    /// Lets a simulator run for once, with all that is in it: parts of the engine that are made with the first step are there then, and have room. What
    /// else comes of it the state replaces.
    /// </summary>
    public static void Prepare(PhysicsSimulator simulator)
    {
        simulator.Enabled = true;
        simulator.Update(AnyStep);
    }

    /// <summary>Sets a simulator and the objects of its file to the state.</summary>
    public static void Restore(StatePart part, SceneContents contents, SceneNode node)
    {
        PhysicsSimulator simulator = contents.Simulator;
        StateStream stream = part.ToStream(Places(contents), node, simulator, simulator.World);
        try
        {
            simulator.Read(stream, new Bridge.StateRoster(), new Bridge.StateRoster())?.Throw();
        }
        catch (Exception exception) when (exception is InvalidOperationException or InvalidCastException or ArgumentException or NullReferenceException or IndexOutOfRangeException)
        {
            throw node.Error("does not fit the scene", exception);
        }

        // The order of making is told by numbers that this process has given out.
        foreach (Geom geom in contents.Geoms)
        {
            if (geom.Link.IsAttached)
            {
                simulator.World.Collider(geom.Link.Handle).Order = geom.Id;
            }
        }
    }

    private static IEnumerable<object> Places(SceneContents contents) =>
        contents.BodyItems.AsEnumerable<object>().Concat(contents.GeomItems).Concat(contents.JointItems).Concat(contents.SpringItems).Concat(contents.ControllerItems);
}
