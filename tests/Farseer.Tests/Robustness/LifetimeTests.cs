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

namespace Farseer.Tests.Robustness;

/// <summary>
/// Things in the wrong place or at the wrong time: of another simulator, added twice, disposed, changed within a handler.
/// </summary>
public class LifetimeTests
{
    [Fact]
    public void WrongPlace_IsRefused_AndChangesNothing()
    {
        var other = new PhysicsSimulator();
        Body foreign = BodyFactory.Instance.CreateBody(other, 1, 1);
        Geom foreignGeom = GeomFactory.Instance.CreateCircleGeom(other, foreign, 1, 8);
        other.Update(0.01f);
        GeomFactory geoms = GeomFactory.Instance;
        var refusals = new (string Name, Action<Bench> Act)[]
        {
            ("body", b => b.Simulator.Add(foreign)),
            ("body", b => b.Simulator.BodyList.Add(foreign)),
            ("body", b => b.Simulator.Remove(foreign)),
            ("geometry", b => b.Simulator.Add(foreignGeom)),
            ("geometry", b => b.Simulator.Remove(foreignGeom)),
            ("body", b => geoms.CreateRectangleGeom(b.Simulator, foreign, 1, 1)),
            ("body", b => geoms.CreateChainGeom(b.Simulator, foreign, Bench.Outline(), true)),
            ("body", b => geoms.CreateGeom(b.Simulator, foreign, b.BoxGeom)),
            ("body", b => geoms.CreateRectangleGeom(other, b.Box, 1, 1)),
            ("bodyToSet", b => b.BoxGeom.SetBody(foreign)),
            ("geometry", b => b.Simulator.Add(new Geom())),
            ("BroadPhaseCollider", b => new PhysicsSimulator().BroadPhaseCollider = new GridCollider(b.Simulator)),
        };
        ulong undisturbed = new Bench().HashLater();
        foreach ((string name, Action<Bench> act) in refusals)
        {
            var bench = new Bench();
            Assert.Equal(name, Assert.ThrowsAny<ArgumentException>(() => act(bench)).ParamName);
            Assert.Equal(undisturbed, bench.HashLater());
            Assert.Equal(1, foreign.GeomCount);
            other.Update(0.01f);
            Assert.Single(other.GeomList);
        }
    }

    [Fact]
    public void AddedTwice_ChangesNothing()
    {
        ulong undisturbed = new Bench().HashLater();
        foreach (Action<Bench> act in new Action<Bench>[]
        {
            b => b.Simulator.Add(b.Box),
            b => b.Simulator.BodyList.Add(b.Box),
            b => b.Simulator.Add(b.BoxGeom),
            b => b.Simulator.Add(b.Simulator.InactivityController),
        })
        {
            var bench = new Bench();
            act(bench);
            Assert.Equal(undisturbed, bench.HashLater());
        }
    }

    [Fact]
    public void BroadPhaseAndQuirks_CannotChangeWhileGeomsExist()
    {
        var bench = new Bench();
        Assert.Throws<InvalidOperationException>(() => bench.Simulator.BroadPhaseCollider = new GridCollider(bench.Simulator));
        Assert.Throws<InvalidOperationException>(() => bench.Simulator.Quirks = Farseer201Quirks.All);
        Assert.Equal(new Bench().HashLater(), bench.HashLater());

        // A geom that waits counts as well.
        var simulator = new PhysicsSimulator();
        GeomFactory.Instance.CreateCircleGeom(simulator, new Body(), 1, 8);
        Assert.Throws<InvalidOperationException>(() => simulator.BroadPhaseCollider = new GridCollider(simulator));
    }

    [Fact]
    public void GeomMovedToAFreshBody_KeepsTheBodyFromOtherSimulators_UntilItLeaves()
    {
        var bench = new Bench();
        var fresh = new Body { Position = new Vector2(100, -50) };
        var passing = new Body();
        bench.BoxGeom.SetBody(passing);
        bench.BoxGeom.SetBody(fresh);
        var other = new PhysicsSimulator();
        other.Add(passing);
        Assert.Throws<ArgumentException>(() => other.Add(fresh));
        bench.Step(2);
        Assert.Equal(new Vector2(100, -50), bench.BoxGeom.Position);
        bench.Simulator.Remove(bench.BoxGeom);
        bench.Step(1);
        other.Add(fresh);

        // The same for a geom that still waits to be taken in.
        Geom waiting = GeomFactory.Instance.CreateCircleGeom(bench.Simulator, new Body(), 1, 8);
        var last = new Body();
        waiting.SetBody(last);
        Assert.Throws<ArgumentException>(() => other.Add(last));
        bench.Step(1);
        Assert.Contains(waiting, bench.Simulator.GeomList);
    }

    [Fact]
    public void RemovingAndAddingInAHandler_WaitsForTheNextUpdate()
    {
        var bench = new Bench();
        int seen = 0;
        bench.BoxGeom.OnCollision += (geom, _, _) =>
        {
            if (seen++ == 0)
            {
                bench.Simulator.Remove(geom);
                bench.Simulator.Remove(geom.Body);
                Assert.Contains(geom, bench.Simulator.GeomList);
                Assert.Contains(geom.Body, bench.Simulator.BodyList);
            }

            return true;
        };
        bench.Step(1);
        Assert.Contains(bench.BoxGeom, bench.Simulator.GeomList);
        bench.Step(1);
        Assert.DoesNotContain(bench.BoxGeom, bench.Simulator.GeomList);
        Assert.DoesNotContain(bench.Box, bench.Simulator.BodyList);
        bench.Simulator.Add(bench.Box);
        bench.Simulator.Add(bench.BoxGeom);
        bench.HashLater();
        bench.AssertSound();
    }

    [Theory]
    [InlineData(typeof(Body))]
    [InlineData(typeof(Geom))]
    [InlineData(typeof(PhysicsSimulator))]
    public void EveryMember_AfterDispose_SaysSoOrDoesNoHarm(Type type)
    {
        foreach (MethodInfo method in type.GetMethods(BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly))
        {
            // A span cannot be handed over by reflection.
            if (Array.Exists(method.GetParameters(), p => p.ParameterType.IsByRefLike))
            {
                continue;
            }

            var bench = new Bench();
            object target = bench.Target(type)!;
            bench.Simulator.Add(new Body());
            ((IDisposable)target).Dispose();
            object?[] arguments = method.GetParameters()
                .Select(p =>
                    p.IsOut ? null : bench.Valid(p.ParameterType.IsByRef ? p.ParameterType.GetElementType()! : p.ParameterType, p.Name!))
                .ToArray();
            Exception? thrown = null;
            try
            {
                method.Invoke(target, arguments);
            }
            catch (TargetInvocationException exception)
            {
                thrown = exception.InnerException;
            }
            catch (NotSupportedException)
            {
                // Reflection cannot call a property that returns a reference; reading one does nothing.
                continue;
            }

            Assert.True(thrown is null or ObjectDisposedException or ArgumentException, method + ": " + thrown);
            if (type == typeof(PhysicsSimulator))
            {
                Assert.Throws<ObjectDisposedException>(() => bench.Step(1));
                continue;
            }

            bench.HashLater();
            bench.AssertSound();
            Assert.DoesNotContain(bench.BoxGeom, bench.Simulator.GeomList);
        }
    }

    [Fact]
    public void UseAfterDispose_IsRefusedWithTheName()
    {
        var bench = new Bench();
        bench.Box.Dispose();
        bench.Box.Dispose();
        var refused = new List<Action>
        {
            () => bench.Box.Mass = 2,
            () => bench.Box.Position = Vector2.Zero,
            () => bench.Box.Rotation = 1,
            () => bench.Box.IsStatic = true,
            () => bench.Box.ApplyForce(Vector2.One),
            () => bench.Box.ApplyTorque(1),
            () => bench.Box.ApplyImpulse(Vector2.One),
            () => bench.Simulator.Add(bench.Box),
            () => bench.Simulator.Add(bench.BoxGeom),
            () => bench.BoxGeom.SetBody(new Body()),
            () => bench.BoxGeom.SetVertices(Bench.Outline()),
            () => GeomFactory.Instance.CreateCircleGeom(bench.Box, 1, 8),
            () => GeomFactory.Instance.CreateCircleGeom(bench.Simulator, bench.Box, 1, 8),
        };
        foreach (Action act in refused)
        {
            Assert.Contains(Assert.Throws<ObjectDisposedException>(act).ObjectName, new[] { "Body", "Geom" });
        }

        bench.HashLater();
        bench.Simulator.Dispose();
        Assert.Throws<ObjectDisposedException>(() => bench.Simulator.Update(0.01f));
        Assert.Throws<ObjectDisposedException>(() => bench.Simulator.Add(new Body()));
        Assert.Throws<ObjectDisposedException>(() => BodyFactory.Instance.CreateBody(bench.Simulator, 1, 1));
        Assert.Throws<ObjectDisposedException>(() => bench.Simulator.Clear());
    }

    [Fact]
    public void BodyOfAnotherSimulator_IsRefusedByAJoint_ThatIsInOne()
    {
        var bench = new Bench();
        using PhysicsSimulator other = new();
        Body foreign = BodyFactory.Instance.CreateCircleBody(other, 1, 1);
        other.Update(0.01f);
        var partner = new Body();
        var pin = new PinJoint(bench.Box, Vector2.Zero, partner, Vector2.Zero) { Enabled = false };
        var nail = new FixedRevoluteJoint(bench.Box, Vector2.Zero) { Enabled = false };
        bench.Simulator.Add(pin);
        bench.Simulator.Add(nail);

        // Both while they wait to be taken in and when they are in.
        for (int i = 0; i < 2; i++)
        {
            Assert.Throws<ArgumentException>("Body1", () => pin.Body1 = foreign);
            Assert.Throws<ArgumentException>("Body2", () => pin.Body2 = foreign);
            Assert.Throws<ArgumentException>("Body", () => nail.Body = foreign);
            Assert.Same(bench.Box, pin.Body1);
            Assert.Same(partner, pin.Body2);
            Assert.Same(bench.Box, nail.Body);
            bench.Simulator.Update(0.01f);
        }
    }

    [Fact]
    public void JointGivenAFreshBody_KeepsItFromOtherSimulators_UntilItLeaves()
    {
        using PhysicsSimulator simulator = new();
        using PhysicsSimulator other = new();
        Body first = BodyFactory.Instance.CreateCircleBody(simulator, 1, 1);
        Body second = BodyFactory.Instance.CreateCircleBody(simulator, 1, 1);
        var passing = new Body();
        var fresh = new Body();
        PinJoint joint = JointFactory.Instance.CreatePinJoint(simulator, first, Vector2.Zero, second, Vector2.Zero);
        simulator.Update(0.01f);
        joint.Body2 = passing;
        joint.Body2 = fresh;
        Assert.Throws<ArgumentException>("body", () => other.Add(fresh));
        simulator.Update(0.01f);
        Assert.Throws<ArgumentException>("body", () => other.Add(fresh));
        other.Add(passing);
        joint.Body2 = second;
        simulator.Clear();
        other.Add(fresh);
        other.Update(0.01f);
        Assert.Equal(2, other.BodyList.Count);
    }

    [Fact]
    public void Spring_RemovedWhileItWaited_StaysWithTheSimulatorThatTookItAfterTheFirstIsCleared()
    {
        using PhysicsSimulator first = new();
        using PhysicsSimulator second = new();
        Body body = BodyFactory.Instance.CreateCircleBody(second, 1, 1);
        var spring = new FarseerGames.FarseerPhysics.Dynamics.Springs.FixedLinearSpring(body, Vector2.Zero, new Vector2(3, 0), 10, 0.1f);
        first.Add(spring);
        first.Remove(spring);
        second.Add(spring);
        first.Clear();
        second.Update(0.01f);
        Assert.Same(spring, Assert.Single(second.SpringList));
    }
}
