using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <content>Saving and restoring.</content>
public partial class Body
{
    ref StateMark IStatePart.Mark => ref Link.Mark;

    /// <summary>The last round when something that a state has of it was set; of what is rarely there nobody tells.</summary>
    internal long ChangedIn => _extras is null || _extras.IsUsual ? Link.ChangedIn : long.MaxValue;

    /// <summary>Writes, or reads, what later updates read of it. Tag and name are the user's.</summary>
    internal void Visit(StateStream s)
    {
        Link.Visit(s);
        VisitGeoms(s);
        IsDisposed = s.Value(IsDisposed);
        IsQuarantined = s.Value(IsQuarantined);
        IsAutoIdle = s.Value(IsAutoIdle);
        Idle = s.Value(Idle);
        IsStaticBySensor = s.Value(IsStaticBySensor);
        LastCall = s.Reference(LastCall);
        LastCallStep = s.Value(LastCallStep);
        Simulator = s.Reference(Simulator);
        JointCount = s.Value(JointCount);
        Membership = s.Value(Membership);
        IsPendingNoted = s.Value(IsPendingNoted);
        IsListenerNoted = s.Value(IsListenerNoted);
        IsGravityNoted = s.Value(IsGravityNoted);
        IsRailNoted = s.Value(IsRailNoted);
        Impulse = s.Value(Impulse);
        AngularImpulse = s.Value(AngularImpulse);
        Swing = s.Value(Swing);
        VisitExtras(s);
    }

    /// <summary>It belongs to no simulator any more, by a state from before it was added; it stays where it is.</summary>
    internal void TakeOut()
    {
        Link.TakeOut();
        Simulator = null;
        JointCount = 0;
        Membership = Membership.None;
        IsPendingNoted = false;
        IsListenerNoted = false;
        IsGravityNoted = false;
        IsRailNoted = false;
    }

    private void VisitGeoms(StateStream s)
    {
        int count = s.Value(GeomCount);
        if (!s.IsReading)
        {
            for (int i = 0; i < count; i++)
            {
                s.Reference(GeomAt(i));
            }

            return;
        }

        var several = _geoms as List<Geom>;
        if (several is null && count > 1)
        {
            several = new List<Geom>(count);
        }

        several?.Clear();
        _geoms = several;
        for (int i = 0; i < count; i++)
        {
            AddGeom(s.Reference<Geom>(null)!);
        }
    }

    private void VisitExtras(StateStream s)
    {
        if (!s.Value(_extras is not null && !(s.IsElsewhere ? _extras.IsUsualButForUsers : _extras.IsUsual)))
        {
            if (_extras is not null)
            {
                // What came since is as if it had not; but for the user's own.
                if (!s.IsElsewhere)
                {
                    _extras.Disposed = null;
                    _extras.Updated = null;
                }

                _extras.IdleTime = 0;
                _extras.MinimumVelocity = BodyExtras.UsualMinimumVelocity;
                _extras.GravityScale = 1;
                _extras.Locks = MotionLocks.None;
                _extras.FixedInertia = 0;
                _extras.ToldX = 0;
                _extras.ToldY = 0;
                _extras.ToldAngle = 0;
            }

            return;
        }

        BodyExtras extras = Extras;
        s.Reference(ref extras.Disposed);
        s.Reference(ref extras.Updated);
        s.Value(ref extras.IdleTime);
        s.Value(ref extras.MinimumVelocity);
        s.Value(ref extras.GravityScale);
        s.Value(ref extras.Locks);
        s.Value(ref extras.FixedInertia);
        s.Value(ref extras.ToldX);
        s.Value(ref extras.ToldY);
        s.Value(ref extras.ToldAngle);
    }

    /// <summary>Lets what no public property shows be saved or set.</summary>
    internal void VisitHidden(IHiddenFields fields)
    {
        int idle = (int)Idle;
        fields.Value("idle", ref idle);
        Idle = (IdleState)idle;
        bool flag = IsQuarantined;
        fields.Value("isQuarantined", ref flag);
        IsQuarantined = flag;
        flag = IsStaticBySensor;
        fields.Value("isStaticBySensor", ref flag);
        IsStaticBySensor = flag;
        Vector2 amount = Link.ForceRef.Force;
        fields.Value("force", ref amount);
        Link.ForceRef.Force = amount;
        float turn = Link.ForceRef.Torque;
        fields.Value("torque", ref turn);
        Link.ForceRef.Torque = turn;
        amount = Impulse;
        fields.Value("impulse", ref amount);
        Impulse = amount;
        turn = AngularImpulse;
        fields.Value("angularImpulse", ref turn);
        AngularImpulse = turn;
        turn = Swing;
        fields.Value("swing", ref turn);
        Swing = turn;
    }
}
