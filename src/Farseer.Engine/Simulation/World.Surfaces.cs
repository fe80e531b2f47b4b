using Farseer.Engine.Contacts;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Pairs whose surfaces are not what the coefficients of their colliders say.</summary>
internal sealed partial class World
{
    /// <summary>Says what surfaces are; null: all are what their colliders say.</summary>
    [NotState(Why.Elsewhere)]
    public IPairSurfaces? Surfaces { get; set; }

    /// <summary>From now on some collider has a surface of its own, or all pairs are judged.</summary>
    public void UseSurfaces()
    {
        if (!_contacts.Surfaces.IsOn)
        {
            _contacts.Surfaces.TurnOn();
            _contacts.Surfaces.EnsureCapacity(_contacts.Records.Capacity);
            for (int i = 0; i < _contacts.End; i++)
            {
                if (_contacts.Records[i].PieceA >= 0)
                {
                    BeginSurface(i);
                }
            }
        }
    }

    /// <summary>A pair is new.</summary>
    private void BeginSurface(int contact)
    {
        _contacts.Surfaces.EnsureCapacity(_contacts.Records.Capacity);
        ref ContactRecord record = ref _contacts.Records[contact];
        _contacts.Surfaces[contact] = new PairSurface { SegmentA = PlaceOf(record.PieceA), SegmentB = PlaceOf(record.PieceB) };
        RefreshSurface(contact);
    }

    /// <summary>Coefficients may have changed since the last step: each pair that has surfaces of its own is asked about anew.</summary>
    private void RefreshSurfaces()
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
                RefreshSurface(i);
            }
        }
    }

    private void RefreshSurface(int contact)
    {
        ref ContactRecord record = ref _contacts.Records[contact];
        ref PairSurface surface = ref _contacts.Surfaces[contact];
        ColliderFlags either = Shapes.ColliderAt(record.PieceA).Flags | Shapes.ColliderAt(record.PieceB).Flags;
        surface.IsSet = 0;
        if (Surfaces == null || !(Surfaces.JudgesAll || (either & ColliderFlags.OwnSurface) != 0))
        {
            return;
        }

        surface.Friction = Settings.FreezePairFriction
            ? _contacts.FirstFriction[contact]
            : ContactUpdate.MixFriction(Shapes, Settings.FrictionMix, record);
        surface.Restitution = (float)ContactUpdate.MixRestitution(Shapes, Settings.RestitutionMix, record);
        surface.Speed = 0;
        surface.RollingArm = 0;
        surface.IsSet = 1;
        Surfaces.Describe(Shapes.ColliderOf(record.PieceA), Shapes.ColliderOf(record.PieceB), ref surface);
        surface.RollingArm *= SizeOf(record);
        _makesEnergy |= surface.Restitution > 1;
        _contacts.Surfaces.AnySpecial |= surface.IsSpecial;
    }

    /// <summary>Half the width of the smaller of two pieces; lines have none.</summary>
    private float SizeOf(in ContactRecord record)
    {
        float a = Shapes.Pieces[record.PieceA].Extent;
        float b = Shapes.Pieces[record.PieceB].Extent;
        return !(a > 0) ? b : !(b > 0) ? a : System.Math.Min(a, b);
    }

    private int PlaceOf(int piece)
    {
        int place = 0;
        for (int at = Shapes.ColliderAt(piece).FirstPiece; at >= 0 && at != piece; at = Shapes.NextPiece[at])
        {
            place++;
        }

        return place;
    }
}
