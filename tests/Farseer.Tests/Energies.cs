using System;
using System.Collections.Generic;
using System.Linq;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Tests;

/// <summary>Energies of bodies, to see that none comes from nowhere; y up.</summary>
internal static class Energies
{
    public static double Kinetic(Body body) =>
        (0.5 * body.Mass * body.LinearVelocity.LengthSquared())
        + (0.5 * body.MomentOfInertia * body.AngularVelocity * body.AngularVelocity);

    /// <summary>Kinetic and potential energy of those that are not static.</summary>
    public static double Whole(IEnumerable<Body> bodies, double gravity) => Moving(bodies).Sum(body =>
    {
        body.GetPosition(out _, out double y);
        return Kinetic(body) + (body.Mass * gravity * y);
    });

    /// <summary>The height at which the bodies that are not static would stand still with the same energy.</summary>
    public static double AsHeight(IEnumerable<Body> bodies, double gravity) => Whole(bodies, gravity) / Weight(bodies, gravity);

    public static double Weight(IEnumerable<Body> bodies, double gravity) => Moving(bodies).Sum(body => body.Mass * gravity);

    /// <summary>
    /// The largest gain of an energy in an update, as a share of what it is at first or of that of a height of 1, the larger one.
    /// </summary>
    public static double LargestGain(PhysicsSimulator simulator, Func<double> find, double weight, int updates)
    {
        double energy = find();
        double scale = Math.Max(Math.Abs(energy), weight);
        double most = 0;
        for (int i = 0; i < updates; i++)
        {
            simulator.Update(1 / 60f);
            double before = energy;
            energy = find();
            most = Math.Max(most, (energy - before) / scale);
        }

        return most;
    }

    private static IEnumerable<Body> Moving(IEnumerable<Body> bodies) => bodies.Where(body => !body.IsStatic);
}
