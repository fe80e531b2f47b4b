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
}
