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
        _sweepPlace.EnsureCapacity(Bodies.Ids.End);
        _sweepKeys.EnsureCapacity(2 * _contacts.Records.Capacity);
        _sweepSort.Reserve(2 * _contacts.Records.Capacity);
        for (int i = 0; i < Bodies.Ids.End; i++)
        {
            _sweepPlace[i] = -1;
        }

        for (int i = 0; i < fast.Count; i++)
        {
            _sweepPlace[fast[i].Body] = i;
        }

        int count = 0;
        for (int i = 0; i < _contacts.End; i++)
        {
            ref ContactRecord record = ref _contacts.Records[i];
            if (record.PieceA < 0)
            {
                continue;
            }

            int placeA = _sweepPlace[record.BodyA];
            int placeB = _sweepPlace[record.BodyB];
            if ((placeA < 0 && placeB < 0) || !Responds(record))
            {
                continue;
            }

            if (placeA >= 0 && (!IsMovable(record.BodyB) || IsBullet(record.BodyA)))
            {
                _sweepKeys[count++] = ((ulong)(uint)placeA << 32) | (uint)i;
            }

            if (placeB >= 0 && (!IsMovable(record.BodyA) || IsBullet(record.BodyB)))
            {
                _sweepKeys[count++] = ((ulong)(uint)placeB << 32) | (uint)i;
            }
        }

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
}
