using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes;

/// <summary>Figures of a whole world, in double precision.</summary>
public static class Measure
{
    /// <summary>Kinetic plus potential energy of the bodies that move freely; the potential is 0 at the origin.</summary>
    public static double Energy(PhysicsSimulator simulator)
    {
        double sum = 0.0;
        Vector2 gravity = simulator.Gravity;
        foreach (Body body in simulator.BodyList)
        {
            if (body.InverseMass == 0f)
            {
                continue;
            }

            Vector2 v = body.LinearVelocity;
            Vector2 p = body.Position;
            sum += 0.5 * body.Mass * (((double)v.X * v.X) + ((double)v.Y * v.Y));
            sum += 0.5 * body.MomentOfInertia * body.AngularVelocity * body.AngularVelocity;
            if (!body.IgnoreGravity)
            {
                sum -= body.Mass * (((double)gravity.X * p.X) + ((double)gravity.Y * p.Y));
            }
        }

        return sum;
    }

    /// <summary>Greatest speed of a point on the rim of a geom's body: linear speed plus spin times half the geom's box.</summary>
    public static double FastestSpeed(IReadOnlyList<Geom> geoms)
    {
        double fastest = 0.0;
        foreach (Geom geom in geoms)
        {
            AABB box = geom.AABB;
            double reach = 0.5 * Math.Max(box.Width, box.Height);
            double speed = geom.Body.LinearVelocity.Length() + (Math.Abs(geom.Body.AngularVelocity) * reach);
            fastest = double.IsNaN(speed) ? double.NaN : Math.Max(fastest, speed);
        }

        return fastest;
    }

    /// <summary>Signed angle of a body in (-pi, pi].</summary>
    public static double Angle(Body body) => Math.IEEERemainder(body.Rotation, 2.0 * Math.PI);
}
