using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics;

/// <content>Whose state is part of the simulator's.</content>
public partial class PhysicsSimulator
{
    private static void TakeOutNew(StateRoster present, StateRoster roster)
    {
        foreach (Joint joint in present.Joints)
        {
            if (!roster.Has(joint))
            {
                joint.TakeOut();
            }
        }

        foreach (Spring spring in present.Springs)
        {
            if (!roster.Has(spring))
            {
                spring.TakeOut();
            }
        }

        foreach (Controller controller in present.Controllers)
        {
            if (!roster.Has(controller))
            {
                controller.TakeOut();
            }
        }

        foreach (Geom geom in present.Geoms)
        {
            if (!roster.Has(geom))
            {
                // A body that is set back to before the geom does not know it.
                geom.TakeOut(leavesBody: geom.Body is { } body && roster.Has(body));
            }
        }

        foreach (Body body in present.Bodies)
        {
            if (!roster.Has(body))
            {
                TakeOut(body, roster);
            }
        }
    }

    // Geoms that go back to the body of then leave it.
    private static void TakeOut(Body body, StateRoster roster)
    {
        body.TakeOut();
        for (int i = body.GeomCount - 1; i >= 0; i--)
        {
            if (roster.Has(body.GeomAt(i)))
            {
                body.RemoveGeom(body.GeomAt(i));
            }
        }
    }

    private void Gather(StateRoster r)
    {
        r.Clear();
        for (int i = 0; i < _table.BodyEnd; i++)
        {
            if (_table.Body(i) is { } body)
            {
                r.EnterOnce(r.Bodies, body);
            }
        }

        for (int i = 0; i < _table.GeomEnd; i++)
        {
            if (_table.Geom(i) is { } geom)
            {
                r.EnterOnce(r.Geoms, geom);
            }
        }

        Gather(r, BodyList);
        Gather(r, _bodiesIn);
        Gather(r, _bodiesOut);
        Gather(r, _bodiesDisposed);
        Gather(r, _pending);
        Gather(r, _listeners);
        Gather(r, GeomList);
        Gather(r, _geomsIn);
        Gather(r, _geomsOut);
        Gather(r, _geomsDisposed);
        Gather(r, _geomsChanged);
        GatherItems(r);
        GatherParts(r);
    }

    /// <summary>The body in a slot of the engine, if there is one.</summary>
    internal Body? BodyOf(int slot) => slot < 0 ? null : _table.Body(slot);

    /// <summary>The geom that a collider of the engine stands for.</summary>
    internal Geom? GeomOf(int slot) => slot < 0 ? null : _table.Geom(slot);

    /// <summary>The joint that one of the engine stands for.</summary>
    internal Joint? JointOf(int slot) => slot < 0 ? null : _jointRelay.Find(slot);

    private void GatherItems(StateRoster r)
    {
        GatherListed(r.Joints, JointList);
        Gather(r.Joints, _joints.Waiting);
        Gather(r.Joints, _jointsDisposed);
        GatherListed(r.Springs, SpringList);
        Gather(r.Springs, _springs.Waiting);
        GatherListed(r.Controllers, ControllerList);
        Gather(r.Controllers, _controllers.Waiting);
        if (!IsListed(InactivityController))
        {
            r.Enter(r.Controllers, InactivityController);
        }

        foreach ((Joint joint, Body taken) in _jointsChanged)
        {
            if (!IsListed(joint))
            {
                r.Enter(r.Joints, joint);
            }

            Enter(r, taken);
        }

        foreach (Joint joint in r.Joints)
        {
            Enter(r, joint.FirstBody);
            Enter(r, joint.SecondBody);
            Enter(r, joint.Link.First);
            Enter(r, joint.Link.Second);
        }

        void Gather<T>(List<T> list, List<T> items)
            where T : class, IItem
        {
            foreach (T item in items)
            {
                if (!IsListed(item) && (item.Simulator is null || ReferenceEquals(item.Simulator, this)))
                {
                    r.Enter(list, item);
                }
            }
        }

        void GatherListed<T>(List<T> list, List<T> items)
            where T : class, IItem
        {
            foreach (T item in items)
            {
                if (IsListed(item))
                {
                    r.EnterOnce(list, item);
                }
                else if (item.Simulator is null || ReferenceEquals(item.Simulator, this))
                {
                    r.Enter(list, item);
                }
            }
        }

        // Each of those stands once in the simulator's list, and is entered from there.
        bool IsListed(IItem item) =>
            item.Membership is Membership.Added or Membership.RemoveQueued && ReferenceEquals(item.Simulator, this);
    }

    /// <summary>The bodies of geoms and the geoms of bodies, until there are no more.</summary>
    private void GatherParts(StateRoster r)
    {
        int nextBody = 0;
        int nextGeom = 0;
        while (nextBody < r.Bodies.Count || nextGeom < r.Geoms.Count)
        {
            for (; nextBody < r.Bodies.Count; nextBody++)
            {
                Body body = r.Bodies[nextBody];
                for (int i = 0; i < body.GeomCount; i++)
                {
                    Enter(r, body.GeomAt(i));
                }
            }

            for (; nextGeom < r.Geoms.Count; nextGeom++)
            {
                Enter(r, r.Geoms[nextGeom].Body);
                Enter(r, r.Geoms[nextGeom].Link.AttachedBody);
            }
        }
    }

    private void Gather(StateRoster r, List<Body> bodies)
    {
        foreach (Body body in bodies)
        {
            Enter(r, body);
        }
    }

    private void Gather(StateRoster r, List<Geom> geoms)
    {
        foreach (Geom geom in geoms)
        {
            Enter(r, geom);
        }
    }

    // What is in the world stands in the table, and was entered from there.
    private void Enter(StateRoster r, Body? body)
    {
        if (body is not null && !ReferenceEquals(body.Link.World, World)
            && (body.Simulator is null || ReferenceEquals(body.Simulator, this)))
        {
            r.Enter(r.Bodies, body);
        }
    }

    private void Enter(StateRoster r, Geom geom)
    {
        if (!geom.Link.IsAttached && (geom.Simulator is null || ReferenceEquals(geom.Simulator, this)))
        {
            r.Enter(r.Geoms, geom);
        }
    }
}
