using System.Runtime.InteropServices;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

/// <summary>
/// The pairs that sleep, listed at both of their bodies: what wakes a body finds them there at once. Lists are linked both ways, so a
/// pair leaves in O(1).
/// </summary>
internal sealed class DormantContacts
{
    // Entries and contacts are stored plus one, so that new memory is an empty list.
    private readonly Column<int> _first = new Column<int>();
    private readonly Column<Links> _links = new Column<Links>();

    /// <summary>First pair of a body, times two plus the side (0 A, 1 B); -1: none.</summary>
    public int First(int body) => body < _first.Capacity ? _first[body] - 1 : -1;

    /// <summary>Next pair of the same body.</summary>
    public int Next(int entry) => Side(entry).Next - 1;

    /// <summary>
    /// Makes room for so many contacts and bodies, so that a pile that falls asleep bit by bit does not allocate each time.
    /// </summary>
    public void Reserve(int contacts, int bodies)
    {
        _links.EnsureCapacity(contacts);
        _first.EnsureCapacity(bodies);
    }

    public void Add(int contact, in ContactRecord record)
    {
        Link(record.BodyA, contact * 2);
        Link(record.BodyB, (contact * 2) + 1);
    }

    public void Remove(int contact, in ContactRecord record)
    {
        Unlink(record.BodyA, contact * 2);
        Unlink(record.BodyB, (contact * 2) + 1);
    }

    private ref Ends Side(int entry)
    {
        ref Links links = ref _links[entry >> 1];
        return ref (entry & 1) == 0 ? ref links.A : ref links.B;
    }

    private void Link(int body, int entry)
    {
        int first = _first[body];
        Side(entry) = new Ends { Next = first };
        if (first > 0)
        {
            Side(first - 1).Previous = entry + 1;
        }

        _first[body] = entry + 1;
    }

    private void Unlink(int body, int entry)
    {
        Ends ends = Side(entry);
        if (ends.Next > 0)
        {
            Side(ends.Next - 1).Previous = ends.Previous;
        }

        if (ends.Previous > 0)
        {
            Side(ends.Previous - 1).Next = ends.Next;
        }
        else
        {
            _first[body] = ends.Next;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    private struct Ends
    {
        public int Next;
        public int Previous;
    }

    [StructLayout(LayoutKind.Sequential)]
    private struct Links
    {
        public Ends A;
        public Ends B;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_first);
        s.Column(_links);
    }
}
