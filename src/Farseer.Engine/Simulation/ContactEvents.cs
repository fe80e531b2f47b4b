using System;
using System.Numerics;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Tells the facade which pairs of colliders touch and which no longer do. Pieces of the same two colliders make one event.
/// The order is that of the colliders' creation, so it does not depend on broad phase, colours or threads.
/// </summary>
internal sealed unsafe class ContactEvents
{
    private readonly WorldStores _stores;
    private readonly RadixSort _sort = new RadixSort();
    private readonly Column<ContactPoint> _points = new Column<ContactPoint>();
    private readonly Column<int> _contacts = new Column<int>();
    private Column<ulong> _keys = new Column<ulong>();
    private Column<PairOfColliders> _pairs = new Column<PairOfColliders>();
    private Column<ulong> _oldKeys = new Column<ulong>();
    private Column<PairOfColliders> _oldPairs = new Column<PairOfColliders>();
    private readonly Column<PairOfColliders> _woken = new Column<PairOfColliders>();
    private int _oldCount;
    private int _count;
    private int _wokenCount;

    public ContactEvents(WorldStores stores) => _stores = stores;

    /// <summary>Impacts of the sweep that have had listeners so far.</summary>
    public int ImpactsHeard { get; private set; }

    public void Raise(ContactStore contacts, ConstraintGraph graph, bool anyHeard)
    {
        IStepHooks? hooks = _stores.Hooks;
        if (hooks == null || (!anyHeard && _oldCount == 0 && _wokenCount == 0))
        {
            return;
        }

        TakeBackWoken();
        int count = Gather(contacts);
        _count = 0;
        int i = 0;
        int old = 0;
        while (i < count)
        {
            int end = i + 1;
            while (end < count && _keys[end] == _keys[i])
            {
                end++;
            }

            ref ContactRecord first = ref contacts.Records[_contacts[i]];
            var pair = new PairOfColliders { A = _stores.Shapes.ColliderOf(first.PieceA), B = _stores.Shapes.ColliderOf(first.PieceB) };
            int position = _count++;
            _keys[position] = _keys[i];
            _pairs[position] = pair;
            while (old < _oldCount && _oldKeys[old] < _keys[i])
            {
                old++;
            }

            bool began = old == _oldCount || _oldKeys[old] != _keys[i] || _oldPairs[old].Gone;
            ContactAnswer answer = RaiseContact(contacts, graph, hooks, i, end, pair, began);
            if (answer == ContactAnswer.Untold && began)
            {
                // What was told of in an earlier step still parts, when its collider is taken out.
                _pairs[position].Gone = true;
            }
            else if (answer != ContactAnswer.Respond && _stores.Settings.SeparateUntouchedPairs)
            {
                _pairs[position].Gone = true;
                _pairs[position].Refused = true;
            }

            i = end;
        }

        RaiseRefused(hooks);
        RaiseSeparations(hooks, _count);
        (_keys, _oldKeys) = (_oldKeys, _keys);
        (_pairs, _oldPairs) = (_oldPairs, _pairs);
        _oldCount = _count;
        _count = 0;
    }

    /// <summary>Pairs asleep neither touch anew nor part: they are left out until they wake.</summary>
    public void LeaveOut()
    {
        int kept = 0;
        for (int i = 0; i < _oldCount; i++)
        {
            PairOfColliders pair = _oldPairs[i];
            if (!_stores.Bodies.IsStill(_stores.Shapes.Colliders[pair.A].Body)
                || !_stores.Bodies.IsStill(_stores.Shapes.Colliders[pair.B].Body))
            {
                _oldKeys[kept] = _oldKeys[i];
                _oldPairs[kept++] = pair;
            }
        }

        _oldCount = kept;
    }

    /// <summary>A pair wakes: listeners have heard that it touches, if it does.</summary>
    public void Woke(in ContactRecord record)
    {
        if ((record.Flags & ContactFlags.Heard) != 0 && IsReported(record))
        {
            _woken.EnsureCapacity(_wokenCount + 1);
            _woken[_wokenCount++] =
                new PairOfColliders { A = _stores.Shapes.ColliderOf(record.PieceA), B = _stores.Shapes.ColliderOf(record.PieceB) };
        }
    }

    /// <summary>A collider goes: the pairs of it that touched separate.</summary>
    public void ColliderRemoved(int collider)
    {
        // Within the raising of events the pair may stand in the list of this step, of the last one, or in both.
        for (int i = 0; i < _count; i++)
        {
            Part(ref _pairs[i], collider, true);
        }

        for (int i = 0; i < _oldCount; i++)
        {
            Part(ref _oldPairs[i], collider, !IsIn(_keys, _count, _oldKeys[i]));
        }

        for (int i = 0; i < _wokenCount; i++)
        {
            Part(ref _woken[i], collider, IsFirstOfItsPair(i));
        }
    }

    /// <summary>Pieces of the same two colliders wake as several pairs, which are one event.</summary>
    private bool IsFirstOfItsPair(int woken)
    {
        for (int i = 0; i < woken; i++)
        {
            if (_woken[i].A == _woken[woken].A && _woken[i].B == _woken[woken].B)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Puts the woken pairs among those of the last step, in their order.</summary>
    private void TakeBackWoken()
    {
        if (_wokenCount == 0)
        {
            return;
        }

        int all = _oldCount + _wokenCount;
        Reserve(all);
        for (int i = 0; i < _oldCount; i++)
        {
            _contacts[i] = i;
            _keys[i] = _oldKeys[i];
            _pairs[i] = _oldPairs[i];
        }

        for (int i = 0; i < _wokenCount; i++)
        {
            PairOfColliders pair = _woken[i];
            _contacts[_oldCount + i] = _oldCount + i;
            _keys[_oldCount + i] = Key(pair.A, pair.B);
            _pairs[_oldCount + i] = pair;
        }

        _sort.Sort(_keys.Pointer, _contacts.Pointer, all);
        _oldCount = 0;
        for (int i = 0; i < all; i++)
        {
            if (_oldCount == 0 || _oldKeys[_oldCount - 1] != _keys[i])
            {
                _oldKeys[_oldCount] = _keys[i];
                _oldPairs[_oldCount++] = _pairs[_contacts[i]];
            }
        }

        _wokenCount = 0;
    }

    /// <summary>
    /// An impact that was found on the way of a fast body. Its listeners are told once a step, and of the parting in the next step
    /// as of any other.
    /// </summary>
    /// <returns>False if a handler cancelled the response.</returns>
    public bool RaiseImpact(ContactStore contacts, int contact, in Manifold manifold)
    {
        ref ContactRecord record = ref contacts.Records[contact];
        record.Flags |= ContactFlags.Touching;
        var pair = new PairOfColliders { A = _stores.Shapes.ColliderOf(record.PieceA), B = _stores.Shapes.ColliderOf(record.PieceB) };
        IStepHooks? hooks = _stores.Hooks;
        if (hooks == null || !(Wants(pair, ColliderFlags.WantsContact) || Wants(pair, ColliderFlags.WantsSeparation)))
        {
            return true;
        }

        record.Flags |= ContactFlags.Due;
        ImpactsHeard++;
        ulong key = Key(record);
        int place = 0;
        while (place < _oldCount && _oldKeys[place] < key)
        {
            place++;
        }

        if (place < _oldCount && _oldKeys[place] == key)
        {
            return (record.Flags & ContactFlags.Vetoed) == 0;
        }

        Reserve(_oldCount + 1);
        for (int i = _oldCount; i > place; i--)
        {
            _oldKeys[i] = _oldKeys[i - 1];
            _oldPairs[i] = _oldPairs[i - 1];
        }

        _oldKeys[place] = key;
        _oldPairs[place] = pair;
        _oldCount++;
        if (!Wants(pair, ColliderFlags.WantsContact))
        {
            return true;
        }

        _points.EnsureCapacity(2);
        int points = WritePoints(_stores.Bodies, record, manifold, _points.Pointer);
        ContactAnswer answer = hooks.OnContact(pair.A, pair.B, new ReadOnlySpan<ContactPoint>(_points.Pointer, points), began: true);
        _oldPairs[place].Gone |= answer == ContactAnswer.Untold;
        bool accepted = answer == ContactAnswer.Respond;
        contacts.Records[contact].Flags = accepted
            ? contacts.Records[contact].Flags & ~ContactFlags.Vetoed
            : contacts.Records[contact].Flags | ContactFlags.Vetoed;
        return accepted;
    }

    private void Part(ref PairOfColliders pair, int collider, bool raise)
    {
        if (!pair.Gone && (pair.A == collider || pair.B == collider))
        {
            pair.Gone = true;
            if (raise && Wants(pair, ColliderFlags.WantsSeparation))
            {
                _stores.Hooks?.OnSeparation(pair.A, pair.B);
            }
        }
    }

    private static bool IsIn(Column<ulong> keys, int count, ulong key)
    {
        for (int i = 0; i < count; i++)
        {
            if (keys[i] == key)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Writes the points of a contact for a reader, at the poses of the step's start.</summary>
    public static int WritePoints(BodyStore bodies, in ContactRecord record, in Manifold manifold, ContactPoint* target)
    {
        ref BodyPose poseA = ref bodies.Pose[record.BodyA];
        for (int k = 0; k < manifold.Count; k++)
        {
            ManifoldPoint point = k == 0 ? manifold.Point0 : manifold.Point1;
            target[k] = new ContactPoint
            {
                X = poseA.X + point.Anchor.X,
                Y = poseA.Y + point.Anchor.Y,
                Normal = manifold.Normal,
                Separation = point.Separation,
                FeatureId = point.Id,
            };
        }

        return manifold.Count;
    }

    private bool Wants(in PairOfColliders pair, ColliderFlags flag) =>
        ((_stores.Shapes.Colliders[pair.A].Flags | _stores.Shapes.Colliders[pair.B].Flags) & flag) != 0;

    private int Gather(ContactStore contacts)
    {
        int count = 0;
        Reserve(contacts.Records.Capacity);
        for (int i = 0; i < contacts.End; i++)
        {
            ref ContactRecord record = ref contacts.Records[i];
            if (record.PieceA >= 0 && (record.Flags & ContactFlags.Heard) != 0 && !record.IsDormant && IsReported(record))
            {
                _keys[count] = Key(record);
                _contacts[count++] = i;
            }
        }

        _sort.Sort(_keys.Pointer, _contacts.Pointer, count);
        return count;
    }

    private void Reserve(int most)
    {
        _contacts.EnsureCapacity(most);
        _keys.EnsureCapacity(most);
        _pairs.EnsureCapacity(most);
        _oldKeys.EnsureCapacity(most);
        _oldPairs.EnsureCapacity(most);
        _woken.EnsureCapacity(most);
        _sort.Reserve(most);
    }

    // The quirk of the original treats a pair whose boxes overlap as one that separates in every step.
    private bool IsReported(in ContactRecord record)
    {
        if ((record.Flags & ContactFlags.Due) != 0)
        {
            return true;
        }

        return _stores.Settings.SeparateUntouchedPairs
            && Box.Overlap(
                _stores.Shapes.TightBox(record.PieceA, _stores.Bodies.Pose[record.BodyA]),
                _stores.Shapes.TightBox(record.PieceB, _stores.Bodies.Pose[record.BodyB]));
    }

    private ulong Key(in ContactRecord record) => Key(_stores.Shapes.ColliderOf(record.PieceA), _stores.Shapes.ColliderOf(record.PieceB));

    private ulong Key(int colliderA, int colliderB) =>
        ((ulong)(uint)_stores.Shapes.Order[colliderA] << 32) | (uint)_stores.Shapes.Order[colliderB];

    private ContactAnswer RaiseContact(
        ContactStore contacts, ConstraintGraph graph, IStepHooks hooks, int start, int end, in PairOfColliders pair, bool began)
    {
        _points.EnsureCapacity(2 * (end - start));
        int points = 0;
        if ((_stores.Shapes.Colliders[pair.A].Flags & _stores.Shapes.Colliders[pair.B].Flags & ColliderFlags.Alive) == 0)
        {
            return ContactAnswer.Untold;
        }

        for (int i = start; i < end; i++)
        {
            ref ContactRecord record = ref contacts.Records[_contacts[i]];
            if ((record.Flags & ContactFlags.Due) != 0)
            {
                points += WritePoints(_stores.Bodies, record, contacts.Manifolds[_contacts[i]], _points.Pointer + points);
            }
        }

        ContactAnswer answer = points > 0 ? ContactAnswer.Respond : ContactAnswer.Refuse;
        if (points > 0 && Wants(pair, ColliderFlags.WantsContact))
        {
            answer = hooks.OnContact(pair.A, pair.B, new ReadOnlySpan<ContactPoint>(_points.Pointer, points), began);
        }

        for (int i = start; i < end; i++)
        {
            if (answer == ContactAnswer.Respond || points == 0)
            {
                Allow(contacts, graph, _contacts[i]);
            }
            else
            {
                Refuse(contacts, graph, _contacts[i]);
            }
        }

        return answer;
    }

    private static void Allow(ContactStore contacts, ConstraintGraph graph, int contact)
    {
        ref ContactRecord record = ref contacts.Records[contact];
        if ((record.Flags & ContactFlags.Vetoed) != 0)
        {
            record.Flags &= ~ContactFlags.Vetoed;
            if (record.Color >= 0)
            {
                ContactLanes.SetFlags(graph.BundleOf(record.Row), RowArena.LaneOf(record.Row), record.Flags);
            }
        }
    }

    /// <summary>Takes the pair's row out, instead of only muting it: a body without rows flies free, exactly.</summary>
    private static void Refuse(ContactStore contacts, ConstraintGraph graph, int contact)
    {
        ref ContactRecord record = ref contacts.Records[contact];
        record.Flags |= ContactFlags.Vetoed;
        if (record.Color >= 0)
        {
            graph.Remove(ref record, contacts.Records);
            contacts.AddIdle(contact);
        }
    }

    /// <summary>The quirk's separations of pairs without response: as in the original, after all contacts of the step.</summary>
    private void RaiseRefused(IStepHooks hooks)
    {
        for (int i = 0; i < _count; i++)
        {
            PairOfColliders pair = _pairs[i];
            ColliderFlags both = _stores.Shapes.Colliders[pair.A].Flags & _stores.Shapes.Colliders[pair.B].Flags;
            if (pair.Refused && (both & ColliderFlags.Alive) != 0 && Wants(pair, ColliderFlags.WantsSeparation))
            {
                hooks.OnSeparation(pair.A, pair.B);
            }
        }
    }

    /// <summary>Both lists are sorted: what is in the old one only has separated.</summary>
    private void RaiseSeparations(IStepHooks hooks, int pairs)
    {
        int next = 0;
        for (int i = 0; i < _oldCount; i++)
        {
            while (next < pairs && _keys[next] < _oldKeys[i])
            {
                next++;
            }

            bool still = next < pairs && _keys[next] == _oldKeys[i];
            PairOfColliders pair = _oldPairs[i];
            if (!still && !pair.Gone && Wants(pair, ColliderFlags.WantsSeparation))
            {
                hooks.OnSeparation(pair.A, pair.B);
            }
        }
    }

    [StructLayout(LayoutKind.Sequential, Pack = 1)]
    private struct PairOfColliders
    {
        public int A;
        public int B;
        public bool Gone;
        public bool Refused;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_points);
        s.Column(_contacts);
        s.Local(_keys);
        s.Column(_pairs);
        s.Local(_oldKeys);
        s.Column(_oldPairs);
        s.Column(_woken);
        s.Value(ref _oldCount);
        s.Value(ref _count);
        s.Value(ref _wokenCount);
        ImpactsHeard = s.Value(ImpactsHeard);
    }
}
