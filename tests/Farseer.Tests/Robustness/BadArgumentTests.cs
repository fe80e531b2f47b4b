using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;
using System.Reflection;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>
/// Every argument of every public member, found by reflection so that new members are tried too: a bad value is refused by name,
/// nothing has changed afterwards, and the simulation goes on to the same bit.
/// </summary>
public class BadArgumentTests
{
    private static readonly Lazy<ulong> _undisturbed = new Lazy<ulong>(() => new Bench().HashLater());

    public static TheoryData<string> Types() =>
        new TheoryData<string>(Door.All.Select(d => d.TypeName).Distinct());

    [Theory]
    [MemberData(nameof(Types))]
    public void BadValue_IsRefusedByNameAndValue_AndNothingChanges(string type)
    {
        var faults = new List<string>();
        foreach (Door door in Door.All.Where(d => d.TypeName == type && !OpenDoors.Contains(d)))
        {
            foreach (object? bad in door.BadValues())
            {
                string? fault = Refuses(door, bad);
                if (fault is not null)
                {
                    faults.Add(door + " = " + Shown(bad) + ": " + fault);
                }
            }
        }

        Assert.True(faults.Count == 0, string.Join(Environment.NewLine, faults));
    }

    [Theory]
    [MemberData(nameof(Types))]
    public void OpenDoor_TakesAnyValue_AndTheWorldStaysSound(string type)
    {
        foreach (Door door in Door.All.Where(d => d.TypeName == type && OpenDoors.Contains(d)))
        {
            foreach (object? value in door.BadValues())
            {
                var bench = new Bench();
                object? target = door.Member is ConstructorInfo ? null : bench.Target(door.Member.DeclaringType!);
                Exception? thrown = door.Call(target, door.Arguments(bench, value));
                Assert.True(thrown is null or ArgumentException, door + " = " + Shown(value) + ": " + thrown);
                bench.HashLater();
                bench.AssertSound();
            }
        }
    }

    [Fact]
    public void EveryOpenDoor_Exists()
    {
        string[] stale = OpenDoors.Reasons.Keys.Where(p => !Door.All.Any(d => OpenDoors.Fits(p, d.Key))).ToArray();
        Assert.Empty(stale);
    }

    [Fact]
    public void DocumentedRange_IsKept()
    {
        var faults = new List<string>();
        int tried = 0;
        foreach (Door door in Door.All.Where(d => !OpenDoors.Contains(d)))
        {
            foreach (object bad in DocumentedRange.Outside(door))
            {
                tried++;
                string? fault = Refuses(door, bad);
                if (fault is not null)
                {
                    faults.Add(door + " = " + Shown(bad) + ": " + fault);
                }
            }
        }

        Assert.True(faults.Count == 0, string.Join(Environment.NewLine, faults));
        Assert.True(tried > 150, "only " + tried + " ranges were found in the documentation");
    }

    /// <summary>Null if the bad value is refused as it should be.</summary>
    private static string? Refuses(Door door, object? bad)
    {
        var bench = new Bench();
        object? target = door.Member is ConstructorInfo ? null : bench.Target(door.Member.DeclaringType!);
        object?[] arguments = door.Arguments(bench, bad);
        object?[] watched = arguments.Append(target).Append(bench.Box).Append(bench.BoxGeom).Append(bench.Simulator).ToArray();
        string before = Picture(watched);
        Exception? thrown = door.Call(target, arguments);
        if (thrown is not ArgumentException refusal)
        {
            return thrown is null ? "was taken" : "threw " + thrown.GetType().Name + ": " + thrown.Message;
        }

        // A property is named by itself, not by the "value" of its setter; an accessor may share the checks of another.
        if (!refusal.Message.Contains(door.Name, StringComparison.Ordinal))
        {
            return "does not name it: " + refusal.Message;
        }

        if (bad is not null and not IEnumerable && !refusal.Message.Contains(Mark(bad), StringComparison.Ordinal))
        {
            return "does not tell the value: " + refusal.Message;
        }

        string after = Picture(watched);
        if (after != before)
        {
            return "changed something: " + before + " to " + after;
        }

        return bench.HashLater() == _undisturbed.Value ? null : "changed what follows";
    }

    /// <summary>The part of a bad value that a message must show.</summary>
    private static string Mark(object bad)
    {
        string text = Convert.ToString(bad, CultureInfo.InvariantCulture)!;
        return bad is Vector2 or Matrix4x4 ? text.Contains("NaN", StringComparison.Ordinal) ? "NaN" : "Infinity" : text;
    }

    private static string Shown(object? value) =>
        value is ICollection list ? list.Count + " items" : Convert.ToString(value, CultureInfo.InvariantCulture) ?? "null";

    /// <summary>All that can be read of some objects, as a text.</summary>
    private static string Picture(IEnumerable<object?> objects)
    {
        var parts = new List<string>();
        foreach (object? item in objects)
        {
            if (item is null || item.GetType().IsPrimitive)
            {
                continue;
            }

            foreach (PropertyInfo property in item.GetType().GetProperties(BindingFlags.Public | BindingFlags.Instance))
            {
                if (property.GetIndexParameters().Length == 0 && property.Name is not ("Grid" or "WorldVertices"))
                {
                    Type type = property.PropertyType.IsByRef ? property.PropertyType.GetElementType()! : property.PropertyType;
                    parts.Add(property.Name + "=" + (type.IsValueType ? property.GetValue(item) : property.GetValue(item)?.GetHashCode()));
                }
            }

            if (item is IEnumerable<Vector2> points)
            {
                parts.Add(string.Join(" ", points));
            }

            if (item is Body body)
            {
                parts.Add(body.GeomCount + " geoms");
            }
        }

        return string.Join("; ", parts);
    }
}
