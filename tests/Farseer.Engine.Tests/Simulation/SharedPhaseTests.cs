using System;
using System.Collections.Generic;
using System.Threading;
using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Simulation;

/// <summary>
/// What workers share of a world in which things come and go: sorting of rows, islands, pairs that end, pairs beside blows, the sweep of
/// fast bodies.
/// </summary>
public sealed class SharedPhaseTests
{
    private const int Columns = 60;
    private const int Layers = 16;
    private const int Steps = 70;
    private const int Shots = 24;

    [Theory]
    [InlineData(2, false)]
    [InlineData(3, false)]
    [InlineData(4, false)]
    [InlineData(2, true)]
    [InlineData(4, true)]
    public void Motion_WhileThingsComeAndGo_IsThatOfOneWorker_InEachStep(int workers, bool hosted)
    {
        using var host = new PresentThreads();
        SleepScene alone = Build(out Queue<Handle> aloneBoxes);
        SleepScene shared = Build(out Queue<Handle> sharedBoxes);
        shared.World.SetWorkers(workers, workers, hosted ? host.Start : null);
        int mostFast = 0;
        for (int step = 0; step < Steps; step++)
        {
            if (step % 6 == 3)
            {
                Change(alone, aloneBoxes, step);
                Change(shared, sharedBoxes, step);
            }

            alone.World.Step(SleepScene.Dt);
            shared.World.Step(SleepScene.Dt);
            Assert.Equal(alone.World.Bodies.MotionHash(), shared.World.Bodies.MotionHash());
            mostFast = Math.Max(mostFast, CountFast(shared));
        }

        // The scene has what it is made for.
        Assert.True(mostFast >= Shots, $"At most {mostFast} bodies were fast.");
        Assert.True(shared.World.Solver.RowOrder.Sorts > 1, $"Rows were sorted {shared.World.Solver.RowOrder.Sorts} times.");
        shared.World.Dispose();
    }

    /// <summary>Walls of boxes a little apart, between two thin fences.</summary>
    private static SleepScene Build(out Queue<Handle> boxes)
    {
        var scene = new SleepScene(allowSleep: false);
        boxes = new Queue<Handle>();
        for (int i = 0; i < Columns * Layers; i++)
        {
            float x = (0.72f * ((i % Columns) - (0.5f * Columns))) + (0.05f * (i / Columns % 3));
            boxes.Enqueue(scene.Box(x, 0.4f + (0.7f * (i / Columns)), 0.6f, 0.6f));
        }

        scene.Box(-28, 10, 0.1f, 20, BodyFlags.Static);
        scene.Box(28, 10, 0.1f, 20, BodyFlags.Static);
        return scene;
    }

    /// <summary>The oldest boxes go; as many small ones come as shots at the walls and fences.</summary>
    private static void Change(SleepScene scene, Queue<Handle> boxes, int step)
    {
        for (int i = 0; i < Shots; i++)
        {
            scene.World.DestroyBody(boxes.Dequeue());
            int side = i % 2 == 0 ? 1 : -1;
            Handle shot = scene.Box(side * (24 + (0.5f * (i / 2 % 4))), 1 + (0.8f * i) + (0.01f * step), 0.3f, 0.3f);
            scene.SetVelocity(shot, (i % 3 == 0 ? 90 : -50) * side, 2);
            boxes.Enqueue(shot);
        }
    }

    private static int CountFast(SleepScene scene)
    {
        int count = 0;
        for (int body = 1; body < scene.World.Bodies.Ids.End; body++)
        {
            const BodyFlags FastNow = BodyFlags.Alive | BodyFlags.Fast;
            count += (scene.World.Bodies.Flags[body] & FastNow) == FastNow ? 1 : 0;
        }

        return count;
    }

    /// <summary>A host whose threads run before it returns: helpers are there however busy the processors are.</summary>
    private sealed class PresentThreads : IDisposable
    {
        private readonly SemaphoreSlim _running = new SemaphoreSlim(0);

        public void Start(int count, Action help)
        {
            for (int i = 0; i < count; i++)
            {
                new Thread(() =>
                {
                    _running.Release();
                    help();
                }) { IsBackground = true }.Start();
            }

            for (int i = 0; i < count; i++)
            {
                _running.Wait();
            }
        }

        public void Dispose() => _running.Dispose();
    }
}
