using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Simulation;
using Farseer.Engine.Springs;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Hands springs to the engine, which integrates them within the substeps. A spring whose update the user calls himself, outside of
/// the moment at which forces act, gives its bodies the plain force instead.
/// </summary>
internal static class SpringLink
{
    /// <summary>Distance of two points of bodies; a body that is null stands for the world.</summary>
    public static float Distance(Body body1, Vector2 point1, Body? body2, Vector2 point2)
    {
        Place(body1, point1, out double x1, out double y1);
        Place(body2, point2, out double x2, out double y2);
        return (float)Math.Sqrt(((x2 - x1) * (x2 - x1)) + ((y2 - y1) * (y2 - y1)));
    }

    /// <summary>Angle of the second body less that of the first, with all turns.</summary>
    public static double Angle(Body? body1, Body body2) => body2.Link.PoseRef.Angle - (body1 is null ? 0 : body1.Link.PoseRef.Angle);

    public static void Linear(Spring spring, Body body1, Vector2 point1, Body? body2, Vector2 point2, float restLength)
    {
        PhysicsSimulator? simulator = spring.Simulator ?? body1.Simulator;
        if (simulator is not { IsApplyingForces: true })
        {
            Pull(spring, body1, point1, body2, point2, restLength);
            return;
        }

        var def = new SpringDef
        {
            Kind = SpringKind.Linear,
            AnchorA = point1,
            AnchorB = point2,
            Rest = restLength,
            Stiffness = spring.SpringConstant,
            Damping = spring.DampingConstant,
        };
        def.BodyA = IndexIn(simulator.World, body1, ref def.AnchorA, out _);
        def.BodyB = IndexIn(simulator.World, body2, ref def.AnchorB, out _);
        spring.Memory.Tell(simulator.World, def);
    }

    public static void Angular(Spring spring, Body? body1, Body body2, float targetAngle, float multiplier, float maxTorque)
    {
        PhysicsSimulator? simulator = spring.Simulator ?? body2.Simulator;
        if (simulator is not { IsApplyingForces: true })
        {
            Twist(spring, body1, body2, targetAngle, multiplier, maxTorque);
            return;
        }

        var def = new SpringDef
        {
            Kind = SpringKind.Angular,
            Rest = targetAngle,
            Stiffness = (double)spring.SpringConstant * multiplier,
            Damping = (double)spring.DampingConstant * multiplier,
            MaxTorque = maxTorque < float.MaxValue ? maxTorque : double.PositiveInfinity,
        };
        def.BodyA = IndexIn(simulator.World, body1, ref def.AnchorA, out double angle1);
        def.BodyB = IndexIn(simulator.World, body2, ref def.AnchorB, out double angle2);
        def.Rest += angle1 - angle2;
        spring.Memory.Tell(simulator.World, def);
    }

    /// <summary>
    /// Index of a body; one that is not in this world is a place of it, index 0, with the point and the angle that it has now.
    /// </summary>
    private static int IndexIn(World world, Body? body, ref Vector2 point, out double angle)
    {
        angle = 0;
        if (body is null)
        {
            return 0;
        }

        if (ReferenceEquals(body.Link.World, world))
        {
            return body.Link.Handle.Index;
        }

        Place(body, point, out double x, out double y);
        point = new Vector2((float)x, (float)y);
        angle = body.Link.PoseRef.Angle;
        return 0;
    }

    private static void Place(Body? body, Vector2 point, out double x, out double y)
    {
        if (body is null)
        {
            x = point.X;
            y = point.Y;
            return;
        }

        ref BodyPose pose = ref body.Link.PoseRef;
        x = pose.X + ((double)pose.Cos * point.X) - ((double)pose.Sin * point.Y);
        y = pose.Y + ((double)pose.Sin * point.X) + ((double)pose.Cos * point.Y);
    }

    private static void Pull(Spring spring, Body body1, Vector2 point1, Body? body2, Vector2 point2, float restLength)
    {
        Place(body1, point1, out double x1, out double y1);
        Place(body2, point2, out double x2, out double y2);
        var line = new Vector2((float)(x2 - x1), (float)(y2 - y1));
        float length = line.Length();
        if (!(length > 0))
        {
            return;
        }

        Vector2 normal = line / length;
        body1.GetVelocityAtLocalPoint(ref point1, out Vector2 speed);
        speed = -speed;
        if (body2 is not null)
        {
            body2.GetVelocityAtLocalPoint(ref point2, out Vector2 speed2);
            speed += speed2;
        }

        Vector2 force = ((spring.SpringConstant * (length - restLength)) + (spring.DampingConstant * Vector2.Dot(speed, normal))) * normal;
        body1.ApplyForceAtLocalPoint(force, point1);
        body2?.ApplyForceAtLocalPoint(-force, point2);
    }

    private static void Twist(Spring spring, Body? body1, Body body2, float targetAngle, float multiplier, float maxTorque)
    {
        float torque = spring.SpringConstant * (float)(Angle(body1, body2) - targetAngle);
        body2.ApplyTorque(Limit(multiplier * (-torque - (spring.DampingConstant * body2.AngularVelocity)), maxTorque));
        body1?.ApplyTorque(Limit(multiplier * (torque - (spring.DampingConstant * body1.AngularVelocity)), maxTorque));
    }

    private static float Limit(float torque, float most) => Math.Min(Math.Max(torque, -most), most);
}
