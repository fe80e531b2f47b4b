using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Reflection;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>
/// A capture into a state that was captured before passes over what has not changed since: whatever a public member changes must be
/// noticed.
/// </summary>
public sealed class UnchangedStateTests
{
    private const float Dt = 1f / 60;

    [Fact]
    public void State_UsedAgainAfterAnyPropertyWasSet_IsTheOneOfANewObject()
    {
        using PhysicsSimulator simulator = Made();
        var again = new PhysicsSimulatorState();
        int set = 0;
        var missed = new List<string>();
        foreach (object item in simulator.BodyList.Skip(1).Take(1).Cast<object>().Concat(simulator.GeomList.Skip(1).Take(1))
            .Concat(simulator.JointList))
        {
            foreach (PropertyInfo property in item.GetType().GetProperties().Where(p => p.SetMethod is { IsPublic: true }))
            {
                simulator.Capture(again);
                if (!TrySet(item, property))
                {
                    continue;
                }

                set++;
                simulator.Capture(again);
                if (!again.IsSameAs(simulator.Capture()))
                {
                    missed.Add(item.GetType().Name + "." + property.Name);
                }
            }
        }

        Assert.True(set > 80, $"only {set} properties were set");
        Assert.Empty(missed);
    }

    [Fact]
    public void State_UsedAgainAfterHandlersAndForces_IsTheOneOfANewObject()
    {
        using PhysicsSimulator simulator = Made();
        var again = new PhysicsSimulatorState();
        Body body = simulator.BodyList[1];
        Geom geom = simulator.GeomList[1];
        Joint joint = simulator.JointList[0];
        EventHandler<EventArgs> handler = (_, _) => { };
        Action[] changes =
        [
            () => joint.Broke += handler, () => joint.Broke -= handler, () => body.Disposed += handler, () => body.Disposed -= handler,
            () => geom.OnSeparation += (_, _) => { }, () => geom.OnSeparation = null, () => body.ApplyImpulse(Vector2.One),
            () => body.ApplyForce(Vector2.One), () => body.ApplyForceAtLocalPoint(Vector2.One, Vector2.UnitX), () => body.Awake = false,
            () => geom.SetSegmentMaterial(0, new SurfaceMaterial { Friction = 1 }), () => geom.ComputeCollisionGrid(),
            () => geom.SetVertices(Vertices.CreateRectangle(2, 1)), () => geom.SetBody(simulator.BodyList[2]), () => simulator.Update(Dt),
            () => simulator.Remove(geom), () => simulator.Update(Dt), () => joint.Dispose(), () => body.Dispose(),
            () => simulator.Update(Dt),
        ];
        for (int i = 0; i < changes.Length; i++)
        {
            simulator.Capture(again);
            changes[i]();

            simulator.Capture(again);
            Assert.True(again.IsSameAs(simulator.Capture()), $"change {i} was missed");
        }
    }

    private static bool TrySet(object item, PropertyInfo property)
    {
        object? value = property.GetValue(item) switch
        {
            bool flag => !flag,
            float number => number + 0.5f,
            double number => number + 0.5,
            int number => number + 1,
            Vector2 vector => vector + new Vector2(0.25f, 0.5f),
            Enum => Enum.GetValues(property.PropertyType).GetValue(1),
            string => "other",
            _ => null,
        };
        try
        {
            property.SetValue(item, value);
            return value is not null;
        }
        catch (TargetInvocationException)
        {
            return false;
        }
    }

    private static PhysicsSimulator Made()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10));
        for (int i = 0; i < 200; i++)
        {
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
            body.Position = new Vector2(2 * i, 0);
            GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1);
        }

        simulator.Update(Dt);
        Joint[] joints =
        [
            new RevoluteJoint(simulator.BodyList[10], simulator.BodyList[11], new Vector2(21, 0)),
            new PinJoint(simulator.BodyList[12], Vector2.Zero, simulator.BodyList[13], Vector2.Zero),
            new SliderJoint(simulator.BodyList[14], Vector2.Zero, simulator.BodyList[15], Vector2.Zero, 1, 3),
            new DistanceJoint(simulator.BodyList[16], Vector2.Zero, simulator.BodyList[17], Vector2.Zero),
            new AngleJoint(simulator.BodyList[18], simulator.BodyList[19]),
            new AngleLimitJoint(simulator.BodyList[20], simulator.BodyList[21], -1, 1),
            new WeldJoint(simulator.BodyList[22], simulator.BodyList[23], new Vector2(45, 0)),
            new FixedRevoluteJoint(simulator.BodyList[24], new Vector2(48, 0)),
            new FixedAngleJoint(simulator.BodyList[25]),
            new FixedAngleLimitJoint(simulator.BodyList[26], -1, 1),
        ];
        foreach (Joint joint in joints)
        {
            simulator.Add(joint);
        }

        simulator.Update(Dt);
        return simulator;
    }
}
