using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Continuous;
using Farseer.Engine.Numerics;
using Farseer.Engine.Queries;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <content>
/// What a fast body may meet beyond the boxes around its foreseen way: after a bounce it flies where nothing foresaw it, and the
/// solver may have thrown it there. Only then is the world asked for it.
/// </content>
internal sealed partial class SweepStage
{
    /// <summary>More immovable boxes than this are not looked at one by one.</summary>
    private const int MostInARow = 2048;
    private readonly BoxPacks _immovable = new BoxPacks();

    [NotState(Why.OfOneStep)]
    private readonly IndexList _beyond = new IndexList();
    private bool _immovableListed;
    private bool _queriesSeeStep;

    /// <summary>The sweep that is to look at what is found.</summary>
    [NotState(Why.OfOneStep)]
    private FastBodySweep _seeker = null!;

    bool IImpactListener.AddsNothing(int body, in BodyPath way)
    {
        BodyPose pose = _bodies.Pose[body];
        BodyReach reach = ReachOf(body, way);
        if (_boxes.Hold(pose, body, reach))
        {
            return true;
        }

        if (_bodies.IsBullet(body) || _immovable.Count > MostInARow)
        {
            return false;
        }

        for (int collider = _colliders.First(body); collider >= 0; collider = _colliders.Next(collider))
        {
            for (int piece = _shapes.Colliders[collider].FirstPiece; piece >= 0; piece = _shapes.NextPiece[piece])
            {
                if (MeetsUnknown(piece, Around(piece, pose, reach)))
                {
                    return false;
                }
            }
        }

        return true;
    }

    void IImpactListener.OnWay(FastBodySweep sweep, int body, in BodyPath way)
    {
        _seeker = sweep;
        BodyPose pose = _bodies.Pose[body];
        BodyReach reach = ReachOf(body, way);
        if (_boxes.Hold(pose, body, reach))
        {
            return;
        }

        for (int collider = _colliders.First(body); collider >= 0; collider = _colliders.Next(collider))
        {
            for (int piece = _shapes.Colliders[collider].FirstPiece; piece >= 0; piece = _shapes.NextPiece[piece])
            {
                SeekPairs(body, piece, Around(piece, pose, reach));
            }
        }
    }

    /// <summary>A box that holds a piece wherever it gets to.</summary>
    private Box Around(int piece, in BodyPose pose, in BodyReach reach)
    {
        Box box = _shapes.TightBox(piece, pose);
        double swing = reach.Turn * _shapes.Pieces[piece].Reach;
        return Box.FromDouble(
            box.MinX + reach.MinX - swing,
            box.MinY + reach.MinY - swing,
            box.MaxX + reach.MaxX + swing,
            box.MaxY + reach.MaxY + swing);
    }

    /// <summary>
    /// Whether <see cref="SeekPairs"/> would find a pair that is not known, of a body that is no bullet. What cannot move is listed.
    /// </summary>
    private bool MeetsUnknown(int piece, in Box box)
    {
        var spread = new SpreadBox(box);
        for (int pack = _immovable.NextPack(0, spread); pack >= 0; pack = _immovable.NextPack(pack + 1, spread))
        {
            int first = pack * WideBoxes.Width;
            for (uint mask = _immovable.Boxes.Overlaps(first, spread); mask != 0; mask &= mask - 1)
            {
                if (!_contacts.Map.Contains(PairBuffer.Pack(piece, _immovable.Proxy(first + WideBoxes.LowestLane(mask)))))
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>How far a way leads from where a body is.</summary>
    private BodyReach ReachOf(int body, in BodyPath way)
    {
        BodyPose pose = _bodies.Pose[body];
        double endX = way.XAt(1) - pose.X;
        double endY = way.YAt(1) - pose.Y;

        // An arc leaves its chord by an eighth of the acceleration.
        double bendX = Math.Abs(way.AccelerationX) / 8;
        double bendY = Math.Abs(way.AccelerationY) / 8;
        BodyReach reach;
        reach.MinX = Math.Min(way.X - pose.X, endX) - bendX;
        reach.MinY = Math.Min(way.Y - pose.Y, endY) - bendY;
        reach.MaxX = Math.Max(way.X - pose.X, endX) + bendX;
        reach.MaxY = Math.Max(way.Y - pose.Y, endY) + bendY;
        reach.Turn = Math.Abs(way.Angle - pose.Angle) + Math.Abs(way.Spin) + (0.5 * Math.Abs(way.SpinGain));
        return reach;
    }

    /// <summary>A step has moved its bodies.</summary>
    public void Begin()
    {
        _sweepGathered = false;
        _immovableListed = false;
        _queriesSeeStep = false;
    }

    /// <summary>Makes the pairs of a piece with what lies in a box and must not be passed, and has the sweep look at them.</summary>
    private void SeekPairs(int body, int piece, in Box box)
    {
        ListImmovable();
        if (_bodies.IsBullet(body) || _immovable.Count > MostInARow)
        {
            AskForPairs(body, piece, box);
            return;
        }

        var spread = new SpreadBox(box);
        for (int pack = _immovable.NextPack(0, spread); pack >= 0; pack = _immovable.NextPack(pack + 1, spread))
        {
            int first = pack * WideBoxes.Width;
            for (uint mask = _immovable.Boxes.Overlaps(first, spread); mask != 0; mask &= mask - 1)
            {
                SeekPair(piece, _immovable.Proxy(first + WideBoxes.LowestLane(mask)), moves: false);
            }
        }
    }

    /// <summary>Lists what cannot move, if it is not listed yet in this step.</summary>
    public void ListImmovable()
    {
        if (_immovableListed)
        {
            return;
        }

        _immovableListed = true;
        _immovable.Clear();
        for (int piece = 0; piece < _proxies.End; piece++)
        {
            ref ProxyInfo info = ref _proxies.Info[piece];
            if ((info.Flags & ProxyFlags.Alive) != 0 && !_bodies.IsMovable(info.Body))
            {
                _immovable.Add(piece, _proxies.Fat[piece]);
            }
        }
    }

    private void AskForPairs(int body, int piece, in Box box)
    {
        if (!_queriesSeeStep)
        {
            _queriesSeeStep = true;
            _queries.Version++;
        }

        QueryFilter filter = QueryFilter.All;
        filter.IgnoredBody = body;
        _queries.FindInBox(box, filter, _beyond);
        for (int i = 0; i < _beyond.Count; i++)
        {
            bool moves = _bodies.IsMovable(_shapes.Colliders[_beyond[i]].Body);
            for (int other = _shapes.Colliders[_beyond[i]].FirstPiece; other >= 0
                && (!moves || _bodies.IsBullet(body)); other = _shapes.NextPiece[other])
            {
                SeekPair(piece, other, moves);
            }
        }
    }

    private void SeekPair(int piece, int other, bool moves)
    {
        ulong key = PairBuffer.Pack(piece, other);
        if (_contacts.Map.Contains(key))
        {
            return;
        }

        _pairs.TryCreate(key);
        if (_contacts.Map.TryGet(key, out int contact) && Responds(_contacts.Records[contact]))
        {
            _seeker.Add(contact, moves);
        }
    }
}
