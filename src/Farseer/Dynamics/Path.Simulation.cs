using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <content>A path comes and goes as a whole.</content>
public partial class Path
{
    /// <summary>Adds all bodies, geoms, joints and springs of the path; those that are in the simulator already stay there.</summary>
    /// <param name="physicsSimulator">The simulator.</param>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentException">A part cannot be added, for instance as it is in another simulator; then none is.</exception>
    /// <exception cref="ObjectDisposedException">The simulator or a part is disposed; then nothing is added.</exception>
    public void AddToPhysicsSimulator(PhysicsSimulator physicsSimulator)
    {
        Require.NotNull(physicsSimulator, nameof(physicsSimulator)).ThrowIfDisposed();
        var added = new Stack<Action>();
        try
        {
            foreach (Body body in Bodies)
            {
                if (!IsIn(physicsSimulator, body.Simulator, body.Membership))
                {
                    physicsSimulator.Add(body);
                    added.Push(() => physicsSimulator.Remove(body));
                }
            }

            foreach (Geom geom in Geoms)
            {
                if (!IsIn(physicsSimulator, geom.Simulator, geom.Membership))
                {
                    physicsSimulator.Add(geom);
                    added.Push(() => physicsSimulator.Remove(geom));
                }
            }

            foreach (Joint joint in Joints)
            {
                if (!IsIn(physicsSimulator, joint))
                {
                    physicsSimulator.Add(joint);
                    added.Push(() => physicsSimulator.Remove(joint));
                }
            }

            foreach (Spring spring in Springs)
            {
                if (!IsIn(physicsSimulator, spring))
                {
                    physicsSimulator.Add(spring);
                    added.Push(() => physicsSimulator.Remove(spring));
                }
            }
        }
        catch
        {
            while (added.Count > 0)
            {
                added.Pop()();
            }

            throw;
        }
    }

    /// <summary>
    /// Removes all bodies, geoms, joints and springs of the path at the next update; those that are in no simulator are ignored. (An
    /// addition to the original.)
    /// </summary>
    /// <param name="physicsSimulator">The simulator.</param>
    /// <exception cref="ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    /// <exception cref="ArgumentException">A part is in another simulator: then none is removed.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public void RemoveFromPhysicsSimulator(PhysicsSimulator physicsSimulator)
    {
        Require.NotNull(physicsSimulator, nameof(physicsSimulator)).ThrowIfDisposed();
        if (Bodies.Exists(b => IsElsewhere(physicsSimulator, b.Simulator)) || Geoms.Exists(g => IsElsewhere(physicsSimulator, g.Simulator))
                || Joints.Exists(j => IsElsewhere(physicsSimulator, j.Simulator))
                || Springs.Exists(s => IsElsewhere(physicsSimulator, s.Simulator)))
        {
            throw new ArgumentException("A part of the path belongs to another simulator.", nameof(physicsSimulator));
        }

        Springs.ForEach(physicsSimulator.Remove);
        Joints.ForEach(physicsSimulator.Remove);
        Geoms.ForEach(physicsSimulator.Remove);
        Bodies.ForEach(physicsSimulator.Remove);
    }

    private static bool IsElsewhere(PhysicsSimulator simulator, PhysicsSimulator? of) => of is not null && !ReferenceEquals(of, simulator);

    private static bool IsIn(PhysicsSimulator simulator, IItem item) => IsIn(simulator, item.Simulator, item.Membership);

    private static bool IsIn(PhysicsSimulator simulator, PhysicsSimulator? of, Membership membership) =>
        ReferenceEquals(of, simulator) && membership is Membership.AddQueued or Membership.Added;
}
