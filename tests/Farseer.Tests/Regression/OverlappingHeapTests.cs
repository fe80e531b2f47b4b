using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// A heap of bodies that begin in each other, one of which is a wheel. What touches a tree of joints is moved by its passes, and these told
/// contacts of turns of several radians since the middle of the step, where contacts can follow one: their sweeps grew what they were to
/// settle, to 1.7·10⁸ m/s in the first step.
/// </summary>
public class OverlappingHeapTests
{
    private static readonly Start[] _starts =
    [
        new(2.6348655f, 2.837925f, 0, 0, 0.71919775f, 2.0265474f, 0.97934f, 0, 0),
        new(3.2425938f, 3.0081086f, 2.80328f, 0.3421f, 0.28317f, 1.4543f, 0.1049f, 0, 0),
        new(-0.02877f, 4.02153f, 0, 0.41612f, 0.89226f, 1.82722f, 0.6307f, 0, 0),
        new(-3.11769f, 6.06537f, 0, 0.8259f, 0.22241f, 2.47193f, 0.03815f, 0.39825f, 0),
        new(3.03933f, 2.88668f, 0, 1.21222f, 0.21978f, 0.87858f, 0.60443f, 0, 1),
        new(-0.31808f, 2.17034f, -0.3203f, 0.98236f, 0.95748f, 1.87228f, 0.92844f, 0.76437f, 0),
        new(3.14931f, 2.92469f, -2.62487f, 0, 0.4033f, 2.25571f, 0.63246f, 0, 0),
        new(-2.68722f, 2.88558f, 0.0376f, 0.46254f, 0.73524f, 2.29391f, 0.65813f, 0, 0),
        new(2.73014f, 1.91574f, 0, 0.5975f, 0.63145f, 1.10933f, 0.72091f, 0, 1),
        new(2.1897f, 2.73128f, 0, 0.52106f, 0.62297f, 1.33121f, 0.79381f, 0.67076f, 0),
    ];

    [Fact]
    public void Heap_OfBodiesInEachOtherAndAWheel_FliesNotApart()
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { Iterations = 10 };
        var bodies = new Body[_starts.Length];
        for (int i = 0; i < _starts.Length; i++)
        {
            Start start = _starts[i];
            var place = new Vector2(start.X, start.Y);
            Geom geom = start.Width > 0
                ? Sandbox.Box(simulator, place, start.Width, start.Height, start.Mass)
                : Sandbox.Ball(simulator, place, start.Height, start.Mass, 20);
            geom.FrictionCoefficient = start.Friction;
            geom.RestitutionCoefficient = start.Restitution;
            geom.CollisionGroup = start.Group;
            geom.Body.Rotation = start.Angle;
            bodies[i] = geom.Body;
        }

        bodies[1].AngularVelocity = 1.17f;
        bodies[3].LinearVelocity = new Vector2(2, -0.98f);
        bodies[5].LinearVelocity = new Vector2(2.97f, 1.99f);
        bodies[6].AngularVelocity = -1.46f;
        simulator.Add(new WheelJoint(bodies[7], bodies[9], bodies[9].Position, new Vector2(0.997f, 0.0775f)) { CollideConnected = false });
        for (int step = 0; step < 120; step++)
        {
            simulator.Update(1 / 60f);

            // A fall of two seconds, and what the heap is pushed apart with.
            Assert.All(bodies, body => Assert.InRange(body.LinearVelocity.Length(), 0, 30));
        }
    }

    private readonly record struct Start(
        float X, float Y, float Angle, float Width, float Height, float Mass, float Friction, float Restitution, int Group);
}
