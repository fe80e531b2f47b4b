using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Threading;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Questions from several threads between updates, and many rays at once.</summary>
public class ParallelQueryTests
{
    private const int Threads = 6;
    private const int Questions = 300;
    private const int Rounds = 12;
    private const int Bodies = 60;

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Questions_OfSeveralThreads_HaveTheAnswersOfOne(bool someWait)
    {
        PhysicsSimulator simulator = Make(out List<Geom> geoms);
        for (int round = 0; round < Rounds; round++)
        {
            simulator.Update(1f / 60);
            if (someWait)
            {
                geoms.Add(Circle(simulator, new Vector2(round, 3), 0.7f));
                geoms[0].Body.Position += new Vector2(0.5f, 0);
            }

            // All threads find the boxes of before the update, and one of them has to bring these up to date.
            var answers = new string[Threads][];
            var failures = new Exception?[Threads];
            using var start = new Barrier(Threads);
            Thread[] threads = Enumerable.Range(0, Threads).Select(t => new Thread(() =>
            {
                try
                {
                    start.SignalAndWait();
                    answers[t] = Ask(simulator, geoms, round);
                }
                catch (Exception exception)
                {
                    failures[t] = exception;
                }
            })).ToArray();
            Array.ForEach(threads, t => t.Start());
            Array.ForEach(threads, t => t.Join());

            Assert.All(failures, Assert.Null);
            string[] expected = Ask(simulator, geoms, round);
            Assert.All(answers, a => Assert.Equal(expected, a));
        }
    }

    [Fact]
    public void RayCastEach_OfMany_FindsWhatEachFinds()
    {
        PhysicsSimulator simulator = Make(out _);
        simulator.Update(1f / 60);
        var random = new Random(7);
        Vector2[] starts = Enumerable.Range(0, Questions).Select(_ => Point(random)).ToArray();
        Vector2[] ends = Enumerable.Range(0, Questions).Select(_ => Point(random)).ToArray();
        var hits = new RayCastHit[Questions];

        int found = simulator.RayCastEach(starts, ends, hits);

        Assert.InRange(found, 1, Questions - 1);
        Assert.Equal(found, hits.Count(h => h.Geom != null));
        for (int i = 0; i < Questions; i++)
        {
            simulator.RayCast(starts[i], ends[i], out RayCastHit one);
            Assert.Equal(one, hits[i]);
        }

        long before = GC.GetAllocatedBytesForCurrentThread();
        simulator.RayCastEach(starts, ends, hits);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    [Fact]
    public void RayCastEach_OfManyWithBadInput_NamesTheArgumentAndCastsNone()
    {
        PhysicsSimulator simulator = Make(out _);
        var points = new Vector2[3];
        var hits = new RayCastHit[3];
        Assert.Equal("ends", Assert.Throws<ArgumentException>(() => simulator.RayCastEach(points, new Vector2[2], hits)).ParamName);
        Assert.Equal("hits", Assert.Throws<ArgumentException>(() => simulator.RayCastEach(points, points, new RayCastHit[4])).ParamName);
        Vector2[] bad = [Vector2.Zero, Vector2.Zero, new Vector2(float.NaN, 0)];
        Assert.Equal("ends", Assert.Throws<ArgumentOutOfRangeException>(() => simulator.RayCastEach(points, bad, hits)).ParamName);
        Assert.All(hits, h => Assert.Null(h.Geom));
    }

    private static PhysicsSimulator Make(out List<Geom> geoms)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 10));
        var random = new Random(3);
        geoms = [];
        for (int i = 0; i < Bodies; i++)
        {
            geoms.Add(Circle(simulator, Point(random), 0.3f + random.NextSingle()));
        }

        return simulator;
    }

    private static Geom Circle(PhysicsSimulator simulator, Vector2 place, float radius)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, radius, 1);
        body.Position = place;
        return GeomFactory.Instance.CreateCircleGeom(simulator, body, radius, 12);
    }

    private static Vector2 Point(Random random) => new Vector2((40 * random.NextSingle()) - 20, (40 * random.NextSingle()) - 20);

    /// <summary>All kinds of questions, and what comes out, as text.</summary>
    private static string[] Ask(PhysicsSimulator simulator, List<Geom> geoms, int seed)
    {
        var random = new Random(seed);
        var hits = new List<RayCastHit>();
        var found = new List<Geom>();
        var answers = new string[Questions];
        for (int i = 0; i < Questions; i++)
        {
            Vector2 a = Point(random);
            Vector2 b = Point(random);
            Geom any = geoms[random.Next(geoms.Count)];
            var filter = new QueryFilter { Accept = g => g.Id % 5 != 0 };
            simulator.RayCast(a, b, out RayCastHit hit, i % 2 == 0 ? filter : null);
            simulator.RayCastAll(a, b, hits);
            string answer = Text(hit) + string.Concat(hits.Select(Text));
            simulator.CircleCast(a, 0.5f, b - a, out hit);
            answer += Text(hit);
            simulator.ShapeCast(any, b - a, out hit);
            answer += Text(hit);
            simulator.ClosestPoint(a, 5, out ClosestPointHit near);
            answer += $"{near.Geom?.Id} {near.Distance:R};";
            simulator.Query(new AABB(Vector2.Min(a, b), Vector2.Max(a, b)), found);
            answer += Text(found);
            simulator.QueryCircle(a, 3, found);
            answer += Text(found);
            simulator.QueryPoint(a, found);
            answer += Text(found);
            simulator.QueryGeom(any, found);
            answers[i] = answer + Text(found);
        }

        return answers;
    }

    private static string Text(RayCastHit hit) => $"{hit.Geom?.Id} {hit.Fraction:R} {hit.Normal:R};";

    private static string Text(List<Geom> geoms) => string.Join(',', geoms.Select(g => g.Id)) + ";";
}
