using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>
/// The manual's chapter "Body Factory". That the overloads add to a simulator or do not: <see cref="FactoryOverloadTests"/>.
/// </summary>
public class BodyFactoryTests
{
    private static readonly BodyFactory _factory = BodyFactory.Instance;

    [Fact]
    [ManualRow("F018")]
    [ManualRow("F019")]
    public void Instance_IsOneAndMakesBodiesThatAreNotShared()
    {
        Assert.NotNull(BodyFactory.Instance);
        Assert.Same(BodyFactory.Instance, BodyFactory.Instance);
        Assert.NotSame(_factory.CreateBody(1, 1), _factory.CreateBody(1, 1));
    }

    [Fact]
    [ManualRow("F020")]
    [ManualRow("F021")]
    [ManualRow("F032")]
    public void RectangleBody_OfTheManual_HasMass1AndItsInertia()
    {
        var simulator = new PhysicsSimulator();
        Body added = _factory.CreateRectangleBody(simulator, 128, 128, 1);
        Body free = _factory.CreateRectangleBody(128, 128, 1);
        foreach (Body body in new[] { added, free })
        {
            Assert.Equal(1, body.Mass);
            Assert.Equal(128 * 128 * 2 / 12f, body.MomentOfInertia, 1e-3f);
            Assert.Equal(Vector2.Zero, body.Position);
        }

        AssertOnlyFirst(simulator, added);
        Assert.Equal(7f / 12 * (9 + 16), _factory.CreateRectangleBody(3, 4, 7).MomentOfInertia, 1e-5f);
    }

    [Fact]
    [ManualRow("F022")]
    [ManualRow("F023")]
    public void CircleBody_HasHalfMassTimesRadiusSquared()
    {
        var simulator = new PhysicsSimulator();
        Body added = _factory.CreateCircleBody(simulator, 10, 3);
        foreach (Body body in new[] { added, _factory.CreateCircleBody(10, 3) })
        {
            Assert.Equal(3, body.Mass);
            Assert.Equal(150, body.MomentOfInertia, 1e-4f);
        }

        AssertOnlyFirst(simulator, added);
    }

    [Fact]
    [ManualRow("F024")]
    [ManualRow("F025")]
    public void PolygonBody_HasTheInertiaAndThePlaceOfItsOutline()
    {
        // A rectangle of 40 x 20 and a triangle, whose inertia about its centroid is m (a² + b² + c²) / 36.
        var simulator = new PhysicsSimulator();
        Vertices rectangle = Sandbox.Outline(100, 50, 140, 50, 140, 70, 100, 70);
        Body added = _factory.CreatePolygonBody(simulator, rectangle, 3);
        foreach (Body body in new[] { added, _factory.CreatePolygonBody(rectangle, 3) })
        {
            Assert.Equal(3, body.Mass);
            Assert.Equal(3f / 12 * (1600 + 400), body.MomentOfInertia, 1e-2f);
            Assert.Equal(120, body.Position.X, 1e-4f);
            Assert.Equal(60, body.Position.Y, 1e-4f);
        }

        AssertOnlyFirst(simulator, added);
        Body triangle = _factory.CreatePolygonBody(Sandbox.Outline(0, 0, 30, 0, 0, 40), 2);
        Assert.Equal(2f / 36 * (900 + 1600 + 2500), triangle.MomentOfInertia, 1e-2f);
        Assert.Equal(10, triangle.Position.X, 1e-4f);
        Assert.Equal(40f / 3, triangle.Position.Y, 1e-4f);
    }

    [Fact]
    [ManualRow("F026")]
    [ManualRow("F027")]
    [ManualRow("F031")]
    public void PlainBody_KeepsTheInertiaGiven_TheOthersWorkItOut()
    {
        var simulator = new PhysicsSimulator();
        Body added = _factory.CreateBody(simulator, 2, 77);
        foreach (Body body in new[] { added, _factory.CreateBody(2, 77) })
        {
            Assert.Equal(2, body.Mass);
            Assert.Equal(77, body.MomentOfInertia);
        }

        AssertOnlyFirst(simulator, added);

        // Twice the mass is twice the inertia wherever it is worked out.
        Vertices outline = Sandbox.Outline(0, 0, 30, 0, 0, 40);
        foreach (Func<float, Body> make in new Func<float, Body>[]
        {
            mass => _factory.CreateRectangleBody(3, 5, mass),
            mass => _factory.CreateCircleBody(3, mass),
            mass => _factory.CreateEllipseBody(3, 5, mass),
            mass => _factory.CreatePolygonBody(outline, mass),
        })
        {
            Assert.NotEqual(1, make(1).MomentOfInertia);
            Assert.Equal(2 * make(1).MomentOfInertia, make(2).MomentOfInertia);
        }
    }

    [Fact]
    [ManualRow("F028")]
    [ManualRow("F029")]
    public void Clone_TakesMassInertiaAndDrag_AndNeitherPlaceNorMotion()
    {
        var original = new Body
        {
            Mass = 4,
            MomentOfInertia = 9,
            LinearDragCoefficient = 0.5f,
            RotationalDragCoefficient = 0.25f,
            Position = new Vector2(5, 6),
            Rotation = 1,
            LinearVelocity = new Vector2(7, 8),
            IsStatic = true,
            IgnoreGravity = true,
            Tag = "original",
        };
        var simulator = new PhysicsSimulator();
        Body added = _factory.CreateBody(simulator, original);
        foreach (Body clone in new[] { added, _factory.CreateBody(original) })
        {
            Assert.NotSame(original, clone);
            Assert.Equal(4, clone.Mass);
            Assert.Equal(9, clone.MomentOfInertia);
            Assert.Equal(0.5f, clone.LinearDragCoefficient);
            Assert.Equal(0.25f, clone.RotationalDragCoefficient);
            Assert.Equal(Vector2.Zero, clone.Position);
            Assert.Equal(0, clone.Rotation);
            Assert.Equal(Vector2.Zero, clone.LinearVelocity);
            Assert.False(clone.IsStatic);
            Assert.False(clone.IgnoreGravity);
            Assert.Null(clone.Tag);
        }

        AssertOnlyFirst(simulator, added);
        added.Mass = 1;
        Assert.Equal(4, original.Mass);
        Assert.Throws<ArgumentNullException>(() => _factory.CreateBody(null!));
    }

    [Fact]
    public void BadNumbers_AreNamed_AndNothingIsAdded()
    {
        var simulator = new PhysicsSimulator();
        Assert.Equal("width", Assert.Throws<ArgumentOutOfRangeException>(() => _factory.CreateRectangleBody(simulator, 0, 1, 1)).ParamName);
        Assert.Equal(
            "height", Assert.Throws<ArgumentOutOfRangeException>(() => _factory.CreateRectangleBody(simulator, 1, float.NaN, 1)).ParamName);
        Assert.Equal("mass", Assert.Throws<ArgumentOutOfRangeException>(() => _factory.CreateCircleBody(simulator, 1, -1)).ParamName);
        Assert.Equal(
            "radius",
            Assert.Throws<ArgumentOutOfRangeException>(() => _factory.CreateCircleBody(simulator, float.PositiveInfinity, 1)).ParamName);
        Assert.Equal(
            "vertices",
            Assert.Throws<ArgumentException>(() => _factory.CreatePolygonBody(simulator, Sandbox.Outline(0, 0, 1, 1), 1)).ParamName);
        simulator.Update(0.01f);
        Assert.Empty(simulator.BodyList);
    }

    private static void AssertOnlyFirst(PhysicsSimulator simulator, Body added)
    {
        simulator.Update(0.01f);
        Assert.Same(added, Assert.Single(simulator.BodyList));
    }
}
