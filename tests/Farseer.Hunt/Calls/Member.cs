using System;
using System.Collections.Generic;
using System.Linq;
using System.Linq.Expressions;
using System.Reflection;

namespace Farseer.Hunt.Calls;

/// <summary>Something that can be called: a public member of the facade, a step, or what only a handler does.</summary>
internal abstract class Member
{
    /// <summary>Unique, without blanks.</summary>
    public abstract string Key { get; }

    /// <summary>Of the arguments; an instance's member has the instance first.</summary>
    public IReadOnlyList<Kind> Kinds { get; protected init; } = Array.Empty<Kind>();

    /// <summary>What it makes, if later calls may use that.</summary>
    public Type? Result { get; protected init; }

    /// <summary>Of members whose result has a type that an argument tells.</summary>
    public Func<IReadOnlyList<object>, Func<int, Type?>, Type?>? ResultOf { get; init; }

    public abstract object? Invoke(object?[] arguments);

    public abstract string Code(IReadOnlyList<string> arguments);

    public static string NameOf(Type type) => type.IsNested ? NameOf(type.DeclaringType!) + "." + type.Name
        : type == typeof(float) ? "float" : type == typeof(int) ? "int" : type == typeof(bool) ? "bool"
        : type == typeof(long) ? "long" : type.Name;
}

/// <summary>A constructor, method, property that is set, or property that leads to an item.</summary>
internal sealed class MethodMember : Member
{
    private readonly MethodBase _method;
    private readonly int _first;
    private readonly string _owner;
    private readonly string? _singleton;

    /// <param name="method">The member.</param>
    /// <param name="kinds">Of all its parameters that are no results, with the instance first if it has one.</param>
    /// <param name="result">What it makes, if that is an item.</param>
    /// <param name="singleton">C# for an instance that there is once, and that instance.</param>
    public MethodMember(MethodBase method, IReadOnlyList<Kind> kinds, Type? result, (string Code, object Instance)? singleton)
    {
        _method = method;
        _owner = NameOf(method.DeclaringType!);
        _first = method.IsStatic || method.IsConstructor || singleton is not null ? 0 : 1;
        _singleton = singleton?.Code;
        Instance = singleton?.Instance;
        Kinds = kinds;
        Result = result;
    }

    public override string Key => _method.IsConstructor
        ? $"new({string.Join(",", Types())})".Insert(3, _owner)
        : $"{_owner}.{_method.Name}({string.Join(",", Types())})";

    private object? Instance { get; }

    public override object? Invoke(object?[] arguments)
    {
        ParameterInfo[] parameters = _method.GetParameters();
        object?[] given = new object?[parameters.Length];
        int next = _first;
        for (int i = 0; i < parameters.Length; i++)
        {
            given[i] = parameters[i].IsOut ? null : arguments[next++];
        }

        return _method is ConstructorInfo constructor
            ? constructor.Invoke(BindingFlags.DoNotWrapExceptions, null, given, null)
            : _method.Invoke(_first == 1 ? arguments[0] : Instance, BindingFlags.DoNotWrapExceptions, null, given, null);
    }

    public override string Code(IReadOnlyList<string> arguments)
    {
        ParameterInfo[] parameters = _method.GetParameters();
        int next = _first;
        var given = new List<string>();
        foreach (ParameterInfo parameter in parameters)
        {
            given.Add(parameter.IsOut ? "out _" : (parameter.ParameterType.IsByRef ? "ref Ref("
                : "") + arguments[next++] + (parameter.ParameterType.IsByRef ? ")" : ""));
        }

        string list = string.Join(", ", given);
        string target = _singleton ?? (_first == 1 ? arguments[0] : _owner);
        return _method.IsConstructor ? $"new {_owner}({list})"
            : _method.IsSpecialName && _method.Name.StartsWith("set_", StringComparison.Ordinal)
                ? $"{target}.{_method.Name.Substring(4)} = {list}"
            : _method.IsSpecialName && _method.Name.StartsWith("get_", StringComparison.Ordinal) ? $"{target}.{_method.Name.Substring(4)}"
            : $"{target}.{_method.Name}({list})";
    }

    private IEnumerable<string> Types() => _method.GetParameters().Select(p => p.ParameterType.Name.Replace("`1", "",
        StringComparison.Ordinal));
}

/// <summary>Writes to what a property returns by reference, as <c>body.LinearVelocity = v</c>.</summary>
internal sealed class ReferenceMember<TOwner, TValue>(string name) : Member
    where TOwner : class
{
    private readonly Reference _get = typeof(TOwner).GetProperty(name)!.GetMethod!.CreateDelegate<Reference>();

    private delegate ref TValue Reference(TOwner owner);

    public override string Key => $"{NameOf(typeof(TOwner))}.ref_{name}({typeof(TValue).Name})";

    public static ReferenceMember<TOwner, TValue> Of(string name, Kind value) => new(name) { Kinds = new[] { new ItemKind(typeof(TOwner)),
        value } };

    public override object? Invoke(object?[] arguments)
    {
        _get((TOwner)arguments[0]!) = (TValue)arguments[1]!;
        return null;
    }

    public override string Code(IReadOnlyList<string> arguments) => $"{arguments[0]}.{name} = {arguments[1]}";
}

/// <summary>A handler of an event, or of a property that holds one. The calls that it makes are those that follow within.</summary>
internal sealed class HandlerMember : Member
{
    private readonly MemberInfo _member;
    private readonly Type _type;

    public HandlerMember(MemberInfo member, Type type)
    {
        _member = member;
        _type = type;
        Kinds = new Kind[] { new ItemKind(member.DeclaringType!), new IntegerKind(1, 6, 1, 20), new IntegerKind(0, 5, 0, 5) };
    }

    public override string Key => $"{NameOf(_member.DeclaringType!)}.{_member.Name}+";

    public bool ReturnsFlag => _type.GetMethod("Invoke")!.ReturnType == typeof(bool);

    public override object? Invoke(object?[] arguments)
    {
        var handler = (Func<bool>)arguments[3]!;
        MethodInfo invoke = _type.GetMethod("Invoke")!;
        Expression call = Expression.Invoke(Expression.Constant(handler));
        Delegate made = Expression.Lambda(
            _type,
            invoke.ReturnType == typeof(bool) ? call : Expression.Block(typeof(void), call),
            invoke.GetParameters().Select(p => Expression.Parameter(p.ParameterType))).Compile();
        if (_member is EventInfo @event)
        {
            @event.AddMethod!.Invoke(arguments[0], BindingFlags.DoNotWrapExceptions, null, new object[] { made }, null);
        }
        else
        {
            var property = (PropertyInfo)_member;
            property.SetMethod!.Invoke(arguments[0], BindingFlags.DoNotWrapExceptions, null,
                new object?[] { Delegate.Combine((Delegate?)property.GetValue(arguments[0]), made) }, null);
        }

        return null;
    }

    public override string Code(IReadOnlyList<string> arguments) => $"{arguments[0]}.{_member.Name} += delegate";
}

/// <summary>
/// Steps of a world, one after the other: what all invariants are looked at between. Time, their number, and what else a step takes.
/// </summary>
internal sealed class StepMember : Member
{
    private readonly Action<object, float, int> _step;
    private readonly Func<string, string, string, string> _code;

    public StepMember(Type world, Action<object, float, int> step, Func<string, string, string, string> code, params Kind[] more)
    {
        _step = step;
        _code = code;
        Kinds = new Kind[] { new ItemKind(world), new TimeKind(), new IntegerKind(1, 12, 1, 30) }.Concat(more).ToArray();
    }

    public override string Key => "Step";

    /// <summary>One step; the third argument is how many there are.</summary>
    public override object? Invoke(object?[] arguments)
    {
        _step(arguments[0]!, (float)arguments[1]!, arguments.Length > 3 ? (int)arguments[3]! : 0);
        return null;
    }

    public override string Code(IReadOnlyList<string> arguments) => _code(arguments[0], arguments[1], arguments.Count > 3
        ? arguments[3] : "");
}

/// <summary>What a handler throws.</summary>
internal sealed class ThrowMember : Member
{
    private static readonly Func<Exception>[] _thrown =
    {
        () => new FormatException("a handler's own"), () => new NotSupportedException("a handler's own"), ()
            => new TimeoutException("a handler's own"),
    };

    public ThrowMember() => Kinds = new Kind[] { new IntegerKind(0, 2, 0, 2) };

    public override string Key => "Throw";

    public override object Invoke(object?[] arguments) => throw _thrown[(int)arguments[0]!]();

    public override string Code(IReadOnlyList<string> arguments) => "throw new FormatException(\"a handler's own\")";
}
