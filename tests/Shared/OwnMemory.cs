using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;

namespace Farseer.Tests.Shared;

/// <summary>
/// What an object of a sample remembers beside its world: fields, and what lists and arrays in them hold. A state of a world does
/// not have them; who goes back to one sets them back himself.
/// </summary>
internal sealed class OwnMemory
{
    private const BindingFlags All = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    private readonly List<(object Owner, FieldInfo Field, object? Value)> _fields = [];
    private readonly List<(IList Items, object?[] Values)> _lists = [];
    private readonly HashSet<object> _seen = new(ReferenceEqualityComparer.Instance);

    public OwnMemory(object owner) => Keep(owner, owner.GetType().Assembly);

    public void Restore()
    {
        foreach ((object owner, FieldInfo field, object? value) in _fields)
        {
            field.SetValue(owner, value);
        }

        foreach ((IList items, object?[] values) in _lists)
        {
            if (!items.IsFixedSize)
            {
                items.Clear();
                Array.ForEach(values, value => items.Add(value));
                continue;
            }

            for (int i = 0; i < values.Length; i++)
            {
                items[i] = values[i];
            }
        }
    }

    private void Keep(object owner, Assembly mine)
    {
        if (!_seen.Add(owner))
        {
            return;
        }

        for (Type? type = owner.GetType(); type is not null && type.Assembly == mine; type = type.BaseType)
        {
            foreach (FieldInfo field in type.GetFields(All))
            {
                object? value = field.GetValue(owner);
                if (!field.IsInitOnly)
                {
                    _fields.Add((owner, field, value));
                }

                if (value is IList list && IsPlain(value.GetType()))
                {
                    object?[] values = new object?[list.Count];
                    list.CopyTo(values, 0);
                    _lists.Add((list, values));
                }
                else if (value is not null && value.GetType().Assembly == mine && value.GetType().IsClass)
                {
                    Keep(value, mine);
                }
            }
        }
    }

    private static bool IsPlain(Type type) =>
        type.IsArray ? type.GetArrayRank() == 1 : type.IsGenericType && type.GetGenericTypeDefinition() == typeof(List<>);
}
