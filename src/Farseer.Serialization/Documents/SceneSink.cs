using System;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>Where a document is written to. Numbers come back bit for bit.</summary>
internal abstract class SceneSink
{
    public abstract void BeginObject();

    public abstract void EndObject();

    public abstract void BeginArray();

    public abstract void EndArray();

    /// <summary>The name of the member that comes next.</summary>
    public abstract void Name(string name);

    public abstract void Null();

    public abstract void Flag(bool value);

    public abstract void Whole(long value);

    public abstract void Number(float value);

    public abstract void Number(double value);

    public abstract void Text(string value);

    public abstract void Bytes(byte[] value);

    public abstract void Numbers(ReadOnlySpan<float> values);

    public abstract void Wholes(ReadOnlySpan<int> values);

    public void Vector(Vector2 value) => Numbers([value.X, value.Y]);

    public void Vectors(ReadOnlySpan<Vector2> values)
    {
        var numbers = new float[2 * values.Length];
        for (int i = 0; i < values.Length; i++)
        {
            numbers[2 * i] = values[i].X;
            numbers[(2 * i) + 1] = values[i].Y;
        }

        Numbers(numbers);
    }
}
