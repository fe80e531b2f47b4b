using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Threading;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Threads share an update and nobody can tell from its result.</summary>
public class WorkerTests
{
    // Enough bodies for updates that are worth waking threads.
    private const int Columns = 80;
    private const int Rows = 14;
    private const int Steps = 120;

    public static TheoryData<string> Kinds =>
        new() { "boxes", "mixed", "bouncing", "deep", "fast", "jointed", "net", "sleeping", "fine", "sizes" };

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Motion_WithAnyNumberOfWorkers_IsTheSameBitForBit(string kind)
    {
        ulong alone = Hash(kind, 1, null, out long aloneCalls);

        foreach (int workers in new[] { 2, 3, 4, 8 })
        {
            using HostThreads host = new(workers - 1);
            Assert.Equal(alone, Hash(kind, workers, host, out long calls));
            Assert.Equal(aloneCalls, calls);
            Assert.True(host.Asked > 0, "No update called for help.");
            Assert.Equal(0, host.Failures);
        }

        Assert.Equal(alone, Hash(kind, 2, null, out _));
        Assert.Equal(alone, Hash(kind, 0, null, out _));
    }

    [Fact]
    public void WorkerCount_ChangedBetweenUpdates_ChangesNothing()
    {
        PhysicsSimulator simulator = Pile("mixed", out _);
        using HostThreads host = new(3);
        for (int step = 0; step < Steps; step++)
        {
            simulator.WorkerCount = step % 4;
            simulator.StepScheduler = step % 3 == 0 ? host : null;
            simulator.Update(Sandbox.Step);
        }

        Assert.Equal(Hash("mixed", 1, null, out _), simulator.MotionHash());
    }

    [Fact]
    public void WorkerCount_ChangedInAHandler_IsTakenInTheNextUpdate()
    {
        PhysicsSimulator simulator = Pile("mixed", out List<Geom> geoms);
        int calls = 0;
        geoms[0].OnCollision += (_, _, _) =>
        {
            simulator.WorkerCount = 1 + (++calls % 3);
            return true;
        };
        Sandbox.Run(simulator, Steps);

        Assert.True(calls > 0);
        Assert.Equal(Hash("mixed", 1, null, out _), simulator.MotionHash());
    }

    [Fact]
    public void Handlers_WithWorkers_RunOnTheCallingThread()
    {
        PhysicsSimulator simulator = Pile("mixed", out List<Geom> geoms);
        simulator.WorkerCount = 2;
        HashSet<int> threads = [];
        foreach (Geom geom in geoms)
        {
            geom.OnCollision += (_, _, _) =>
            {
                threads.Add(Environment.CurrentManagedThreadId);
                return true;
            };
        }

        Sandbox.Run(simulator, 20);

        Assert.Equal([Environment.CurrentManagedThreadId], threads);
    }

    [Fact]
    public void BodiesMadeAndRemovedInHandlers_WithWorkers_GiveTheSameWorld()
    {
        Assert.Equal(HashOfMischief(1), HashOfMischief(2));
    }

    [Fact]
    public void ExceptionOfAHandler_WithWorkers_ComesOutAndTheNextUpdatesWork()
    {
        PhysicsSimulator simulator = Pile("mixed", out List<Geom> geoms);
        simulator.WorkerCount = 2;
        Geom.CollisionEventHandler handler = (_, _, _) => throw new FormatException("mine");
        geoms.ForEach(g => g.OnCollision += handler);
        int thrown = 0;
        for (int i = 0; i < 20; i++)
        {
            try
            {
                simulator.Update(Sandbox.Step);
            }
            catch (FormatException)
            {
                thrown++;
            }
        }

        Assert.True(thrown > 0);
        geoms.ForEach(g => g.OnCollision -= handler);
        Sandbox.Run(simulator, 20);
        Assert.True(float.IsFinite(geoms[0].Body.Position.Y));
    }

    [Fact]
    public void SchedulerThatThrows_ComesOutAfterTheUpdate_WhichIsComplete()
    {
        PhysicsSimulator simulator = Pile("boxes", out _);
        PhysicsSimulator twin = Pile("boxes", out _);
        Sandbox.Run(simulator, 20);
        Sandbox.Run(twin, 20);
        simulator.WorkerCount = 3;
        simulator.StepScheduler = new Scheduler((_, _) => throw new FormatException("mine"));
        for (int i = 0; i < 10; i++)
        {
            Assert.Throws<FormatException>(() => simulator.Update(Sandbox.Step));
            twin.Update(Sandbox.Step);
        }

        Assert.Equal(twin.MotionHash(), simulator.MotionHash());
    }

    [Fact]
    public void SchedulerThatCallsAtOnceOrLateOrNever_ChangesNothing()
    {
        ulong alone = Hash("boxes", 1, null, out _);
        List<Action> late = [];

        Assert.Equal(alone, Hash("boxes", 3, new Scheduler((_, help) => help()), out _));
        Assert.Equal(alone, Hash("boxes", 3, new Scheduler((_, help) => late.Add(help)), out _));
        Assert.Equal(alone, Hash("boxes", 3, new Scheduler((_, _) => { }), out _));
        late.ForEach(help => help());
    }

    [Fact]
    public void ManySimulators_UpdatedAtOnceWithWorkers_AreIndependent()
    {
        ulong alone = Hash("mixed", 1, null, out _);
        ulong[] hashes = new ulong[6];
        Thread[] threads = [.. Enumerable.Range(0, hashes.Length).Select(i => new Thread(() => hashes[i] = Hash("mixed", 2, null, out _)))];
        foreach (Thread thread in threads)
        {
            thread.Start();
        }

        foreach (Thread thread in threads)
        {
            thread.Join();
        }

        Assert.All(hashes, h => Assert.Equal(alone, h));
    }

    [Fact]
    public void WarmUpdates_WithTwoWorkers_AllocateNothing()
    {
        PhysicsSimulator simulator = Pile("boxes", out _);
        simulator.WorkerCount = 2;
        Sandbox.Run(simulator, 400);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Sandbox.Run(simulator, 100);

        // What the other thread allocates would be seen in its own count only; the scenes' runner counts all threads.
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void SimulatorThatGoes_TakesItsThreadsWithIt(bool disposed)
    {
        WeakReference world = Drop(disposed);
        for (int i = 0; i < 100 && world.IsAlive; i++)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
            Thread.Sleep(10);
        }

        // A thread that still ran would hold it.
        Assert.False(world.IsAlive);
    }

    [Fact]
    public void Dispose_InAHandler_EndsTheThreadsAndTheUpdate()
    {
        PhysicsSimulator simulator = Pile("mixed", out List<Geom> geoms);
        simulator.WorkerCount = 2;
        geoms.ForEach(g => g.OnCollision += (_, _, _) =>
        {
            simulator.Dispose();
            return true;
        });

        Assert.Throws<ObjectDisposedException>(() => Sandbox.Run(simulator, Steps));
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(int.MinValue)]
    public void WorkerCount_BelowZero_IsRefusedAndKept(int value)
    {
        PhysicsSimulator simulator = new() { WorkerCount = 2 };

        Assert.Equal("WorkerCount", Assert.Throws<ArgumentOutOfRangeException>(() => simulator.WorkerCount = value).ParamName);
        Assert.Equal(2, simulator.WorkerCount);
    }

    [Fact]
    public void WorkerCount_HoweverLarge_Works()
    {
        PhysicsSimulator simulator = Pile("boxes", out _);
        simulator.WorkerCount = int.MaxValue;
        Sandbox.Run(simulator, 10);

        Assert.Equal(int.MaxValue, simulator.WorkerCount);
    }

    private static ulong Hash(string kind, int workers, IStepScheduler? scheduler, out long calls)
    {
        PhysicsSimulator simulator = Pile(kind, out List<Geom> geoms);
        long told = 0;
        for (int i = 0; i < geoms.Count; i += 7)
        {
            int number = i;
            geoms[i].OnCollision += (_, _, points) =>
            {
                told = (told * 31) + number + points.Count;
                return true;
            };
        }

        simulator.WorkerCount = workers;
        simulator.StepScheduler = scheduler;
        Sandbox.Run(simulator, Steps);
        calls = told;
        ulong hash = simulator.MotionHash();
        simulator.Dispose();
        return hash;
    }

    private static ulong HashOfMischief(int workers)
    {
        PhysicsSimulator simulator = Pile("mixed", out List<Geom> geoms);
        simulator.WorkerCount = workers;
        int calls = 0;
        foreach (Geom geom in geoms)
        {
            geom.OnCollision += (a, b, _) =>
            {
                switch (++calls % 50)
                {
                    case 10:
                        Sandbox.Box(simulator, a.Body.Position + new Vector2(0, -200));
                        break;
                    case 20 when !b.Body.IsStatic:
                        b.Body.Dispose();
                        break;
                    case 30:
                        a.Body.ApplyImpulse(new Vector2(3, -20));
                        break;
                    case 40:
                        return false;
                }

                return true;
            };
        }

        Sandbox.Run(simulator, Steps);
        return simulator.MotionHash();
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static WeakReference Drop(bool disposed)
    {
        PhysicsSimulator simulator = Pile("boxes", out _);
        simulator.WorkerCount = 2;
        Sandbox.Run(simulator, 5);
        if (disposed)
        {
            simulator.Dispose();
        }

        return new WeakReference(simulator);
    }

    private static PhysicsSimulator Pile(string kind, out List<Geom> geoms)
    {
        PhysicsSimulator simulator = new(new Vector2(0, 100)) { AllowSleep = kind == "sleeping" };
        simulator.Iterations = kind == "fine" ? 11 : simulator.Iterations;
        if (kind != "mixed")
        {
            simulator.BroadPhaseCollider = new GridCollider(simulator);
        }

        geoms = [];
        Body ground = BodyFactory.Instance.CreateRectangleBody(simulator, 4000, 40, 1);
        ground.IsStatic = true;
        ground.Position = new Vector2(0, 20);
        GeomFactory.Instance.CreateRectangleGeom(simulator, ground, 4000, 40);
        float gap = kind == "deep" ? 0.7f : 1.02f;
        for (int row = 0; row < Rows; row++)
        {
            for (int column = 0; column < Columns; column++)
            {
                int number = (row * Columns) + column;
                var place = new Vector2((column - (Columns / 2)) * 22 * gap, -10 - (20 * gap * row));
                float size = kind == "sizes" && number % 17 == 0 ? 70 : 20;
                Geom geom = (kind == "boxes" || kind == "sleeping" ? 0 : number % 4) switch
                {
                    1 => Sandbox.Ball(simulator, place, 9),
                    2 => Sandbox.Box(simulator, place, 12, 19),
                    3 => Sandbox.Ball(simulator, place, 8, 2, 5),
                    _ => Sandbox.Box(simulator, place, size, size),
                };
                geom.RestitutionCoefficient = kind == "bouncing" ? 0.6f : 0;
                geom.Body.AngularVelocity = kind == "boxes" || kind == "sleeping" ? 0 : (number % 5) - 2;
                geom.Body.LinearVelocity = kind == "fast" ? new Vector2(((number * 37) % 101) - 50, 0) * 60 : Vector2.Zero;
                geoms.Add(geom);
            }
        }

        for (int i = 0; kind == "jointed" && i + 1 < geoms.Count; i += 3)
        {
            Body left = geoms[i].Body;
            JointFactory.Instance.CreateRevoluteJoint(simulator, left, geoms[i + 1].Body, left.Position + new Vector2(11, 0));
        }

        // Every body holds its neighbours at the side and above: a net.
        for (int i = 0; kind == "net" && i < geoms.Count; i++)
        {
            Pin(simulator, geoms, i, (i + 1) % Columns == 0 ? geoms.Count : i + 1);
            Pin(simulator, geoms, i, i + Columns);
        }

        return simulator;
    }

    private static void Pin(PhysicsSimulator simulator, List<Geom> geoms, int i, int k)
    {
        if (k < geoms.Count)
        {
            Body body = geoms[i].Body;
            JointFactory.Instance.CreateRevoluteJoint(simulator, body, geoms[k].Body, (body.Position + geoms[k].Body.Position) / 2);
        }
    }

    private sealed class Scheduler(Action<int, Action> start) : IStepScheduler
    {
        public void Start(int count, Action help) => start(count, help);
    }
}
