using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Numerics;
using Farseer.Hunt;
using Farseer.Hunt.Running;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;
using Xunit;
using Xunit.Abstractions;

namespace Farseer.Tests.Behavior;

/// <summary>States are captured and gone back to.</summary>
public sealed class StateTests(ITestOutputHelper output)
{
    /// <summary>A share of a minute's work; the command <c>state</c> of the hunt does more.</summary>
    private const int Worlds = 60;

    private const float Dt = 1f / 60;

    [Fact]
    public void RandomWorlds_RestoredAfterDetours_GoOnAsWithout()
    {
        using var log = new StringWriter(CultureInfo.InvariantCulture);
        StateTally tally = StateHunt.Run(Facades.Find("farseer"), 1, TimeSpan.MaxValue, Worlds, long.MaxValue, null, log);
        output.WriteLine(log.ToString());
        Assert.True(tally.Different == 0, log.ToString());
        Assert.True(tally.Detours > 1000);
    }

    [Fact]
    public void Pyramid_CapturedAndRestored_AllocatesNothingOnceWarm()
    {
        PhysicsSimulator simulator = Pyramid(20, out _);
        var state = new PhysicsSimulatorState();
        Exchange(simulator, state);
        const int Rounds = 50;
        long before = GC.GetAllocatedBytesForCurrentThread();
        long start = Stopwatch.GetTimestamp();
        for (int i = 0; i < Rounds; i++)
        {
            simulator.Capture(state);
        }

        TimeSpan capture = Stopwatch.GetElapsedTime(start) / Rounds;
        start = Stopwatch.GetTimestamp();
        for (int i = 0; i < Rounds; i++)
        {
            simulator.Restore(state);
        }

        TimeSpan restore = Stopwatch.GetElapsedTime(start) / Rounds;
        long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
        int bodies = simulator.BodyList.Count;
        output.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"{bodies} bodies: {(double)state.ByteCount / bodies:f0} bytes a body, {capture.TotalMilliseconds:f3} ms a capture, "
            + $"{restore.TotalMilliseconds:f3} ms a restore"));
        Assert.Equal(0, allocated);

        static void Exchange(PhysicsSimulator simulator, PhysicsSimulatorState state)
        {
            for (int i = 0; i < 3; i++)
            {
                simulator.Capture(state);
                simulator.Update(Dt);
                simulator.Restore(state);
            }
        }
    }

    [Fact]
    public void Restore_OfWhatWasAddedRemovedAndDisposedSince_HasTheSameInstances()
    {
        PhysicsSimulator simulator = Pyramid(4, out Body top);
        PhysicsSimulatorState state = simulator.Capture();
        Body[] bodies = simulator.BodyList.ToArray();
        Body added = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        added.Position = new Vector2(20, 20);
        simulator.Remove(bodies[1]);
        top.Dispose();
        Sandbox.Run(simulator, 5);
        float fallen = added.Position.Y;
        simulator.Restore(state);
        Assert.Equal(bodies, simulator.BodyList.ToArray());
        Assert.False(top.IsDisposed);
        Assert.DoesNotContain(added, simulator.BodyList);
        Assert.Equal(fallen, added.Position.Y);

        // It belongs to nobody, so another one may have it.
        using var other = new PhysicsSimulator();
        other.Add(added);
        other.Update(Dt);
        Assert.Contains(added, other.BodyList);
    }

    [Fact]
    public void Restore_OfABodyThatAnotherSimulatorHasByNow_IsRefusedAndChangesNothing()
    {
        PhysicsSimulator simulator = Pyramid(4, out Body top);
        PhysicsSimulatorState state = simulator.Capture();
        simulator.Remove(top.GeomAt(0));
        simulator.Remove(top);
        simulator.Update(Dt);
        using var other = new PhysicsSimulator();
        other.Add(top);
        other.Update(Dt);
        ulong hash = simulator.MotionHash();
        Assert.Throws<InvalidOperationException>(() => simulator.Restore(state));
        Assert.Equal(hash, simulator.MotionHash());
        Assert.Contains(top, other.BodyList);
    }

    [Fact]
    public void Capture_WithAJointOfTheUsersThatSavesNothing_NamesItsType()
    {
        PhysicsSimulator simulator = Pyramid(2, out _);
        simulator.Add(new Silent());
        InvalidOperationException refused = Assert.Throws<InvalidOperationException>(() => simulator.Capture());
        Assert.Contains(typeof(Silent).FullName!, refused.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Restore_WithAControllerOfTheUsers_GivesItItsBytesBack()
    {
        PhysicsSimulator simulator = Pyramid(2, out _);
        var counter = new Counter();
        simulator.Add(counter);
        Sandbox.Run(simulator, 3);
        PhysicsSimulatorState state = simulator.Capture();
        Assert.Equal(3, counter.Count);
        Sandbox.Run(simulator, 4);
        simulator.Restore(state);
        Assert.Equal(3, counter.Count);
    }

    [Fact]
    public void Restore_IntoAnItemThatThrows_RestoresAllElseAndThrowsThen()
    {
        PhysicsSimulator simulator = Pyramid(3, out Body top);
        var moody = new Moody();
        var counter = new Counter();
        simulator.Add(moody);
        simulator.Add(counter);
        Sandbox.Run(simulator, 2);
        PhysicsSimulatorState state = simulator.Capture();
        Vector2 place = top.Position;
        top.Position = new Vector2(50, 50);
        Sandbox.Run(simulator, 3);
        Assert.Throws<FormatException>(() => simulator.Restore(state));
        Assert.Equal(place, top.Position);
        Assert.Equal(2, counter.Count);
        moody.IsCalm = true;
        simulator.Restore(state);
        Assert.True(simulator.Capture().IsSameAs(state));
        Sandbox.Run(simulator, 3);
        Assert.Equal(5, counter.Count);
    }

    [Fact]
    public void Capture_OfAnItemThatThrows_LeavesAStateThatHoldsNothing()
    {
        PhysicsSimulator simulator = Pyramid(2, out _);
        PhysicsSimulatorState state = simulator.Capture();
        var moody = new Moody { CannotSave = true };
        simulator.Add(moody);
        Assert.Throws<FormatException>(() => simulator.Capture(state));
        Assert.Equal(0, state.ByteCount);
        Assert.Equal("state", Assert.Throws<ArgumentException>(() => simulator.Restore(state)).ParamName);
        moody.CannotSave = false;
        simulator.Capture(state);
        Assert.True(state.ByteCount > 0);
    }

    [Fact]
    public void Restore_OfABodyThatGotAGeomSince_LeavesTheGeomWithoutBody()
    {
        PhysicsSimulator simulator = Pyramid(3, out Body top);
        PhysicsSimulatorState state = simulator.Capture();
        Geom[] geoms = simulator.GeomList.ToArray();
        Geom since = GeomFactory.Instance.CreateCircleGeom(simulator, top, 0.5f, 12);
        Sandbox.Run(simulator, 3);
        simulator.Restore(state);
        Assert.Equal(1, top.GeomCount);
        Assert.Null(since.Body);
        Assert.Equal(geoms, simulator.GeomList.ToArray());
        Assert.Throws<ArgumentException>(() => simulator.Add(since));

        // It may be used again.
        since.SetBody(top);
        simulator.Add(since);
        Sandbox.Run(simulator, 1);
        Assert.Contains(since, simulator.GeomList);
        Assert.Equal(2, top.GeomCount);
    }

    [Fact]
    public void Restore_OfAGeomThatWentToABodyMadeSince_IsOnItsBodyAlone()
    {
        PhysicsSimulator simulator = Pyramid(3, out Body top);
        Geom geom = top.GeomAt(0);
        PhysicsSimulatorState state = simulator.Capture();
        Body since = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        geom.SetBody(since);
        Sandbox.Run(simulator, 2);
        simulator.Restore(state);
        Assert.Same(top, geom.Body);
        Assert.Equal(1, top.GeomCount);
        Assert.Equal(0, since.GeomCount);
    }

    [Fact]
    public void Restore_WithHandlersOfListsAddedSince_ForgetsThem()
    {
        PhysicsSimulator simulator = Pyramid(2, out Body top);
        int told = 0;
        int since = 0;
        simulator.BodyList.Removed += _ => told++;
        PhysicsSimulatorState state = simulator.Capture();
        simulator.BodyList.Removed += _ => since++;
        simulator.GeomList.Removed += _ => since++;
        simulator.Restore(state);
        top.Dispose();
        Sandbox.Run(simulator, 1);
        Assert.Equal((1, 0), (told, since));
    }

    [Fact]
    public void Restore_OfASpringWhoseTargetWasSetSince_HasItUnset()
    {
        var simulator = new PhysicsSimulator { Quirks = Farseer201Quirks.AngleSpringTargetLimited };
        Body first = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        Body second = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        second.Rotation = 7;
        var spring = new AngleSpring(first, second, 1, 1);
        simulator.Add(spring);
        Sandbox.Run(simulator, 1);
        float target = spring.TargetAngle;
        Assert.InRange(target, 6, 8);
        PhysicsSimulatorState state = simulator.Capture();
        spring.TargetAngle = 6;
        Assert.Equal(5.5f, spring.TargetAngle);
        simulator.Restore(state);
        Assert.Equal(target, spring.TargetAngle);
    }

    [Fact]
    public void CaptureAndRestore_WithWhatCannotBe_AreRefused()
    {
        PhysicsSimulator simulator = Pyramid(2, out Body top);
        Assert.Equal("state", Assert.Throws<ArgumentNullException>(() => simulator.Capture(null!)).ParamName);
        Assert.Equal("state", Assert.Throws<ArgumentNullException>(() => simulator.Restore(null!)).ParamName);
        Assert.Equal("state", Assert.Throws<ArgumentException>(() => simulator.Restore(new PhysicsSimulatorState())).ParamName);
        PhysicsSimulatorState foreign = Pyramid(2, out _).Capture();
        Assert.Equal("state", Assert.Throws<ArgumentException>(() => simulator.Restore(foreign)).ParamName);
        PhysicsSimulatorState own = simulator.Capture();
        int refused = 0;
        top.Updated += (ref Vector2 _, ref float _) =>
        {
            Assert.Throws<InvalidOperationException>(() => simulator.Capture());
            Assert.Throws<InvalidOperationException>(() => simulator.Restore(own));
            refused++;
        };
        top.LinearVelocity = new Vector2(1, 0);
        simulator.Update(Dt);
        Assert.True(refused > 0);
    }

    internal static PhysicsSimulator Pyramid(int rows, out Body top)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 200, 2, 1);
        floor.Position = new Vector2(0, -1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 200, 2);
        top = floor;
        for (int row = 0; row < rows; row++)
        {
            for (int i = 0; i < rows - row; i++)
            {
                top = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
                top.Position = new Vector2((i * 1.1f) + (row * 0.55f), 0.5f + row);
                GeomFactory.Instance.CreateRectangleGeom(simulator, top, 1, 1);
            }
        }

        Sandbox.Run(simulator, 30);
        return simulator;
    }

    internal sealed class Silent : Joint
    {
        public override void Validate()
        {
        }

        public override void PreStep(float inverseDt)
        {
        }
    }

    private sealed class Counter : Controller, ISavedState
    {
        public int Count { get; private set; }

        public int StateSize => sizeof(int);

        public override void Validate()
        {
        }

        public override void Update(float dt) => Count++;

        public void SaveState(Span<byte> destination) => BitConverter.TryWriteBytes(destination, Count);

        public void RestoreState(ReadOnlySpan<byte> source) => Count = BitConverter.ToInt32(source);
    }

    private sealed class Moody : Controller, ISavedState
    {
        public bool IsCalm { get; set; }

        public bool CannotSave { get; set; }

        public int StateSize => 1;

        public override void Validate()
        {
        }

        public override void Update(float dt)
        {
        }

        public void SaveState(Span<byte> destination)
        {
            if (CannotSave)
            {
                throw new FormatException();
            }
        }

        public void RestoreState(ReadOnlySpan<byte> source)
        {
            if (!IsCalm)
            {
                throw new FormatException();
            }
        }
    }
}
