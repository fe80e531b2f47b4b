using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <content>The names of fields, and what differs in every simulation.</content>
internal sealed unsafe partial class StateStream
{
    // Stretches that are not the same in all simulations that were made in the same way.
    private readonly Column<(int At, int End)> _locals = new Column<(int At, int End)>(1);
    private int _localCount;

    private StateTrace? _names;

    /// <summary>Names of the fields and where each begins, for those who look for a difference; null: nobody does.</summary>
    public StateTrace? Trace { get; set; }

    /// <summary>Names are noted now.</summary>
    public bool IsNaming => _names is not null;

    /// <summary>How many stretches are not the same in simulations that were made in the same way.</summary>
    public int LocalCount => _localCount;

    /// <summary>Where one of them is.</summary>
    public (int At, int End) Local(int index) => _locals[index];

    /// <summary>Whether a place belongs to what is not the same in simulations that were made in the same way.</summary>
    public bool IsLocal(int at)
    {
        for (int i = 0; i < _localCount; i++)
        {
            if (at >= _locals[i].At && at < _locals[i].End)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>What follows belongs to this part: for those who look for a difference.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public StateStream Of(string part, int item = -1, object? who = null)
    {
        _names?.Enter(part, item, who);
        return this;
    }

    /// <summary>
    /// A column that is not the same in all simulations that were made in the same way: numbers that say who is older, and what lies side
    /// by side in lanes, of which there are more on some processors. It is a part of the state, and not of its hash.
    /// </summary>
    public void Local<T>(Column<T> column, [CallerArgumentExpression(nameof(column))] string name = "")
        where T : unmanaged
    {
        Section();
        int at = _at;
        Column(column, name);
        NoteLocal(at);
    }

    /// <summary>The same of so many records: who found what is in the order of the workers.</summary>
    public void Local<T>(Column<T> column, int count, [CallerArgumentExpression(nameof(column))] string name = "")
        where T : unmanaged
    {
        Section();
        int at = _at;
        Column(column, count, name);
        NoteLocal(at);
    }

    private void NoteLocal(int at)
    {
        if (!IsReading)
        {
            _locals.EnsureCapacity(_localCount + 1);
            _locals[_localCount++] = (at, _at);
        }
    }

    /// <summary>Numbers of the lanes of a bundle, which belong to items of a part.</summary>
    public void Lanes<T>(T* lanes, int* items, int count, string part, string name)
        where T : unmanaged
    {
        for (int i = 0; i < count && _names is not null; i++)
        {
            _names.Enter(part, items[i], null);
            _names.Note(_at + (i * sizeof(T)), _objectAt, name, new StateKind<T>());
        }

        Raw(lanes, count * sizeof(T));
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Note<T>(string name)
        where T : unmanaged => _names!.Note(_at, _objectAt, name, new StateKind<T>());
}
