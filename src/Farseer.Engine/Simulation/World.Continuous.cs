using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Continuous;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>The sweep of fast bodies along the way that they took.</summary>
internal sealed partial class World : IImpactListener
{
    private readonly FastBodySweep _sweep = new FastBodySweep();
    private readonly RadixSort _sweepSort = new RadixSort();
    private readonly Column<int> _sweepPlace = new Column<int>();
    private readonly Column<SweepRoles> _sweepRoles = new Column<SweepRoles>();
    private readonly Column<ulong> _sweepKeys = new Column<ulong>();

    bool IImpactListener.OnImpact(int contact, in Manifold manifold) =>
        _events.RaiseImpact(this, _contacts, contact, manifold);

    private unsafe void SweepFastBodies(float dt, float substep)
    {
        SweepInput input;
        input.Bodies = Bodies;
        input.Shapes = Shapes;
        input.Contacts = _contacts;
        input.Joints = Joints;
        input.Settings = Settings;
        input.Listener = this;
        input.Dt = dt;
        input.Substep = substep;
        ForgetBeyond();
        FastList fast = _lists.Fast;
        int count = GatherSweepPairs(fast);
        int next = 0;
        for (int i = 0; i < fast.Count; i++)
        {
            _sweep.Begin();
            for (; next < count && (int)(_sweepKeys[next] >> 32) == i; next++)
            {
                int contact = (int)(uint)_sweepKeys[next];
                ref ContactRecord record = ref _contacts.Records[contact];
                _sweep.Add(contact, IsMovable(record.BodyA == fast[i].Body ? record.BodyB : record.BodyA));
            }

            FastMotion motion = fast[i];
            const BodyFlags Both = BodyFlags.Alive | BodyFlags.Enabled;
            if ((Bodies.Flags[motion.Body] & Both) == Both)
            {
                _sweep.Run(input, motion);
            }
        }
    }

    /// <summary>The pairs of fast bodies with what they are looked after against, by body.</summary>
    private unsafe int GatherSweepPairs(FastList fast)
    {
        int end = Bodies.Ids.End;
        _sweepPlace.EnsureCapacity(end);
        _sweepRoles.EnsureCapacity(end);
        SweepRoles* roles = _sweepRoles.Pointer;
        for (int i = 0; i < end; i++)
        {
            roles[i] = IsMovable(i) ? SweepRoles.None : SweepRoles.Wall;
        }

        for (int i = 0; i < fast.Count; i++)
        {
            int body = fast[i].Body;
            _sweepPlace[body] = i;
            roles[body] |= IsBullet(body) ? SweepRoles.Fast | SweepRoles.Bullet : SweepRoles.Fast;
        }

        int count = 0;
        ContactRecord* records = _contacts.Records.Pointer;
        for (int i = 0; i < _contacts.End; i++)
        {
            ContactRecord* record = records + i;
            if (record->PieceA < 0)
            {
                continue;
            }

            SweepRoles a = roles[record->BodyA];
            SweepRoles b = roles[record->BodyB];
            bool forA = (a & SweepRoles.Bullet) != 0 || ((a & SweepRoles.Fast) != 0 && (b & SweepRoles.Wall) != 0);
            bool forB = (b & SweepRoles.Bullet) != 0 || ((b & SweepRoles.Fast) != 0 && (a & SweepRoles.Wall) != 0);
            if (!(forA || forB) || !Responds(*record))
            {
                continue;
            }

            _sweepKeys.EnsureCapacity(count + 2);
            if (forA)
            {
                _sweepKeys[count++] = ((ulong)(uint)_sweepPlace[record->BodyA] << 32) | (uint)i;
            }

            if (forB)
            {
                _sweepKeys[count++] = ((ulong)(uint)_sweepPlace[record->BodyB] << 32) | (uint)i;
            }
        }

        _sweepSort.Reserve(count);
        _sweepSort.Sort(_sweepKeys.Pointer, count);
        return count;
    }

    private bool IsMovable(int body) => (Bodies.Flags[body] & (BodyFlags.Static | BodyFlags.Kinematic)) == 0;

    private bool IsBullet(int body) => (Bodies.Flags[body] & BodyFlags.Bullet) != 0;

    private bool Responds(in ContactRecord record)
    {
        ColliderFlags both = Shapes.Colliders[record.ColliderA].Flags & Shapes.Colliders[record.ColliderB].Flags;
        return (both & (ColliderFlags.Alive | ColliderFlags.ResponseEnabled)) == (ColliderFlags.Alive | ColliderFlags.ResponseEnabled);
    }

    /// <summary>What a body is in the sweep.</summary>
    [Flags]
    private enum SweepRoles : byte
    {
        None = 0,

        /// <summary>Must not be passed.</summary>
        Wall = 1,
        Fast = 2,

        /// <summary>Fast, and must pass nothing.</summary>
        Bullet = 4,
    }
}
