using System;
using System.Collections.Generic;
using Box2D.Collision.Shapes;
using Box2D.Dynamics.Contacts;
using Farseer.Engine.Storage;

namespace Box2D.Bridge;

/// <summary>All contacts, newest first, and where to find that of two colliders.</summary>
internal sealed class ContactBook
{
    /// <summary>Contacts to begin with.</summary>
    private const int LeastSpares = 16;

    private readonly Dictionary<ulong, b2Contact> _byPair = new Dictionary<ulong, b2Contact>();

    /// <summary>Ended contacts, accepted and refused ones, for those to come: steps are not to allocate.</summary>
    [NotState(Why.Room)]
    private readonly Stack<b2Contact> _spare = new Stack<b2Contact>();
    [NotState(Why.Room)]
    private readonly Stack<b2Contact> _spareRefused = new Stack<b2Contact>();

    public b2Contact? First { get; private set; }

    public int Count => _byPair.Count;

    public static ulong Key(int colliderA, int colliderB) => colliderA < colliderB
        ? ((ulong)(uint)colliderA << 32) | (uint)colliderB
        : ((ulong)(uint)colliderB << 32) | (uint)colliderA;

    public b2Contact? Find(int colliderA, int colliderB) =>
        _byPair.TryGetValue(Key(colliderA, colliderB), out b2Contact? contact) ? contact : null;

    public b2Contact Add(b2Shape shapeA, b2Shape shapeB, bool accepted)
    {
        (b2Shape first, b2Shape second) = IsSwapped(shapeA, shapeB) ? (shapeB, shapeA) : (shapeA, shapeB);
        Stack<b2Contact> spare = accepted ? _spare : _spareRefused;
        if (spare.Count == 0)
        {
            // As many again as there are: one by one, bodies that bounce about would allocate whenever more of them are near each other
            // than ever before.
            for (int more = Math.Max(LeastSpares, Count); more > 0; more--)
            {
                spare.Push(accepted ? new b2Contact(first, second) : new b2NullContact(first, second));
            }
        }

        b2Contact contact = spare.Pop();
        contact.Begin(first, second);
        contact.Key = Key(shapeA.Link.Collider.Index, shapeB.Link.Collider.Index);
        contact.Next = First;
        if (First is not null)
        {
            First.Previous = contact;
        }

        First = contact;
        _byPair.Add(contact.Key, contact);
        return contact;
    }

    public void Remove(b2Contact contact)
    {
        _byPair.Remove(contact.Key);
        if (contact.Previous is null)
        {
            First = contact.Next;
        }
        else
        {
            contact.Previous.Next = contact.Next;
        }

        if (contact.Next is not null)
        {
            contact.Next.Previous = contact.Previous;
        }

        (contact.IsAccepted ? _spare : _spareRefused).Push(contact);
    }

    /// <summary>As in the original a polygon comes before a circle; otherwise the older shape comes first.</summary>
    private static bool IsSwapped(b2Shape a, b2Shape b) => a.GetType() == b2Shape.e_circleShape && b.GetType() == b2Shape.e_polygonShape;

    /// <summary>
    /// Writes, or reads, the contacts. Which object stands for a contact is not kept: they are used again and again as bodies come and go.
    /// </summary>
    public void Visit(StateStream s)
    {
        int count = s.Value(Count);
        if (s.IsReading)
        {
            while (First is not null)
            {
                Remove(First);
            }
        }

        // The last one first, for each comes in before the others.
        b2Contact? contact = First;
        while (contact?.Next is not null)
        {
            contact = contact.Next;
        }

        for (int i = 0; i < count; i++)
        {
            b2Shape shape1 = s.Reference(contact?.Shape1)!;
            b2Shape shape2 = s.Reference(contact?.Shape2)!;
            bool accepted = s.Value(contact is not null && contact.IsAccepted);
            b2Contact visited = s.IsReading ? Add(shape1, shape2, accepted) : contact!;
            visited.WasNear = s.Value(visited.WasNear);
            visited.Points.Visit(s);
            contact = s.IsReading ? null : visited.Previous;
        }
    }
}
