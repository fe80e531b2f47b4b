using System;
using System.Numerics;

namespace FarseerGames.FarseerPhysics;

/// <summary>The checks of arguments at the door; each exception names the argument and the value.</summary>
internal static class Require
{
    public static bool IsFinite(float value) => !float.IsNaN(value) && !float.IsInfinity(value);

    public static bool IsFinite(Vector2 value) => IsFinite(value.X) && IsFinite(value.Y);

    public static float Positive(float value, string name)
    {
        if (!(value > 0f) || float.IsInfinity(value))
        {
            throw new ArgumentOutOfRangeException(name, value, $"{name} must be a finite number above 0.");
        }

        return value;
    }

    public static float NotNegative(float value, string name)
    {
        if (!(value >= 0f) || float.IsInfinity(value))
        {
            throw new ArgumentOutOfRangeException(name, value, $"{name} must be a finite number, 0 or more.");
        }

        return value;
    }

    public static float Finite(float value, string name)
    {
        if (!IsFinite(value))
        {
            throw new ArgumentOutOfRangeException(name, value, $"{name} must be a finite number.");
        }

        return value;
    }

    public static Vector2 Finite(Vector2 value, string name)
    {
        if (!IsFinite(value))
        {
            throw new ArgumentOutOfRangeException(name, value, $"{name} must have finite coordinates.");
        }

        return value;
    }

    public static float NotBelow(float value, float least, string name)
    {
        if (!(value >= least))
        {
            throw new ArgumentOutOfRangeException(name, value, $"{name} must not be below {least}.");
        }

        return value;
    }

    /// <summary>The unit vector of a direction that must have a length.</summary>
    public static Vector2 Direction(Vector2 value, string name)
    {
        var length = value.Length();
        if (!(length > 0f) || !IsFinite(length))
        {
            throw new ArgumentOutOfRangeException(name, value, $"{name} must be finite and not (0, 0).");
        }

        return value / length;
    }

    public static int AtLeast(int value, int least, string name)
    {
        if (value < least)
        {
            throw new ArgumentOutOfRangeException(name, value, $"{name} must be at least {least}.");
        }

        return value;
    }

    public static T NotNull<T>(T? value, string name)
        where T : class =>
        value ?? throw new ArgumentNullException(name);
}
