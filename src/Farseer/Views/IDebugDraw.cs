using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Views;

/// <summary>
/// What a <see cref="PhysicsSimulatorView"/> draws with: implement it over the graphics of your game. All points are in the world; later
/// calls cover earlier ones.
/// </summary>
/// <example>
/// <code>
/// var view = new PhysicsSimulatorView(simulator, draw);
/// view.Draw();
/// </code>
/// </example>
public interface IDebugDraw
{
    /// <summary>Draws a line.</summary>
    /// <param name="start">One end.</param>
    /// <param name="end">The other end.</param>
    /// <param name="color">Its colour.</param>
    void DrawLine(Vector2 start, Vector2 end, DebugColor color);

    /// <summary>Draws an outline and what is inside it.</summary>
    /// <param name="vertices">The corners; the last is joined to the first. The list is used again after the call.</param>
    /// <param name="line">Colour of the outline.</param>
    /// <param name="fill">Colour of the inside; its opacity may be 0.</param>
    void DrawPolygon(Vertices vertices, DebugColor line, DebugColor fill);

    /// <summary>Draws a circle and what is inside it.</summary>
    /// <param name="center">Its centre.</param>
    /// <param name="radius">Its radius, a length of the world.</param>
    /// <param name="line">Colour of the outline.</param>
    /// <param name="fill">Colour of the inside; its opacity may be 0.</param>
    void DrawCircle(Vector2 center, float radius, DebugColor line, DebugColor fill);

    /// <summary>Draws a mark whose size on the screen does not depend on the scale.</summary>
    /// <param name="position">The position, in world coordinates.</param>
    /// <param name="size">Its diameter in pixels.</param>
    /// <param name="color">Its colour.</param>
    void DrawPoint(Vector2 position, float size, DebugColor color);
}
