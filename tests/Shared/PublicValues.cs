using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace Farseer.Tests.Shared;

/// <summary>A hash of all numbers, truth values and places that public properties of things show.</summary>
internal static class PublicValues
{
    private static readonly ConditionalWeakTable<Type, PropertyInfo[]> _properties = [];

    public static int HashOf(IEnumerable<object> items)
    {
        var hash = default(HashCode);
        foreach (object item in items)
        {
            foreach (PropertyInfo property in _properties.GetValue(item.GetType(), Readable))
            {
                hash.Add(property.GetValue(item));
            }
        }

        return hash.ToHashCode();
    }

    private static PropertyInfo[] Readable(Type type) => [.. type.GetProperties(BindingFlags.Instance | BindingFlags.Public)
        .Where(p => p.GetMethod is { IsPublic: true } && p.GetIndexParameters().Length == 0)
        .Where(p => p.PropertyType is { IsValueType: true, IsByRefLike: false })
        .Where(p => p.Name != "Id")
        .OrderBy(p => p.MetadataToken)];
}
