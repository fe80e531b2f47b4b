using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using FarseerGames.FarseerPhysics.Collisions;

namespace Farseer.Tests.Api;

/// <summary>One row of tests/data/farseer-2.0.1.tsv.</summary>
public sealed record ApiRow(string Namespace, string Type, string Kind, string Member, string Signature, string Value)
{
    public string Key => $"{Type}: {Signature}";

    public static IReadOnlyList<ApiRow> All() => TestData.Read("farseer-2.0.1.tsv")
        .Split('\n')
        .Skip(1)
        .Select(line => line.TrimEnd('\r').Split('\t'))
        .Where(cells => cells.Length >= 7)
        .Select(cells => new ApiRow(cells[0], cells[1], cells[2], cells[3], cells[4], cells[6]))
        .ToArray();
}

/// <summary>Reads the public members of the library by reflection and writes them as the table does.</summary>
internal static class PublicSurface
{
    private const BindingFlags Every =
        BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.FlattenHierarchy;

    private static readonly Dictionary<Type, string> _keywords = new()
    {
        [typeof(void)] = "void",
        [typeof(bool)] = "bool",
        [typeof(byte)] = "byte",
        [typeof(int)] = "int",
        [typeof(uint)] = "uint",
        [typeof(long)] = "long",
        [typeof(float)] = "float",
        [typeof(double)] = "double",
        [typeof(string)] = "string",
        [typeof(object)] = "object",
        [typeof(System.Numerics.Matrix4x4)] = "Matrix",
    };

    private static readonly Dictionary<string, Type> _types = typeof(Vertices).Assembly.GetExportedTypes()
        .ToDictionary(type => type.Namespace + "|" + Name(type), StringComparer.Ordinal);

    /// <summary>Null if the library has what the row says; otherwise what is wrong.</summary>
    public static string? Fault(ApiRow row)
    {
        // A delegate's row names the delegate itself.
        if (!_types.TryGetValue(row.Namespace + "|" + row.Type, out var type))
        {
            return "type is missing";
        }

        return row.Kind switch
        {
            "class" or "struct" or "interface" or "enum" => KindFault(row, type),
            "enum value" => Enum.IsDefined(type, row.Member)
                && Convert.ToInt64(Enum.Parse(type, row.Member), null).ToString(System.Globalization.CultureInfo.InvariantCulture)
                == row.Value ? null : $"value is missing or not {row.Value}",
            "delegate" => Any(new[] { Delegate(type) }, row),
            "constructor" => Any(type.GetConstructors(Every).Where(Visible).Select(c => $"{ShortName(type)}({Parameters(c)})"), row),
            "method" or "operator" => Any(type.GetMethods(Every).Where(Visible).Select(Method), row),
            "property" or "field" => Any(Variables(type), Plain(row)),
            "indexer" => Any(type.GetProperties(Every).Select(Indexer), row),
            "event" => Any(Variables(type).Concat(type.GetEvents(Every).Select(e => $"event {Name(e.EventHandlerType!)} {e.Name}")), row),
            _ => $"kind {row.Kind} is not known to the test",
        };
    }

    private static string? KindFault(ApiRow row, Type type)
    {
        var kind = type.IsEnum ? "enum" : type.IsValueType ? "struct" : type.IsInterface ? "interface" : "class";
        if (kind != row.Kind)
        {
            return $"is a {kind}";
        }

        var bases = row.Signature.Split(" : ");
        if (bases.Length < 2)
        {
            return null;
        }

        var has = type.GetInterfaces().Select(Name).ToHashSet(StringComparer.Ordinal);
        for (var parent = type.BaseType; parent != null; parent = parent.BaseType)
        {
            has.Add(Name(parent));
        }

        var lacks = Regex.Split(bases[1], ", (?![^<]*>)").Where(name => !has.Contains(name)).ToArray();
        return lacks.Length == 0 ? null : "is not a " + string.Join(", ", lacks);
    }

    private static string? Any(IEnumerable<string> candidates, ApiRow row)
    {
        // Whether a member overrides one of a base class is not part of how it is used; that it can be overridden is not compared.
        var wanted = Bare(row.Signature);
        var all = candidates.Select(Bare).ToArray();
        if (all.Contains(wanted))
        {
            return null;
        }

        var name = Regex.Match(wanted, @"(\w+)(\(| \{|$)").Groups[1].Value;
        var near = all.Where(other => Regex.IsMatch(other, $@"\b{Regex.Escape(name)}(\(| \{{|$)")).ToArray();
        return near.Length == 0 ? "is missing" : "differs: " + string.Join(" | ", near);
    }

    private static string Bare(string signature) =>
        Regex.Replace(signature, @"^((virtual|abstract|override|sealed|readonly) )+", string.Empty)
            .Replace("protected set;", "set;", StringComparison.Ordinal);

    /// <summary>A field may have become a property and the other way round; what counts is that the same uses compile.</summary>
    private static ApiRow Plain(ApiRow row) => row.Kind == "property" || row.Signature.StartsWith("const ", StringComparison.Ordinal)
        ? row
        : row with { Signature = row.Signature + " { get; set; }" };

    private static IEnumerable<string> Variables(Type type)
    {
        foreach (var field in type.GetFields(Every).Where(f => f.IsPublic || f.IsFamily))
        {
            var shared = field.IsStatic ? "static " : string.Empty;
            yield return field.IsLiteral
                ? $"const {Name(field.FieldType)} {field.Name}"
                : $"{shared}{Name(field.FieldType)} {field.Name} {{ get; set; }}";
            yield return $"{shared}{Name(field.FieldType)} {field.Name} {{ get; }}";
        }

        // An event takes and gives up handlers just as a public field of the delegate's type does.
        foreach (var item in type.GetEvents(Every))
        {
            yield return $"{Name(item.EventHandlerType!)} {item.Name} {{ get; set; }}";
        }

        foreach (var property in type.GetProperties(Every).Where(p => p.GetIndexParameters().Length == 0))
        {
            var getter = property.GetMethod is { } get && Visible(get) ? get : null;
            var setter = property.SetMethod is { } set && Visible(set) ? set : null;
            var shared = (getter ?? setter)?.IsStatic == true ? "static " : string.Empty;
            var head = $"{shared}{Name(property.PropertyType)} {property.Name} ";
            var isSettable = setter != null || property.PropertyType.IsByRef;
            if (getter != null)
            {
                yield return head + "{ get; }";
            }

            if (getter != null && isSettable)
            {
                yield return head + "{ get; set; }";
            }

            if (setter != null)
            {
                yield return head + "{ set; }";
            }
        }
    }

    private static string Indexer(PropertyInfo property)
    {
        var parameters = string.Join(", ", property.GetIndexParameters().Select(Parameter));
        var set = property.SetMethod is { } setter && Visible(setter) ? " set;" : string.Empty;
        return $"{Name(property.PropertyType)} this[{parameters}] {{ get;{set} }}";
    }

    private static string Method(MethodInfo method)
    {
        var shared = method.IsStatic ? "static " : string.Empty;
        var generic = method.IsGenericMethod
            ? "<" + string.Join(", ", method.GetGenericArguments().Select(Name)) + ">"
            : string.Empty;
        return $"{shared}{Name(method.ReturnType)} {method.Name}{generic}({Parameters(method)})";
    }

    private static string Delegate(Type type)
    {
        var invoke = type.GetMethod("Invoke");
        return invoke is null
            ? string.Empty
            : $"delegate {Name(invoke.ReturnType)} {ShortName(type)}({Parameters(invoke)})";
    }

    private static string Parameters(MethodBase method) => string.Join(", ", method.GetParameters().Select(Parameter));

    private static string Parameter(ParameterInfo parameter)
    {
        var prefix = parameter.IsOut ? "out "
            : parameter.ParameterType.IsByRef ? "ref "
            : parameter.IsDefined(typeof(ParamArrayAttribute), false) ? "params "
            : string.Empty;
        return $"{prefix}{Name(parameter.ParameterType)} {parameter.Name}";
    }

    private static bool Visible(MethodBase method) => method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly;

    private static string Name(Type type)
    {
        if (type.IsByRef)
        {
            return Name(type.GetElementType()!);
        }

        if (type.IsArray)
        {
            return Name(type.GetElementType()!) + "[" + new string(',', type.GetArrayRank() - 1) + "]";
        }

        if (_keywords.TryGetValue(type, out var keyword))
        {
            return keyword;
        }

        var name = ShortName(type);
        if (type.IsGenericType)
        {
            name += "<" + string.Join(", ", type.GetGenericArguments().Select(Name)) + ">";
        }

        return type.IsNested && !type.IsGenericParameter ? Name(type.DeclaringType!) + "." + name : name;
    }

    private static string ShortName(Type type)
    {
        var tick = type.Name.IndexOf('`', StringComparison.Ordinal);
        return tick < 0 ? type.Name : type.Name[..tick];
    }
}
