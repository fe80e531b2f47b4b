using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>The contacts of each frame. A contact keeps its slot within a chunk, so that one that rests costs nothing.</summary>
internal sealed class ContactTrack
{
    private const int X = 0;
    private const int Y = 1;
    private const int NormalX = 2;
    private const int NormalY = 3;
    private const int Separation = 4;
    private const int NormalImpulse = 5;
    private const int TangentImpulse = 6;
    private const int IsThere = 7;
    private const int GeomA = 8;
    private const int GeomB = 9;
    private const int MostOfAPair = 64;

    private readonly Dictionary<long, int> _slots = new Dictionary<long, int>();
    private readonly List<Contact> _sorted = new List<Contact>();
    private readonly Comparison<Contact> _alongSurface;

    public ContactTrack() => _alongSurface = static (a, b) => Along(a).CompareTo(Along(b));

    public Track Track { get; } = new Track(
        "contact",
        new ColumnSpec("x", ColumnKind.Single, Digits.Place),
        new ColumnSpec("y", ColumnKind.Single, Digits.Place),
        new ColumnSpec("nx", ColumnKind.Single, Digits.Direction),
        new ColumnSpec("ny", ColumnKind.Single, Digits.Direction),
        new ColumnSpec("separation", ColumnKind.Single, Digits.Depth),
        new ColumnSpec("push", ColumnKind.Single, Digits.Size),
        new ColumnSpec("friction", ColumnKind.Single, Digits.Size),
        new ColumnSpec("there", ColumnKind.Byte),
        new ColumnSpec("a", ColumnKind.Integer),
        new ColumnSpec("b", ColumnKind.Integer));

    public void Record(ArbiterList arbiters, GeomTable geoms)
    {
        Track.Begin(0);
        Track.Clear(IsThere);
        for (int i = 0; i < arbiters.Count; i++)
        {
            Arbiter arbiter = arbiters[i];
            int a = geoms.Find(arbiter.GeomA);
            int b = geoms.Find(arbiter.GeomB);
            if (a < 0 || b < 0)
            {
                continue;
            }

            _sorted.Clear();
            _sorted.AddRange(arbiter.ContactList);
            if (_sorted.Count > 1)
            {
                _sorted.Sort(_alongSurface);
            }

            for (int k = 0; k < _sorted.Count && k < MostOfAPair; k++)
            {
                Take(a, b, k, _sorted[k]);
            }
        }
    }

    /// <summary>The chunk is packed: slots are given out anew.</summary>
    public void Forget() => _slots.Clear();

    // The list is deepest first, which changes from step to step; the order along the surface does not.
    private static float Along(in Contact contact) => Vector2.Dot(contact.Position, new Vector2(contact.Normal.Y, -contact.Normal.X));

    private void Take(int a, int b, int index, in Contact contact)
    {
        long key = unchecked((((long)a << 28) ^ ((long)b << 6)) | (uint)index);
        if (!_slots.TryGetValue(key, out int slot))
        {
            slot = _slots.Count;
            _slots.Add(key, slot);
            Track.Grow(slot + 1);
            Track.Set(slot, GeomA, a);
            Track.Set(slot, GeomB, b);
        }

        Track.Set(slot, X, contact.Position.X);
        Track.Set(slot, Y, contact.Position.Y);
        Track.Set(slot, NormalX, contact.Normal.X);
        Track.Set(slot, NormalY, contact.Normal.Y);
        Track.Set(slot, Separation, contact.Separation);
        Track.Set(slot, NormalImpulse, contact.NormalImpulse);
        Track.Set(slot, TangentImpulse, contact.TangentImpulse);
        Track.Set(slot, IsThere, 1);
    }
}
