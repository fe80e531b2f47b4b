using Box2D.Bridge;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics;

/// <content>Debug drawing.</content>
public partial class b2World
{
    [NotState(Why.Users)]
    private b2DebugDraw? _debugDraw;

    /// <summary>Registers the drawing that shows the world at the end of each step.</summary>
    /// <param name="debugDraw">The drawing, or null for none.</param>
    public void SetDebugDraw(b2DebugDraw? debugDraw) => _debugDraw = debugDraw;

    /// <summary>Draws the world now, as at the end of a step.</summary>
    public void DrawDebugData()
    {
        if (_debugDraw is not null)
        {
            WorldPainter.Draw(this, _debugDraw, _lower, _upper);
        }
    }
}
