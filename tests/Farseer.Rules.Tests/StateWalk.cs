using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Reflection.Emit;
using System.Runtime.CompilerServices;

namespace Farseer.Rules.Tests;

/// <summary>
/// What of a world lives from step to step, and what of it a state has: all fields from a root on, and those that some method with a
/// <c>StateStream</c> writes and reads.
/// </summary>
internal sealed class StateWalk
{
    private const BindingFlags All = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    private static readonly Dictionary<int, OpCode> _opCodes = typeof(OpCodes).GetFields()
        .Select(f => (OpCode)f.GetValue(null)!)
        .ToDictionary(o => o.Value & 0xFFFF);

    private readonly List<Type> _types;
    private readonly Type _stream;
    private readonly Type _excuse;
    private readonly HashSet<Type> _known;
    private readonly HashSet<(Type? Owner, string Name)> _set = [];
    private readonly HashSet<(Type? Owner, string Name)> _read = [];
    private readonly HashSet<(Type? Owner, string Name)> _given = [];
    private readonly HashSet<(Type? Owner, string Name)> _shared = [];
    private readonly HashSet<Type> _seen = [];
    private readonly List<(Type Type, string Name)> _others = [];

    public StateWalk(params Assembly[] facades)
    {
        var engine = Assembly.Load("Farseer.Engine");
        _stream = engine.GetType("Farseer.Engine.Storage.StateStream", true)!;
        _excuse = engine.GetType("Farseer.Engine.Storage.NotStateAttribute", true)!;
        _known = [.. _stream.GetMethods().SelectMany(m => m.GetParameters()).Where(p => p.ParameterType.IsGenericType)
            .Select(p => p.ParameterType.GetGenericTypeDefinition())];
        _types = [.. facades.Append(engine).SelectMany(a => a.GetTypes())];
        foreach (MethodBase method in _types.SelectMany(t => t.GetMethods(All | BindingFlags.Static)).Where(IsVisit))
        {
            Note(method);
        }

        foreach (ConstructorInfo constructor in _types.SelectMany(t => t.GetConstructors(All)))
        {
            NoteCollaborators(constructor);
        }
    }

    /// <summary>Fields that no state has and that say no reason.</summary>
    public List<string> Missing { get; } = [];

    /// <summary>Fields that were given to the constructor of their owner, whose types nothing visits.</summary>
    public IEnumerable<string> Unvisited => _others.Where(o => !_seen.Contains(o.Type) && !o.Type.IsInterface).Select(o => o.Name);

    /// <summary>Fields that a state has and that say why it has not.</summary>
    public List<string> Contradictory { get; } = [];

    public int Visited { get; private set; }

    /// <summary>Types of records that a state has as they lie in memory.</summary>
    public HashSet<Type> Records { get; } = [];

    /// <summary>Records with bytes that belong to no field, whatever they are.</summary>
    public IEnumerable<string> Padded => Records.SelectMany(Parts).Where(HasPadding).Select(t => t.FullName!).Distinct().Order();

    /// <summary>Reasons, by the field or type that gives them.</summary>
    public Dictionary<string, string> Reasons { get; } = [];

    /// <summary>Fields that say why no state has them and that nobody asks.</summary>
    public IEnumerable<string> Unasked => _types.Where(t => !t.IsGenericType).SelectMany(t => t.GetMembers(All))
        .Where(m => m is FieldInfo or PropertyInfo)
        .Where(m => m.GetCustomAttributesData().Any(a => a.AttributeType == _excuse))
        .Select(m => m.DeclaringType!.FullName + "." + m.Name)
        .Where(n => !Reasons.ContainsKey(n));

    public void Walk(Type type)
    {
        if (type.IsGenericType && !type.IsGenericTypeDefinition && _types.Contains(type.GetGenericTypeDefinition()))
        {
            Array.ForEach(type.GetGenericArguments(), Walk);
            type = type.GetGenericTypeDefinition();
        }

        // What the stream takes itself.
        if (_known.Contains(type))
        {
            return;
        }

        if (type.IsArray || (type.IsGenericType && !_types.Contains(type)))
        {
            Array.ForEach(type.IsArray ? [type.GetElementType()!] : type.GetGenericArguments(), Walk);
            return;
        }

        // Records without references are written as they are.
        if (!_types.Contains(type) || type.IsEnum || typeof(Delegate).IsAssignableFrom(type) || IsPlain(type)
            || !_seen.Add(type) || Excused(type, type.FullName!))
        {
            return;
        }

        foreach (Type derived in _types.Where(t => t != type && type.IsAssignableFrom(t)))
        {
            Walk(derived);
        }

        if (type.BaseType is { } basis)
        {
            Walk(basis);
        }

        Array.ForEach(type.GetFields(All), Look);
    }

    private static IEnumerable<Type> Parts(Type type) => type.IsPrimitive || type.IsEnum || type.IsPointer
        ? [] : type.GetFields(All).Where(f => !f.IsDefined(typeof(FixedBufferAttribute))).SelectMany(f => Parts(f.FieldType)).Prepend(type);

    private static bool HasPadding(Type type) => Size(type) != type.GetFields(All).Sum(f => Size(f.FieldType));

    private static int Size(Type type) => type.IsPointer ? IntPtr.Size
        : (int)typeof(Unsafe).GetMethod(nameof(Unsafe.SizeOf))!.MakeGenericMethod(type).Invoke(null, null)!;

    private bool IsVisit(MethodBase method) =>
        method.DeclaringType != _stream && method.GetParameters().Any(p => p.ParameterType == _stream);

    private static bool IsPlain(Type type) =>
        type.IsPrimitive || type.IsPointer || type.IsEnum
        || (type.IsValueType && !type.ContainsGenericParameters && type.GetFields(All).All(f => IsPlain(f.FieldType)));

    private void Look(FieldInfo field)
    {
        Type type = field.FieldType;
        PropertyInfo? property = field.Name.StartsWith('<')
            ? field.DeclaringType!.GetProperty(field.Name[1..field.Name.IndexOf('>', StringComparison.Ordinal)], All) : null;
        string name = field.DeclaringType!.FullName + "." + (property?.Name ?? field.Name);
        bool isSet = _set.Contains(Key(field));
        bool isVisited = isSet || (_read.Contains(Key(field)) && !type.IsValueType);
        if (Excused((MemberInfo?)property ?? field, name))
        {
            if (isSet)
            {
                Contradictory.Add(name);
            }

            return;
        }

        // What is made with its owner and never changed needs no state; where something lies is no state either.
        if (type.IsPointer || type.IsFunctionPointer
            || (field.IsInitOnly && (IsPlain(type) || type == typeof(string) || typeof(Delegate).IsAssignableFrom(type))))
        {
            return;
        }

        if (!isVisited && field.IsInitOnly && _shared.Contains(Key(field)))
        {
            return;
        }

        if (!isVisited && field.IsInitOnly && _given.Contains(Key(field)))
        {
            _others.Add((type, name));
            return;
        }

        if (!isVisited)
        {
            if (!Excused(type, name))
            {
                Missing.Add(name);
            }

            return;
        }

        Visited++;
        Walk(type);
    }

    private bool Excused(MemberInfo member, string name)
    {
        if (member.GetCustomAttributesData().FirstOrDefault(a => a.AttributeType == _excuse) is not { } excuse)
        {
            return false;
        }

        Reasons[name] = Enum.GetName(excuse.ConstructorArguments[0].ArgumentType, excuse.ConstructorArguments[0].Value!)!;
        return true;
    }

    // Fields of a constructed type are those of its definition.
    private static (Type? Owner, string Name) Key(FieldInfo field) =>
        (field.DeclaringType is { IsGenericType: true } type ? type.GetGenericTypeDefinition() : field.DeclaringType, field.Name);

    private bool IsProperty(MethodBase method) => method.IsSpecialName && _types.Contains(method.DeclaringType!);

    // Of a property of an interface, those that stand for it.
    private void NoteAll(MethodBase method, int depth)
    {
        Note(method, depth);
        if (method.DeclaringType is { IsInterface: true, IsGenericType: false } face)
        {
            foreach (Type type in _types.Where(t => !t.IsInterface && !t.IsGenericTypeDefinition && face.IsAssignableFrom(t)))
            {
                InterfaceMapping map = type.GetInterfaceMap(face);
                Note(map.TargetMethods[Array.IndexOf(map.InterfaceMethods, method)], depth);
            }
        }
    }

    private void NoteCollaborators(ConstructorInfo constructor)
    {
        List<(OpCode Code, MemberInfo? Member)> il = [.. Read(constructor)];
        for (int i = 1; i < il.Count; i++)
        {
            // As it was given, or read from a property of what was given, which is looked at there.
            bool isRead = i > 1 && il[i - 1].Member is MethodInfo called && IsProperty(called);
            if (il[i].Code == OpCodes.Stfld && il[isRead ? i - 2 : i - 1].Code.Name!.StartsWith("ldarg", StringComparison.Ordinal))
            {
                (isRead ? _shared : _given).Add(Key((FieldInfo)il[i].Member!));
            }
        }
    }

    private void Note(MethodBase method, int depth = 0)
    {
        foreach ((OpCode code, MemberInfo? member) in Read(method))
        {
            if (member is MethodInfo { IsGenericMethod: true } told && told.DeclaringType == _stream && told.Name != "ClearBehind")
            {
                Records.UnionWith(told.GetGenericArguments().Where(t => t is { IsValueType: true, ContainsGenericParameters: false }));
            }

            if (member is FieldInfo field)
            {
                (code == OpCodes.Ldfld ? _read : _set).Add(Key(field));
            }
            else if (member is MethodBase called && depth < 2 && !IsVisit(called)
                && (IsProperty(called) || called.IsDefined(typeof(CompilerGeneratedAttribute))))
            {
                NoteAll(called, depth + 1);
            }
        }
    }

    private static IEnumerable<(OpCode Code, MemberInfo? Member)> Read(MethodBase method)
    {
        if (method.GetMethodBody()?.GetILAsByteArray() is not { } il)
        {
            yield break;
        }

        Type[]? ofType = method.DeclaringType is { IsGenericType: true } owner ? owner.GetGenericArguments() : null;
        Type[]? ofMethod = method.IsGenericMethod ? method.GetGenericArguments() : null;
        for (int at = 0; at < il.Length;)
        {
            int value = il[at++];
            OpCode code = _opCodes[value == 0xFE ? 0xFE00 | il[at++] : value];
            yield return (code, code.OperandType is OperandType.InlineField or OperandType.InlineMethod
                ? method.Module.ResolveMember(BitConverter.ToInt32(il, at), ofType, ofMethod) : null);
            at += code.OperandType switch
            {
                OperandType.InlineNone => 0,
                OperandType.ShortInlineBrTarget or OperandType.ShortInlineI or OperandType.ShortInlineVar => 1,
                OperandType.InlineVar => 2,
                OperandType.InlineI8 or OperandType.InlineR => 8,
                OperandType.InlineSwitch => 4 + (4 * BitConverter.ToInt32(il, at)),
                _ => 4,
            };
        }
    }
}
