using System;
using FarseerGames.FarseerPhysics.Serialization.Documents;
using FarseerGames.FarseerPhysics.Serialization.States;

namespace FarseerGames.FarseerPhysics.Serialization.Recordings;

/// <summary>What makes one state of another.</summary>
internal sealed class StateChange
{
    private readonly ulong _from;
    private readonly ulong _to;
    private readonly StatePart _difference;

    private readonly bool _keepsReferences;
    private readonly bool _keepsRoom;

    private StateChange(ulong from, ulong to, StatePart difference, bool keepsReferences, bool keepsRoom)
    {
        _from = from;
        _to = to;
        _difference = difference;
        _keepsReferences = keepsReferences;
        _keepsRoom = keepsRoom;
    }

    public static StateChange Between(StateImage from, StateImage to)
    {
        bool keepsReferences = from.Part.References.AsSpan().SequenceEqual(to.Part.References);
        bool keepsRoom = from.Part.Room.AsSpan().SequenceEqual(to.Part.Room);
        var difference = new StatePart(
            Parted(to.Part.Bytes, from.Part.Bytes),
            keepsReferences ? [] : to.Part.References,
            keepsRoom ? [] : to.Part.Room,
            to.Part.Layout);
        return new StateChange(from.Hash, to.Hash, difference, keepsReferences, keepsRoom);
    }

    public static StateChange Read(SceneNode node)
    {
        var members = new SceneObject(node);
        ulong from = Number(members.Take("from"));
        ulong to = Number(members.Take("to"));
        bool keepsReferences = members.Take("keepsReferences").Flag();
        bool keepsRoom = members.Take("keepsRoom").Flag();
        return new StateChange(from, to, StatePart.Read(members), keepsReferences, keepsRoom);
    }

    /// <summary>The state that comes of another; null if that is not the one that the change is of.</summary>
    public StateImage? Applied(StateImage from)
    {
        if (from.Hash != _from)
        {
            return null;
        }

        int[] references = _keepsReferences ? from.Part.References : _difference.References;
        StateImage to = StateImage.From(new StatePart(
            Parted(_difference.Bytes, from.Part.Bytes), references, _keepsRoom ? from.Part.Room : _difference.Room, _difference.Layout));
        return to.Hash == _to ? to : null;
    }

    public void Write(SceneSink sink)
    {
        sink.BeginObject();
        Number(sink, "from", _from);
        Number(sink, "to", _to);
        sink.Flag("keepsReferences", _keepsReferences);
        sink.Flag("keepsRoom", _keepsRoom);
        _difference.Write(sink);
        sink.EndObject();
    }

    public static void Number(SceneSink sink, string name, ulong value)
    {
        sink.Whole(name, (long)value);
    }

    public static ulong Number(SceneNode node) => (ulong)node.Long();

    /// <summary>The bits that differ; what is longer stays as it is behind the end of the other.</summary>
    private static byte[] Parted(byte[] of, byte[] against)
    {
        var parted = (byte[])of.Clone();
        for (int i = 0; i < Math.Min(of.Length, against.Length); i++)
        {
            parted[i] ^= against[i];
        }

        return parted;
    }
}
