using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace Farseer.Hunt.Calls;

/// <summary>
/// All public members of some types, found by reflection. A member whose parameters have known names and types needs no entry; a name
/// that is new needs one in
/// <see cref="Names"/>, and what is left out needs a reason.
/// </summary>
internal sealed class Catalogue
{
    private const BindingFlags Declared = BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    private static readonly string[] _looks =
    {
        "Get", "RayCast", "Query", "ClosestPoint", "Collide", "CircleCast", "ShapeCast", "StateHash", "MotionHash", "Test", "Compute",
        "Support",
            "Centroid", "IsConnected", "Intersect",
    };

    private readonly Names _names;
    private readonly HashSet<string> _reasonsUsed = new(StringComparer.Ordinal);

    public Catalogue(Names names)
    {
        _names = names;
        foreach (Type type in names.Types)
        {
            if (!type.IsAbstract && !type.IsInterface)
            {
                AddAll(type.GetConstructors(Declared), type);
            }

            AddAll(type.GetMethods(Declared), type);
            foreach (EventInfo @event in type.GetEvents(Declared).Where(e => !IsLeftOut(type, e.Name)))
            {
                Members.Add(new HandlerMember(@event, @event.EventHandlerType!));
            }
        }

        UnusedReasons = names.LeftOut.Keys.Where(k => !_reasonsUsed.Contains(k)).ToList();
    }

    public List<Member> Members { get; } = new();

    /// <summary>Those that change nothing.</summary>
    public List<Member> Looks { get; } = new();

    /// <summary>Members that are neither modelled nor left out with a reason.</summary>
    public List<string> Unknown { get; } = new();

    public List<string> UnusedReasons { get; }

    private void AddAll(IEnumerable<MethodBase> methods, Type type)
    {
        foreach (MethodBase method in methods.Where(m => IsMeant(m)))
        {
            string name = method.IsConstructor ? "new" : method.IsSpecialName ? method.Name.Substring(4) : method.Name;
            if (IsLeftOut(type, name))
            {
                continue;
            }

            if (method.IsSpecialName && !method.IsConstructor && method.Name[0] == 'g')
            {
                AddWay((MethodInfo)method);
            }
            else
            {
                Add(method, name);
            }
        }
    }

    /// <summary>No operator, none that every object has, and none that another has by value.</summary>
    private static bool IsMeant(MethodBase method)
    {
        bool isAccessor = method.Name.StartsWith("set_", StringComparison.Ordinal) || method.Name.StartsWith("get_",
            StringComparison.Ordinal);
        if (!method.IsConstructor && ((method.IsSpecialName && !isAccessor) || method.Name is "Equals" or "GetHashCode" or "ToString"))
        {
            return false;
        }

        // An override is its base's member.
        bool isOverride = method is MethodInfo { IsVirtual: true } info && info.GetBaseDefinition().DeclaringType != info.DeclaringType;
        ParameterInfo[] parameters = method.GetParameters();
        bool isByReference = parameters.Any(p => p.ParameterType.IsByRef && !p.IsOut)
            && method.DeclaringType!.GetMethods(Declared).Any(m => m.Name == method.Name && !m.GetParameters().Any(p
                => p.ParameterType.IsByRef));
        return !isOverride && !isByReference && !method.IsGenericMethod;
    }

    private bool IsLeftOut(Type type, string name)
    {
        foreach (string key in new[] { type.Name + "." + name, "*." + name })
        {
            if (_names.LeftOut.ContainsKey(key))
            {
                _reasonsUsed.Add(key);
                return true;
            }
        }

        return false;
    }

    /// <summary>A property that leads from an item to another.</summary>
    private void AddWay(MethodInfo getter)
    {
        if (_names.Ways.Contains(getter.DeclaringType!) && _names.Types.Contains(getter.ReturnType) && getter.GetParameters().Length == 0)
        {
            Members.Add(new MethodMember(getter, new[] { new ItemKind(getter.DeclaringType!) }, getter.ReturnType, null));
        }
    }

    private void Add(MethodBase method, string name)
    {
        Type owner = method.DeclaringType!;
        ParameterInfo[] parameters = method.GetParameters();
        if (method.IsSpecialName && !method.IsConstructor && typeof(Delegate).IsAssignableFrom(parameters[0].ParameterType))
        {
            Members.Add(new HandlerMember(owner.GetProperty(name, Declared)!, parameters[0].ParameterType));
            return;
        }

        (string Code, object Instance)? singleton = _names.Singletons.TryGetValue(owner, out object? instance)
            ? (owner.Name + ".Instance", instance) : null;
        var kinds = new List<Kind?>();
        if (!method.IsStatic && !method.IsConstructor && singleton is null)
        {
            kinds.Add(new ItemKind(owner));
        }

        bool isSetter = method.IsSpecialName && !method.IsConstructor;
        foreach (ParameterInfo parameter in parameters.Where(p => !p.IsOut))
        {
            string called = isSetter ? char.ToLowerInvariant(name[0]) + name.Substring(1) : parameter.Name!;
            Type type = parameter.ParameterType.IsByRef ? parameter.ParameterType.GetElementType()! : parameter.ParameterType;
            Kind? kind = _names.KindOf(owner, called, type, parameter.HasDefaultValue);
            if (kind is null)
            {
                Unknown.Add($"{owner.Name}.{name}: {type.Name} {called}");
            }

            kinds.Add(kind);
        }

        if (kinds.Contains(null))
        {
            return;
        }

        Type? result = method is MethodInfo info ? info.ReturnType : owner;
        bool makes = result is not null && _names.Types.Contains(result);
        var member = new MethodMember(method, kinds!, makes ? result : null, singleton) { ResultOf = makes ? _names.ResultOf(method)
            : null };
        Members.Add(member);
        if (!isSetter && !makes && _looks.Any(l => name.StartsWith(l, StringComparison.Ordinal)) && name != "ComputeCollisionGrid")
        {
            Looks.Add(member);
        }
    }
}

/// <summary>What a facade says of the names in its API.</summary>
internal abstract class Names
{
    /// <summary>The types whose members are called.</summary>
    public abstract IReadOnlyList<Type> Types { get; }

    /// <summary>Types whose properties lead to other items.</summary>
    public abstract IReadOnlyCollection<Type> Ways { get; }

    public virtual IReadOnlyDictionary<Type, object> Singletons { get; } = new Dictionary<Type, object>();

    /// <summary>Members that are not called, as <c>Owner.Name</c> or <c>*.Name</c>, and why.</summary>
    public abstract IReadOnlyDictionary<string, string> LeftOut { get; }

    /// <summary>
    /// Numbers by the names of parameters and properties, or by <c>Owner.name</c> where the same name means different things.
    /// </summary>
    protected abstract IReadOnlyDictionary<string, Span> Spans { get; }

    protected abstract IReadOnlyDictionary<string, (int Low, int High, int Least, int Most)> Integers { get; }

    /// <summary>A type that only some calls know: by the argument that tells it.</summary>
    public virtual Func<IReadOnlyList<object>, Func<int, Type?>, Type?>? ResultOf(MethodBase method) => null;

    public Kind? KindOf(Type owner, string name, Type type, bool isOptional)
    {
        if (type == typeof(float) || type == typeof(double))
        {
            return SpanOf(owner, name) is { } span ? new NumberKind(span, type == typeof(double)) : null;
        }

        if (type == typeof(int) || type == typeof(uint) || type == typeof(byte) || type == typeof(long))
        {
            return Integers.TryGetValue(owner.Name + "." + name, out (int Low, int High, int Least, int Most) own)
                || Integers.TryGetValue(name, out own)
                ? new IntegerKind(own.Low, own.High, own.Least, own.Most, type)
                : null;
        }

        return type == typeof(bool) ? new FlagKind()
            : type.IsEnum ? new ChoiceKind(type)
            : Special(owner, name, type) ?? (Types.Contains(type) ? new ItemKind(type, isOptional || IsOptional(owner, name)) : null);
    }

    protected Span? SpanOf(Type owner, string name) =>
        Spans.TryGetValue(owner.Name + "." + name, out Span? span) || Spans.TryGetValue(name, out span) ? span : null;

    protected virtual bool IsOptional(Type owner, string name) => false;

    /// <summary>Vectors, outlines and whatever else is no plain number or item.</summary>
    protected abstract Kind? Special(Type owner, string name, Type type);
}
