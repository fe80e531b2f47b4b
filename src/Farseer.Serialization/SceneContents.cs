using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Serialization;

/// <summary>
/// What was loaded from a file, in the file's order, also what is in no simulator: see <see cref="SceneFileOptions.Loaded"/>. Handlers and
/// whatever else no file holds are attached to these objects.
/// </summary>
public sealed class SceneContents
{
    private readonly Dictionary<object, int> _places = new Dictionary<object, int>();

    internal SceneContents(PhysicsSimulator simulator) => Simulator = simulator;

    /// <summary>The simulator. Add to it, or take out of it, only when it is loaded.</summary>
    public PhysicsSimulator Simulator { get; }

    /// <summary>The bodies.</summary>
    public IReadOnlyList<Body> Bodies => BodyItems;

    /// <summary>The geoms.</summary>
    public IReadOnlyList<Geom> Geoms => GeomItems;

    /// <summary>The joints.</summary>
    public IReadOnlyList<Joint> Joints => JointItems;

    /// <summary>The springs.</summary>
    public IReadOnlyList<Spring> Springs => SpringItems;

    /// <summary>The controllers, the simulator's own <see cref="PhysicsSimulator.InactivityController"/> among them.</summary>
    public IReadOnlyList<Controller> Controllers => ControllerItems;

    /// <summary>The paths that were saved with the simulator: see <see cref="SceneFileOptions.Paths"/>.</summary>
    public IReadOnlyList<Path> Paths => PathItems;

    internal List<Body> BodyItems { get; } = new List<Body>();

    internal List<Geom> GeomItems { get; } = new List<Geom>();

    internal List<Joint> JointItems { get; } = new List<Joint>();

    internal List<Spring> SpringItems { get; } = new List<Spring>();

    internal List<Controller> ControllerItems { get; } = new List<Controller>();

    internal List<Path> PathItems { get; } = new List<Path>();

    /// <summary>Enters something once.</summary>
    internal bool Enter<T>(List<T> list, T item)
        where T : class
    {
        if (_places.ContainsKey(item))
        {
            return false;
        }

        _places.Add(item, list.Count);
        list.Add(item);
        return true;
    }

    /// <summary>Its place in its list; -1: it is not there.</summary>
    internal int PlaceOf(object? item) => item is not null && _places.TryGetValue(item, out int place) ? place : -1;

    /// <summary>Puts the geoms in the order of their making, which decides which of a pair is the first.</summary>
    internal void SortGeoms()
    {
        GeomItems.Sort(static (a, b) => a.Id.CompareTo(b.Id));
        for (int i = 0; i < GeomItems.Count; i++)
        {
            _places[GeomItems[i]] = i;
        }
    }
}
