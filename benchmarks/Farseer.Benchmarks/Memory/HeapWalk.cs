using System;
using System.Collections.Generic;
using System.Reflection;

namespace Farseer.Benchmarks.Memory;

/// <summary>
/// All objects that can be reached from one, their bytes booked to the store that keeps them: the field of the first object on the way
/// whose kind there is once in a world. Sizes are those of fields and elements on 64 bits, without the gaps of alignment within records.
/// </summary>
internal sealed class HeapWalk
{
    private const BindingFlags OwnFields = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
    private const int ObjectHeader = 16;
    private const int ArrayHeader = 24;
    private const int Word = 8;

    private readonly Dictionary<Type, List<FieldInfo>> _fields = [];
    private readonly HashSet<object> _seen = new HashSet<object>(ReferenceEqualityComparer.Instance);
    private readonly Queue<(object Item, string Store)> _open = new Queue<(object Item, string Store)>();
    private readonly Dictionary<string, long> _bytes = [];

    /// <summary>Bytes by store.</summary>
    public IReadOnlyDictionary<string, long> Bytes => _bytes;

    /// <summary>Bytes of all stores.</summary>
    public long Total
    {
        get
        {
            long total = 0;
            foreach (long bytes in _bytes.Values)
            {
                total += bytes;
            }

            return total;
        }
    }

    /// <summary>How many objects were found.</summary>
    public int Objects => _seen.Count;

    /// <summary>Walks from one object. Of what an earlier walk has seen no bytes are booked, if one is given.</summary>
    public void Walk(object root, HeapWalk? earlier = null)
    {
        Open(root, root.GetType().Name);
        while (_open.Count > 0)
        {
            (object item, string store) = _open.Dequeue();
            if (earlier?._seen.Contains(item) != true)
            {
                _bytes[store] = _bytes.GetValueOrDefault(store) + SizeOf(item);
            }

            if (item is Array array)
            {
                if (!item.GetType().GetElementType()!.IsValueType)
                {
                    foreach (object? element in array)
                    {
                        Open(element, StoreOf(element, store));
                    }
                }

                continue;
            }

            foreach (FieldInfo field in Fields(item.GetType()))
            {
                if (!field.FieldType.IsValueType && !field.FieldType.IsPointer)
                {
                    object? value = field.GetValue(item);
                    Open(value, StoreOf(value, value is Array || IsStorage(item) ? store : $"{item.GetType().Name}.{Plain(field.Name)}"));
                }
            }
        }
    }

    // A type or a member that something holds is the runtime's.
    private void Open(object? item, string store)
    {
        if (item is not null and not MemberInfo and not Assembly && _seen.Add(item))
        {
            _open.Enqueue((item, store));
        }
    }

    // Objects of the public API are many: they are booked by their kind.
    private static string StoreOf(object? item, string field)
    {
        Type? type = item?.GetType();
        bool isPublic = type?.Namespace?.StartsWith("FarseerGames", StringComparison.Ordinal) == true && !type.IsArray;
        return isPublic ? type!.Name : field;
    }

    // Lists and maps of the engine are part of the field that has them.
    private static bool IsStorage(object item) => item.GetType().Namespace == "Farseer.Engine.Storage";

    private static string Plain(string field) => field.StartsWith('<') ? field[1..field.IndexOf('>', StringComparison.Ordinal)] : field;

    private List<FieldInfo> Fields(Type type)
    {
        if (!_fields.TryGetValue(type, out List<FieldInfo>? fields))
        {
            fields = [];
            for (Type? part = type; part != null; part = part.BaseType)
            {
                fields.AddRange(part.GetFields(OwnFields));
            }

            _fields[type] = fields;
        }

        return fields;
    }

    private long SizeOf(object item)
    {
        Type type = item.GetType();
        if (item is Array array)
        {
            return ArrayHeader + (array.LongLength * SizeInField(type.GetElementType()!));
        }

        if (item is string text)
        {
            return ArrayHeader + (2L * text.Length);
        }

        long size = ObjectHeader;
        foreach (FieldInfo field in Fields(type))
        {
            size += SizeInField(field.FieldType);
        }

        return (size + (Word - 1)) / Word * Word;
    }

    private long SizeInField(Type type)
    {
        if (!type.IsValueType)
        {
            return Word;
        }

        if (type.IsEnum)
        {
            return SizeInField(Enum.GetUnderlyingType(type));
        }

        switch (Type.GetTypeCode(type))
        {
            case TypeCode.Boolean or TypeCode.Byte or TypeCode.SByte:
                return 1;
            case TypeCode.Char or TypeCode.Int16 or TypeCode.UInt16:
                return 2;
            case TypeCode.Int32 or TypeCode.UInt32 or TypeCode.Single:
                return 4;
            case TypeCode.Int64 or TypeCode.UInt64 or TypeCode.Double:
                return Word;
        }

        if (type.IsPrimitive)
        {
            return Word;
        }

        long size = 0;
        foreach (FieldInfo field in Fields(type))
        {
            size += SizeInField(field.FieldType);
        }

        return Math.Max(1, size);
    }
}
