using Farseer.Engine.Bodies;
using Farseer.Engine.Queries;

namespace Farseer.Engine.Simulation;

/// <summary>Keeps the queries up to what happens between steps.</summary>
internal sealed partial class World
{
    /// <summary>Rays, boxes, shapes and points against all colliders, at any time.</summary>
    public WorldQueries Queries { get; }

    private void NotePlaced(int body)
    {
        Disturb(body);
        Bodies.Flags[body] |= BodyFlags.Moved;
        NoteAltered(body);
        if (!Queries.IsUsed)
        {
            return;
        }

        for (int collider = _firstCollider[body]; collider >= 0; collider = _nextCollider[collider])
        {
            for (int piece = Shapes.Colliders[collider].FirstPiece; piece >= 0; piece = Shapes.NextPiece[piece])
            {
                Queries.Changed(piece);
            }
        }
    }

    private void ForgetInQueries(int collider)
    {
        for (int piece = Shapes.Colliders[collider].FirstPiece; Queries.IsUsed && piece >= 0; piece = Shapes.NextPiece[piece])
        {
            Queries.Removed(piece);
        }
    }
}
