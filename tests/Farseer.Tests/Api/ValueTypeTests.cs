using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Porting;
using Xunit;

namespace Farseer.Tests.Api;

public class ValueTypeTests
{
    [Fact]
    [ManualRow("F235")]
    public void ContactList_IndexOfSafe_FindsByName()
    {
        var list = new ContactList(4) { Contact(1), Contact(2), Contact(3) };
        Assert.Equal(1, list.IndexOfSafe(new Contact(Vector2.One, Vector2.UnitX, 5, new ContactId(0, 2, 0))));
        Assert.Equal(-1, list.IndexOfSafe(Contact(9)));
        var copy = new ContactList(list);
        list.Clear();
        Assert.Equal(3, copy.Count);
        Assert.Throws<ArgumentOutOfRangeException>(() => new ContactList(-1));
        Assert.Throws<ArgumentNullException>(() => new ContactList(null!));
    }

    [Fact]
    [ManualRow("F236")]
    public void Contact_OfTheNarrowPhase_SaysWhereWhichWayAndHowDeep()
    {
        for (int i = 0; i < 12; i++)
        {
            // Two corners of a box of 20 by 10 are 0.02·i deep in a floor whose surface is at y = 0, or a ball's lowest point is.
            PhysicsSimulator simulator = new PhysicsSimulator();
            Geom floor = Sandbox.Floor(simulator);
            float depth = 0.02f * i;
            Geom geom = i % 2 == 0
                ? Sandbox.Box(simulator, new Vector2(3 * i, -5 + depth), 20, 10)
                : Sandbox.Ball(simulator, new Vector2(3 * i, -5 + depth), 5);
            ContactList? told = null;
            geom.OnCollision += (_, other, contacts) =>
            {
                Assert.Same(floor, other);
                told ??= new ContactList(contacts);
                return true;
            };
            simulator.Update(Sandbox.Step);

            Assert.NotNull(told);
            Assert.Equal(i % 2 == 0 ? 2 : 1, told.Count);
            foreach (Contact contact in told)
            {
                // From the geom whose handler it is to the floor, down; midway between the surfaces.
                Assert.Equal(new Vector2(0, 1), contact.Normal, (a, b) => Vector2.Distance(a, b) < 1e-5f);
                Assert.Equal(-depth, contact.Separation, 1e-4f);
                Assert.Equal(depth / 2, contact.Position.Y, 1e-3f);
                Assert.Equal(i % 2 == 0 ? 10 : 0, Math.Abs(contact.Position.X - (3 * i)), 1e-3f);
            }
        }
    }

    [Fact]
    public void Contact_OfValues_HoldsThemAndEqualsByName()
    {
        var contact = new Contact(new Vector2(1, 2), new Vector2(0, -1), -0.5f, new ContactId(1, 2, 3));
        Assert.Equal(new Vector2(1, 2), contact.Position);
        Assert.Equal(new Vector2(0, -1), contact.Normal);
        Assert.Equal(-0.5f, contact.Separation);
        var moved = new Contact(Vector2.Zero, Vector2.UnitX, 0, new ContactId(1, 2, 3));
        Assert.True(contact == moved);
        Assert.Equal(contact.GetHashCode(), moved.GetHashCode());
        Assert.True(contact != Contact(2));
        Assert.True(contact.Equals((object)moved));
        Assert.False(contact.Equals("text"));
    }

    [Fact]
    public void Contact_Setters_StoreTheValues()
    {
        var contact = Contact(1);
        contact.SetBias(1);
        contact.SetMassNormal(2);
        contact.SetMassTangent(3);
        contact.SetNormalImpulse(4);
        contact.SetTangentImpulse(5);
        Assert.Equal(
            (1f, 2f, 3f, 4f, 5f),
            (contact.Bias, contact.MassNormal, contact.MassTangent, contact.NormalImpulse, contact.TangentImpulse));
    }

    [Fact]
    public void ContactId_OfNumbers_EqualsOnlyWhenAllAgree()
    {
        var id = new ContactId(1, 2, 3);
        Assert.Equal((1, 2, 3), (id.Geom1Index, id.Geom1Vertex, id.Geom2Index));
        Assert.True(id == new ContactId(1, 2, 3));
        Assert.True(id != new ContactId(0, 2, 3));
        Assert.True(id != new ContactId(1, 0, 3));
        Assert.True(id != new ContactId(1, 2, 0));
        Assert.Equal(id.GetHashCode(), new ContactId(1, 2, 3).GetHashCode());
    }

    [Fact]
    public void Feature_OfPosition_IsInfinitelyFar()
    {
        var feature = new Feature(new Vector2(3, 4));
        Assert.Equal(new Vector2(3, 4), feature.Position);
        Assert.Equal(Vector2.Zero, feature.Normal);
        Assert.Equal(float.MaxValue, feature.Distance);
        var other = new Feature(new Vector2(3, 4), Vector2.Zero, float.MaxValue);
        Assert.True(feature == other);
        Assert.Equal(feature.GetHashCode(), other.GetHashCode());
        Assert.True(feature != new Feature(new Vector2(3, 4), Vector2.UnitX, float.MaxValue));
        Assert.False(feature.Equals("text"));
    }

    [Fact]
    [ManualRow("F254")]
    [ManualRow("F256")]
    [ManualRow("F257")]
    public void CollisionCategory_IsASetOfFlags()
    {
        Assert.NotEmpty(typeof(CollisionCategory).GetCustomAttributes(typeof(FlagsAttribute), false));
        Assert.Equal(0, (int)CollisionCategory.None);
        Assert.Equal(int.MaxValue, (int)CollisionCategory.All);
        var all = CollisionCategory.None;
        for (var i = 1; i <= 31; i++)
        {
            var category = Enum.Parse<CollisionCategory>($"Cat{i}");
            Assert.Equal(1 << (i - 1), (int)category);
            all |= category;
        }

        Assert.Equal(CollisionCategory.All, all);
        Assert.Equal(33, Enum.GetValues<CollisionCategory>().Length);
        var some = CollisionCategory.All & ~CollisionCategory.Cat5;
        Assert.False(some.HasFlag(CollisionCategory.Cat5));
        Assert.True(some.HasFlag(CollisionCategory.Cat4));
    }

    [Fact]
    [ManualRow("F255")]
    public void CollisionCategories_OfTheExample_AreTheSameValues()
    {
        CollisionCategory some = CollisionCategories.All & ~CollisionCategories.Cat5;
        Assert.Equal(CollisionCategory.All & ~CollisionCategory.Cat5, some);
        var fields = typeof(CollisionCategories).GetFields();
        Assert.Equal(
            Enum.GetNames<CollisionCategory>().OrderBy(n => n, StringComparer.Ordinal),
            fields.Select(f => f.Name).OrderBy(n => n, StringComparer.Ordinal));
        Assert.All(fields, field => Assert.Equal(Enum.Parse(typeof(CollisionCategory), field.Name), field.GetValue(null)));
    }

    [Fact]
    [ManualRow("F286")]
    public void Pool_OfArbiters_GivesThoseBackThatALetGo()
    {
        // The simulator's own: the pairs of an update are the objects of the one before.
        PhysicsSimulator simulator = Sandbox.WithFloor(out _);
        for (int i = 0; i < 5; i++)
        {
            Sandbox.Box(simulator, new Vector2(30 * i, -9.9f));
        }

        Sandbox.Run(simulator, 5);
        Arbiter[] first = simulator.ArbiterList.ToArray();
        Assert.Equal(5, first.Length);
        simulator.Update(Sandbox.Step);
        Arbiter[] next = simulator.ArbiterList.ToArray();
        Assert.Equal(5, next.Length);
        Assert.All(next, arbiter => Assert.Contains(arbiter, first, ReferenceEqualityComparer.Instance));

        // One of the user's own: what a list drops is there to be fetched.
        var pool = new Pool<Arbiter>();
        var list = new ArbiterList();
        for (int i = 0; i < 4; i++)
        {
            list.Add(pool.Fetch());
        }

        Arbiter[] made = list.ToArray();
        made[1].ContactList.Add(Contact(1));
        list.RemoveContactCountEqualsZero(pool);
        Assert.Equal(3, pool.Count);
        Assert.Same(made[1], Assert.Single(list));
        Arbiter[] again = [pool.Fetch(), pool.Fetch(), pool.Fetch()];
        Assert.Equal(3, again.Distinct(ReferenceEqualityComparer.Instance).Count());
        Assert.All(again, arbiter => Assert.Contains(arbiter, made, ReferenceEqualityComparer.Instance));
        Assert.DoesNotContain(made[1], again, ReferenceEqualityComparer.Instance);
        Assert.Equal(0, pool.Count);
    }

    [Fact]
    [ManualRow("F287")]
    [ManualRow("F288")]
    [ManualRow("F289")]
    public void Pool_InsertAndFetch_GiveObjectsBack()
    {
        var pool = new Pool<object>();
        Assert.Equal(0, pool.Count);
        var made = pool.Fetch();
        Assert.NotNull(made);
        Assert.NotSame(made, pool.Fetch());
        pool.Insert(made);
        Assert.Equal(1, pool.Count);
        Assert.Same(made, pool.Fetch());
        Assert.Equal(0, pool.Count);
    }

    [Fact]
    public void Pool_OfSize_HoldsThatManyDifferentObjects()
    {
        var pool = new Pool<object>(3);
        Assert.Equal(3, pool.Count);
        var objects = new[] { pool.Fetch(), pool.Fetch(), pool.Fetch() };
        Assert.Equal(3, objects.Distinct().Count());
        Assert.Equal("size", Assert.Throws<ArgumentOutOfRangeException>(() => new Pool<object>(-1)).ParamName);
        Assert.Equal("item", Assert.Throws<ArgumentNullException>(() => pool.Insert(null!)).ParamName);
    }

    [Fact]
    public void FrictionType_HasItsTwoValues()
    {
        Assert.Equal(0, (int)FrictionType.Average);
        Assert.Equal(1, (int)FrictionType.Minimum);
    }

    [Fact]
    [ManualRow("F299")]
    [ManualRow("F300")]
    [ManualRow("F301")]
    [ManualRow("F302")]
    public void Vector2_OfTheManual_HasZeroConstructorAndFields()
    {
        var position = new Vector2(3f, 4f);
        var velocity = Vector2.Zero;
        Assert.Equal(0, velocity.X);
        Assert.Equal(0, velocity.Y);
        velocity.X = 1;
        velocity.Y = 2;

        // The manual's example: the same by value, by reference and written in line.
        Vector2 inLine;
        inLine.X = position.X - velocity.X;
        inLine.Y = position.Y - velocity.Y;
        Vector2.Subtract(ref position, ref velocity, out Vector2 byReference);
        Assert.Equal(new Vector2(2, 2), inLine);
        Assert.Equal(inLine, byReference);
        Assert.Equal(inLine, Vector2.Subtract(position, velocity));
        Assert.Equal(new Vector2(3, 4), position);

        // The result may be one of the arguments.
        Vector2.Subtract(ref position, ref velocity, out position);
        Assert.Equal(inLine, position);
    }

    private static Contact Contact(int vertex) => new(Vector2.Zero, Vector2.UnitY, 0, new ContactId(0, vertex, 0));
}
