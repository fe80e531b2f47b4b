using System;
using System.Collections.Generic;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Serialization.States;

namespace FarseerGames.FarseerPhysics.Serialization.Recordings;

/// <summary>
/// A state in terms of the objects of a file, so that two simulators that were loaded of the same file can be compared and set by it.
/// </summary>
internal sealed class StateImage
{
    private StateImage(StatePart part)
    {
        Part = part;
        ulong sum = 14695981039346656037;
        foreach (byte b in part.Bytes)
        {
            sum = (sum ^ b) * 1099511628211;
        }

        foreach (int reference in part.References)
        {
            sum = (sum ^ (uint)reference) * 1099511628211;
        }

        Hash = sum;
    }

    public StatePart Part { get; }

    /// <summary>Of all that the state says.</summary>
    public ulong Hash { get; }

    /// <summary>Captures a simulator; null if something belongs to it that is not in the file.</summary>
    public static StateImage? Of(SceneContents contents)
    {
        StateStream stream = SimulatorState.Capture(contents.Simulator);
        for (int i = 0; i < stream.ObjectCount; i++)
        {
            if (stream.Objects[i] is Body or Geom or Joint or Spring or Controller && contents.PlaceOf(stream.Objects[i]) < 0)
            {
                return null;
            }
        }

        return new StateImage(SimulatorState.ToPart(stream, contents));
    }

    public bool IsSameAs(StateImage other) =>
        Hash == other.Hash
        && Part.Bytes.AsSpan().SequenceEqual(other.Part.Bytes)
        && Part.References.AsSpan().SequenceEqual(other.Part.References);

    /// <summary>What no state says and only a file does: objects that were replaced since it was written.</summary>
    public static List<object?> FixedParts(SceneContents contents)
    {
        var parts = new List<object?> { contents.Simulator.Scaling, contents.Simulator.BroadPhaseCollider };
        foreach (Geom geom in contents.Geoms)
        {
            parts.Add(geom.Form);
        }

        foreach (Controller controller in contents.Controllers)
        {
            parts.Add(controller switch
            {
                WaveController wave => wave.XPosition?.Length,
                FluidDragController fluid => fluid.Container,
                WindController wind => wind.Area,
                _ => null,
            });
        }

        return parts;
    }

    public void Restore(SceneContents contents) =>
        SimulatorState.Restore(Part, contents, static (problem, cause) => new SceneFileException("The state " + problem + ".", cause));

    internal static StateImage From(StatePart part) => new StateImage(part);
}
