using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>The manual's chapter "Collision group and categories".</summary>
public class CollisionFilterTests
{
    [Fact]
    [ManualRow("F246")]
    [ManualRow("F251")]
    [ManualRow("F253")]
    public void Defaults_AreNoGroupAndAllCategories()
    {
        Geom made = GeomFactory.Instance.CreateCircleGeom(new Body(), 5, 16);
        foreach (Geom geom in new[] { made, new Geom() })
        {
            Assert.Equal(0, geom.CollisionGroup);
            Assert.Equal(CollisionCategory.All, geom.CollisionCategories);
            Assert.Equal(CollisionCategory.All, geom.CollidesWith);
            Assert.True(geom.CollisionEnabled);
            Assert.True(geom.CollisionResponseEnabled);
        }
    }

    [Theory]
    [InlineData(0, 0, true)]
    [InlineData(7, 7, false)]
    [InlineData(-7, -7, false)]
    [InlineData(7, 8, true)]
    [InlineData(7, 0, true)]
    [InlineData(int.MinValue, int.MaxValue, true)]
    [ManualRow("F245")]
    [ManualRow("F247")]
    [ManualRow("F248")]
    public void CollisionGroup_TheSameAndNotZero_PassesThrough(int first, int second, bool collides)
    {
        AssertCollides(collides, (a, b) =>
        {
            a.CollisionGroup = first;
            b.CollisionGroup = second;
            Assert.Equal(first, a.CollisionGroup);
            Assert.Equal(second, b.CollisionGroup);
        });
    }

    [Theory]
    [InlineData(CollisionCategory.Cat1, CollisionCategory.All, CollisionCategory.Cat2, CollisionCategory.All, true)]
    [InlineData(CollisionCategory.Cat1, CollisionCategory.Cat2, CollisionCategory.Cat2, CollisionCategory.Cat1, true)]
    [InlineData(CollisionCategory.Cat1, CollisionCategory.Cat3, CollisionCategory.Cat2, CollisionCategory.Cat3, false)]
    [InlineData(CollisionCategory.Cat1, CollisionCategory.None, CollisionCategory.Cat2, CollisionCategory.None, false)]
    [InlineData(
        CollisionCategory.Cat1 | CollisionCategory.Cat31, CollisionCategory.Cat2, CollisionCategory.Cat2, CollisionCategory.Cat31, true)]
    [InlineData(CollisionCategory.All, CollisionCategory.All, CollisionCategory.None, CollisionCategory.All, false)]
    [ManualRow("F249")]
    [ManualRow("F250")]
    [ManualRow("F252")]
    public void Categories_OfEachWantedByTheOther_Collide(
        CollisionCategory first, CollisionCategory firstWants, CollisionCategory second, CollisionCategory secondWants, bool collides)
    {
        AssertCollides(collides, (a, b) =>
        {
            a.CollisionCategories = first;
            a.CollidesWith = firstWants;
            b.CollisionCategories = second;
            b.CollidesWith = secondWants;
            Assert.Equal(first, a.CollisionCategories);
            Assert.Equal(secondWants, b.CollidesWith);
        });
    }

    [Fact]
    [ManualRow("F258")]
    public void Categories_OfTheManualsExample_LeaveEachOtherOut()
    {
        AssertCollides(false, (a, b) =>
        {
            a.CollisionCategories = CollisionCategory.Cat5;
            a.CollidesWith = CollisionCategory.All & ~CollisionCategory.Cat4;
            b.CollisionCategories = CollisionCategory.Cat4;
            b.CollidesWith = CollisionCategory.All & ~CollisionCategory.Cat5;
        });
        AssertCollides(true, (a, b) =>
        {
            a.CollisionCategories = CollisionCategory.Cat5;
            a.CollidesWith = CollisionCategory.All & ~CollisionCategory.Cat4;
            b.CollisionCategories = CollisionCategory.Cat3;
            b.CollidesWith = CollisionCategory.All & ~CollisionCategory.Cat6;
        });
    }

    [Theory]
    [InlineData(10, false)]
    [InlineData(11, true)]
    [ManualRow("F259")]
    public void Group_OfTheManualsExample_LeavesTwoOverlappingGeomsWhereTheyAre(int groupOfSecond, bool parts)
    {
        var simulator = new PhysicsSimulator();
        Geom a = Sandbox.Box(simulator, Vector2.Zero);
        Geom b = Sandbox.Box(simulator, new Vector2(10, 0));
        a.CollisionGroup = 10;
        b.CollisionGroup = groupOfSecond;
        Sandbox.Run(simulator, 50);
        float distance = b.Position.X - a.Position.X;
        if (parts)
        {
            Assert.InRange(distance, 19, 21);
        }
        else
        {
            Assert.Equal(10, distance);
            Assert.Empty(simulator.ArbiterList);
        }
    }

    [Fact]
    public void Group_IsStrongerThanCategories()
    {
        AssertCollides(false, (a, b) =>
        {
            a.CollisionGroup = 3;
            b.CollisionGroup = 3;
            a.CollidesWith = CollisionCategory.All;
            b.CollidesWith = CollisionCategory.All;
        });
    }

    [Fact]
    public void Filter_ChangedWhileTouching_HoldsFromTheNextUpdate()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Geom floor = Sandbox.Floor(simulator);
        Geom box = Sandbox.Box(simulator, new Vector2(0, -10));
        Sandbox.Run(simulator, 50);
        Assert.Single(simulator.ArbiterList);
        floor.CollisionGroup = 2;
        box.CollisionGroup = 2;
        Sandbox.Run(simulator, 10);
        Assert.Empty(simulator.ArbiterList);
        Assert.True(box.Body.LinearVelocity.Y > 5);
        box.CollisionGroup = 0;
        Sandbox.Run(simulator, 200);
        Assert.InRange(box.Body.Position.Y, -10.01f, -9.9f);
    }

    [Fact]
    public void GeomWithoutABody_CollidesWithNothing()
    {
        Geom box = Sandbox.Box(Sandbox.Falling(), Vector2.Zero);
        Assert.False(SweepAndPruneCollider.DoCollision(new Geom(), box));
        Assert.False(SweepAndPruneCollider.DoCollision(box, new Geom()));
    }

    private static void AssertCollides(bool collides, Action<Geom, Geom> set)
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Geom floor = Sandbox.Floor(simulator);
        Geom box = Sandbox.Box(simulator, new Vector2(0, -15));
        set(floor, box);
        bool heard = false;
        floor.OnCollision += (_, _, _) => heard = true;
        Sandbox.Run(simulator, 100);
        Assert.Equal(collides, heard);
        Assert.Equal(collides, box.Body.Position.Y < 0);
        Assert.Equal(collides, SweepAndPruneCollider.DoCollision(floor, box));
    }
}
