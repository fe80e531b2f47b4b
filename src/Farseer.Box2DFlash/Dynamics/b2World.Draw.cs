namespace Box2D.Dynamics;

/// <content>Debug drawing.</content>
public partial class b2World
{
    private void DrawDebugData()
    {
    }
}
