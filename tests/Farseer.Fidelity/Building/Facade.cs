using System;
using System.Collections.Generic;
using System.Linq;
using System.Linq.Expressions;
using System.Reflection;

namespace Farseer.Fidelity.Building;

/// <summary>
/// The library under test, seen through reflection on its public API alone: what a scene names is
/// looked up when it is needed, so that a part that is not built yet is one named, skipped scene and
/// not a runner that does not compile.
/// </summary>
public static class Facade
{
    private const BindingFlags Instance =
        BindingFlags.Public | BindingFlags.Instance | BindingFlags.IgnoreCase | BindingFlags.FlattenHierarchy;

    private static readonly Assembly Library = Assembly.Load("Farseer");

    private delegate ref TValue RefGetter<TTarget, TValue>(TTarget target);

    public static Type? FindType(string name)
        => Library.GetExportedTypes().FirstOrDefault(t => string.Equals(t.Name, name, StringComparison.OrdinalIgnoreCase));

    public static Type Type(string name) => FindType(name) ?? throw new MissingPartException(name);

    /// <summary>The single instance of a factory class.</summary>
    public static object Factory(string name)
    {
        Type type = Type(name);
        PropertyInfo? instance = type.GetProperty("Instance", BindingFlags.Public | BindingFlags.Static);
        return instance?.GetValue(null) ?? throw new MissingPartException(name + ".Instance");
    }

    public static bool HasMember(object target, string name) => FindMember(target.GetType(), name) is not null;

    public static Type MemberType(object target, string name) => Member(target, name) switch
    {
        PropertyInfo p => p.PropertyType.IsByRef ? p.PropertyType.GetElementType()! : p.PropertyType,
        FieldInfo f => f.FieldType,
        EventInfo e => e.EventHandlerType!,
        MemberInfo m => throw new MissingPartException(target.GetType().Name + "." + m.Name),
    };

    public static object? Get(object target, string name) => Unwrapped(() => Member(target, name) switch
    {
        PropertyInfo p => p.GetValue(target),
        FieldInfo f => f.GetValue(target),
        MemberInfo m => throw new MissingPartException(target.GetType().Name + "." + m.Name),
    });

    public static void Set(object target, string name, object? value) => Unwrapped(() =>
    {
        switch (Member(target, name))
        {
            case PropertyInfo { CanWrite: true } p:
                p.SetValue(target, value);
                break;
            case PropertyInfo { PropertyType.IsByRef: true } p:
                typeof(Facade).GetMethod(nameof(SetByRef), BindingFlags.NonPublic | BindingFlags.Static)!
                    .MakeGenericMethod(p.DeclaringType!, p.PropertyType.GetElementType()!)
                    .Invoke(null, [p, target, value]);
                break;
            case FieldInfo f:
                f.SetValue(target, value);
                break;
            case MemberInfo m:
                throw new MissingPartException(target.GetType().Name + "." + m.Name + " (setter)");
        }

        return null;
    });

    /// <summary>
    /// Adds <paramref name="handler"/> (given its arguments, returning the result or null) to an event or delegate member.
    /// </summary>
    public static void Subscribe(object target, string name, Func<object?[], object?> handler)
    {
        MemberInfo member = Member(target, name);
        Delegate created = CreateDelegate(MemberType(target, name), handler);
        Unwrapped(() =>
        {
            if (member is EventInfo e)
            {
                e.AddEventHandler(target, created);
            }
            else
            {
                Set(target, name, Delegate.Combine((Delegate?)Get(target, name), created));
            }

            return null;
        });
    }

    /// <summary>Calls through reflection, letting the library's own exception come out.</summary>
    public static object? Invoke(MethodBase method, object? target, object?[] args)
        => Unwrapped(() => method is ConstructorInfo c ? c.Invoke(args) : method.Invoke(target, args));

    public static IEnumerable<MethodInfo> Methods(Type type, string name, bool isStatic)
        => type.GetMethods(BindingFlags.Public | BindingFlags.FlattenHierarchy | (isStatic ? BindingFlags.Static : BindingFlags.Instance))
            .Where(m => m.Name == name && !m.IsGenericMethodDefinition);

    private static MemberInfo Member(object target, string name)
        => FindMember(target.GetType(), name) ?? throw new MissingPartException(target.GetType().Name + "." + name);

    private static MemberInfo? FindMember(Type type, string name)
        => type.GetMember(name, MemberTypes.Property | MemberTypes.Field | MemberTypes.Event, Instance)
            .OrderBy(m => m is EventInfo ? 0 : 1)
            .ThenByDescending(m => Depth(m.DeclaringType!))
            .FirstOrDefault();

    private static int Depth(Type type)
    {
        int depth = 0;
        for (Type? t = type; t is not null; t = t.BaseType)
        {
            depth++;
        }

        return depth;
    }

    private static void SetByRef<TTarget, TValue>(PropertyInfo property, TTarget target, TValue value)
        => property.GetMethod!.CreateDelegate<RefGetter<TTarget, TValue>>()(target) = value;

    private static Delegate CreateDelegate(Type delegateType, Func<object?[], object?> handler)
    {
        MethodInfo invoke = delegateType.GetMethod("Invoke")!;
        ParameterExpression[] parameters = invoke.GetParameters().Select(p => Expression.Parameter(p.ParameterType, p.Name)).ToArray();
        Expression call = Expression.Invoke(
            Expression.Constant(handler),
            Expression.NewArrayInit(typeof(object), parameters.Select(p => Expression.Convert(p, typeof(object)))));
        Expression body = invoke.ReturnType == typeof(void) ? call : Expression.Convert(call, invoke.ReturnType);
        return Expression.Lambda(delegateType, body, parameters).Compile();
    }

    private static object? Unwrapped(Func<object?> action)
    {
        try
        {
            return action();
        }
        catch (TargetInvocationException e) when (e.InnerException is not null)
        {
            System.Runtime.ExceptionServices.ExceptionDispatchInfo.Capture(e.InnerException).Throw();
            throw;
        }
    }
}
