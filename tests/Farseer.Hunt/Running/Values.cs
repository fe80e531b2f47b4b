using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Reflection;

namespace Farseer.Hunt.Running;

/// <summary>All public values of an item: what can be asked for without an argument and is a number or made of numbers.</summary>
internal static class Values
{
    private static readonly ConcurrentDictionary<Type, (string Name, MethodInfo Get)[]> _getters = new();

    /// <returns>The first value that is no finite number, or null.</returns>
    public static (string Name, object Value)? FirstUnsound(object item)
    {
        foreach ((string name, MethodInfo get) in _getters.GetOrAdd(item.GetType(), Find))
        {
            object? value;
            try
            {
                value = get.Invoke(item, BindingFlags.DoNotWrapExceptions, null, null, null);
            }
            catch (Exception refusal) when (refusal is ArgumentException or InvalidOperationException)
            {
                // Items that are gone, or that do not belong to a world yet, refuse some.
                continue;
            }

            if (value is not null && !IsFinite(value))
            {
                // Of a value that is made of values, the one that it is.
                return value.GetType().Namespace?.StartsWith("System", StringComparison.Ordinal) == true ? (name, value)
                    : FirstUnsound(value) ?? (name, value);
            }
        }

        return null;
    }

    private static (string Name, MethodInfo Get)[] Find(Type type) => type
        .GetMethods(BindingFlags.Public | BindingFlags.Instance)
        .Where(m => m.GetParameters().Length == 0 && !m.IsGenericMethod && (m.Name.StartsWith("get_", StringComparison.Ordinal)
            || m.Name.StartsWith("Get", StringComparison.Ordinal)))
        .Where(m => IsMadeOfNumbers(m.ReturnType.IsByRef ? m.ReturnType.GetElementType()! : m.ReturnType))
        .Select(m => (m.DeclaringType!.Name + "." + m.Name.Replace("get_", "", StringComparison.Ordinal), m))
        .ToArray();

    private static bool IsMadeOfNumbers(Type type) =>
        type == typeof(float) || type == typeof(double) || type == typeof(Vector2) || type == typeof(Matrix4x4) || type == typeof(float[])
        || type.Name is "b2Vec2" or "b2Mat22" or "b2XForm" or "StepReport" or "AABB";

    private static bool IsFinite(object value) => value switch
    {
        float number => float.IsFinite(number),
        double number => double.IsFinite(number),
        Vector2 point => float.IsFinite(point.X) && float.IsFinite(point.Y),
        float[] numbers => numbers.All(float.IsFinite),
        Matrix4x4 m => float.IsFinite(m.M11 + m.M12 + m.M21 + m.M22 + m.M41 + m.M42),
        _ => FirstUnsound(value) is null,
    };
}
