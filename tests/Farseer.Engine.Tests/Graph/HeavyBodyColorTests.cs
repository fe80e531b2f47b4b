using System;
using System.Collections.Generic;
using Farseer.Engine.Bodies;
using Farseer.Engine.Constraints;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Engine.Tests.Graph;

/// <summary>
/// Rows of a body that outweighs the others by far lie side by side, so that a drum does not end in bundles of one contact.
/// </summary>
public sealed unsafe class HeavyBodyColorTests
{
    private const int Lanes = ContactBundle.Lanes;
    private const int Contacts = 100;
    private const int Heavy = 1;

    [Fact]
    public void RowsOfAHeavyBody_FillTheirBundles()
    {
        ConstraintGraph graph = Star(heavyMass: 1000, out _, out Column<ContactRecord> records);

        // Eight colours that all rows draw from, one row each, and the others.
        int bundles = CountBundles(graph);
        Assert.InRange(bundles, 1, BodyColors.Drawn + ((Contacts - BodyColors.Drawn + Lanes - 1) / Lanes));

        for (int i = 0; i < Contacts; i++)
        {
            graph.Remove(ref records[i], records);
        }

        Assert.Equal(0, graph.RowCount);
        Assert.Equal(0, CountBundles(graph));
    }

    [Fact]
    public void RowsOfABodyThatIsNotHeavyEnough_HaveColoursOfTheirOwn()
    {
        ConstraintGraph graph = Star(heavyMass: 50, out _, out _);

        Assert.Equal(Contacts, CountBundles(graph));
        Assert.DoesNotContain(graph.Used.ToArray(), c => c.IsShared);
    }

    [Fact]
    public void RowOfAHeavyBody_OnceItBounces_GetsAColourOfItsOwn()
    {
        ConstraintGraph graph = Star(heavyMass: 1000, out _, out Column<ContactRecord> records);
        int bouncing = FindShared(records);
        int shared = CountShared(graph);
        graph.BundleOf(records[bouncing].Row)->Restitution[RowArena.LaneOf(records[bouncing].Row)] = 0.5f;

        graph.RecallShared(records);

        Assert.False(BodyColors.IsShared(records[bouncing].Color));
        Assert.Equal(shared - 1, CountShared(graph));
        AssertRows(graph, records, null);
    }

    [Fact]
    public void RowsOfABodyThatWasHeavy_GetColoursOfTheirOwn()
    {
        ConstraintGraph graph = Star(heavyMass: 1000, out BodyStore bodies, out Column<ContactRecord> records);
        Weigh(bodies, Heavy, 2);

        graph.RecallShared(records);

        Assert.Equal(0, CountShared(graph));
        Assert.Equal(Contacts, graph.RowCount);
        AssertRows(graph, records, bodies);
    }

    [Fact]
    public void RowsOfBodiesOfAnyMass_ThatComeAndGo_ShareNoLightBody() => Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
    {
        const int Bodies = 30;
        var random = new Random(seed);
        var graph = new ConstraintGraph();
        BodyStore bodies = Store(Bodies + 1);
        graph.EnsureBodies(Bodies + 1);
        graph.Weigh(bodies);
        for (int i = 1; i <= Bodies; i++)
        {
            Weigh(bodies, i, MathF.Pow(100, random.Next(4)));
        }

        var records = new Column<ContactRecord>(400);
        var used = new HashSet<(int A, int B)>();
        for (int step = 0; step < 1500; step++)
        {
            int contact = random.Next(records.Capacity);
            if (records[contact].BodyA != 0)
            {
                used.Remove((records[contact].BodyA, records[contact].BodyB));
                graph.Remove(ref records[contact], records);
                records[contact] = default;
                continue;
            }

            // Some bodies have many, as drums do.
            int a = random.Next(3) == 0 ? 1 + random.Next(Bodies) : 1 + random.Next(3);
            int b = 1 + random.Next(Bodies);
            if (a != b && used.Add((a, b)))
            {
                records[contact] = new ContactRecord { BodyA = a, BodyB = b, PieceA = a, PieceB = b };
                graph.Add(contact, ref records[contact], movesA: true, movesB: true);
            }

            if (random.Next(100) == 0)
            {
                Weigh(bodies, 1 + random.Next(Bodies), MathF.Pow(100, random.Next(4)));
                graph.RecallShared(records);
            }
        }

        graph.RecallShared(records);
        AssertRows(graph, records, bodies);
    }).QuickCheckThrowOnFailure();

    /// <summary>Each row is where its record says, and no two of a colour have a body in common but a heavy one.</summary>
    private static void AssertRows(ConstraintGraph graph, Column<ContactRecord> records, BodyStore? bodies)
    {
        int rows = 0;
        foreach (GraphColor color in graph.Used)
        {
            var seen = new HashSet<int>();
            foreach (ContactBundle* bundle in color.Bundles)
            {
                for (int lane = 0; lane < Lanes && bundle->Contact[lane] >= 0; lane++)
                {
                    rows++;
                    ref ContactRecord record = ref records[bundle->Contact[lane]];
                    Assert.True(graph.BundleOf(record.Row) == bundle && RowArena.LaneOf(record.Row) == lane);
                    foreach (int body in new[] { record.BodyA, record.BodyB })
                    {
                        int other = record.BodyA + record.BodyB - body;
                        bool heavy = color.IsShared && (bodies == null ? body == Heavy : bodies.Mass[body].Mass > bodies.Mass[other].Mass);
                        Assert.True(color.IsSequential || heavy || seen.Add(body), $"body {body} has two rows of a colour");
                    }
                }
            }

            if (color.IsShared && bodies != null)
            {
                AssertNoneIsBoth(color, bodies);
            }
        }

        Assert.Equal(graph.RowCount, rows);
    }

    private static void AssertNoneIsBoth(GraphColor color, BodyStore bodies)
    {
        var heavy = new HashSet<int>();
        var light = new HashSet<int>();
        foreach (ContactBundle* bundle in color.Bundles)
        {
            for (int lane = 0; lane < Lanes && bundle->Contact[lane] >= 0; lane++)
            {
                bool ofA = bodies.Mass[bundle->BodyA[lane]].Mass > bodies.Mass[bundle->BodyB[lane]].Mass;
                heavy.Add(ofA ? bundle->BodyA[lane] : bundle->BodyB[lane]);
                light.Add(ofA ? bundle->BodyB[lane] : bundle->BodyA[lane]);
            }
        }

        Assert.False(heavy.Overlaps(light), "a heavy body of some rows is the light one of another");
    }

    private static int FindShared(Column<ContactRecord> records)
    {
        int contact = 0;
        while (!BodyColors.IsShared(records[contact].Color))
        {
            contact++;
        }

        return contact;
    }

    private static int CountShared(ConstraintGraph graph)
    {
        int rows = 0;
        foreach (GraphColor color in graph.Used)
        {
            rows += color.IsShared ? color.RowCount : 0;
        }

        return rows;
    }

    private static int CountBundles(ConstraintGraph graph)
    {
        int bundles = 0;
        foreach (GraphColor color in graph.Used)
        {
            bundles += color.BundleCount;
        }

        return bundles;
    }

    /// <summary>A body of some mass with contacts with a hundred others, of mass 1.</summary>
    private static ConstraintGraph Star(float heavyMass, out BodyStore bodies, out Column<ContactRecord> records)
    {
        var graph = new ConstraintGraph();
        bodies = Store(Contacts + 2);
        graph.EnsureBodies(Contacts + 2);
        graph.Weigh(bodies);
        records = new Column<ContactRecord>(Contacts);
        Weigh(bodies, Heavy, heavyMass);
        for (int i = 0; i < Contacts; i++)
        {
            int light = i + 2;
            Weigh(bodies, light, 1);
            records[i] = i % 2 == 0
                ? new ContactRecord { BodyA = Heavy, BodyB = light, PieceA = Heavy, PieceB = light }
                : new ContactRecord { BodyA = light, BodyB = Heavy, PieceA = light, PieceB = Heavy };
            graph.Add(i, ref records[i], movesA: true, movesB: true);
        }

        return graph;
    }

    private static BodyStore Store(int count)
    {
        var bodies = new BodyStore();
        bodies.Mass.EnsureCapacity(count);
        bodies.Size.EnsureCapacity(count);
        return bodies;
    }

    private static void Weigh(BodyStore bodies, int body, float mass)
    {
        bodies.Size[body].Reach = 1;
        bodies.Mass[body] = new BodyMass { Mass = mass, Inertia = 10 * mass, InverseMass = 1 / mass, InverseInertia = 0.1f / mass };
    }
}
