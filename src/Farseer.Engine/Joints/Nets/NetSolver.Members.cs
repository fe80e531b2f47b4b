using System;
using System.Runtime.InteropServices;
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
        if (!_search.Any && !_bodies.Any)
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
            if (_places[joint].Held && (_places[joint].Wanted != _wanted[joint] || _places[joint].Order != _store.Links[joint].Order))
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

        _bodies.List(_search);
        FindSolved();
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
        NetRows rows = RowsOf(place.List);
        ReadAnchors(joint, ref rows.AnchorsOf(place.Row));
        if (afresh)
        {
            rows.Take(place.Row, default);
        }

        _store.Changed |= FormOf(joint) != place.Form;
    }

    /// <summary>Writes what a joint did in the last step to the store, where readers look for it.</summary>
    public void Report(int joint)
    {
        if (!Has(joint))
        {
            return;
        }

        if (_step.Dt > 0)
        {
            RowsOf(_places[joint].List).Report(_places[joint].Row, ref _store.States[joint], _step.Dt);
        }
    }

    private void FindNets(int* order, int count, byte* moves, int bodyEnd)
    {
        JointRows rows = default;
        JointFrame frame = default;
        frame.PullTime = 1;
        frame.H = 1;
        _search.Begin(bodyEnd);
        for (int i = 0; i < count; i++)
        {
            ref JointLink link = ref _store.Links[order[i]];
            if ((moves[link.BodyA] & moves[link.BodyB]) == 0)
            {
                _search.Anchor(moves[link.BodyA] != 0 ? link.BodyA : link.BodyB);
            }
            else
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

    /// <summary>0, or which bodies move and the form, if the joint is one of a net that has a form on lanes.</summary>
    private byte Wanted(int joint, byte* moves)
    {
        ref JointLink link = ref _store.Links[joint];
        int which = moves[link.BodyA] | (moves[link.BodyB] << 1);
        bool ofNet = (moves[link.BodyA] != 0 && _search.IsNet(link.BodyA)) || (moves[link.BodyB] != 0 && _search.IsNet(link.BodyB));
        NetForm form = ofNet ? FormOf(joint) : NetForm.None;
        return form == NetForm.None ? (byte)0 : (byte)(which | ((int)form << 2));
    }

    // What may break by its error needs the errors that it would have had, which the scalar rows account for.
    private NetForm FormOf(int joint)
    {
        ref JointSettings settings = ref _store.Settings[joint];
        return double.IsInfinity(settings.Breakpoint) && double.IsInfinity(settings.BreakForce)
            ? _kinds.Of(_store.Links[joint].Kind).NetFormOf(settings, _store.Flags[joint])
            : NetForm.None;
    }

    private void Add(int joint, byte wanted)
    {
        ref JointLink link = ref _store.Links[joint];
        bool movesA = (wanted & 1) != 0;
        bool movesB = (wanted & 2) != 0;
        int color = _bodyColors.Choose(link.BodyA, link.BodyB, movesA, movesB);
        NetPlace place = default;
        place.Color = color;
        place.Wanted = wanted;
        place.Order = link.Order;
        place.List = PlaceOf(color, place.Form);
        NetRows rows = RowsOf(place.List);
        place.Row = rows.AddRow();
        NetEnds* ends = rows.EndsOf(place.Row);
        int lane = rows.LaneOf(place.Row);
        ends->BodyA[lane] = link.BodyA;
        ends->BodyB[lane] = link.BodyB;
        ends->Joint[lane] = joint;
        ReadAnchors(joint, ref rows.AnchorsOf(place.Row));

        // Impulses in terms of a response of 1, which the start of the step turns into that of the bodies.
        ends->Response[lane] = 1;
        rows.Take(place.Row, _store.States[joint]);
        _bodyColors.Mark(link.BodyA, color, movesA);
        _bodyColors.Mark(link.BodyB, color, movesB);
        _bodies.Count(link.BodyA, 1);
        _bodies.Count(link.BodyB, 1);
        _places[joint] = place;
    }

    private void Remove(int joint)
    {
        Report(joint);
        NetPlace place = _places[joint];
        NetRows rows = RowsOf(place.List);
        NetEnds* ends = rows.EndsOf(place.Row);
        int lane = rows.LaneOf(place.Row);
        _bodyColors.Unmark(ends->BodyA[lane], place.Color);
        _bodyColors.Unmark(ends->BodyB[lane], place.Color);
        _bodies.Count(ends->BodyA[lane], -1);
        _bodies.Count(ends->BodyB[lane], -1);
        int moved = rows.RemoveRow(place.Row);
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
        anchors.Target = settings.Target;
    }

    /// <summary>Where the row of a joint is.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 1)]
    private struct NetPlace
    {
        public int Color;
        public int List;
        public int Row;

        /// <summary>Of the joint, which is unlike that of every other that had its index before.</summary>
        public int Order;

        /// <summary>Which bodies move and the form; 0: it has no row.</summary>
        public byte Wanted;

        public readonly bool Held => Wanted != 0;

        public readonly NetForm Form => (NetForm)(Wanted >> 2);
    }
}
