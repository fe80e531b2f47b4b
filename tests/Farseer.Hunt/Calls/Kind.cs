using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;

namespace Farseer.Hunt.Calls;

/// <summary>A kind of argument: how one is chosen, written, read, made simpler and given to a member.</summary>
internal abstract class Kind
{
    /// <returns>A value, or null if there is none, as of an item that was never made.</returns>
    public abstract object? Draw(Decoder decoder);

    /// <summary>The value as C#.</summary>
    public abstract string Code(object value, Func<int, string> name);

    /// <summary>The value without blanks, to be read again.</summary>
    public virtual string Token(object value) => Convert.ToString(value, CultureInfo.InvariantCulture)!;

    public abstract object Read(string token);

    /// <summary>What a member is called with.</summary>
    public virtual object? Live(object value, Func<int, object?> item) => value;

    public virtual IEnumerable<object> Simpler(object value) => Array.Empty<object>();

    public static string Digits(float value) => float.IsNaN(value) ? "float.NaN"
        : float.IsInfinity(value) ? value > 0 ? "float.PositiveInfinity" : "float.NegativeInfinity"
        : value.ToString("r", CultureInfo.InvariantCulture) + "f";

    protected static IEnumerable<float> Simpler(float value)
    {
        if (value == 0)
        {
            yield break;
        }

        foreach (float simple in new[] { 0, 1, -1, MathF.Round(value), Choices.Rounded(MathF.Round(value, 1)) })
        {
            if (float.IsFinite(value) && simple != value && MathF.Abs(simple) <= MathF.Max(1, MathF.Abs(value)))
            {
                yield return simple;
            }
        }
    }

    protected static float Number(string token) => float.Parse(token, CultureInfo.InvariantCulture);

    protected static Vector2 Point(string token)
    {
        string[] parts = token.Split(',');
        return new Vector2(Number(parts[0]), Number(parts[1]));
    }

    protected static string Token(Vector2 point) => string.Create(CultureInfo.InvariantCulture, $"{point.X:r},{point.Y:r}");
}

internal sealed class NumberKind(Span span, bool isDouble = false) : Kind
{
    public override object Draw(Decoder decoder) => span.Draw(decoder);

    public override string Code(object value, Func<int, string> name) => Digits((float)value);

    public override string Token(object value) => ((float)value).ToString("r", CultureInfo.InvariantCulture);

    public override object Read(string token) => Number(token);

    public override object Live(object value, Func<int, object?> item) => isDouble ? (double)(float)value : value;

    public override IEnumerable<object> Simpler(object value) => Simpler((float)value).Cast<object>();
}

/// <summary>Seconds of a step: ordinary worlds too see very short and very long ones, and changes between them.</summary>
internal sealed class TimeKind : Kind
{
    public override object Draw(Decoder decoder) => decoder.Choices.Below(16) switch
    {
        0 => decoder.Choices.Between(1e-6f, 0.02f),
        1 => 0.1f,
        2 => decoder.Choices.Between(0.03f, decoder.Profile < Profile.Ordinary ? 0.1f : 0.5f),
        3 or 4 => 1 / 30f,
        _ => 1 / 60f,
    };

    public override string Code(object value, Func<int, string> name) => Digits((float)value);

    public override string Token(object value) => ((float)value).ToString("r", CultureInfo.InvariantCulture);

    public override object Read(string token) => Number(token);

    public override IEnumerable<object> Simpler(object value) => (float)value == 1 / 60f ? Array.Empty<object>()
        : new object[] { 1 / 60f };
}

internal sealed class IntegerKind(int low, int high, int least, int most, Type? type = null) : Kind
{
    public override object Draw(Decoder decoder) => decoder.Profile == Profile.Extreme && decoder.Choices.OneIn(4)
        ? least + decoder.Choices.Below(most - least + 1)
        : low + decoder.Choices.Below(high - low + 1);

    public override string Code(object value, Func<int, string> name) =>
        type == typeof(uint) ? unchecked((uint)(int)value).ToString(CultureInfo.InvariantCulture) + "u" : Token(value);

    public override object Read(string token) => int.Parse(token, CultureInfo.InvariantCulture);

    public override object Live(object value, Func<int, object?> item) =>
        type == typeof(uint)
            ? unchecked((uint)(int)value)
            : type == typeof(byte) ? (byte)(int)value : type == typeof(long) ? (long)(int)value : value;

    public override IEnumerable<object> Simpler(object value)
    {
        int number = (int)value;
        return new[] { 1, low, number / 2, number - 1 }.Where(n => n >= Math.Min(1, least) && n < number).Distinct().Cast<object>();
    }
}

internal sealed class FlagKind : Kind
{
    public override object Draw(Decoder decoder) => decoder.Choices.Flag();

    public override string Code(object value, Func<int, string> name) => (bool)value ? "true" : "false";

    public override object Read(string token) => bool.Parse(token);
}

/// <summary>One of the values of an enumeration, or any of their unions if they are flags.</summary>
internal sealed class ChoiceKind(Type type) : Kind
{
    private readonly long[] _values = Enum.GetValues(type).Cast<object>().Select(v => Convert.ToInt64(v,
        CultureInfo.InvariantCulture)).Distinct().ToArray();

    public override object Draw(Decoder decoder)
    {
        long value = _values[decoder.Choices.Below(_values.Length)];
        return type.IsDefined(typeof(FlagsAttribute), false) && decoder.Choices.Flag()
            ? value | _values[decoder.Choices.Below(_values.Length)] : value;
    }

    public override string Code(object value, Func<int, string> name)
        => $"({Member.NameOf(type)}){((long)value < 0 ? $"({value})" : value)}";

    public override object Read(string token) => long.Parse(token, CultureInfo.InvariantCulture);

    public override object Live(object value, Func<int, object?> item) => Enum.ToObject(type, (long)value);

    public override IEnumerable<object> Simpler(object value) => (long)value == 0 ? Array.Empty<object>() : new object[] { 0L };
}

/// <summary>
/// A place, velocity, force or direction; <paramref name="make"/> turns it into the facade's own vector, <paramref name="type"/>.
/// </summary>
internal sealed class PointKind(Span span, string type = "Vector2", Func<Vector2, object>? make = null) : Kind
{
    public override object Draw(Decoder decoder) => new Vector2(span.Draw(decoder), span.Draw(decoder));

    public override string Code(object value, Func<int, string> name)
        => $"new {type}({Digits(((Vector2)value).X)}, {Digits(((Vector2)value).Y)})";

    public override string Token(object value) => Token((Vector2)value);

    public override object Read(string token) => Point(token);

    public override object Live(object value, Func<int, object?> item) => make is null ? value : make((Vector2)value);

    public override IEnumerable<object> Simpler(object value)
    {
        var point = (Vector2)value;
        return Simpler(point.X).Select(x => (object)new Vector2(x, point.Y)).Concat(Simpler(point.Y).Select(y
            => (object)new Vector2(point.X, y)));
    }
}

/// <summary>Vertices: stars, rectangles, lines, and in extreme worlds anything.</summary>
internal sealed class OutlineKind(Span span, Func<string, string> write, Func<Vector2[], object> make) : Kind
{
    public override object Draw(Decoder decoder)
    {
        Choices choices = decoder.Choices;
        float size = MathF.Abs(span.Draw(decoder));
        int count = 3 + choices.Below(6);
        bool isWild = decoder.Profile == Profile.Extreme && choices.OneIn(4);
        bool isRound = choices.Flag();
        return Enumerable.Range(0, count).Select(i =>
        {
            float angle = 2 * MathF.PI * i / count;
            float radius = size * (isRound ? 1 : choices.Between(0.4f, 1));
            return isWild
                ? new Vector2(span.Draw(decoder), span.Draw(decoder))
                : new Vector2(Choices.Rounded(radius * MathF.Cos(angle)), Choices.Rounded(radius * MathF.Sin(angle)));
        }).ToArray();
    }

    public override string Code(object value, Func<int, string> name) =>
        write(string.Join(", ", ((Vector2[])value).Select(p => $"new({Digits(p.X)}, {Digits(p.Y)})")));

    public override string Token(object value) => string.Join(";", ((Vector2[])value).Select(Token));

    public override object Read(string token) => token.Split(';').Select(Point).ToArray();

    public override object Live(object value, Func<int, object?> item) => make((Vector2[])value);

    public override IEnumerable<object> Simpler(object value)
    {
        var points = (Vector2[])value;
        return points.Length <= 3 ? Array.Empty<object>() : Enumerable.Range(0, points.Length).Select(i => (object)points.Where((_, n)
            => n != i).ToArray());
    }
}

/// <summary>Something that an earlier call made. −1 is none.</summary>
internal sealed class ItemKind(Type type, bool isOptional = false) : Kind
{
    public Type Type => type;

    public override object? Draw(Decoder decoder) => isOptional && decoder.Choices.Below(4) != 0 ? -1 : decoder.Pick(type);

    public override string Code(object value, Func<int, string> name) => (int)value < 0 ? "null" : name((int)value);

    public override object Read(string token) => int.Parse(token, CultureInfo.InvariantCulture);

    public override object? Live(object value, Func<int, object?> item) =>
        (int)value < 0 ? null : item((int)value) is { } found && type.IsInstanceOfType(found) ? found : throw new MissingItemException();
}

/// <summary>Always the same, made anew.</summary>
internal sealed class FreshKind(string code, Func<object?> make) : Kind
{
    public override object Draw(Decoder decoder) => 0;

    public override string Code(object value, Func<int, string> name) => code;

    public override object Read(string token) => 0;

    public override object? Live(object value, Func<int, object?> item) => make();
}

/// <summary>The item of a call is not there: its maker was left out, or has refused.</summary>
internal sealed class MissingItemException : Exception
{
}
