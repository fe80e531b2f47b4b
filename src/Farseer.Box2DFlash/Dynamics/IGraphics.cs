namespace Box2D.Dynamics;

/// <summary>
/// What <see cref="b2DebugDraw"/> draws on: the calls that it makes on the graphics of a sprite in ActionScript. Write one for your
/// screen, or derive from <see cref="b2DebugDraw"/> instead.
/// </summary>
/// <example>
/// <code>
/// IGraphics screen = draw.m_sprite;
/// screen.lineStyle(1, 0xFF0000, 1);
/// screen.moveTo(10, 20);
/// screen.lineTo(30, 40);
/// </code>
/// </example>
public interface IGraphics
{
    /// <summary>How lines are drawn from now on.</summary>
    /// <param name="thickness">Thickness, pixels.</param>
    /// <param name="color">0xRRGGBB.</param>
    /// <param name="alpha">Opacity, 0 to 1.</param>
    void lineStyle(float thickness, uint color, float alpha);

    /// <summary>Moves the pen without drawing.</summary>
    /// <param name="x">Pixels.</param>
    /// <param name="y">Pixels.</param>
    void moveTo(float x, float y);

    /// <summary>Draws a line.</summary>
    /// <param name="x">Pixels.</param>
    /// <param name="y">Pixels.</param>
    void lineTo(float x, float y);

    /// <summary>Fills what is drawn until <see cref="endFill"/>.</summary>
    /// <param name="color">0xRRGGBB.</param>
    /// <param name="alpha">Opacity, 0 to 1.</param>
    void beginFill(uint color, float alpha);

    /// <summary>Ends the filling.</summary>
    void endFill();

    /// <summary>Draws a circle.</summary>
    /// <param name="x">Centre, pixels.</param>
    /// <param name="y">Centre, pixels.</param>
    /// <param name="radius">Pixels.</param>
    void drawCircle(float x, float y, float radius);

    /// <summary>Clears all that was drawn; called before each drawing.</summary>
    void clear();
}
