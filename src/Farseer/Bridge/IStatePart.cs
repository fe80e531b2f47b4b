using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Somebody whose own state is part of a simulator's, and to whom other parts of it refer.</summary>
internal interface IStatePart
{
    /// <summary>Where it stands among all of them.</summary>
    ref StateMark Mark { get; }
}

/// <summary>
/// Which roster entered somebody last, and as which: so a roster knows at once whom it has, and a reference is told by a number that is the
/// same in every simulation that was made in the same way.
/// </summary>
[NotState(Why.OfOneStep)]
internal struct StateMark
{
    /// <summary>Each roster has another one each time that it is filled; 0: none yet.</summary>
    public long Round;

    /// <summary>1 for the first that was entered.</summary>
    public int Place;

    /// <summary>The last round when something that a state has of the item was set; 0: since it was made nothing was.</summary>
    public long ChangedIn;

    /// <summary>Something that a state has of the item is set: states from before have something else.</summary>
    public void Change() => ChangedIn = StateRoster.LastRound;

    /// <summary>Somebody gets hold of something of the item to set it.</summary>
    /// <returns>What he gets hold of.</returns>
    public T Changed<T>(T what)
    {
        Change();
        return what;
    }

    /// <summary>Sets such a field, and notes it if that changes it.</summary>
    public void Set<T>(ref T field, T value)
    {
        if (!EqualityComparer<T>.Default.Equals(field, value))
        {
            field = value;
            Change();
        }
    }

    /// <summary>The same of a number, also where zero only changes its sign.</summary>
    public void Set(ref float field, float value)
    {
        if (FloatBits.ToInt(field) != FloatBits.ToInt(value))
        {
            field = value;
            Change();
        }
    }

    /// <summary>The same of two numbers.</summary>
    public void Set(ref Vector2 field, Vector2 value)
    {
        Set(ref field.X, value.X);
        Set(ref field.Y, value.Y);
    }
}
