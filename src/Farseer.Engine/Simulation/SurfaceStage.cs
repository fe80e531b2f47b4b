using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Pairs whose surfaces are not what the coefficients of their colliders say.</summary>
[NotState(Why.Fixed)]
internal sealed class SurfaceStage : WorldPhase
{
    public SurfaceStage(WorldStores stores)
        : base(stores)
    {
    }

    /// <summary>Says what surfaces are; null: all are what their colliders say.</summary>
    public IPairSurfaces? Judge { get; set; }

    /// <summary>From now on some collider has a surface of its own, or all pairs are judged.</summary>
    public void Use()
    {
        if (!_contacts.Surfaces.IsOn)
        {
            _contacts.Surfaces.TurnOn();
            _contacts.Surfaces.EnsureCapacity(_contacts.Records.Capacity);
            for (int i = 0; i < _contacts.End; i++)
            {
                if (_contacts.Records[i].PieceA >= 0)
                {
                    Begin(i);
                }
            }
        }
    }

    /// <summary>A pair is new.</summary>
    public void Begin(int contact)
    {
        _contacts.Surfaces.EnsureCapacity(_contacts.Records.Capacity);
        ref ContactRecord record = ref _contacts.Records[contact];
        _contacts.Surfaces[contact] = new PairSurface { SegmentA = PlaceOf(record.PieceA), SegmentB = PlaceOf(record.PieceB) };
        Refresh(contact);
    }

    /// <summary>Coefficients may have changed since the last step: each pair that has surfaces of its own is asked about anew.</summary>
    public void RefreshAll()
    {
        _contacts.Surfaces.AnySpecial = false;
        if (!_contacts.Surfaces.IsOn)
        {
            return;
        }

        for (int i = 0; i < _contacts.End; i++)
        {
            ref ContactRecord record = ref _contacts.Records[i];
            if (record.PieceA >= 0 && !record.IsDormant)
            {
                Refresh(i);
            }
        }
    }

    private void Refresh(int contact)
    {
        ref ContactRecord record = ref _contacts.Records[contact];
        ref PairSurface surface = ref _contacts.Surfaces[contact];
        ColliderFlags either = _shapes.ColliderAt(record.PieceA).Flags | _shapes.ColliderAt(record.PieceB).Flags;
        surface.IsSet = 0;
        if (Judge == null || !(Judge.JudgesAll || (either & ColliderFlags.OwnSurface) != 0))
        {
            return;
        }

        surface.Friction = _settings.FreezePairFriction
            ? _contacts.FirstFriction[contact]
            : ContactUpdate.MixFriction(_shapes, _settings.FrictionMix, record);
        surface.Restitution = (float)ContactUpdate.MixRestitution(_shapes, _settings.RestitutionMix, record);
        surface.Speed = 0;
        surface.RollingArm = 0;
        surface.IsSet = 1;
        Judge.Describe(_shapes.ColliderOf(record.PieceA), _shapes.ColliderOf(record.PieceB), ref surface);
        surface.RollingArm *= SizeOf(record);
        _stores.MakesEnergy |= surface.Restitution > 1;
        _contacts.Surfaces.AnySpecial |= surface.IsSpecial;
    }

    /// <summary>Half the width of the smaller of two pieces; lines have none.</summary>
    private float SizeOf(in ContactRecord record)
    {
        float a = _shapes.Pieces[record.PieceA].Extent;
        float b = _shapes.Pieces[record.PieceB].Extent;
        return !(a > 0) ? b : !(b > 0) ? a : Math.Min(a, b);
    }

    private int PlaceOf(int piece)
    {
        int place = 0;
        for (int at = _shapes.ColliderAt(piece).FirstPiece; at >= 0 && at != piece; at = _shapes.NextPiece[at])
        {
            place++;
        }

        return place;
    }
}
