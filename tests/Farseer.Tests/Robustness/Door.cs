using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Reflection;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Tests.Robustness;

/// <summary>One argument of one public member: where a bad value may come in. A property that can be set has one, its value.</summary>
internal sealed class Door
{
    private Door(MethodBase member, int index)
    {
        Member = member;
        Index = index;
        ParameterInfo parameter = member.GetParameters()[index];
        Type = parameter.ParameterType.IsByRef ? parameter.ParameterType.GetElementType()! : parameter.ParameterType;
        IsSetter = member.Name.StartsWith("set_", StringComparison.Ordinal);
        Name = IsSetter ? member.Name.Substring(4) : parameter.Name!;
    }

    public MethodBase Member { get; }

    public int Index { get; }

    public Type Type { get; }

    public bool IsSetter { get; }

    /// <summary>What an exception must name: the parameter, or the property.</summary>
    public string Name { get; }

    /// <summary>Names the door in the list of exceptions; overloads share it.</summary>
    public string Key => TypeName + "." + (IsSetter ? Name : (Member.IsConstructor ? "new" : Member.Name) + "(" + Name + ")");

    public string TypeName => Member.DeclaringType!.Name.Split('`')[0];

    public static List<Door> All { get; } = Find().ToList();

    /// <summary>Values that no member should take without a word.</summary>
    public IEnumerable<object?> BadValues()
    {
        if (Type == typeof(float))
        {
            return new object?[] { float.NaN, float.PositiveInfinity, float.NegativeInfinity };
        }

        if (Type == typeof(double))
        {
            return new object?[] { double.NaN, double.PositiveInfinity, double.NegativeInfinity, double.MaxValue };
        }

        if (Type == typeof(Vector2))
        {
            return new object?[] {
                new Vector2(float.NaN, 1), new Vector2(1, float.PositiveInfinity), new Vector2(float.NegativeInfinity, 0),
            };
        }

        if (Type == typeof(Matrix4x4))
        {
            return new object?[] { Matrix4x4.CreateScale(float.NaN), new Matrix4x4 { M41 = float.PositiveInfinity } };
        }

        if (Type == typeof(int))
        {
            return new object?[] { -1, int.MinValue };
        }

        if (Type == typeof(long))
        {
            return new object?[] { -1L, long.MinValue };
        }

        if (Type.IsEnum)
        {
            return new[] { Enum.ToObject(Type, 1 << 30) };
        }

        return Type == typeof(Vertices) ? new object?[] { null, new Vertices(), BadVertices() }
            : Type.IsValueType ? Array.Empty<object?>() : new object?[] { null };
    }

    /// <summary>Calls the member with one bad argument and returns what it threw.</summary>
    public Exception? Call(object? target, object?[] arguments)
    {
        try
        {
            if (Member is ConstructorInfo constructor)
            {
                constructor.Invoke(arguments);
            }
            else
            {
                Member.Invoke(Member.IsStatic ? null : target, arguments);
            }

            return null;
        }
        catch (TargetInvocationException exception)
        {
            return exception.InnerException;
        }
    }

    /// <summary>Valid arguments, and the given one at this door.</summary>
    public object?[] Arguments(Bench bench, object? value) =>
        Member.GetParameters().Select((p, i) => i == Index ? value : p.IsOut ? null : bench.Valid(Bare(p.ParameterType), p.Name!))
            .ToArray();

    public override string ToString() => Member.DeclaringType!.Name + "." + Member + " " + Name;

    private static Vertices BadVertices()
    {
        Vertices vertices = Bench.Outline();
        vertices[2] = new Vector2(3, float.NaN);
        return vertices;
    }

    private static Type Bare(Type type) => type.IsByRef ? type.GetElementType()! : type;

    private static IEnumerable<Door> Find()
    {
        const BindingFlags Declared = BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;
        foreach (Type exported in typeof(PhysicsSimulator).Assembly.GetExportedTypes().OrderBy(t => t.FullName, StringComparer.Ordinal))
        {
            if (exported.Name.Contains('<', StringComparison.Ordinal)
                || exported.IsInterface
                || exported.IsEnum
                || typeof(Delegate).IsAssignableFrom(exported))
            {
                continue;
            }

            Type type = exported.IsGenericTypeDefinition
                ? exported.MakeGenericType(exported == typeof(ItemList<>) ? typeof(Body) : typeof(object))
                : exported;
            IEnumerable<MethodBase> members = type.GetConstructors(Declared);
            members = members.Concat(type.GetMethods(Declared).Where(m => !m.IsGenericMethod && !IsAccessorOfEvent(m)));
            foreach (MethodBase member in members)
            {
                // A span cannot be handed over by reflection: tests of such a member's own try what is bad.
                ParameterInfo[] parameters = member.GetParameters();
                if (Array.Exists(parameters, p => p.ParameterType.IsByRefLike))
                {
                    continue;
                }

                for (int i = 0; i < parameters.Length; i++)
                {
                    if (!parameters[i].IsOut)
                    {
                        yield return new Door(member, i);
                    }
                }
            }
        }
    }

    /// <summary>Adding or removing no handler is legal for every event of .NET.</summary>
    private static bool IsAccessorOfEvent(MethodInfo method) =>
        method.Name.StartsWith("add_", StringComparison.Ordinal) || method.Name.StartsWith("remove_", StringComparison.Ordinal);
}
