using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>Energy and momentum of all that moves.</summary>
internal static class Bookkeeping
{
    public static double Kinetic(IReadOnlyList<Actor> actors)
    {
        double sum = 0;
        foreach (Actor actor in actors)
        {
            sum += actor.IsStatic || actor.Body.IsKinematic ? 0 : actor.KineticEnergy;
        }

        return sum;
    }

    /// <summary>Kinetic energy and that of height above y = 0.</summary>
    public static double Total(IReadOnlyList<Actor> actors, double gravity)
    {
        double sum = Kinetic(actors);
        foreach (Actor actor in actors)
        {
            sum += actor.IsStatic || actor.Body.IsKinematic ? 0 : actor.Mass * gravity * actor.Position.Y;
        }

        return sum;
    }

    public static Vec Momentum(IReadOnlyList<Actor> actors)
    {
        Vec sum = new(0, 0);
        foreach (Actor actor in actors)
        {
            sum += actor.IsStatic ? new Vec(0, 0) : actor.Mass * actor.Velocity;
        }

        return sum;
    }

    public static double Mass(IReadOnlyList<Actor> actors)
    {
        double sum = 0;
        foreach (Actor actor in actors)
        {
            sum += actor.IsStatic || actor.Body.IsKinematic ? 0 : actor.Mass;
        }

        return sum;
    }

    public static double Fastest(IReadOnlyList<Actor> actors)
    {
        double fastest = 0;
        foreach (Actor actor in actors)
        {
            fastest = Math.Max(fastest, actor.IsStatic || actor.Body.IsKinematic ? 0 : actor.Velocity.Length);
        }

        return fastest;
    }

    public static double Median(List<double> values)
    {
        if (values.Count == 0)
        {
            return Runner.Exploded;
        }

        values.Sort();
        return 0.5 * (values[(values.Count - 1) / 2] + values[values.Count / 2]);
    }
}

/// <summary>How far the energy of a world rises above the least that it ever was before.</summary>
internal sealed class RunningRise
{
    private const double Gravity = 10;

    private readonly Rig _rig;
    private double _least;

    public RunningRise(Rig rig)
    {
        _rig = rig;
        Start = _least = Energy;
    }

    public double Start { get; }

    public double Rise { get; private set; }

    private double Energy => Bookkeeping.Total(_rig.Actors, Gravity);

    public void Look()
    {
        double now = Energy;
        Rise = Math.Max(Rise, now - _least);
        _least = Math.Min(_least, now);
    }
}
