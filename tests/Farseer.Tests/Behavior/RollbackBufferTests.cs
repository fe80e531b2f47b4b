using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Frames are kept as what changed, and any of them is gone back to.</summary>
public sealed class RollbackBufferTests
{
    private const float Dt = 1f / 60;

    [Theory]
    [InlineData(1, 8)]
    [InlineData(2, 40)]
    [InlineData(3, 150)]
    [InlineData(4, 400)]
    public void Rewind_ToAnyFrameHeld_StepsAgainToTheSameHashes(int seed, int frames)
    {
        var random = new Random(seed);
        PhysicsSimulator simulator = StateTests.Pyramid(5, out _);
        Body[] boxes = simulator.BodyList.ToArray();
        var buffer = new RollbackBuffer(simulator, frames);
        var hashes = new List<ulong> { simulator.MotionHash() };
        Assert.Equal(0, buffer.Push());
        for (int round = 0; round < 25; round++)
        {
            for (int i = random.Next(1, frames); i > 0; i--)
            {
                long frame = buffer.NewestFrame + 1;
                Play(simulator, boxes, (int)frame);
                Assert.Equal(frame, buffer.Push());
                if (frame == hashes.Count)
                {
                    hashes.Add(simulator.MotionHash());
                }

                Assert.Equal(hashes[(int)frame], simulator.MotionHash());
            }

            long back = random.NextInt64(buffer.OldestFrame, buffer.NewestFrame + 1);
            buffer.Rewind(back);
            Assert.Equal(hashes[(int)back], simulator.MotionHash());
            Assert.Equal(back, buffer.NewestFrame);
            Assert.True(buffer.Count <= frames);
        }
    }

    [Fact]
    public void Rewind_ToEachFrameInTurn_GivesTheStateThatWasCapturedThen()
    {
        const int Frames = 140;
        PhysicsSimulator simulator = StateTests.Pyramid(4, out _);
        Body[] boxes = simulator.BodyList.ToArray();
        var buffer = new RollbackBuffer(simulator, Frames);
        var states = new List<PhysicsSimulatorState>();
        for (int frame = 0; frame < Frames; frame++)
        {
            buffer.Push();
            states.Add(simulator.Capture());
            Play(simulator, boxes, frame + 1);
        }

        for (int frame = Frames - 1; frame >= 0; frame -= frame > 70 ? 1 : 7)
        {
            buffer.Rewind(frame);
            Assert.True(simulator.Capture().IsSameAs(states[frame]), "frame " + frame);
        }
    }

    [Fact]
    public void Push_BeyondTheNumberOfFrames_DropsTheOldest()
    {
        PhysicsSimulator simulator = StateTests.Pyramid(2, out _);
        var buffer = new RollbackBuffer(simulator, 5);
        Assert.Equal((0, -1, -1, 0), (buffer.Count, buffer.OldestFrame, buffer.NewestFrame, buffer.ByteCount));
        for (int i = 0; i < 8; i++)
        {
            Assert.Equal(i, buffer.Push());
            simulator.Update(Dt);
        }

        Assert.Equal((5, 3, 7), (buffer.Count, buffer.OldestFrame, buffer.NewestFrame));
        ulong hash = simulator.MotionHash();
        ArgumentOutOfRangeException refused = Assert.Throws<ArgumentOutOfRangeException>(() => buffer.Rewind(2));
        Assert.Equal("frame", refused.ParamName);
        Assert.Equal(2L, refused.ActualValue);
        Assert.Contains("3 to 7", refused.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => buffer.Rewind(8));
        Assert.Equal(hash, simulator.MotionHash());
        Assert.Equal((5, 3, 7), (buffer.Count, buffer.OldestFrame, buffer.NewestFrame));
    }

    [Fact]
    public void Push_BeyondTheBudget_DropsTheOldest()
    {
        PhysicsSimulator simulator = StateTests.Pyramid(8, out _);
        var whole = new RollbackBuffer(simulator, 1);
        whole.Push();
        long budget = whole.ByteCount * 3;
        RollbackBuffer buffer = RollbackBuffer.WithBudget(simulator, budget);
        for (int i = 0; i < 200; i++)
        {
            simulator.BodyList[1 + (i % 30)].ApplyImpulse(new Vector2(2, 1));
            simulator.Update(Dt);
            buffer.Push();
            Assert.InRange(buffer.ByteCount, 1, budget);
        }

        Assert.InRange(buffer.Count, 3, 150);
        Assert.Equal(199, buffer.NewestFrame);
        buffer.Rewind(buffer.OldestFrame);
        Assert.Equal(1, buffer.Count);
        RollbackBuffer small = RollbackBuffer.WithBudget(simulator, 1);
        small.Push();
        small.Push();
        Assert.Equal((1, 1), (small.Count, small.NewestFrame));
        small.Rewind(1);
    }

    [Fact]
    public void PushAndRewind_OnceWarm_AllocateNothing()
    {
        PhysicsSimulator simulator = StateTests.Pyramid(12, out _);
        var buffer = new RollbackBuffer(simulator, 80);
        Run(300);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Run(300);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);

        void Run(int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                buffer.Push();
                simulator.Update(Dt);
                if (i % 10 == 9)
                {
                    buffer.Rewind(Math.Max(buffer.OldestFrame, buffer.NewestFrame - (i % 70)));
                }
            }
        }
    }

    [Fact]
    public void Frames_OfAWorldAtRest_TakeFewBytes()
    {
        var simulator = new PhysicsSimulator(Vector2.Zero) { AllowSleep = true };
        for (int i = 0; i < 200; i++)
        {
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
            body.Position = new Vector2(3 * i, 0);
            GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1);
        }

        Sandbox.Run(simulator, 120);
        var buffer = new RollbackBuffer(simulator, 50);
        buffer.Push();
        long whole = buffer.ByteCount;
        for (int i = 0; i < 49; i++)
        {
            simulator.Update(Dt);
            buffer.Push();
        }

        // Less than four bytes a body and frame, the scene's own counters included.
        Assert.InRange(buffer.ByteCount - whole, 1, 49 * 4 * 200);
    }

    [Fact]
    public void Clear_OfABuffer_HoldsNothingAndGoesOnWithTheNumbers()
    {
        PhysicsSimulator simulator = StateTests.Pyramid(2, out _);
        var buffer = new RollbackBuffer(simulator, 5);
        buffer.Push();
        buffer.Push();
        buffer.Clear();
        Assert.Equal((0, -1, -1, 0), (buffer.Count, buffer.OldestFrame, buffer.NewestFrame, buffer.ByteCount));
        Assert.Throws<ArgumentOutOfRangeException>(() => buffer.Rewind(1));
        Assert.Equal(2, buffer.Push());
        simulator.Update(Dt);
        buffer.Rewind(2);
    }

    [Fact]
    public void Rewind_ThatIsRefused_ChangesNeitherSimulatorNorBuffer()
    {
        PhysicsSimulator simulator = StateTests.Pyramid(4, out Body top);
        var buffer = new RollbackBuffer(simulator, 5);
        buffer.Push();
        ulong first = simulator.MotionHash();
        simulator.Remove(top.GeomAt(0));
        simulator.Remove(top);
        simulator.Update(Dt);
        buffer.Push();
        using var other = new PhysicsSimulator();
        other.Add(top);
        other.Update(Dt);
        ulong hash = simulator.MotionHash();
        Assert.Throws<InvalidOperationException>(() => buffer.Rewind(0));
        Assert.Equal(hash, simulator.MotionHash());
        Assert.Equal((2, 1), (buffer.Count, buffer.NewestFrame));
        other.Remove(top);
        other.Update(Dt);
        buffer.Rewind(0);
        Assert.Equal(first, simulator.MotionHash());
    }

    [Fact]
    public void Push_ThatIsRefused_LeavesTheBufferAsItWas()
    {
        PhysicsSimulator simulator = StateTests.Pyramid(2, out _);
        var buffer = new RollbackBuffer(simulator, 5);
        buffer.Push();
        ulong hash = simulator.MotionHash();
        var silent = new StateTests.Silent();
        simulator.Add(silent);
        Assert.Throws<InvalidOperationException>(() => buffer.Push());
        Assert.Equal(1, buffer.Count);
        simulator.Remove(silent);
        int refused = 0;
        simulator.BodyList[1].Updated = (ref Vector2 position, ref float rotation) =>
        {
            Assert.Throws<InvalidOperationException>(() => buffer.Push());
            Assert.Throws<InvalidOperationException>(() => buffer.Rewind(0));
            refused++;
        };
        simulator.BodyList[1].ApplyImpulse(new Vector2(5, 0));
        simulator.Update(Dt);
        Assert.True(refused > 0);
        buffer.Rewind(0);
        Assert.Equal(hash, simulator.MotionHash());
        simulator.Dispose();
        Assert.Throws<ObjectDisposedException>(() => buffer.Push());
        Assert.Throws<ObjectDisposedException>(() => buffer.Rewind(0));
    }

    /// <summary>What an item does while it is saved reaches neither the buffer nor the simulator that save it.</summary>
    [Fact]
    public void Push_FromAnItemThatIsSaved_IsRefusedAndAllStaysAsItWas()
    {
        PhysicsSimulator simulator = StateTests.Pyramid(3, out _);
        var buffer = new RollbackBuffer(simulator, 5);
        var meddler = new Meddler();
        simulator.Add(meddler);
        simulator.Update(Dt);
        buffer.Push();
        PhysicsSimulatorState first = simulator.Capture();
        simulator.Update(Dt);
        var calls = new Action[]
        {
            () => buffer.Push(), () => buffer.Rewind(0), buffer.Clear, () => simulator.Capture(), () => simulator.Restore(first),
            () => simulator.StateHash(), () => simulator.Update(Dt),
        };
        foreach (Action call in calls)
        {
            ulong hash = simulator.StateHash();
            meddler.Deed = call;
            InvalidOperationException refused = Assert.Throws<InvalidOperationException>(() => buffer.Push());
            Assert.Matches("saved or restored|saves or restores", refused.Message);
            meddler.Deed = null;
            Assert.Equal(hash, simulator.StateHash());
            Assert.Equal((1, 0), (buffer.Count, buffer.NewestFrame));
        }

        // The frame that was under way when it was refused was taken back.
        buffer.Push();
        buffer.Rewind(0);
        Assert.True(simulator.Capture().IsSameAs(first));
    }

    [Fact]
    public void Constructor_WithBadArguments_NamesThem()
    {
        using var simulator = new PhysicsSimulator();
        Assert.Equal("simulator", Assert.Throws<ArgumentNullException>(() => new RollbackBuffer(null!, 1)).ParamName);
        Assert.Equal("simulator", Assert.Throws<ArgumentNullException>(() => RollbackBuffer.WithBudget(null!, 1)).ParamName);
        Assert.Equal("frames", Assert.Throws<ArgumentOutOfRangeException>(() => new RollbackBuffer(simulator, 0)).ParamName);
        Assert.Equal("bytes", Assert.Throws<ArgumentOutOfRangeException>(() => RollbackBuffer.WithBudget(simulator, 0)).ParamName);
    }

    /// <summary>What is done depends on the frame alone: bodies are pushed, come and go.</summary>
    private static void Play(PhysicsSimulator simulator, Body[] boxes, int frame)
    {
        if (frame % 3 == 0)
        {
            Body box = boxes[1 + (frame / 3 % (boxes.Length - 1))];
            box.ApplyImpulse(new Vector2((frame % 5) - 2, 1));
        }

        if (frame % 7 == 0)
        {
            Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 0.3f, 1);
            ball.Position = new Vector2(frame % 4, 9);
            Geom geom = GeomFactory.Instance.CreateCircleGeom(simulator, ball, 0.3f, 12);
            if (frame % 2 == 0)
            {
                geom.OnCollision = (a, b, contacts) => true;
            }
        }

        if (frame % 11 == 0 && simulator.BodyList.Count > boxes.Length)
        {
            Body last = simulator.BodyList[^1];
            simulator.Remove(last.GeomAt(0));
            simulator.Remove(last);
        }

        simulator.Update(Dt);
    }

    /// <summary>Does something while it is saved.</summary>
    private sealed class Meddler : Controller, ISavedState
    {
        public Action? Deed { get; set; }

        public int StateSize => 1;

        public override void Validate()
        {
        }

        public override void Update(float dt)
        {
        }

        public void SaveState(Span<byte> destination) => Deed?.Invoke();

        public void RestoreState(ReadOnlySpan<byte> source)
        {
        }
    }
}
