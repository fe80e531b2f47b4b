using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Runtime;
using Farseer.Scenes;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using Xunit;

namespace Farseer.Samples.Tests;

public class SceneTests
{
    public static TheoryData<string> Names
    {
        get
        {
            TheoryData<string> names = [];
            foreach (Scene scene in SceneLibrary.All)
            {
                names.Add(scene.Name);
            }

            return names;
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Scene_RunToItsEnd_PassesItsChecks(string name)
    {
        Scene scene = SceneLibrary.Find(name)!;

        scene.RunToEnd();

        IReadOnlyList<SceneOutcome> outcomes = scene.Check();
        Assert.NotEmpty(outcomes);
        Assert.True(outcomes.All(o => o.Ok), string.Join(Environment.NewLine, outcomes.Where(o => !o.Ok)
            .Select(o => string.Create(CultureInfo.InvariantCulture, $"{o.Name}: {o.Value} {o.Relation} {o.Limit}"))));
    }

    /// <summary>
    /// Groups of piles are solved by whoever is free, all substeps of one before the next. Worlds come and go meanwhile, so that what lies
    /// behind the memory of one is given back: a pass that read there once ended the process.
    /// </summary>
    [Fact]
    public void Scene_OfManyPyramidsWithTwoWorkers_MovesAsWithOne()
    {
        for (int round = 0; round < 8; round++)
        {
            Assert.Equal(RunPyramids(1), RunPyramids(2));
        }
    }

    private static ulong RunPyramids(int workers)
    {
        PerformanceScene scene = PerformanceScenes.Find("many_pyramids")!;
        using var simulator = new PhysicsSimulator { WorkerCount = workers };
        scene.Build(simulator, scene.DefaultSize);
        for (int step = 0; step < 8; step++)
        {
            scene.Drive(step);
            simulator.Update(scene.Dt);
        }

        return simulator.MotionHash();
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Scene_WarmWithHandlers_AllocatesNothing(string name)
    {
        // A first run of the same scene compiles every method that the second one will use.
        RunAndCount(SceneLibrary.Find(name)!);

        (long bytes, int events) = RunAndCount(SceneLibrary.Find(name)!);

        Assert.Equal(0, bytes);
        Assert.True(
            events > 0 || name is "chain" or "rope-100" or "projectiles" or "springs" or "gear-joint", "No handler was ever called.");
    }

    // A background collection writes off the unused rest of a thread's allocation buffer, which then counts as allocated: up to
    // 8 KiB in some step of some scene, another one each time. Without it the counts are exact and repeat.
    [Fact]
    public void Counting_WhileTestsRun_IsNotDisturbedByABackgroundCollector() =>
        Assert.Equal(GCLatencyMode.Batch, GCSettings.LatencyMode);

    // The boxes of falling bodies change their size class; no class may grow then.
    [Fact]
    public void LargePyramid_AfterItsFirstStep_AllocatesNothing()
    {
        LargePyramid scene = new();
        long bytes = 0;
        for (int run = 0; run < 2; run++)
        {
            PhysicsSimulator simulator = new();
            scene.Build(simulator, 40);
            simulator.Update(scene.Dt);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int step = 0; step < 120; step++)
            {
                simulator.Update(scene.Dt);
            }

            bytes = GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.Equal(0, bytes);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Scene_BuiltTwice_EndsInTheSameState(string name)
    {
        Scene scene = SceneLibrary.Find(name)!;
        ulong first = Shorter(scene);

        // The same instance again: Build must start over.
        ulong second = Shorter(scene);

        Assert.Equal(first, second);
    }

    [Fact]
    public void Library_Names_AreUniqueAndTypeable()
    {
        IReadOnlyList<Scene> all = SceneLibrary.All;

        Assert.True(all.Count >= 16);
        Assert.Equal(all.Count, all.Select(s => s.Name).Distinct().Count());
        Assert.Equal(all.Count, all.Select(s => s.Title).Distinct().Count());
        Assert.All(all, s => Assert.Matches("^[a-z]+(-[a-z0-9]+)*$", s.Name));
        Assert.NotNull(SceneLibrary.Find(SceneLibrary.DefaultName));
    }

    private static ulong Shorter(Scene scene)
    {
        PhysicsSimulator simulator = new();
        scene.Build(simulator);
        for (int step = 0; step < 100; step++)
        {
            scene.Step(simulator, step, scene.Dt);
        }

        return simulator.MotionHash();
    }

    [Theory]
    [InlineData(float.MaxValue)]
    [InlineData(1e12f)]
    public void Spinner_WhoseRotorJamsBodiesAgainstTheRing_ThrowsNobodyOffAndWhirlsItUp(float torque)
    {
        PerformanceScene scene = new Spinner();
        using PhysicsSimulator simulator = new();
        scene.Build(simulator, scene.DefaultSize);
        foreach (RevoluteJoint rotor in simulator.JointList.OfType<RevoluteJoint>())
        {
            rotor.MaxMotorTorque = torque;
        }

        int fast = 0;
        for (int step = 0; step < 120; step++)
        {
            scene.Drive(step);
            simulator.Update(scene.Dt);

            // The tips of the rotor move at 5 rad/s · 20 m = 100 m/s, and a body that they strike may leave at twice that; one that a
            // struck body strikes, or that is squeezed out between two, may leave faster still, for as long as it flies freely.
            float fastest = simulator.BodyList.Max(body => body.LinearVelocity.Length());
            Assert.InRange(fastest, 0, 300);
            fast += fastest > 200 ? 1 : 0;
        }

        Assert.InRange(fast, 0, 1);

        // The heap, which begins at a mean height of 18 and far too dense, is whirled up to 41 in a bin whose middle is at 32, as in the
        // other engine (42).
        Assert.InRange(simulator.BodyList.Average(body => body.Position.Y), 38, 44);
    }

    /// <summary>Bytes of the second half of a run, when the stores have their size, and the number of events heard.</summary>
    private static (long Bytes, int Events) RunAndCount(Scene scene)
    {
        PhysicsSimulator simulator = new();
        scene.Build(simulator);
        scene.Step(simulator, 0, scene.Dt);
        int events = 0;
        foreach (Geom geom in simulator.GeomList)
        {
            geom.OnCollision += (first, second, contacts) =>
            {
                events++;
                return true;
            };
            geom.OnSeparation += (first, second) => events++;
        }

        long bytes = 0;
        for (int step = 1; step < scene.Steps; step++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            scene.Step(simulator, step, scene.Dt);
            bytes += step >= scene.Steps / 2 ? GC.GetAllocatedBytesForCurrentThread() - before : 0;
        }

        return (bytes, events);
    }
}
