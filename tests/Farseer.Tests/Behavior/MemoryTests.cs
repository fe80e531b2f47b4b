using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>What a world keeps. The collector counts for the whole process, so the class runs while no other does.</summary>
[Collection(Name)]
[CollectionDefinition(Name, DisableParallelization = true)]
public class MemoryTests
{
    private const string Name = "What the collector counts";
    private const int Base = 60;

    // 1,880 to 1,950 measured alone, 580 of it the rows of three contacts a body; 1,796 in a pyramid of base 100, where what a world has
    // anyway weighs less. Among all tests of the net standard asset up to 410 more were counted.
    private const double MostBytes = 2500;

    /// <summary>The median of three worlds: what the process makes once, or frees meanwhile of tests before, is not the world's.</summary>
    [Fact]
    public void Pyramid_OfBoxes_KeepsLittleABody()
    {
        double[] kept = [KeptABody(), KeptABody(), KeptABody()];
        Array.Sort(kept);
        Assert.True(kept[1] < MostBytes, $"{kept[0]:F0}, {kept[1]:F0}, {kept[2]:F0} bytes a body");
    }

    [Fact]
    public void RectangleGeom_AskedForItsOutline_GivesTheSameListAgain()
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(4, 2, 1);
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(body, 4, 2);
        var copy = new Geom(new Body(), geom);

        Assert.Equal(Vertices.CreateRectangle(4, 2), geom.LocalVertices);
        Assert.Same(geom.LocalVertices, geom.LocalVertices);
        Assert.Equal(geom.LocalVertices, copy.LocalVertices);
        Assert.NotSame(geom.LocalVertices, copy.LocalVertices);
        Assert.Same(geom.WorldVertices, geom.WorldVertices);
    }

    [Fact]
    public void Body_TakenOutAndPutBack_KeepsItsState()
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero);
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 2, 2, 3);
        body.LinearVelocity = new Vector2(3, 4);
        body.AngularVelocity = 0.5f;
        simulator.Update(0.01f);
        Vector2 place = body.Position;
        float angle = body.Rotation;

        simulator.Remove(body);
        simulator.Update(0.01f);
        Assert.Equal((place, angle, 3f), (body.Position, body.Rotation, body.Mass));
        Assert.True(body.LinearVelocity.Length() > 4.9f);

        simulator.Add(body);
        simulator.Update(0.01f);
        Assert.True(body.Position.X > place.X && body.Rotation > angle && body.AngularVelocity > 0.49f);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static double KeptABody()
    {
        long before = Held();
        using PhysicsSimulator simulator = Pyramid();
        for (int i = 0; i < 20; i++)
        {
            simulator.Update(1f / 60f);
        }

        return (Held() - before) / (double)simulator.BodyList.Count;
    }

    /// <summary>
    /// Bytes of what is alive. Columns of the net standard asset are pinned among other objects, and what is free between them is counted
    /// by <see cref="GC.GetTotalMemory"/>: up to four times what a world keeps, after two thousand tests.
    /// </summary>
    private static long Held()
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect(GC.MaxGeneration, GCCollectionMode.Forced, blocking: true, compacting: true);
        GCMemoryInfo info = GC.GetGCMemoryInfo(GCKind.FullBlocking);
        return info.HeapSizeBytes - info.FragmentedBytes;
    }

    private static PhysicsSimulator Pyramid()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowSleep = false };
        Body ground = BodyFactory.Instance.CreateRectangleBody(simulator, 4 * Base, 2, 1);
        ground.IsStatic = true;
        ground.Position = new Vector2(0, -1);
        GeomFactory.Instance.CreateRectangleGeom(simulator, ground, 4 * Base, 2);
        for (int row = 0; row < Base; row++)
        {
            for (int i = row; i < Base; i++)
            {
                Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
                body.Position = new Vector2(((row + 1) * 0.5f) + (i - row) - (0.5f * Base), ((2 * row) + 1) * 0.5f);
                GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1);
            }
        }

        return simulator;
    }
}
