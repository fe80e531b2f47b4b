using System;

namespace Farseer.Rollback;

/// <summary>
/// What a rollback library asks of a game: keep the state of a frame, go back to one, and go on by one frame. A frame is the state
/// before its inputs: frame 0 is the beginning, and <see cref="Advance"/> makes frame n + 1 of frame n.
/// </summary>
internal interface IRollbackGame
{
    /// <summary>Says whether two games are the same.</summary>
    ulong Checksum { get; }

    /// <summary>Keeps the state of now as that frame; it is the next one, or one that is done again.</summary>
    void Save(int frame);

    /// <summary>Goes back to a frame that was saved; those after it are forgotten.</summary>
    void Load(int frame);

    /// <summary>One update with the inputs of all players, by their numbers.</summary>
    void Advance(ReadOnlySpan<PlayerInput> inputs);
}
