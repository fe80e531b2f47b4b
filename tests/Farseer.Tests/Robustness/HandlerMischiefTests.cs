using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>Whatever a handler does, the simulation goes on.</summary>
public class HandlerMischiefTests
{
    [Fact]
    public void AnyChangeInAnyHandler_IsDeferredOrDone_AndTheRestGoesOn()
    {
        Action<PhysicsSimulator, Geom>[] mischief =
        {
            (s, g) => s.Remove(g),
            (s, g) => s.Remove(g.Body),
            (_, g) => g.Dispose(),
            (_, g) => g.Body.Dispose(),
            (s, _) => s.Clear(),
            (s, _) => Box(s, new Vector2(200, -50)),
            (_, g) => g.Body.IsStatic = true,
            (_, g) => g.Body.Enabled = false,
            (_, g) => g.Body.Position += new Vector2(0, -30),
            (_, g) => g.CollisionEnabled = false,
            (_, g) => g.CollisionGroup = 3,
            (_, g) => g.SetVertices(Vertices.CreateRectangle(10, 10)),
            (_, g) => g.SetBody(new Body { Position = new Vector2(0, -60) }),
            (s, _) => s.GeomList.Clear(),
            (s, _) => s.BodyList.Clear(),
            (s, _) => s.ArbiterList.Clear(),
            (s, _) => Assert.Throws<InvalidOperationException>(() => s.Update(0.01f)),
        };
        for (int m = 0; m < mischief.Length; m++)
        {
            for (int place = 0; place < 4; place++)
            {
                Act(mischief[m], place);
            }
        }
    }

    /// <summary>An update lasts as long as it was told to, whatever handlers do to the number of its iterations.</summary>
    [Fact]
    public void IterationsChangedInAHandler_ActFromTheNextUpdate()
    {
        PhysicsSimulator simulator = Scene(out Geom geom);
        geom.Body.LinearDragCoefficient = 0;
        Run(simulator, 100);
        geom.Body.LinearVelocity.X = 100;
        geom.OnCollision += (_, _, _) =>
        {
            simulator.Iterations = simulator.Iterations == 5 ? 50 : 5;
            return true;
        };
        float start = geom.Body.Position.X;
        for (int i = 1; i <= 10; i++)
        {
            simulator.Update(0.01f);

            // 1 an update, with the box on top at rest: neither has friction. Its weight cannot turn it by more than the gap allows.
            Assert.Equal(start + i, geom.Body.Position.X, 0.01f);
        }
    }

    [Fact]
    public void ExceptionOfAHandler_ComesOutAfterTheStep_AndTheNextStepWorks()
    {
        PhysicsSimulator simulator = Scene(out Geom geom);
        Geom.CollisionEventHandler handler = (_, _, _) => throw new FormatException("mine");
        geom.OnCollision += handler;
        Exception? seen = null;
        for (int i = 0; i < 100; i++)
        {
            try
            {
                simulator.Update(0.01f);
            }
            catch (FormatException exception)
            {
                seen = exception;
            }
        }

        Assert.NotNull(seen);
        geom.OnCollision -= handler;
        simulator.Update(0.01f);
        Assert.InRange(geom.Body.Position.Y, -21, -19);
    }

    [Fact]
    public void WrongItems_AreRefusedByName()
    {
        var simulator = new PhysicsSimulator();
        var other = new PhysicsSimulator();
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        Assert.Equal("body", Assert.Throws<ArgumentException>(() => other.Add(body)).ParamName);
        Assert.Equal("body", Assert.Throws<ArgumentException>(() => other.Remove(body)).ParamName);
        Assert.Throws<ArgumentNullException>(() => simulator.Add((Body)null!));
        Assert.Throws<ArgumentNullException>(() => simulator.Add((Geom)null!));
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(body, 1, 1);
        Assert.Throws<ArgumentException>(() => other.Add(geom));
        simulator.Add(geom);
        Assert.Throws<InvalidOperationException>(() => simulator.BroadPhaseCollider = new BruteForceCollider(simulator));
        Assert.Throws<ArgumentException>(() => simulator.Add(new Geom()));
        body.Dispose();
        Assert.Throws<ObjectDisposedException>(() => simulator.Add(body));
        Assert.Throws<ObjectDisposedException>(() => body.ApplyForce(Vector2.One));
        Assert.Throws<ObjectDisposedException>(() => GeomFactory.Instance.CreateRectangleGeom(body, 1, 1));
        simulator.Dispose();
        Assert.Throws<ObjectDisposedException>(() => simulator.Update(0.01f));
    }

    [Fact]
    public void VelocityThatIsNotANumber_LeavesTheOthersUnharmed()
    {
        PhysicsSimulator simulator = Scene(out Geom geom);
        Run(simulator, 20);
        Body far = Box(simulator, new Vector2(100, -40));
        geom.Body.LinearVelocity.X = float.NaN;
        Run(simulator, 100);
        Assert.InRange(far.Position.Y, -21, -19);
    }

    [Theory]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    [InlineData(-1f)]
    [InlineData(0f)]
    public void WrongNumbers_AreRefusedAndChangeNothing(float bad)
    {
        var body = new Body();
        Assert.Throws<ArgumentOutOfRangeException>(() => body.Mass = bad);
        Assert.Throws<ArgumentOutOfRangeException>(() => body.MomentOfInertia = bad);
        Assert.Equal(1, body.Mass);
        Assert.Equal(1, body.MomentOfInertia);
        Assert.Throws<ArgumentOutOfRangeException>(() => BodyFactory.Instance.CreateCircleBody(bad, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => BodyFactory.Instance.CreateRectangleBody(1, bad, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => BodyFactory.Instance.CreateRectangleBody(1, 1, bad));
        Assert.Throws<ArgumentOutOfRangeException>(() => GeomFactory.Instance.CreateCircleGeom(body, bad, 8));
        Assert.Throws<ArgumentOutOfRangeException>(() => GeomFactory.Instance.CreateRectangleGeom(body, bad, 8));
        var simulator = new PhysicsSimulator();
        if (bad != 0)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => simulator.Update(bad));
        }

        if (!(bad <= 0))
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => GeomFactory.Instance.CreateRectangleGeom(body, 1, 1, bad));
        }
    }

    /// <summary>It waits for the end of the update; what else the handler does then is done as if it had not been called.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void SimulatorDisposedInAHandler_EndsWithTheUpdate_AndKeepsNothing(int place)
    {
        PhysicsSimulator simulator = Scene(out Geom geom);
        Body left = Box(simulator, new Vector2(100, -60));
        Body other = Box(simulator, new Vector2(130, -60));
        var joint = new RevoluteJoint(left, other, new Vector2(115, -60));
        simulator.Add(joint);
        var spring = new LinearSpring(left, Vector2.Zero, other, Vector2.Zero, 1, 1);
        simulator.Add(spring);
        Geom late = GeomFactory.Instance.CreateRectangleGeom(left, 5, 5);
        bool done = false;
        AddHandler(simulator, geom, place, () =>
        {
            if (!done)
            {
                done = true;
                simulator.Dispose();
                simulator.Add(late);
                joint.Dispose();
                spring.Dispose();
                other.Dispose();
                simulator.Dispose();
                Assert.NotEmpty(simulator.BodyList);
            }
        });
        for (int i = 0; i < 150 && !done; i++)
        {
            simulator.Update(0.01f);
        }

        Assert.True(done, "handler " + place + " was not called");
        Assert.Empty(simulator.BodyList);
        Assert.Empty(simulator.GeomList);
        Assert.Empty(simulator.JointList);
        Assert.Empty(simulator.SpringList);
        Assert.Empty(simulator.ArbiterList);
        Assert.Throws<ObjectDisposedException>(() => simulator.Update(0.01f));
        simulator.Dispose();
        var next = new PhysicsSimulator();
        next.Add(left);
        next.Add(late);
        next.Add(geom.Body);
        next.Add(geom);
        next.Update(0.01f);
        Assert.Equal(2, next.GeomList.Count);
    }

    private static void Act(Action<PhysicsSimulator, Geom> mischief, int place)
    {
        PhysicsSimulator simulator = Scene(out Geom geom);
        bool done = false;
        AddHandler(simulator, geom, place, () =>
        {
            if (!done)
            {
                done = true;
                mischief(simulator, geom);
            }
        });
        Run(simulator, 150);
        Assert.True(done, "handler " + place + " was not called");
        Body later = Box(simulator, new Vector2(100, -60));
        Run(simulator, 20);
        Assert.True(later.Position.Y > -60);
        Assert.False(float.IsNaN(later.Position.Y));
    }

    private static void AddHandler(PhysicsSimulator simulator, Geom geom, int place, Action act)
    {
        switch (place)
        {
            case 0:
                geom.OnCollision += (_, _, _) =>
                {
                    act();
                    return true;
                };
                break;
            case 1:
                geom.RestitutionCoefficient = 2;
                geom.OnSeparation += (_, _) => act();
                break;
            case 2:
                simulator.BroadPhaseCollider.OnBroadPhaseCollision += (_, _) =>
                {
                    act();
                    return true;
                };
                break;
            default:
                geom.Body.Updated += (ref Vector2 _, ref float _) => act();
                break;
        }
    }

    private static PhysicsSimulator Scene(out Geom geom)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 400, 20, 1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 400, 20);
        Body box = Box(simulator, new Vector2(0, -25));
        geom = box.GeomAt(0);
        Box(simulator, new Vector2(0, -50));
        return simulator;
    }

    private static Body Box(PhysicsSimulator simulator, Vector2 place)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 20, 20, 1);
        body.Position = place;
        GeomFactory.Instance.CreateRectangleGeom(simulator, body, 20, 20);
        return body;
    }

    private static void Run(PhysicsSimulator simulator, int steps)
    {
        for (int i = 0; i < steps; i++)
        {
            simulator.Update(0.01f);
        }
    }
}
