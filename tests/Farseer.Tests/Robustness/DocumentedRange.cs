using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Xml.Linq;
using FarseerGames.FarseerPhysics;

namespace Farseer.Tests.Robustness;

/// <summary>
/// What the documentation says about the range of a number, and values just outside of it: the words "above 0", "at least n",
/// "n or more" and "from n to m" are promises.
/// </summary>
internal static class DocumentedRange
{
    private static readonly Lazy<Dictionary<string, XElement>> _members = new Lazy<Dictionary<string, XElement>>(Read);

    public static IEnumerable<object> Outside(Door door)
    {
        if (door.Type != typeof(float) && door.Type != typeof(int))
        {
            yield break;
        }

        string words = Words(door);
        if (words.Contains("above 0", StringComparison.Ordinal))
        {
            yield return Number(door, 0);
            yield return Number(door, -1);
        }
        else if (words.Contains("at least 0", StringComparison.Ordinal) || words.Contains("0 or more", StringComparison.Ordinal))
        {
            yield return Number(door, -1);
        }
        else if (words.Contains("at least 1", StringComparison.Ordinal))
        {
            yield return Number(door, 0);
        }
        else if (words.Contains("from 3 to 65536", StringComparison.Ordinal))
        {
            yield return Number(door, 2);
            yield return Number(door, 65537);
            yield return Number(door, int.MaxValue);
        }
    }

    private static object Number(Door door, int value) => Convert.ChangeType(value, door.Type);

    private static string Words(Door door)
    {
        if (!_members.Value.TryGetValue(Id(door), out XElement? member))
        {
            return "";
        }

        XElement? words = door.IsSetter
            ? member.Element("summary")
            : member.Elements("param").FirstOrDefault(p => (string?)p.Attribute("name") == door.Name);
        return words is null ? "" : string.Join(" ", words.Value.Split(default(char[]), StringSplitOptions.RemoveEmptyEntries));
    }

    private static string Id(Door door)
    {
        Type type = door.Member.DeclaringType!;
        string owner = (type.IsGenericType ? type.GetGenericTypeDefinition() : type).FullName!;
        if (door.IsSetter)
        {
            return "P:" + owner + "." + door.Name;
        }

        string name = door.Member.IsConstructor ? "#ctor" : door.Member.Name;
        return "M:" + owner + "." + name + "("
            + string.Join(",", door.Member.GetParameters().Select(p => p.ParameterType.FullName!.Replace('&', '@'))) + ")";
    }

    private static Dictionary<string, XElement> Read() =>
        XDocument.Load(
            Path.Combine(AppContext.BaseDirectory, Path.ChangeExtension(typeof(PhysicsSimulator).Assembly.GetName().Name, ".xml")!))
            .Descendants("member")
            .ToDictionary(m => (string)m.Attribute("name")!);
}
