using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>Saving and restoring.</content>
public partial class Geom
{
    ref StateMark IStatePart.Mark => ref Link.Mark;

    /// <summary>The last round when something that a state has of it was set; of what is rarely there nobody tells.</summary>
    internal long ChangedIn => _extras is null || _extras.IsUsual ? Link.Mark.ChangedIn : long.MaxValue;

    /// <summary>Writes, or reads, what later updates read of it: not tag and name, the user's, nor outlines, which never change.</summary>
    internal void Visit(StateStream s)
    {
        GeomForm? form = _form;
        Link.Visit(s);
        s.Reference(ref _body);
        s.Reference(ref _form);
        s.Reference(ref _localVertices);
        s.Reference(ref _offset);
        s.Value(ref _collisionGridCellSize);
        IsDisposed = s.Value(IsDisposed);
        Simulator = s.Reference(Simulator);
        Membership = s.Value(Membership);
        IsLeaving = s.Value(IsLeaving);
        WaitsForRemake = s.Value(WaitsForRemake);
        if (!s.Value(_extras is not null && !(s.IsElsewhere ? _extras.IsUsualButForUsers : _extras.IsUsual)))
        {
            if (_extras is not null)
            {
                if (!s.IsElsewhere)
                {
                    _extras.OnCollision = null;
                    _extras.OnSeparation = null;
                    _extras.Grid = null;
                }

                _extras.Surface = default;
                _extras.Segments = null;
                _extras.OneWay = default;
            }
        }
        else
        {
            GeomExtras extras = _extras ??= new GeomExtras();
            s.Reference(ref extras.OnCollision);
            s.Reference(ref extras.OnSeparation);
            s.Reference(ref extras.Grid);
            s.Value(ref extras.Surface);
            s.Value(ref extras.OneWay);
            VisitSegments(s, extras);
        }

        if (s.IsReading)
        {
            ForgetFrame(keepsForm: ReferenceEquals(form, _form));
        }
    }

    private static void VisitSegments(StateStream s, GeomExtras extras)
    {
        int count = s.Value(extras.Segments is null ? -1 : extras.Segments.Length);
        if (count < 0)
        {
            extras.Segments = null;
            return;
        }

        if (extras.Segments is null || extras.Segments.Length != count)
        {
            extras.Segments = new SurfaceMaterial?[count];
        }

        for (int i = 0; i < count; i++)
        {
            bool own = s.Value(extras.Segments[i].HasValue);
            SurfaceMaterial material = s.Value(extras.Segments[i].GetValueOrDefault());
            extras.Segments[i] = own ? material : null;
        }
    }

    /// <summary>It belongs to no simulator any more, by a state from before it was added.</summary>
    /// <param name="leavesBody">Nor to its body, which is set back to a time before the geom.</param>
    internal void TakeOut(bool leavesBody)
    {
        Link.TakeOut();
        if (leavesBody)
        {
            Link.Mark.Change();
            _body = null;
            ForgetFrame();
        }

        Simulator = null;
        Membership = Membership.None;
        IsLeaving = false;
    }
}
