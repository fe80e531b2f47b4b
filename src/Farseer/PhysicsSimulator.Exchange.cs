using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics;

/// <content>
/// Works off what waits. Only what waits at the start of an update is looked at: a handler that adds more while it runs makes it
/// wait for the next one. If a handler throws, what is left stays in the queues.
/// </content>
public partial class PhysicsSimulator
{
    private void TakeInAndOut()
    {
        if (_geomsIn.Count + _bodiesIn.Count > 0)
        {
            (int bodyEnd, int geomEnd) = World.Expect(_bodiesIn.Count, _geomsIn.Count);
            _table.Expect(bodyEnd, geomEnd);
            ListRoom.Expect(BodyList, _bodiesIn.Count);
            ListRoom.Expect(GeomList, _geomsIn.Count);
        }

        if (_geomsIn.Count > 0)
        {
            int count = _geomsIn.Count;
            for (int i = 0; i < count; i++)
            {
                TakeIn(_geomsIn[i]);
            }

            ListRoom.WorkedOff(_geomsIn, count);
        }

        if (_bodiesIn.Count > 0)
        {
            int count = _bodiesIn.Count;
            for (int i = 0; i < count; i++)
            {
                TakeIn(_bodiesIn[i]);
            }

            ListRoom.WorkedOff(_bodiesIn, count);
        }

        _joints.TakeIn();
        TakeInControls();
        if (_geomsOut.Count + _geomsDisposed.Count + _bodiesOut.Count + _bodiesDisposed.Count > 0)
        {
            RemoveWaiting();
        }

        _joints.TakeOut();
        if (JointList.Count > 0 || _jointsDisposed.Count > 0)
        {
            SweepJoints();
        }

        TakeOutControls();
        if (_geomsChanged.Count > 0)
        {
            int count = _geomsChanged.Count;
            for (int i = 0; i < count; i++)
            {
                Remake(_geomsChanged[i]);
            }

            _geomsChanged.RemoveRange(0, count);
        }

        LayRails();
    }

    private void RemoveWaiting()
    {
        // What a handler disposes meanwhile is not marked and waits for the next update.
        int geoms = MarkLeaving(_geomsOut);
        int lost = MarkLeaving(_geomsDisposed);
        bool removed = _geomsOut.Count > 0;
        bool disposed = _geomsDisposed.Count > 0;
        bool unlist = GeomList.Removed is not null || !ListRoom.AreMany(geoms + lost);
        if (!unlist)
        {
            ((List<Geom>)GeomList).RemoveAll(static geom => geom.IsLeaving);
        }

        TakeOut(_geomsOut, geoms, unlist);
        TakeOut(_bodiesOut);
        TakeOut(_geomsDisposed, lost, unlist);
        TakeOut(_bodiesDisposed);
        _arbiters.IsStale = true;
        if (removed)
        {
            _broadPhaseCollider.ProcessRemovedGeoms();
        }

        if (disposed)
        {
            _broadPhaseCollider.ProcessDisposedGeoms();
        }
    }

    private static int MarkLeaving(List<Geom> geoms)
    {
        for (int i = 0; i < geoms.Count; i++)
        {
            geoms[i].IsLeaving = geoms[i].Membership == Membership.RemoveQueued || geoms[i].IsDisposed;
        }

        return geoms.Count;
    }

    private void TakeIn(Geom geom)
    {
        if (geom.Membership != Membership.AddQueued || !ReferenceEquals(geom.Simulator, this))
        {
            return;
        }

        _geomsWaiting--;
        if (geom.IsDisposed)
        {
            Forget(geom);
            return;
        }

        geom.Membership = Membership.Added;
        _lastForm = geom.ShareForm(_lastForm);
        AttachCollider(geom);
        GeomList.TakeIn(geom);
        _broadPhaseCollider.Add(geom);
    }

    private void TakeIn(Body body)
    {
        if (body.Membership != Membership.AddQueued || !ReferenceEquals(body.Simulator, this))
        {
            return;
        }

        if (body.IsDisposed)
        {
            body.Membership = Membership.None;
            ReleaseIfUnused(body);
            return;
        }

        body.Membership = Membership.Added;
        AttachBody(body);
        BodyList.TakeIn(body);
    }

    private void TakeOut(List<Geom> geoms, int count, bool unlist)
    {
        for (int i = 0; i < count; i++)
        {
            Geom geom = geoms[i];
            if (geom.IsLeaving)
            {
                geom.IsLeaving = false;
                if (geom.Membership == Membership.AddQueued)
                {
                    _geomsWaiting--;
                    Forget(geom);
                }
                else if (geom.Membership != Membership.None)
                {
                    Release(geom);
                    if (unlist)
                    {
                        GeomList.TakeOut(geom);
                    }
                }
            }
        }

        geoms.RemoveRange(0, count);
    }

    /// <summary>Takes out those that still are to leave: a removal may have been taken back, an addition not yet done.</summary>
    private void TakeOut(List<Body> bodies)
    {
        int count = bodies.Count;
        bool unlist = BodyList.Removed is not null || !ListRoom.AreMany(count);
        for (int i = 0; i < count; i++)
        {
            Body body = bodies[i];
            if (body.IsDisposed && body.Membership == Membership.AddQueued)
            {
                body.Membership = Membership.None;
                ReleaseIfUnused(body);
            }
            else if (body.Membership == Membership.RemoveQueued || (body.IsDisposed && body.Membership == Membership.Added))
            {
                Release(body);
                if (unlist)
                {
                    BodyList.TakeOut(body);
                }
            }
        }

        bodies.RemoveRange(0, count);
        if (!unlist)
        {
            ((List<Body>)BodyList).RemoveAll(static body => body.Membership == Membership.None);
        }
    }

    /// <summary>Takes it out of the world, not of the list.</summary>
    private void Release(Geom geom)
    {
        Body? carrier = geom.Link.AttachedBody;
        DetachCollider(geom);
        Forget(geom);
        if (carrier is not null && !ReferenceEquals(carrier, geom.Body))
        {
            ReleaseIfUnused(carrier);
        }
    }

    private void Release(Body body)
    {
        body.Membership = Membership.None;
        if (!body.Link.IsUsed)
        {
            Detach(body);
        }
        else
        {
            body.Link.SetSimulated(false);
        }

        ReleaseIfUnused(body);
    }

    /// <summary>A geom got another body or outline: its collider is made anew.</summary>
    private void Remake(Geom geom)
    {
        geom.WaitsForRemake = false;
        if (!geom.Link.IsAttached || !ReferenceEquals(geom.Simulator, this))
        {
            return;
        }

        Body? carrier = geom.Link.AttachedBody;
        DetachCollider(geom);
        geom.Body.Simulator = this;
        AttachCollider(geom);
        if (carrier is not null && !ReferenceEquals(carrier, geom.Body))
        {
            ReleaseIfUnused(carrier);
        }
    }

    private void AttachBody(Body body)
    {
        bool isSimulated = body.Membership != Membership.None;
        if (body.Link.World is null)
        {
            body.Link.Attach(World, isSimulated);
            _table.SetBody(body.Link.Handle.Index, body);
            _relay.Recorder.Take(body);
            _poses.Put(body.Link.Handle.Index, body.Link.PoseRef);
        }
        else
        {
            body.Link.SetSimulated(isSimulated);
        }

        if (body.GravityScale != 1)
        {
            NoteGravity(body);
        }

        if (body.IsRailed)
        {
            NoteRails(body);
        }

        if (body.Impulse != System.Numerics.Vector2.Zero || body.AngularImpulse != 0 || body.Swing != 0)
        {
            NotePending(body);
        }

        NoteListener(body);
    }

    private void AttachCollider(Geom geom)
    {
        AttachBody(geom.Body);
        geom.Body.Link.Colliders++;
        geom.Link.Attach(geom, World);
        _table.SetGeom(geom.Link.Handle.Index, geom);
    }

    private void DetachCollider(Geom geom)
    {
        Body carrier = geom.Link.AttachedBody!;
        int index = geom.Link.Handle.Index;
        _relay.IsRemoving = true;
        geom.Link.Detach();
        _relay.IsRemoving = false;
        _table.SetGeom(index, null);
        carrier.Link.Colliders--;
        DetachIfUnused(carrier);
    }

    private void DetachIfUnused(Body body)
    {
        if (body.Link.World is not null && !body.Link.IsUsed && !body.Link.IsSimulated)
        {
            Detach(body);
        }
    }

    private void Detach(Body body)
    {
        _table.SetBody(body.Link.Handle.Index, null);
        body.Link.Detach();
    }
}
