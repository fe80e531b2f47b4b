using System;
using System.Collections.Generic;
using System.Numerics;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Farseer.Engine.Bodies;
using FarseerGames.FarseerPhysics.Serialization.Documents;

namespace FarseerGames.FarseerPhysics.Serialization.Flash;

/// <summary>Writes a world of the other facade.</summary>
internal sealed class WorldWriter
{
    private readonly WorldContents _contents;
    private readonly SceneFileOptions _options;
    private readonly SceneSink _sink;

    public WorldWriter(WorldContents contents, SceneFileOptions options, SceneSink sink)
    {
        _contents = contents;
        _options = options;
        _sink = sink;
    }

    public void Write()
    {
        b2World world = _contents.World;
        _sink.Name("world");
        _sink.BeginObject();
        Vector("lowerBound", world.Lower);
        Vector("upperBound", world.Upper);
        Vector("gravity", world.Engine.Gravity);
        Flag("doSleep", world.DoSleep);
        WorldTables.World.Write(world, _sink);
        _sink.EndObject();
        WriteItems("bodies", _contents.Bodies, WriteBody);
        WriteItems("shapes", _contents.Shapes, WriteShape);
        WriteItems("joints", _contents.Joints, WriteJoint);
    }

    private void WriteItems<T>(string name, List<T> items, Action<T> write)
    {
        _sink.Name(name);
        _sink.BeginArray();
        foreach (T item in items)
        {
            _sink.BeginObject();
            write(item);
            _sink.EndObject();
        }

        _sink.EndArray();
    }

    private void WriteBody(b2Body body)
    {
        Flag("isGround", ReferenceEquals(body, _contents.World.GetGroundBody()));
        Flag("isAttached", body.Link.IsAttached);
        Flag("fixedRotation", body.IsFixedRotation);
        b2Vec2 position = body.GetPosition();
        Vector("position", new Vector2(position.x, position.y));
        _sink.Name("angle");
        _sink.Number(body.GetAngle());
        Number("mass", body.GetMass());
        Number("inertia", body.GetInertia());
        Double("centerX", body.Link.CenterX);
        Double("centerY", body.Link.CenterY);
        Double("worldCenterX", body.Link.WorldCenterX);
        Double("worldCenterY", body.Link.WorldCenterY);
        Double("fullAngle", body.Link.Angle);
        WorldTables.Body.Write(body, _sink);
        Flag("keepsVelocity", body.Link.KeepsVelocity);
        Vector("linearVelocity", body.Link.Velocity);
        Number("angularVelocity", body.Link.Spin);
        BodyForce force = body.Link.Force;
        Vector("force", force.Force);
        Number("torque", force.Torque);
        Flag("isFrozen", body.IsFrozen());
        Flag("isSleeping", body.IsSleeping());
        Tag(body.GetUserData());
    }

    private void WriteShape(b2Shape shape)
    {
        _sink.Name("body");
        _sink.Whole(_contents.Bodies.IndexOf(shape.GetBody()!));
        if (shape is b2CircleShape circle)
        {
            Number("radius", circle.GetRadius());
            Vector("center", circle.Center);
        }
        else
        {
            _sink.Name("vertices");
            _sink.Vectors(((b2PolygonShape)shape).CornerArray);
        }

        WorldTables.Shape.Write(shape, _sink);
        b2FilterData filter = shape.Filter;
        _sink.Name("categoryBits");
        _sink.Whole(filter.categoryBits);
        _sink.Name("maskBits");
        _sink.Whole(filter.maskBits);
        _sink.Name("groupIndex");
        _sink.Whole(filter.groupIndex);
        Tag(shape.GetUserData());
    }

    private void WriteJoint(b2Joint joint)
    {
        _sink.Name("kind");
        _sink.Text(WorldJoints.NameOf(joint));
        if (joint is b2GearJoint gear)
        {
            Place("joint1", _contents.Joints.IndexOf(gear.Joint1));
            Place("joint2", _contents.Joints.IndexOf(gear.Joint2));
        }
        else
        {
            Place("body1", _contents.Bodies.IndexOf(joint.GetBody1()));
            Place("body2", _contents.Bodies.IndexOf(joint.GetBody2()));
        }

        Flag("collideConnected", joint.CollideConnected);
        Flag("isLimitEnabled", joint.Link.Limit);
        Flag("isMotorEnabled", joint.Link.Motor);
        Flag("isSpring", joint.Link.Spring);
        (b2Vec2? local1, b2Vec2? local2) = WorldJoints.LocalsOf(joint);
        Anchor("localAnchor1", local1);
        Anchor("localAnchor2", local2);
        JointValues.Write(joint.Link.Held, _sink);
        Tag(joint.GetUserData());
    }

    private void Anchor(string name, b2Vec2? value)
    {
        if (value is not null)
        {
            Vector(name, new Vector2(value.x, value.y));
        }
    }

    private void Place(string name, int place)
    {
        _sink.Name(name);
        _sink.Whole(place);
    }

    private void Tag(object? tag)
    {
        if (_options.Text(tag) is { } text)
        {
            _sink.Name("userData");
            _sink.Text(text);
        }
    }

    private void Flag(string name, bool value)
    {
        _sink.Name(name);
        _sink.Flag(value);
    }

    private void Number(string name, float value)
    {
        _sink.Name(name);
        _sink.Number(value);
    }

    private void Double(string name, double value)
    {
        _sink.Name(name);
        _sink.Number(value);
    }

    private void Vector(string name, Vector2 value)
    {
        _sink.Name(name);
        _sink.Vector(value);
    }
}
