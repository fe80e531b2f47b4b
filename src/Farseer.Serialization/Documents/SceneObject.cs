using System;
using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>An object of a document while it is read: each member is taken once, and in the end none must be left.</summary>
internal sealed class SceneObject
{
    private readonly Dictionary<string, SceneNode> _members;

    public SceneObject(SceneNode node)
    {
        Node = node;
        _members = node.Members();
    }

    public SceneNode Node { get; }

    /// <summary>A member that may be missing, and is if it is null.</summary>
    public bool TryTake(string name, out SceneNode value)
    {
        bool isThere = _members.TryGetValue(name, out value);
        _members.Remove(name);
        return isThere && !value.IsNull;
    }

    public SceneNode Take(string name) => TryTake(name, out SceneNode value) ? value : throw Node.Error("needs the member " + name);

    /// <summary>Those of an array that may be missing.</summary>
    public List<SceneNode> TakeItems(string name) => TryTake(name, out SceneNode value) ? value.Items() : new List<SceneNode>();

    /// <summary>A number that is taken later.</summary>
    public double Look(string name, double without) =>
        _members.TryGetValue(name, out SceneNode value) && !value.IsNull ? value.Finite() : without;

    public void Finish()
    {
        foreach (SceneNode left in _members.Values)
        {
            throw left.Error("is unknown");
        }
    }

    /// <summary>Does what may refuse a value, and says where the value stands if it does.</summary>
    public static void Try<T, TValue>(SceneNode node, T item, TValue value, Action<T, TValue> act)
    {
        try
        {
            act(item, value);
        }
        catch (Exception exception) when (exception is ArgumentException or InvalidOperationException or OverflowException)
        {
            throw node.Error("cannot be used: " + FirstLine(exception.Message), exception);
        }
    }

    public static string FirstLine(string text)
    {
        int end = text.IndexOfAny(['\r', '\n']);
        return end < 0 ? text : text.Substring(0, end);
    }
}
