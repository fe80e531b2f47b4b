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
        _sink.Vector("lowerBound", world.Lower);
        _sink.Vector("upperBound", world.Upper);
        _sink.Vector("gravity", world.Engine.Gravity);
        _sink.Flag("doSleep", world.DoSleep);
        WorldTables.World.Write(world, _sink);
        _sink.EndObject();
        _sink.Items("bodies", _contents.Bodies, WriteBody);
        _sink.Items("shapes", _contents.Shapes, WriteShape);
        _sink.Items("joints", _contents.Joints, WriteJoint);
    }

    private void WriteBody(b2Body body)
    {
        _sink.Flag("isGround", ReferenceEquals(body, _contents.World.GetGroundBody()));
        _sink.Flag("isAttached", body.Link.IsAttached);
        _sink.Flag("fixedRotation", body.IsFixedRotation);
        b2Vec2 position = body.GetPosition();
        _sink.Vector("position", new Vector2(position.x, position.y));
        _sink.Number("angle", body.GetAngle());
        _sink.Number("mass", body.GetMass());
        _sink.Number("inertia", body.GetInertia());
        _sink.Number("centerX", body.Link.CenterX);
        _sink.Number("centerY", body.Link.CenterY);
        _sink.Number("worldCenterX", body.Link.WorldCenterX);
        _sink.Number("worldCenterY", body.Link.WorldCenterY);
        _sink.Number("fullAngle", body.Link.Angle);
        WorldTables.Body.Write(body, _sink);
        _sink.Flag("keepsVelocity", body.Link.KeepsVelocity);
        _sink.Vector("linearVelocity", body.Link.Velocity);
        _sink.Number("angularVelocity", body.Link.Spin);
        BodyForce force = body.Link.Force;
        _sink.Vector("force", force.Force);
        _sink.Number("torque", force.Torque);
        _sink.Flag("isFrozen", body.IsFrozen());
        _sink.Flag("isSleeping", body.IsSleeping());
        Tag(body.GetUserData());
    }

    private void WriteShape(b2Shape shape)
    {
        _sink.Whole("body", _contents.Bodies.IndexOf(shape.GetBody()!));
        if (shape is b2CircleShape circle)
        {
            _sink.Number("radius", circle.GetRadius());
            _sink.Vector("center", circle.Center);
        }
        else
        {
            _sink.Name("vertices");
            _sink.Vectors(((b2PolygonShape)shape).CornerArray);
        }

        WorldTables.Shape.Write(shape, _sink);
        b2FilterData filter = shape.Filter;
        _sink.Whole("categoryBits", filter.categoryBits);
        _sink.Whole("maskBits", filter.maskBits);
        _sink.Whole("groupIndex", filter.groupIndex);
        Tag(shape.GetUserData());
    }

    private void WriteJoint(b2Joint joint)
    {
        _sink.Text("kind", WorldJoints.NameOf(joint));
        if (joint is b2GearJoint gear)
        {
            _sink.Whole("joint1", _contents.Joints.IndexOf(gear.Joint1));
            _sink.Whole("joint2", _contents.Joints.IndexOf(gear.Joint2));
        }
        else
        {
            _sink.Whole("body1", _contents.Bodies.IndexOf(joint.GetBody1()));
            _sink.Whole("body2", _contents.Bodies.IndexOf(joint.GetBody2()));
        }

        _sink.Flag("collideConnected", joint.CollideConnected);
        _sink.Flag("isLimitEnabled", joint.Link.Limit);
        _sink.Flag("isMotorEnabled", joint.Link.Motor);
        _sink.Flag("isSpring", joint.Link.Spring);
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
            _sink.Vector(name, new Vector2(value.x, value.y));
        }
    }

    private void Tag(object? tag)
    {
        if (_options.Text(tag) is { } text)
        {
            _sink.Text("userData", text);
        }
    }
}
