using System;
using System.Collections.Generic;
using System.Linq;
using Box2D.Dynamics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Serialization.States;

namespace FarseerGames.FarseerPhysics.Serialization.Flash;

/// <summary>The exact state of a world of the other facade as a part of its file.</summary>
internal static class WorldState
{
    public static StatePart ToPart(WorldContents contents)
    {
        var stream = new StateStream { Room = new List<int>() };
        contents.World.Write(stream, new Box2D.Bridge.StateRoster());
        return StatePart.Of(stream, Places(contents), StateLayout.OfWorld, FixedOnes(contents.World));
    }

    public static void Restore(StatePart part, WorldContents contents, Func<string, Exception?, Exception> fault)
    {
        StateStream stream = part.ToStream(Places(contents), fault, FixedOnes(contents.World));
        try
        {
            contents.World.Read(stream, new Box2D.Bridge.StateRoster());
        }
        catch (Exception exception) when (exception is InvalidOperationException or InvalidCastException or ArgumentException
            or NullReferenceException or IndexOutOfRangeException)
        {
            throw fault("does not fit the scene", exception);
        }
    }

    private static object[] FixedOnes(b2World world) => [world, world.Engine.World, Box2D.Dynamics.b2ContactFilter.b2_defaultFilter];

    private static IEnumerable<object> Places(WorldContents contents) =>
        contents.Bodies.AsEnumerable<object>().Concat(contents.Shapes).Concat(contents.Joints)
            .Concat(contents.Joints.SelectMany(static joint => new object[] { joint.Edge1, joint.Edge2 }));
}
