using System;
using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>The contacts between two geoms (manual: "Narrow phase").</summary>
/// <example>
/// <code>
/// geom.OnCollision += (own, met, contacts) =&gt;
/// {
///     Console.WriteLine(contacts.Count + " points");
///     return true;
/// };
/// </code>
/// </example>
public class ContactList : List<Contact>
{
    /// <summary>Makes an empty list.</summary>
    /// <param name="capacity">The number of contacts to hold without growing; 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is negative.</exception>
    public ContactList(int capacity)
        : base(Require.AtLeast(capacity, 0, nameof(capacity)))
    {
    }

    /// <summary>Makes a list of the same contacts as another.</summary>
    /// <param name="contactList">The list to copy.</param>
    /// <exception cref="ArgumentNullException"><paramref name="contactList"/> is null.</exception>
    public ContactList(ContactList contactList)
        : base(Require.NotNull(contactList, nameof(contactList)))
    {
    }

    /// <summary>Finds a contact by its name (<see cref="ContactId"/>), without allocating.</summary>
    /// <param name="contact">The contact to look for; its position and normal do not matter.</param>
    /// <returns>The index of the first contact that equals it, or -1.</returns>
    public int IndexOfSafe(Contact contact)
    {
        for (var i = 0; i < Count; i++)
        {
            if (this[i].Equals(contact))
            {
                return i;
            }
        }

        return -1;
    }
}
