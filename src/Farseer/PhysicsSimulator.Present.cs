using System.Collections.Generic;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics;

/// <content>What is there for those who look between updates: what the last one took in, and what waits for the next.</content>
public partial class PhysicsSimulator
{
    [NotState(Why.OfOneStep)]
    private readonly List<Geom> _present = new List<Geom>();

    /// <summary>Lists the geoms that wait for the next update, or for another outline or body in it, each once.</summary>
    internal void ListWaiting(List<Geom> geoms)
    {
        ListQueued(geoms);

        for (int i = 0; i < _geomsChanged.Count; i++)
        {
            Geom geom = _geomsChanged[i];
            if (geom.WaitsForRemake && geom.Membership == Membership.Added && !geom.IsDisposed && ReferenceEquals(geom.Simulator, this))
            {
                ListOnce(geom, geoms);
            }
        }

        for (int i = 0; i < geoms.Count; i++)
        {
            geoms[i].IsListed = false;
        }
    }

    /// <summary>The geoms that are in the simulator or wait for it.</summary>
    internal List<Geom> ListPresent()
    {
        _present.Clear();
        ListQueued(_present);

        // Those in the list come first, and have no place among those that wait.
        int waiting = _present.Count;
        for (int i = 0; i < GeomList.Count; i++)
        {
            if (!GeomList[i].IsDisposed && GeomList[i].Membership != Membership.RemoveQueued)
            {
                _present.Add(GeomList[i]);
            }
        }

        for (int i = 0; i < waiting; i++)
        {
            _present[i].IsListed = false;
            _present.Add(_present[i]);
        }

        _present.RemoveRange(0, waiting);
        return _present;
    }

    private void ListQueued(List<Geom> geoms)
    {
        for (int i = 0; i < _geomsIn.Count; i++)
        {
            Geom geom = _geomsIn[i];
            if (geom.Membership == Membership.AddQueued && !geom.IsDisposed && ReferenceEquals(geom.Simulator, this))
            {
                ListOnce(geom, geoms);
            }
        }
    }

    // What was added, removed and added again stands in the queue twice.
    private static void ListOnce(Geom geom, List<Geom> geoms)
    {
        if (!geom.IsListed)
        {
            geom.IsListed = true;
            geoms.Add(geom);
        }
    }

    internal void ListPresent(List<Body> bodies)
    {
        for (int i = 0; i < BodyList.Count; i++)
        {
            if (!BodyList[i].IsDisposed && BodyList[i].Membership != Membership.RemoveQueued)
            {
                bodies.Add(BodyList[i]);
            }
        }

        HashSet<Body>? seen = null;
        for (int i = 0; i < _bodiesIn.Count; i++)
        {
            Body body = _bodiesIn[i];
            if (body.Membership == Membership.AddQueued && !body.IsDisposed && ReferenceEquals(body.Simulator, this)
                && (seen ??= new HashSet<Body>()).Add(body))
            {
                bodies.Add(body);
            }
        }
    }

    internal QueryCrowd Asking => _queries;

    /// <summary>For those who look at what waits while others do.</summary>
    [NotState(Why.Fixed)]
    internal object WaitingGate { get; } = new object();

    /// <summary>False: certainly nothing waits.</summary>
    internal bool MayWait => _geomsIn.Count > 0 || _geomsChanged.Count > 0;

    internal void UseSurfaces() => World.Surfaces.Use();

    internal void ListPresent(List<Joint> joints) => _joints.ListPresent(joints);

    /// <summary>The geoms that the engine has.</summary>
    internal List<Geom> ListAttached()
    {
        var geoms = new List<Geom>();
        for (int i = 0; i < _table.GeomEnd; i++)
        {
            if (_table.Geom(i) is { } geom)
            {
                geoms.Add(geom);
            }
        }

        return geoms;
    }

    internal void ListPresent(List<Spring> springs) => _springs.ListPresent(springs);

    /// <summary>Lists the controllers that are in the simulator or will be at the next update.</summary>
    internal void ListPresent(List<Controller> controllers) => _controllers.ListPresent(controllers);

    /// <summary>The number of items of each kind, for a debugger.</summary>
    /// <returns>A line of text.</returns>
    public override string ToString() => string.Format(
        System.Globalization.CultureInfo.InvariantCulture,
        "PhysicsSimulator after {0} updates: {1} bodies ({2} asleep), {3} geoms, {4} joints, {5} springs",
        StepCount,
        BodyList.Count,
        SleepingBodyCount,
        GeomList.Count,
        JointList.Count,
        SpringList.Count);
}
