using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Serialization.Documents;

namespace FarseerGames.FarseerPhysics.Serialization.Tables;

/// <summary>Writes what no public property shows.</summary>
internal sealed class HiddenWriter : IHiddenFields
{
    private readonly SceneSink _sink;

    public HiddenWriter(SceneSink sink) => _sink = sink;

    public void Value(string name, ref bool value) => _sink.Flag(name, value);

    public void Value(string name, ref int value) => _sink.Whole(name, value);

    public void Value(string name, ref float value) => _sink.Number(name, value);

    public void Value(string name, ref double value) => _sink.Number(name, value);

    public void Value(string name, ref Vector2 value) => _sink.Vector(name, value);

    public void Values(string name, ref float[] values)
    {
        _sink.Name(name);
        _sink.Numbers(values);
    }
}

/// <summary>Sets what no public property shows; what is missing stays as it is.</summary>
internal sealed class HiddenReader : IHiddenFields
{
    private readonly SceneObject _members;

    public HiddenReader(SceneObject members) => _members = members;

    public void Value(string name, ref bool value)
    {
        if (_members.TryTake(name, out SceneNode node))
        {
            value = node.Flag();
        }
    }

    public void Value(string name, ref int value)
    {
        if (_members.TryTake(name, out SceneNode node))
        {
            value = node.Whole();
        }
    }

    public void Value(string name, ref float value)
    {
        if (_members.TryTake(name, out SceneNode node))
        {
            value = node.Single();
        }
    }

    /// <summary>These are places and angles in bodies: no joint holds with one that is not finite.</summary>
    public void Value(string name, ref double value)
    {
        if (_members.TryTake(name, out SceneNode node))
        {
            value = node.Finite();
        }
    }

    public void Value(string name, ref Vector2 value)
    {
        if (_members.TryTake(name, out SceneNode node))
        {
            value = node.Vector();
        }
    }

    public void Values(string name, ref float[] values)
    {
        if (_members.TryTake(name, out SceneNode node))
        {
            values = node.Singles();
        }
    }
}
