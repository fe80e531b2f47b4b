using System;
using System.Collections.Generic;
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

    public void Flag(string name, bool value)
    {
        Name(name);
        Flag(value);
    }

    public void Whole(string name, long value)
    {
        Name(name);
        Whole(value);
    }

    public void Number(string name, float value)
    {
        Name(name);
        Number(value);
    }

    public void Number(string name, double value)
    {
        Name(name);
        Number(value);
    }

    public void Text(string name, string value)
    {
        Name(name);
        Text(value);
    }

    public void Vector(string name, Vector2 value)
    {
        Name(name);
        Vector(value);
    }

    /// <summary>An object as a member.</summary>
    public void Member(string name, Action write)
    {
        Name(name);
        BeginObject();
        write();
        EndObject();
    }

    /// <summary>A list of objects as a member.</summary>
    public void Items<T>(string name, List<T> items, Action<T> write)
    {
        Name(name);
        BeginArray();
        foreach (T item in items)
        {
            BeginObject();
            write(item);
            EndObject();
        }

        EndArray();
    }

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
