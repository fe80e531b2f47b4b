using System;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>A function of one number that goes through keys, smoothly (cubic Hermite) or in steps.</summary>
/// <example>
/// <code>
/// var path = new Curve();
/// path.Keys.Add(new CurveKey(0, 0));
/// path.Keys.Add(new CurveKey(2, 5));
/// float height = path.Evaluate(1);
/// </code>
/// </example>
public class Curve
{
    private CurveLoopType _preLoop;
    private CurveLoopType _postLoop;

    /// <summary>Makes a curve without keys, whose value is 0 everywhere.</summary>
    public Curve()
    {
    }

    /// <summary>True if the curve has at most one key.</summary>
    public bool IsConstant => Keys.Count <= 1;

    /// <summary>The keys.</summary>
    public CurveKeyCollection Keys { get; private set; } = new CurveKeyCollection();

    /// <summary>How the curve continues before the first key. Default <see cref="CurveLoopType.Constant"/>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not a member of its enum.</exception>
    public CurveLoopType PreLoop
    {
        get => _preLoop;
        set => _preLoop = Known(value, nameof(PreLoop));
    }

    /// <summary>How the curve continues after the last key. Default <see cref="CurveLoopType.Constant"/>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not a member of its enum.</exception>
    public CurveLoopType PostLoop
    {
        get => _postLoop;
        set => _postLoop = Known(value, nameof(PostLoop));
    }

    /// <summary>Makes an equal curve with keys of its own.</summary>
    /// <returns>The new curve.</returns>
    public Curve Clone() => new Curve { PreLoop = _preLoop, PostLoop = _postLoop, Keys = Keys.Clone() };

    /// <summary>The value of the curve.</summary>
    /// <param name="position">The position on the curve; finite.</param>
    /// <returns>The value.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="position"/> is not finite.</exception>
    public float Evaluate(float position)
    {
        Require.Finite(position, nameof(position));
        if (Keys.Count == 0)
        {
            return 0;
        }

        CurveKey first = Keys[0];
        CurveKey last = Keys[Keys.Count - 1];
        if (position < first.Position)
        {
            return Keys.Count > 1 && _preLoop == CurveLoopType.Linear
                ? first.Value - (first.TangentIn * (first.Position - position))
                : Outside(position, _preLoop, first, last, first.Value);
        }

        if (position > last.Position)
        {
            return Keys.Count > 1 && _postLoop == CurveLoopType.Linear
                ? last.Value - (last.TangentOut * (last.Position - position))
                : Outside(position, _postLoop, first, last, last.Value);
        }

        return Between(position);
    }

    /// <summary>Works out both tangents of a key.</summary>
    /// <param name="keyIndex">Number of the key.</param>
    /// <param name="tangentType">The kind of tangent.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such key, or the kind is not a member of its enum.</exception>
    public void ComputeTangent(int keyIndex, CurveTangent tangentType)
    {
        Require.Within(keyIndex, 0, Keys.Count - 1, nameof(keyIndex));
        Known(tangentType, nameof(tangentType));
        ComputeTangent(keyIndex, tangentType, tangentType);
    }

    /// <summary>
    /// Works out the tangents of a key. The ends of the curve have only one neighbour: the missing one is the key itself.
    /// </summary>
    /// <param name="keyIndex">Number of the key.</param>
    /// <param name="tangentInType">The kind of tangent towards it.</param>
    /// <param name="tangentOutType">The kind of tangent away from it.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such key, or a kind is not a member of its enum.</exception>
    public void ComputeTangent(int keyIndex, CurveTangent tangentInType, CurveTangent tangentOutType)
    {
        Require.Within(keyIndex, 0, Keys.Count - 1, nameof(keyIndex));
        Known(tangentInType, nameof(tangentInType));
        Known(tangentOutType, nameof(tangentOutType));
        CurveKey key = Keys[keyIndex];
        CurveKey before = Keys[Math.Max(0, keyIndex - 1)];
        CurveKey after = Keys[Math.Min(Keys.Count - 1, keyIndex + 1)];
        key.TangentIn = Tangent(tangentInType, key.Value - before.Value, key.Position - before.Position, before, after);
        key.TangentOut = Tangent(tangentOutType, after.Value - key.Value, after.Position - key.Position, before, after);
    }

    /// <summary>Works out the tangents of all keys.</summary>
    /// <param name="tangentType">The kind of tangent.</param>
    /// <exception cref="ArgumentOutOfRangeException">The kind is not a member of its enum.</exception>
    public void ComputeTangents(CurveTangent tangentType)
    {
        Known(tangentType, nameof(tangentType));
        ComputeTangents(tangentType, tangentType);
    }

    /// <summary>Works out the tangents of all keys.</summary>
    /// <param name="tangentInType">The kind of tangents towards the keys.</param>
    /// <param name="tangentOutType">The kind of tangents away from the keys.</param>
    /// <exception cref="ArgumentOutOfRangeException">A kind is not a member of its enum.</exception>
    public void ComputeTangents(CurveTangent tangentInType, CurveTangent tangentOutType)
    {
        Known(tangentInType, nameof(tangentInType));
        Known(tangentOutType, nameof(tangentOutType));
        for (int i = 0; i < Keys.Count; i++)
        {
            ComputeTangent(i, tangentInType, tangentOutType);
        }
    }

    private static float Tangent(CurveTangent type, float rise, float run, CurveKey before, CurveKey after)
    {
        if (type == CurveTangent.Linear)
        {
            return rise;
        }

        float span = after.Position - before.Position;
        return type == CurveTangent.Smooth && span > 0 ? (after.Value - before.Value) * (run / span) : 0;
    }

    private float Outside(float position, CurveLoopType loop, CurveKey first, CurveKey last, float constant)
    {
        float length = last.Position - first.Position;
        if (loop is CurveLoopType.Constant or CurveLoopType.Linear || !(length > 0))
        {
            return constant;
        }

        float cycle = (float)Math.Floor((position - first.Position) / length);
        float within = Math.Min(Math.Max(position - (cycle * length), first.Position), last.Position);
        switch (loop)
        {
            case CurveLoopType.CycleOffset:
                return Between(within) + (cycle * (last.Value - first.Value));
            case CurveLoopType.Oscillate when cycle % 2 != 0:
                return Between(Math.Min(Math.Max(last.Position + first.Position - within, first.Position), last.Position));
            default:
                return Between(within);
        }
    }

    private float Between(float position)
    {
        int next = 1;
        while (next < Keys.Count && Keys[next].Position <= position)
        {
            next++;
        }

        CurveKey a = Keys[next - 1];
        if (next == Keys.Count || a.Continuity == CurveContinuity.Step)
        {
            return a.Value;
        }

        CurveKey b = Keys[next];
        float t = (position - a.Position) / (b.Position - a.Position);
        float t2 = t * t;
        float t3 = t2 * t;
        return (a.Value * ((2 * t3) - (3 * t2) + 1)) + (a.TangentOut * (t3 - (2 * t2) + t))
            + (b.Value * ((3 * t2) - (2 * t3))) + (b.TangentIn * (t3 - t2));
    }

    private static CurveLoopType Known(CurveLoopType value, string name) =>
        value >= CurveLoopType.Constant && value <= CurveLoopType.Linear
            ? value
            : throw Require.Range(name, value, "must be a member of CurveLoopType");

    private static void Known(CurveTangent value, string name)
    {
        if (value < CurveTangent.Flat || value > CurveTangent.Smooth)
        {
            throw Require.Range(name, value, "must be a member of CurveTangent");
        }
    }
}
