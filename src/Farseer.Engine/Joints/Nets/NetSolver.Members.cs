using System;
using System.Runtime.InteropServices;
using Farseer.Engine.Constraints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Nets;

/// <content>Which joints have rows, and what they did.</content>
internal sealed unsafe partial class NetSolver
{
    private readonly NetSearch _search = new NetSearch();
    private readonly Column<NetPlace> _places = new Column<NetPlace>();
    private readonly Column<byte> _wanted = new Column<byte>();
    private readonly IndexList _members = new IndexList();
    private readonly JointKinds _kinds = new JointKinds();
    private int _end;

    /// <summary>The bodies that belong to nets, as of <see cref="Renew"/>: no joint between them is an edge of a tree.</summary>
    public NetSearch Search => _search;

    /// <summary>The joint has a row here.</summary>
    public bool Has(int joint) => joint < _end && _places[joint].Held && _places[joint].Order == _store.Links[joint].Order;

    /// <summary>
    /// Finds the nets among the joints that act. Rows of joints that still belong to one stay where they are, with their colours; only
    /// what changed comes and goes.
    /// </summary>
    /// <param name="order">The joints that act, in their order.</param>
    /// <param name="count">How many.</param>
    /// <param name="moves">1 for a body that can move.</param>
    /// <param name="bodyEnd">One past the highest body.</param>
    public void Renew(int* order, int count, byte* moves, int bodyEnd)
    {
        FindNets(order, count, moves, bodyEnd);
        if (!_search.Any && _members.Count == 0)
        {
            return;
        }

        _bodyColors.EnsureBodies(bodyEnd);
        _bodies.EnsureBodies(bodyEnd);
        int end = _store.Ids.End;
        _places.EnsureCapacity(end);
        _wanted.EnsureCapacity(end);
        _end = Math.Max(_end, end);
        for (int joint = 0; joint < _end; joint++)
        {
            _wanted[joint] = 0;
        }

        for (int i = 0; i < count; i++)
        {
            _wanted[order[i]] = Wanted(order[i], moves);
        }

        for (int joint = 0; joint < _end; joint++)
        {
            if (_places[joint].Held && (_places[joint].Moves != _wanted[joint] || _places[joint].Order != _store.Links[joint].Order))
            {
                Remove(joint);
            }
        }

        _members.Clear();
        for (int i = 0; i < count; i++)
        {
            int joint = order[i];
            if (_wanted[joint] != 0)
            {
                _members.Add(joint);
                if (!_places[joint].Held)
                {
                    Add(joint, _wanted[joint]);
                }
            }
        }

        _bodies.List();
    }

    /// <summary>Settings or flags of a joint changed.</summary>
    /// <param name="joint">Its index.</param>
    /// <param name="afresh">It was switched: it starts without impulses.</param>
    public void Edited(int joint, bool afresh)
    {
        if (!Has(joint))
        {
            return;
        }

        NetPlace place = _places[joint];
        NetColor color = _colors[place.Color];
        ReadAnchors(joint, ref color.AnchorsOf(place.Row));
        if (afresh)
        {
            NetBundle* row = color.BundleOf(place.Row);
            int lane = color.LaneOf(place.Row);
            row->ImpulseX[lane] = 0;
            row->ImpulseY[lane] = 0;
            row->SumX[lane] = 0;
            row->SumY[lane] = 0;
            row->StartX[lane] = 0;
            row->StartY[lane] = 0;
        }

        _store.Changed |= !IsPivot(joint);
    }

    /// <summary>Writes what a joint did in the last step to the store, where readers look for it.</summary>
    public void Report(int joint)
    {
        if (!Has(joint))
        {
            return;
        }

        NetPlace place = _places[joint];
        NetBundle* row = _colors[place.Color].BundleOf(place.Row);
        int lane = _colors[place.Color].LaneOf(place.Row);
        ref JointState state = ref _store.States[joint];
        double inverse = row->Response[lane] > 0 ? 1 / row->Response[lane] : 0;
        double x = row->ImpulseX[lane] * inverse;
        double y = row->ImpulseY[lane] * inverse;
        state.Impulse[0] = x;
        state.Impulse[1] = y;
        double errorX = row->StartX[lane];
        double errorY = row->StartY[lane];
        state.Error = Math.Sqrt((errorX * errorX) + (errorY * errorY));

        // The sum lacks the impulse of the last substep. A pivot has no moment about its anchor.
        double perStep = _step.Dt > 0 ? 1 / _step.Dt : 0;
        state.ForceX = ((row->SumX[lane] * inverse) + x) * perStep;
        state.ForceY = ((row->SumY[lane] * inverse) + y) * perStep;
        state.Torque = 0;
    }

    private void FindNets(int* order, int count, byte* moves, int bodyEnd)
    {
        JointRows rows = default;
        JointFrame frame = default;
        frame.Dt = 1;
        frame.H = 1;
        _search.Begin(bodyEnd);
        for (int i = 0; i < count; i++)
        {
            ref JointLink link = ref _store.Links[order[i]];
            if ((moves[link.BodyA] & moves[link.BodyB]) != 0)
            {
                // How many rows there are does not depend on the poses.
                rows.Count = 0;
                rows.Hard = 0;
                _kinds.Of(link.Kind).Write(frame, _store.Settings[order[i]], _store.Flags[order[i]], ref rows);
                if (rows.Hard > 0)
                {
                    _search.Tie(link.BodyA, link.BodyB);
                }
            }
        }

        _search.End();
    }

    /// <summary>0, or which bodies move, if the joint is a pivot of a net.</summary>
    private byte Wanted(int joint, byte* moves)
    {
        ref JointLink link = ref _store.Links[joint];
        int which = moves[link.BodyA] | (moves[link.BodyB] << 1);
        bool ofNet = (moves[link.BodyA] != 0 && _search.IsNet(link.BodyA)) || (moves[link.BodyB] != 0 && _search.IsNet(link.BodyB));
        return ofNet && IsPivot(joint) ? (byte)which : (byte)0;
    }

    // What may break by its error needs the errors that it would have had, which the scalar rows account for.
    private bool IsPivot(int joint)
    {
        ref JointSettings settings = ref _store.Settings[joint];
        return double.IsInfinity(settings.Breakpoint) && double.IsInfinity(settings.BreakForce)
            && _kinds.Of(_store.Links[joint].Kind).IsPivot(settings, _store.Flags[joint]);
    }

    private void Add(int joint, byte moves)
    {
        ref JointLink link = ref _store.Links[joint];
        bool movesA = (moves & 1) != 0;
        bool movesB = (moves & 2) != 0;
        int index = _bodyColors.Choose(link.BodyA, link.BodyB, movesA, movesB);
        NetColor color = _colors[index];
        int place = color.AddRow();
        NetBundle* row = color.BundleOf(place);
        int lane = color.LaneOf(place);
        row->BodyA[lane] = link.BodyA;
        row->BodyB[lane] = link.BodyB;
        row->Joint[lane] = joint;
        ReadAnchors(joint, ref color.AnchorsOf(place));

        // Impulses in terms of a response of 1, which the start of the step turns into that of the bodies.
        row->Response[lane] = 1;
        row->ImpulseX[lane] = (float)_store.States[joint].Impulse[0];
        row->ImpulseY[lane] = (float)_store.States[joint].Impulse[1];
        row->StartX[lane] = (float)_store.States[joint].Error;
        _bodyColors.Mark(link.BodyA, index, movesA);
        _bodyColors.Mark(link.BodyB, index, movesB);
        _bodies.Count(link.BodyA, 1);
        _bodies.Count(link.BodyB, 1);
        _places[joint] = new NetPlace { Held = true, Color = index, Row = place, Order = link.Order, Moves = moves };
    }

    private void Remove(int joint)
    {
        Report(joint);
        NetPlace place = _places[joint];
        NetColor color = _colors[place.Color];
        NetBundle* row = color.BundleOf(place.Row);
        int lane = color.LaneOf(place.Row);
        _bodyColors.Unmark(row->BodyA[lane], place.Color);
        _bodyColors.Unmark(row->BodyB[lane], place.Color);
        _bodies.Count(row->BodyA[lane], -1);
        _bodies.Count(row->BodyB[lane], -1);
        int moved = color.RemoveRow(place.Row);
        if (moved >= 0)
        {
            _places[moved].Row = place.Row;
        }

        _places[joint] = default;
    }

    private void ReadAnchors(int joint, ref NetAnchors anchors)
    {
        ref JointSettings settings = ref _store.Settings[joint];
        anchors.AX = settings.AnchorAX;
        anchors.AY = settings.AnchorAY;
        anchors.BX = settings.AnchorBX;
        anchors.BY = settings.AnchorBY;
    }

    /// <summary>Where the row of a joint is.</summary>
    [StructLayout(LayoutKind.Sequential)]
    private struct NetPlace
    {
        public int Color;
        public int Row;

        /// <summary>Of the joint, which is unlike that of every other that had its index before.</summary>
        public int Order;

        /// <summary>Which bodies move.</summary>
        public byte Moves;
        public bool Held;
    }
}
