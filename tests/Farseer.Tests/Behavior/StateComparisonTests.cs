using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Views;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>
/// Two states that differ in one field are told apart by it: whose it is, what it is called, both values and both bit patterns.
/// </summary>
public sealed class StateComparisonTests
{
    private const float Dt = 1f / 60;

    [Fact]
    public void Hash_OfASimulatorThatIsLookedAt_StaysTheSame()
    {
        using PhysicsSimulator simulator = Made();
        ulong before = simulator.StateHash();

        new PhysicsSimulatorView(simulator, new SvgDebugDraw(new Vector2(-20, -20), new Vector2(20, 20), 200, 200)).Draw();
        foreach (Geom geom in simulator.GeomList)
        {
            Assert.NotEmpty(geom.LocalVertices);
            Assert.NotEmpty(geom.WorldVertices);
            Assert.NotNull(geom.AABB);
        }

        Assert.Equal(before, simulator.StateHash());
    }

    [Fact]
    public void Simulators_MadeByTheSameProgram_AreTheSame()
    {
        using PhysicsSimulator one = Made();
        using PhysicsSimulator other = Made();

        StateComparison comparison = one.Compare(other);

        Assert.True(comparison.IsSame, comparison.ToString());
        Assert.Null(comparison.First);
        Assert.Equal("The states are the same.", comparison.ToString());
        Assert.Equal(one.StateHash(), other.StateHash());
    }

    [Fact]
    public void Velocity_OfOneBody_IsNamed()
    {
        using PhysicsSimulator one = Made();
        using PhysicsSimulator other = Made();
        Body body = other.BodyList[2];
        float before = body.LinearVelocity.X;
        body.LinearVelocity = new Vector2(before + 0.5f, body.LinearVelocity.Y);

        StateDifference difference = One(one, other, "Bodies", "State[");

        Assert.Equal("body 2 'crate 2'", difference.Item);
        Assert.EndsWith("].LinearVelocity.X", difference.Field, StringComparison.Ordinal);
        Assert.Equal(Bits(before), difference.FirstBits);
        Assert.Equal(Bits(before + 0.5f), difference.SecondBits);
        Assert.Contains("body 2 'crate 2'", difference.ToString(), StringComparison.Ordinal);
        Assert.NotEqual(one.StateHash(), other.StateHash());
    }

    [Fact]
    public void Friction_OfOneGeom_IsNamed()
    {
        using PhysicsSimulator one = Made();
        using PhysicsSimulator other = Made();
        other.GeomList[1].FrictionCoefficient = 0.75f;

        StateDifference difference = One(one, other, "Geom", "Link.Friction", "Friction");

        Assert.Equal("geom 1 'side 1'", difference.Item);
        Assert.Equal(Bits(one.GeomList[1].FrictionCoefficient), difference.FirstBits);
        Assert.Equal(Bits(0.75f), difference.SecondBits);
        Assert.Equal("0.75", difference.SecondValue);
    }

    [Fact]
    public void Softness_OfOneJoint_IsNamed()
    {
        using PhysicsSimulator one = Made();
        using PhysicsSimulator other = Made();
        other.JointList[0].Softness = 0.25f;

        StateDifference difference = One(one, other, "Joint", "softness");

        Assert.Equal("RevoluteJoint 0 'pin'", difference.Item);
        Assert.Equal(Bits(0.25f), difference.SecondBits);
    }

    [Fact]
    public void Gravity_OfTheSimulator_IsNamed()
    {
        using PhysicsSimulator one = Made();
        using PhysicsSimulator other = Made();
        other.Gravity = new Vector2(0, -11);

        StateDifference difference = One(one, other, "Settings", "Gravity.Y");

        Assert.Equal("-11", difference.SecondValue);
    }

    [Fact]
    public void Impulse_OfOnePair_IsNamed()
    {
        using PhysicsSimulator one = Made();
        using PhysicsSimulator other = Made();
        Assert.True(one.Compare(other).IsSame);
        other.Update(Dt);
        one.Update(Dt);
        other.BodyList[1].ApplyImpulse(new Vector2(0, -0.5f));
        other.Update(Dt);
        one.Update(Dt);

        StateComparison comparison = one.Compare(other, 1000);

        Assert.True(
            comparison.Differences.Any(d => d is { Section: "Contact", Field: "Point0.Feed", Item: "geom 0 and geom 1 'side 1'" }),
            comparison.ToString());
    }

    [Fact]
    public void Handler_OfOneBody_IsNamed()
    {
        using PhysicsSimulator one = Made();
        using PhysicsSimulator other = Made();
        other.BodyList[1].Updated += Moved;

        StateComparison comparison = one.Compare(other);

        Assert.Contains(comparison.Differences, d => d.Section == "Body" && d.Index == 1 && d.Item == "body 1 'crate 1'");
        Assert.NotEqual(one.StateHash(), other.StateHash());
    }

    [Fact]
    public void States_OfOneSimulatorAtTwoTimes_DifferAndTheSimulatorStaysAsItIs()
    {
        using PhysicsSimulator simulator = Made();
        PhysicsSimulatorState first = simulator.Capture();
        simulator.BodyList[1].AngularVelocity = 3;
        PhysicsSimulatorState second = simulator.Capture();
        simulator.Update(Dt);
        ulong hash = simulator.StateHash();

        StateComparison comparison = first.Compare(second);

        Assert.Equal("body 1 'crate 1'", comparison.First!.Item);
        Assert.EndsWith(".AngularVelocity", comparison.First.Field, StringComparison.Ordinal);
        Assert.Equal("3", comparison.First.SecondValue);
        Assert.Equal(hash, simulator.StateHash());
        Assert.True(first.Compare(first).IsSame);
    }

    [Fact]
    public void Differences_AreNotMoreThanAskedFor()
    {
        using PhysicsSimulator one = Made();
        using PhysicsSimulator other = Made();
        other.Update(Dt);

        Assert.Equal(5, one.Compare(other, 5).Differences.Count);
        Assert.Equal(5, one.Compare(other, 5).ToString().Split('\n').Length);
    }

    [Fact]
    public void Compare_WithBadArguments_NamesThem()
    {
        using PhysicsSimulator simulator = Made();
        var empty = new PhysicsSimulatorState();

        Assert.Equal("other", Assert.Throws<ArgumentNullException>(() => simulator.Compare(null!)).ParamName);
        Assert.Equal("most", Assert.Throws<ArgumentOutOfRangeException>(() => simulator.Compare(simulator, 0)).ParamName);
        Assert.Equal("other", Assert.Throws<ArgumentException>(() => simulator.Capture().Compare(empty)).ParamName);
        Assert.Throws<InvalidOperationException>(() => empty.Compare(simulator.Capture()));
    }

    [Fact]
    public void StateHash_OfWhatWaits_IsAnother()
    {
        using PhysicsSimulator one = Made();
        using PhysicsSimulator other = Made();
        ulong motion = other.MotionHash();
        other.BodyList[1].ApplyForce(new Vector2(1, 0));

        Assert.Equal(motion, other.MotionHash());
        Assert.NotEqual(one.StateHash(), other.StateHash());
        one.BodyList[1].ApplyForce(new Vector2(1, 0));
        Assert.Equal(one.StateHash(), other.StateHash());
    }

    [Fact]
    public void StateHash_WithinAnUpdate_IsRefused()
    {
        using PhysicsSimulator simulator = Made();
        Exception? thrown = null;
        simulator.BodyList[1].Updated += (ref Vector2 _, ref float _) => thrown ??= Record.Exception(() => simulator.StateHash());
        simulator.Update(Dt);

        Assert.IsType<InvalidOperationException>(thrown);
    }

    private static void Moved(ref Vector2 position, ref float rotation)
    {
    }

    private static string Bits(float value) =>
        BitConverter.SingleToUInt32Bits(value).ToString("x8", System.Globalization.CultureInfo.InvariantCulture);

    private static StateDifference One(PhysicsSimulator one, PhysicsSimulator other, string section, params string[] fields)
    {
        StateComparison comparison = one.Compare(other);
        return Assert.Single(
            comparison.Differences, d => d.Section == section && fields.Any(f => d.Field.StartsWith(f, StringComparison.Ordinal)));
    }

    /// <summary>A floor and crates on it, two of them pinned together, after some updates.</summary>
    private static PhysicsSimulator Made()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 40, 1, 1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 40, 1);
        var crates = new Body[5];
        for (int i = 1; i <= 4; i++)
        {
            Body crate = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
            crate.Position = new Vector2(3 * i, 1);
            crate.Name = "crate " + i;
            Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, crate, 1, 1);
            geom.Name = "side " + i;
            crates[i] = crate;
        }

        RevoluteJoint pin = JointFactory.Instance.CreateRevoluteJoint(simulator, crates[3], crates[4], new Vector2(10.5f, 1));
        pin.Tag = "pin";
        for (int i = 0; i < 10; i++)
        {
            simulator.Update(Dt);
        }

        return simulator;
    }
}
