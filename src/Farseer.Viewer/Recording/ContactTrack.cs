using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>
/// The contacts of each frame. A contact keeps its slot within a chunk, and its place and normal are taken in the coordinates of a
/// body that moves, so that one that rests on it costs nothing.
/// </summary>
internal sealed class ContactTrack
{
    public const string Name = "contact";

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
        Name,
        new ColumnSpec("x", ColumnKind.Single, Digits.Length),
        new ColumnSpec("y", ColumnKind.Single, Digits.Length),
        new ColumnSpec("nx", ColumnKind.Single, Digits.Direction),
        new ColumnSpec("ny", ColumnKind.Single, Digits.Direction),
        new ColumnSpec("separation", ColumnKind.Single, Digits.Length),
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

            // The page makes the same choice.
            Body body = arbiter.GeomA.Body.IsStatic ? arbiter.GeomB.Body : arbiter.GeomA.Body;
            Frame frame = new Frame(body);
            for (int k = 0; k < _sorted.Count && k < MostOfAPair; k++)
            {
                Take(a, b, k, _sorted[k], frame);
            }
        }
    }

    /// <summary>The chunk is packed: slots are given out anew.</summary>
    public void Forget() => _slots.Clear();

    // The list is deepest first, which changes from step to step; the order along the surface does not.
    private static float Along(in Contact contact) => Vector2.Dot(contact.Position, new Vector2(contact.Normal.Y, -contact.Normal.X));

    private void Take(int a, int b, int index, in Contact contact, in Frame frame)
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

        frame.Turn(contact.Position.X - frame.X, contact.Position.Y - frame.Y, out double x, out double y);
        Track.Set(slot, X, x);
        Track.Set(slot, Y, y);
        frame.Turn(contact.Normal.X, contact.Normal.Y, out x, out y);
        Track.Set(slot, NormalX, x);
        Track.Set(slot, NormalY, y);
        Track.Set(slot, Separation, contact.Separation);
        Track.Set(slot, NormalImpulse, contact.NormalImpulse);
        Track.Set(slot, TangentImpulse, contact.TangentImpulse);
        Track.Set(slot, IsThere, 1);
    }

    /// <summary>The coordinates of a body.</summary>
    private readonly struct Frame
    {
        private readonly double _cos;
        private readonly double _sin;

        public Frame(Body body)
        {
            body.GetPosition(out double x, out double y);
            body.GetTotalRotation(out double angle);
            X = x;
            Y = y;
            _cos = Math.Cos(angle);
            _sin = Math.Sin(angle);
        }

        public double X { get; }

        public double Y { get; }

        public void Turn(double x, double y, out double localX, out double localY)
        {
            localX = (_cos * x) + (_sin * y);
            localY = (_cos * y) - (_sin * x);
        }
    }
}
