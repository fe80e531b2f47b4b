using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Simulation;

/// <summary>What is known of the gaps of pairs that the narrow phase passes over.</summary>
public sealed unsafe class IdleGapTests
{
    private const float Dt = 1f / 60;
    private const int BodyCount = 120;

    [Theory]
    [InlineData(1, 0f)]
    [InlineData(2, 3f)]
    [InlineData(3, 40f)]
    public void Gap_OfPairsInACrowd_IsNeverMoreThanTheNarrowPhaseFinds(int seed, float speed)
    {
        World world = Crowd(new Random(seed), speed);
        BodyPose[] before = new BodyPose[world.Bodies.Ids.End];
        int known = 0;
        for (int step = 0; step < 240; step++)
        {
            for (int i = 0; i < before.Length; i++)
            {
                before[i] = world.Bodies.Pose[i];
            }

            if (step == 100)
            {
                // Moved by hand: what was known of this body must be forgotten.
                world.SetPosition(Middle(world), 0.5, 3);
                before[BodyCount / 2] = world.Bodies.Pose[BodyCount / 2];
            }

            world.Step(Dt);
            ContactStore contacts = world.Contacts;
            for (int i = 0; contacts.KeepsGaps && i < contacts.IdleCount; i++)
            {
                IdleBundle* idle = contacts.Gaps + (i / IdleBundle.Lanes);
                int lane = i % IdleBundle.Lanes;
                float gap = idle->Gap[lane];
                if (gap > 0)
                {
                    known++;
                    Assert.Equal(0, PointsWithin(world, before, idle->PieceA[lane], idle->PieceB[lane], gap));
                }
            }
        }

        // The test says something only if gaps were kept.
        Assert.True(known > 1000, $"only {known} gaps were known");
    }

    /// <summary>Pairs are looked at in the order of their kinds, which the idle list tells without their records.</summary>
    [Fact]
    public void IdleList_OfACrowd_NamesEachPairAndItsKind()
    {
        World world = Crowd(new Random(4), 10);
        var kinds = new int[ContactRecord.Kinds];
        for (int step = 0; step < 120; step++)
        {
            world.Step(Dt);
            ContactStore contacts = world.Contacts;
            for (int i = 0; i < contacts.IdleCount; i++)
            {
                ContactRecord record = contacts.Records[contacts.Idle(i)];
                Assert.True(record.IsIdle);
                Assert.Equal(i, record.Row);
                Assert.Equal(KindOf(world, record), contacts.IdleKind(i));
                kinds[(int)contacts.IdleKind(i)]++;
            }
        }

        Assert.All(kinds, count => Assert.True(count > 100));
    }

    private static PairKind KindOf(World world, in ContactRecord record)
    {
        ShapeKind a = world.Shapes.Pieces[record.PieceA].Kind;
        ShapeKind b = world.Shapes.Pieces[record.PieceB].Kind;
        int circles = (a == ShapeKind.Circle ? 1 : 0) + (b == ShapeKind.Circle ? 1 : 0);
        return circles == 2 ? PairKind.Circles
            : circles == 1 ? PairKind.CircleAndHull
            : a == ShapeKind.Box && b == ShapeKind.Box ? PairKind.Boxes
            : PairKind.Hulls;
    }

    private static Handle Middle(World world) => world.Bodies.Ids.HandleOf(BodyCount / 2);

    private static int PointsWithin(World world, BodyPose[] poses, int a, int b, float margin)
    {
        PairInput pair;
        pair.Vertices = world.Shapes.Vertices.Pointer;
        pair.Normals = world.Shapes.Normals.Pointer;
        pair.OutlineBefore = world.Shapes.OutlineBefore.Pointer;
        pair.OutlineAfter = world.Shapes.OutlineAfter.Pointer;
        pair.PieceA = world.Shapes.Pieces.Pointer + a;
        pair.PieceB = world.Shapes.Pieces.Pointer + b;
        BodyPose poseA = poses[pair.PieceA->Body];
        BodyPose poseB = poses[pair.PieceB->Body];
        pair.RotationA = new Rotation(poseA.Cos, poseA.Sin);
        pair.RotationB = new Rotation(poseB.Cos, poseB.Sin);
        pair.Offset = new Vector2((float)(poseB.X - poseA.X), (float)(poseB.Y - poseA.Y));
        pair.Margin = margin;
        Collision.Collide(pair, out Manifold manifold);
        return manifold.Count;
    }

    private static World Crowd(Random random, float speed)
    {
        var world = new World();
        world.Settings.Gravity = new Vector2(0, -10);
        world.Settings.AllowedPenetration = 0.005f;
        Add(world, ShapeBuilder.Box(40, 1), 0, -0.5f, BodyFlags.Static, default, 0);
        Add(world, ShapeBuilder.Box(1, 40), -8, 19, BodyFlags.Static, default, 0);
        Add(world, ShapeBuilder.Box(1, 40), 8, 19, BodyFlags.Static, default, 0);
        for (int i = 0; i < BodyCount; i++)
        {
            ShapeGeometry shape = (i % 6) switch
            {
                0 => ShapeBuilder.Box(0.8f, 0.5f),
                1 => ShapeBuilder.Circle(0.4f),
                2 => ShapeBuilder.Polygon(Regular(3, 0.6f)),
                3 => ShapeBuilder.Polygon(Regular(4, 0.5f), 0.1f),
                4 => ShapeBuilder.Polygon(Regular(5, 0.5f)),
                _ => ShapeBuilder.Polygon(Regular(8, 0.5f)),
            };
            var velocity = new Vector2((float)((2 * random.NextDouble()) - 1), (float)((2 * random.NextDouble()) - 1)) * speed;
            float spin = speed * (float)((2 * random.NextDouble()) - 1);
            Add(world, shape, -6 + (i % 12 * 1.1f), 1 + (i / 12 * 1.2f), BodyFlags.None, velocity, spin);
        }

        return world;
    }

    private static Vector2[] Regular(int corners, float radius)
    {
        var points = new Vector2[corners];
        for (int i = 0; i < corners; i++)
        {
            double angle = 2 * Math.PI * i / corners;
            points[i] = new Vector2((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle)));
        }

        return points;
    }

    private static void Add(World world, ShapeGeometry shape, float x, float y, BodyFlags flags, Vector2 velocity, float spin)
    {
        Handle body = world.CreateBody(new BodyDef
        {
            X = x,
            Y = y,
            Mass = 1,
            Inertia = 0.1f,
            LinearVelocity = velocity,
            AngularVelocity = spin,
            Flags = BodyFlags.Enabled | flags,
        });
        world.CreateCollider(body, shape, new ColliderDef
        {
            Flags = ColliderFlags.CollisionEnabled | ColliderFlags.ResponseEnabled,
            Friction = 0.6f,
            Categories = 1,
            CollidesWith = 1,
        });
    }
}
