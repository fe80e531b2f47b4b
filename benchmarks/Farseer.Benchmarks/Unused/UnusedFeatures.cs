using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Numerics;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Benchmarks.Unused;

/// <summary>
/// The verb <c>unused</c>: what a feature costs where it has nothing to do. Two equal worlds step by turns, one with the feature, which of
/// them first changing from step to step; the median of the ratios of the steps' times, and whether both worlds stay equal bit for bit.
/// What a feature needs to be there (a body far away, a joint's two) is there in both.
/// </summary>
internal static class UnusedFeatures
{
    private const int WarmSteps = 300;
    private const int Steps = 1500;
    private const int Base = 30;

    private static readonly Feature[] Features =
    [
        new Feature("nothing (noise of the measurement)", (simulator, far) => { }),
        new Feature(
            "a joint between bodies that cannot move",
            (simulator, far) => JointFactory.Instance.CreateRevoluteJoint(simulator, far[0], far[1], far[0].Position)),
        new Feature("continuous collision, all bodies slow", (simulator, far) => simulator.IsContinuousCollisionEnabled = true),
        new Feature(
            "a sensor that nothing is near",
            (simulator, far) => GeomFactory.Instance.CreateRectangleGeom(simulator, far[2], 1f, 1f).IsSensor = true),
        new Feature("sleeping allowed, nothing rests", AllowSleep),
        new Feature("a handler added and removed again", (simulator, far) => ListenAndLeave(simulator)),
        new Feature("a report and a budget, off again", (simulator, far) => ReportAndStop(simulator)),
        new Feature("a controller without bodies", (simulator, far) => simulator.Add(Fluid())),
    ];

    public static int Run(TextWriter output)
    {
        output.WriteLine(
            $"large_pyramid={Base}, {Steps} pairs of steps after {WarmSteps}; ratio of the times with and without, median (quartiles)");
        foreach (Feature feature in Features)
        {
            Compare(output, feature);
        }

        return 0;
    }

    private static void Compare(TextWriter output, Feature feature)
    {
        using PhysicsSimulator plain = Build(null);
        using PhysicsSimulator with = Build(feature);
        PhysicsSimulator[] worlds = [plain, with];
        PerformanceScene scene = Scene();
        var ratios = new List<double>(Steps);
        var ticks = new long[2];
        for (int step = 0; step < WarmSteps + Steps; step++)
        {
            for (int turn = 0; turn < 2; turn++)
            {
                int which = (turn + step) & 1;
                long start = Stopwatch.GetTimestamp();
                worlds[which].Update(scene.Dt);
                ticks[which] = Stopwatch.GetTimestamp() - start;
            }

            if (step >= WarmSteps)
            {
                ratios.Add((double)ticks[1] / ticks[0]);
            }
        }

        ratios.Sort();
        string bits = SameMotion(plain, with) ? "same bits" : "OTHER BITS";
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"  {feature.Name,-42} {ratios[Steps / 2]:F4} ({ratios[Steps / 4]:F3}..{ratios[3 * Steps / 4]:F3})  {bits}"));
    }

    private static PerformanceScene Scene() => PerformanceScenes.Find("large_pyramid")!;

    private static PhysicsSimulator Build(Feature? feature)
    {
        var simulator = new PhysicsSimulator();
        Scene().Build(simulator, Base);
        simulator.IsContinuousCollisionEnabled = false;
        var far = new Body[3];
        for (int i = 0; i < far.Length; i++)
        {
            far[i] = BodyFactory.Instance.CreateRectangleBody(simulator, 1f, 1f, 1f);
            far[i].Position = new Vector2(1000 + (10 * i), 1000);
            far[i].IsStatic = true;
        }

        simulator.Update(Scene().Dt);
        feature?.SwitchOn(simulator, far);
        return simulator;
    }

    /// <summary>The time to sleep is longer than the run, so what is looked after never sleeps.</summary>
    private static void AllowSleep(PhysicsSimulator simulator, Body[] far)
    {
        simulator.TimeToSleep = 1e6f;
        simulator.AllowSleep = true;
    }

    /// <summary>For the step that follows nothing is asked any more.</summary>
    private static void ReportAndStop(PhysicsSimulator simulator)
    {
        simulator.ErrorBudget = ErrorBudget.OfLength(1f);
        simulator.EnableReport = true;
        simulator.EnableReport = false;
        simulator.ErrorBudget = ErrorBudget.None;
    }

    private static void ListenAndLeave(PhysicsSimulator simulator)
    {
        Geom.CollisionEventHandler handler = (first, second, contacts) => true;
        foreach (Geom geom in simulator.GeomList)
        {
            geom.OnCollision += handler;
            geom.OnCollision -= handler;
        }
    }

    private static FluidDragController Fluid()
    {
        var fluid = new FluidDragController();
        fluid.Initialize(new AABBFluidContainer(new AABB(new Vector2(900, 900), new Vector2(910, 910))), 1f, 1f, 1f, new Vector2(0, -10));
        return fluid;
    }

    // Not the state hash: that counts the geom of a sensor too.
    private static bool SameMotion(PhysicsSimulator first, PhysicsSimulator second)
    {
        for (int i = 0; i < first.BodyList.Count; i++)
        {
            Body a = first.BodyList[i];
            Body b = second.BodyList[i];
            if (a.Position != b.Position
                || a.Rotation != b.Rotation
                || a.LinearVelocity != b.LinearVelocity
                || a.AngularVelocity != b.AngularVelocity)
            {
                return false;
            }
        }

        return first.BodyList.Count == second.BodyList.Count;
    }

    private sealed record Feature(string Name, Action<PhysicsSimulator, Body[]> SwitchOn);
}
