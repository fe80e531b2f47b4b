using System.Collections.Generic;
using System.Linq;
using System.Text.Json.Nodes;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Farseer.Fidelity.Building;

namespace Farseer.Fidelity.Flash;

/// <summary>Draws a scene and writes the calls down.</summary>
internal static class FlashDrawing
{
    public static JsonNode? Of(FlashScene scene, IEnumerable<string> flags) => throw new MissingPartException("b2DebugDraw");
}
