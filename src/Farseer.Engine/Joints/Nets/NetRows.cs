using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Nets;

/// <summary>Forms of joints that have rows on lanes.</summary>
internal enum NetForm : byte
{
    /// <summary>None: its rows are iterated one by one.</summary>
    None,

    /// <summary>Two anchors in one place.</summary>
    Pivot,

    /// <summary>Two anchors in one place, without turning.</summary>
    Weld,

    /// <summary>Two anchors at a distance.</summary>
    Rod,
}

/// <summary>What the passes of a substep work on.</summary>
internal readonly unsafe struct NetMotion
{
    public readonly BodyState* States;
    public readonly BodyMotion* Motions;

    public NetMotion(BodyStore bodies)
    {
        States = bodies.State.Pointer;
        Motions = bodies.Motion.Pointer;
    }
}

/// <summary>
/// The joints of one form and colour: no two share a body that can move, so a bundle's lanes never meet. Every pass takes a run of
/// bundles, so that several workers can share one.
/// </summary>
internal abstract unsafe class NetRows
{
    private readonly Column<byte> _memory = new Column<byte>();
    // Null until there is a row: most colours of most worlds never have one.
    private Column<NetAnchors>? _anchors;
    private readonly int _lanesUsed;
    private readonly int _size;

    /// <param name="size">Bytes of a bundle, which begins with <see cref="NetEnds"/> and is all columns of lanes.</param>
    /// <param name="sequential">True for the overflow, whose joints may share bodies: one filled lane a bundle.</param>
    protected NetRows(int size, bool sequential)
    {
        _size = size;
        _lanesUsed = sequential ? 1 : NetEnds.Lanes;
    }

    /// <summary>
    /// Workers may share a pass. Rows of the overflow may share bodies, and those at something that cannot move share that: they are few.
    /// </summary>
    public bool IsShared { get; set; }

    public int RowCount { get; private set; }

    public int BundleCount => (RowCount + _lanesUsed - 1) / _lanesUsed;

    public NetEnds* EndsOf(int row) => (NetEnds*)(Memory + ((row / _lanesUsed) * (long)_size));

    public int LaneOf(int row) => row % _lanesUsed;

    public ref NetAnchors AnchorsOf(int row) => ref _anchors![row];

    protected byte* Memory => _memory.Pointer;

    /// <summary>
    /// Arms, errors and masses of some bundles at the start of the step; impulses are those of a substep of another length.
    /// </summary>
    public void Place(int first, int count, NetPose* poses, float impulseScale)
    {
        int end = (first + count) * _lanesUsed;
        PlaceRows(first * _lanesUsed, end < RowCount ? end : RowCount, poses, impulseScale);
    }

    /// <summary>Errors of the rows came from outside, and are to go by displacements.</summary>
    public bool Disturbed { get; set; }

    /// <summary>Arms and errors where the step begins.</summary>
    /// <param name="first">The first bundle.</param>
    /// <param name="count">How many.</param>
    /// <param name="motion">The bodies.</param>
    /// <param name="keep">Share of the errors of the last step that remain errors of motion.</param>
    /// <returns>True if any error came from outside.</returns>
    public abstract bool Begin(int first, int count, in NetMotion motion, float keep);

    public abstract void WarmStart(int first, int count, in NetMotion motion);

    public abstract void Solve(int first, int count, in NetMotion motion, in NetSoftness softness);

    public abstract void TurnAndRelax(int first, int count, in NetMotion motion);

    /// <summary>One sweep of velocities that take out what came from outside, of which nothing is kept.</summary>
    public abstract void Pull(int first, int count, in NetMotion motion, in NetSoftness softness);

    /// <summary>Arms and errors where the bodies are now.</summary>
    /// <param name="first">The first bundle.</param>
    /// <param name="count">How many.</param>
    /// <param name="motion">The bodies.</param>
    /// <param name="displaced">They have been displaced since the last time.</param>
    public abstract void Turn(int first, int count, in NetMotion motion, bool displaced);

    /// <summary>Takes over the impulses of the last substep, in terms of a response of 1, and the error.</summary>
    public abstract void Take(int row, in JointState state);

    /// <summary>What the joint did in the last step.</summary>
    public abstract void Report(int row, ref JointState state, double dt);

    /// <summary>Appends an empty row; the caller fills it.</summary>
    public int AddRow()
    {
        int row = RowCount++;
        (_anchors ??= new Column<NetAnchors>()).EnsureCapacity(RowCount);
        if (LaneOf(row) == 0)
        {
            _memory.EnsureCapacity(BundleCount * _size);
            NetEnds* bundle = EndsOf(row);
            Unsafe.InitBlock(bundle, 0, (uint)_size);
            for (int lane = 0; lane < NetEnds.Lanes; lane++)
            {
                bundle->Joint[lane] = -1;
            }
        }

        return row;
    }

    /// <summary>Removes a row; the last one takes its place.</summary>
    /// <returns>The joint that moved into <paramref name="row"/>, or -1.</returns>
    public int RemoveRow(int row)
    {
        int last = RowCount - 1;
        int moved = -1;
        int* from = (int*)EndsOf(last) + LaneOf(last);
        if (row != last)
        {
            int* to = (int*)EndsOf(row) + LaneOf(row);
            for (int i = 0; i < _size / sizeof(int); i += NetEnds.Lanes)
            {
                to[i] = from[i];
            }

            AnchorsOf(row) = AnchorsOf(last);
            moved = EndsOf(row)->Joint[LaneOf(row)];
        }

        // Both ends of an empty lane are the dummy body, which nothing moves: its row finds no speed and gives no impulse.
        for (int i = 0; i < _size / sizeof(int); i += NetEnds.Lanes)
        {
            from[i] = 0;
        }

        EndsOf(last)->Joint[LaneOf(last)] = -1;
        RowCount = last;
        return moved;
    }

    /// <summary>What makes an impulse of a lane, a speed, an impulse again; 0 where nothing can be moved.</summary>
    protected static double InverseResponse(NetEnds* e, int lane) => e->Response[lane] > 0 ? 1 / (double)e->Response[lane] : 0;

    protected abstract void PlaceRows(int from, int to, NetPose* poses, float impulseScale);

    /// <summary>Writes what all forms have: the arms in the middle of the step and the shares of the bodies.</summary>
    /// <returns>The factor by which impulses change.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    protected static float PlaceEnds(
        NetEnds* e, int lane, NetPose* poses, in NetAnchors anchors, float impulseScale, out double x, out double y)
    {
        NetPose* a = poses + e->BodyA[lane];
        NetPose* b = poses + e->BodyB[lane];
        double ax = (a->Cos * anchors.AX) - (a->Sin * anchors.AY);
        double ay = (a->Sin * anchors.AX) + (a->Cos * anchors.AY);
        double bx = (b->Cos * anchors.BX) - (b->Sin * anchors.BY);
        double by = (b->Sin * anchors.BX) + (b->Cos * anchors.BY);
        e->MiddleAX[lane] = (float)ax;
        e->MiddleAY[lane] = (float)ay;
        e->MiddleBX[lane] = (float)bx;
        e->MiddleBY[lane] = (float)by;
        x = (b->X - a->X) + (bx - ax);
        y = (b->Y - a->Y) + (by - ay);

        float response = a->InverseMass + b->InverseMass;
        float inverse = response > 0 ? 1 / response : 0;
        float scale = e->Response[lane] > 0 ? impulseScale * (response / e->Response[lane]) : 0;
        e->Response[lane] = response;
        e->ShareA[lane] = a->InverseMass * inverse;
        e->ShareB[lane] = b->InverseMass * inverse;
        e->TurnA[lane] = a->InverseInertia * inverse;
        e->TurnB[lane] = b->InverseInertia * inverse;
        return scale;
    }

    /// <summary>Drops all rows: a state is restored that has none.</summary>
    public void Forget() => RowCount = 0;

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        IsShared = s.Value(IsShared);
        RowCount = s.Value(RowCount);
        Disturbed = s.Value(Disturbed);
        if (s.Lacks(_anchors))
        {
            _anchors = new Column<NetAnchors>();
        }

        s.Reference(ref _anchors);
        if (_anchors != null)
        {
            s.Column(_memory);
            s.Column(_anchors);
        }
    }
}
