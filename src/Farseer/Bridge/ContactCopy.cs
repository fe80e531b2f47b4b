using System;
using System.Numerics;
using Farseer.Engine.Simulation;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Turns the engine's contact points into the documented list.</summary>
internal static class ContactCopy
{
    /// <summary>
    /// Fills <paramref name="list"/> deepest first, at most <paramref name="most"/> contacts; equally deep ones keep their order.
    /// Nothing is allocated once the list has its size.
    /// </summary>
    public static void Fill(ContactList list, ReadOnlySpan<ContactPoint> points, Geom a, Geom b, bool flip, int most)
    {
        list.Clear();
        for (int i = 0; i < points.Length; i++)
        {
            ref readonly ContactPoint point = ref points[i];
            Vector2 normal = flip ? -point.Normal : point.Normal;
            var id = new ContactId(a.Id, (int)point.FeatureId, b.Id);
            var contact = new Contact(new Vector2((float)point.X, (float)point.Y), normal, point.Separation, id);
            contact.SetNormalImpulse(point.NormalImpulse);
            contact.SetTangentImpulse(point.TangentImpulse);
            int place = list.Count;
            while (place > 0 && list[place - 1].Separation > contact.Separation)
            {
                place--;
            }

            list.Insert(place, contact);
        }

        if (list.Count > most)
        {
            list.RemoveRange(most, list.Count - most);
        }
    }
}
