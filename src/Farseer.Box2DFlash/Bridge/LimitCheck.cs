using System;

namespace Box2D.Bridge;

/// <summary>Limits must be finite and in order.</summary>
internal static class LimitCheck
{
    public static void Ordered(float lower, float upper, string lowerName, string upperName, bool inUse)
    {
        Require.Finite(lower, lowerName);
        Require.Finite(upper, upperName);
        if (inUse && lower > upper)
        {
            throw new ArgumentOutOfRangeException(lowerName, lower, "The lower limit must not be above the upper one.");
        }
    }
}
