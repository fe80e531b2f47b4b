using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Serialization.Documents;

namespace FarseerGames.FarseerPhysics.Serialization.Tables;

/// <summary>Which members of a file a type has, those of its base type first; they are set in this order.</summary>
internal abstract class Table
{
    /// <summary>The properties that are left out, and why; a test asks for one of the two for each that can be set.</summary>
    public Dictionary<string, string> LeftOut { get; } = new Dictionary<string, string>();

    public abstract void Write(object item, SceneSink sink);

    public abstract void Read(object item, SceneObject members);
}

/// <summary>The members of a type.</summary>
internal sealed class Table<T> : Table
    where T : class
{
    private readonly Table? _base;
    private readonly List<Field> _fields = new List<Field>();

    public Table(Table? baseTable = null)
    {
        _base = baseTable;
        foreach (KeyValuePair<string, string> left in baseTable?.LeftOut ?? new Dictionary<string, string>())
        {
            LeftOut.Add(left.Key, left.Value);
        }
    }

    public override void Write(object item, SceneSink sink)
    {
        _base?.Write(item, sink);
        foreach (Field field in _fields)
        {
            sink.Name(field.Name);
            field.Write((T)item, sink);
        }
    }

    public override void Read(object item, SceneObject members)
    {
        _base?.Read(item, members);
        foreach (Field field in _fields)
        {
            if (members.TryTake(field.Name, out SceneNode node))
            {
                field.Read((T)item, node);
            }
        }
    }

    public Table<T> Without(string property, string reason)
    {
        LeftOut.Add(property, reason);
        return this;
    }

    public Table<T> Flag(string name, Func<T, bool> get, Action<T, bool> set) =>
        Add(name, get, set, static (sink, value) => sink.Flag(value), static node => node.Flag());

    public Table<T> Whole(string name, Func<T, int> get, Action<T, int> set) =>
        Add(name, get, set, static (sink, value) => sink.Whole(value), static node => node.Whole());

    public Table<T> Number(string name, Func<T, float> get, Action<T, float> set) =>
        Add(name, get, set, static (sink, value) => sink.Number(value), static node => node.Single());

    public Table<T> Double(string name, Func<T, double> get, Action<T, double> set) =>
        Add(name, get, set, static (sink, value) => sink.Number(value), static node => node.Double());

    public Table<T> Vector(string name, Func<T, Vector2> get, Action<T, Vector2> set) =>
        Add(name, get, set, static (sink, value) => sink.Vector(value), static node => node.Vector());

    public Table<T> Text(string name, Func<T, string?> get, Action<T, string> set) =>
        Add(
            name,
            item => get(item) ?? "",
            (item, value) => SetUnlessEmpty(item, value, set),
            static (sink, value) => sink.Text(value),
            static node => node.Text());

    /// <summary>Members of an enum by name, several of them as in <c>Cat1, Cat4</c>.</summary>
    public Table<T> Choice<TEnum>(string name, Func<T, TEnum> get, Action<T, TEnum> set)
        where TEnum : struct, Enum =>
        Add(name, get, set, static (sink, value) => sink.Text(value.ToString()), EnumOf<TEnum>);

    private static TEnum EnumOf<TEnum>(SceneNode node)
        where TEnum : struct, Enum =>
        Enum.TryParse(node.Text(), out TEnum value) ? value : throw node.Error("must be made of members of the enum " + typeof(TEnum).Name);

    private static void SetUnlessEmpty(T item, string value, Action<T, string> set)
    {
        if (value.Length > 0)
        {
            set(item, value);
        }
    }

    private Table<T> Add<TValue>(
        string name, Func<T, TValue> get, Action<T, TValue> set, Action<SceneSink, TValue> write, Func<SceneNode, TValue> read)
    {
        _fields.Add(new Field<TValue>(name, get, set, write, read));
        return this;
    }

    private abstract class Field
    {
        protected Field(string name) => Name = name;

        public string Name { get; }

        public abstract void Write(T item, SceneSink sink);

        public abstract void Read(T item, SceneNode node);
    }

    private sealed class Field<TValue> : Field
    {
        private readonly Func<T, TValue> _get;
        private readonly Action<T, TValue> _set;
        private readonly Action<SceneSink, TValue> _write;
        private readonly Func<SceneNode, TValue> _read;

        public Field(string name, Func<T, TValue> get, Action<T, TValue> set, Action<SceneSink, TValue> write, Func<SceneNode, TValue> read)
            : base(name)
        {
            _get = get;
            _set = set;
            _write = write;
            _read = read;
        }

        public override void Write(T item, SceneSink sink) => _write(sink, _get(item));

        public override void Read(T item, SceneNode node) => SceneObject.Try(node, item, _read(node), _set);
    }
}
