using Farseer.Engine.Numerics;

namespace Box2D.Bridge;

/// <summary>Forces and torques of joints as the public types give them: those beyond a float are the largest one.</summary>
internal static class Reactions
{
    public static float Of(double force) => FloatBits.Nearest(force);
}
