using System;
using System.Linq;
using System.Reflection;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>The small objects that shapes and contacts are described by.</summary>
public sealed class ShapeDefinitionTests
{
    [Theory]
    [InlineData(null)]
    [InlineData(0)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(12)]
    public void SetAsBox_KeepsAnArrayThatHasRoom_AndMakesOneElse(int? room)
    {
        b2Vec2[] array = room is null ? null! : new b2Vec2[room.Value];
        b2PolygonDef def = new() { vertices = array };
        def.SetAsBox(1, 2);

        Assert.Equal(room >= 4, ReferenceEquals(array, def.vertices));
        Assert.Equal(room >= 4 ? room : 4, def.vertices.Length);
        Assert.Equal(4, def.vertexCount);
        Assert.Equal([(-1f, -2f), (1, -2), (1, 2), (-1, 2)], def.vertices.Take(4).Select(v => (v.x, v.y)));
    }

    [Fact]
    public void SetAsBox_OfANewDefinition_WritesIntoItsVectors()
    {
        b2PolygonDef def = new();
        (b2Vec2[] array, b2Vec2 first) = (def.vertices, def.vertices[0]);
        def.SetAsBox(1, 2);

        Assert.Same(array, def.vertices);
        Assert.Same(first, def.vertices[0]);
        Assert.Equal((8, 0f), (array.Length, array[4].x));
    }

    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(3, -2, 0.7f)]
    [InlineData(-1, 4, -2.5f)]
    public void SetAsOrientedBox_TurnsThenMoves(float x, float y, float angle)
    {
        b2PolygonDef def = new();
        def.SetAsOrientedBox(1, 2, new b2Vec2(x, y), angle);
        (double X, double Y)[] corners = [(-1, -2), (1, -2), (1, 2), (-1, 2)];
        for (int i = 0; i < 4; i++)
        {
            (double tx, double ty) = PlacedShape.Turned(corners[i], angle);

            // Places within 8 m in single precision.
            Assert.Equal(x + tx, def.vertices[i].x, 1e-6);
            Assert.Equal(y + ty, def.vertices[i].y, 1e-6);
        }
    }

    [Fact]
    public void SetAsOrientedBox_WithoutACentre_LeavesItUnturned()
    {
        b2PolygonDef def = new();
        def.SetAsOrientedBox(1, 2, null, 0.7f);

        Assert.Equal([(-1f, -2f), (1, -2), (1, 2), (-1, 2)], def.vertices.Take(4).Select(v => (v.x, v.y)));
    }

    [Fact]
    public void SetAsBox_WithABadArgument_NamesItAndChangesNothing()
    {
        b2PolygonDef def = new();
        string? Name(Action call) => Assert.Throws<ArgumentOutOfRangeException>(call).ParamName;

        Assert.Equal("hx", Name(() => def.SetAsBox(-1, 1)));
        Assert.Equal("hy", Name(() => def.SetAsBox(1, float.NaN)));
        Assert.Equal("hx", Name(() => def.SetAsOrientedBox(0, 1, new b2Vec2(), 1)));
        Assert.Equal("hy", Name(() => def.SetAsOrientedBox(1, float.PositiveInfinity, new b2Vec2(), 1)));
        Assert.Equal("center", Name(() => def.SetAsOrientedBox(1, 1, new b2Vec2(float.NaN, 0), 1)));
        Assert.Equal("angle", Name(() => def.SetAsOrientedBox(1, 1, new b2Vec2(), float.NaN)));
        Assert.Equal((0, 0f), (def.vertexCount, def.vertices[0].x));
    }

    [Theory]
    [InlineData(1, 1, 2, 2, true)]
    [InlineData(-3, -3, -2, -2, true)]
    [InlineData(1, 1, 1, 2, true)]
    [InlineData(1, 1, 2, 1, true)]
    [InlineData(0, 0, 0, 0, true)]
    [InlineData(2, 1, 1, 2, false)]
    [InlineData(1, 2, 2, 1, false)]
    [InlineData(0, 1, 1, 0, false)]
    [InlineData(1, 0, 0, 1, false)]
    [InlineData(float.NaN, 0, 1, 1, false)]
    [InlineData(float.NegativeInfinity, 0, 1, 1, false)]
    [InlineData(0, 0, 1, float.PositiveInfinity, false)]
    public void Box_IsValid_IfItsCornersAreFiniteAndInOrder(float x1, float y1, float x2, float y2, bool valid) =>
        Assert.Equal(valid, new b2AABB { lowerBound = new b2Vec2(x1, y1), upperBound = new b2Vec2(x2, y2) }.IsValid());

    /// <summary>Each part is a byte of the number: setting one leaves the others.</summary>
    [Theory]
    [InlineData("referenceEdge", 0)]
    [InlineData("incidentEdge", 8)]
    [InlineData("incidentVertex", 16)]
    [InlineData("flip", 24)]
    public void Features_AreTheBytesOfTheKey(string name, int shift)
    {
        PropertyInfo part = typeof(Features).GetProperty(name)!;
        uint others = ~(0xFFu << shift);
        foreach (uint key in new[] { 0u, 0x12345678u, 0x89ABCDEFu, uint.MaxValue })
        {
            foreach (int value in new[] { 0, 1, 0x5A, 0x80, 0xFF, 0x1A5, -1, int.MinValue, int.MaxValue })
            {
                b2ContactID id = new() { key = key };
                Assert.Equal((int)((key / Math.Pow(2, shift)) % 256), part.GetValue(id.features));
                part.SetValue(id.features, value);
                int lowest = ((value % 256) + 256) % 256;

                Assert.Equal(lowest, part.GetValue(id.features));
                Assert.Equal((key & others) + (uint)(lowest * Math.Pow(2, shift)), id.key);
            }
        }
    }

    [Fact]
    public void ContactId_CopyAndSet_TakeTheNumberAlone()
    {
        b2ContactID id = new() { key = 0x12345678u };
        b2ContactID copy = id.Copy();
        copy.features.flip = 1;
        b2ContactID other = new() { key = 5 };
        other.Set(copy);

        Assert.Equal((0x12345678u, 0x01345678u, 0x01345678u), (id.key, copy.key, other.key));
        Assert.NotSame(id.features, copy.features);
        Assert.Equal(0x34, other.features.incidentVertex);
        Assert.Equal(0u, new b2ContactID().key);
    }

    [Fact]
    public void Filter_IsCopied_GoingInAndOut()
    {
        b2CircleDef def = new() { filter = new b2FilterData { categoryBits = 6, maskBits = 0xA, groupIndex = -3 } };
        b2FilterData copy = def.filter.Copy();
        b2Shape shape = Bench.Body(Bench.World(0), 0, 0, def).GetShapeList()!;
        (def.filter.categoryBits, def.filter.maskBits, def.filter.groupIndex) = (1, 2, 3);
        b2FilterData handed = shape.GetFilterData();

        Assert.Equal((6u, 0xAu, -3), (copy.categoryBits, copy.maskBits, copy.groupIndex));
        Assert.Equal((6u, 0xAu, -3), (handed.categoryBits, handed.maskBits, handed.groupIndex));
        (handed.categoryBits, handed.maskBits, handed.groupIndex) = (7, 8, 9);
        Assert.Equal((6u, 0xAu, -3), Of(shape.GetFilterData()));
        shape.SetFilterData(handed);
        (handed.categoryBits, handed.maskBits, handed.groupIndex) = (0, 0, 0);
        Assert.Equal((7u, 8u, 9), Of(shape.GetFilterData()));
        Assert.Equal("filter", Assert.Throws<ArgumentNullException>(() => shape.SetFilterData(null!)).ParamName);

        static (uint, uint, int) Of(b2FilterData data) => (data.categoryBits, data.maskBits, data.groupIndex);
    }

    /// <summary>ActionScript's truth of an object: what is there is true, null is false.</summary>
    [Theory]
    [InlineData(typeof(b2Shape))]
    [InlineData(typeof(b2Body))]
    [InlineData(typeof(b2Contact))]
    [InlineData(typeof(b2Joint))]
    [InlineData(typeof(b2JointEdge))]
    public void Truth_OfAnObject_IsWhetherItIsThere(Type type)
    {
        b2World world = Bench.World(0);
        b2Body first = Bench.Dynamic(world, 0, 0);
        b2Body second = Bench.Dynamic(world, 0.9f, 0);
        b2DistanceJointDef def = new() { collideConnected = true };
        def.Initialize(first, second, new b2Vec2(0, 0), new b2Vec2(0.9f, 0));
        b2Joint joint = world.CreateJoint(def);
        Bench.Step(world, 1);
        object[] all = [first.GetShapeList()!, first, world.GetContactList()!, joint, first.GetJointList()!];
        object there = all.Single(type.IsInstanceOfType);
        bool Call(string name, object? value) => (bool)type.GetMethod(name, [type])!.Invoke(null, [value])!;

        Assert.Equal((true, false), (Call("op_True", there), Call("op_True", null)));
        Assert.Equal((false, true), (Call("op_False", there), Call("op_False", null)));
        Assert.Equal((false, true), (Call("op_LogicalNot", there), Call("op_LogicalNot", null)));
    }
}
