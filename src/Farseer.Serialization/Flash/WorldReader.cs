using System;
using System.Collections.Generic;
using System.Numerics;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using FarseerGames.FarseerPhysics.Serialization.Documents;

namespace FarseerGames.FarseerPhysics.Serialization.Flash;

/// <summary>
/// Makes a world of the other facade, as a program does that makes bodies, gives them shapes, then masses, and joins them; velocities and
/// sleep come last.
/// </summary>
internal sealed class WorldReader
{
    private readonly SceneObject _root;
    private readonly SceneFileOptions _options;
    private readonly List<SceneObject> _bodies = new List<SceneObject>();

    public WorldReader(SceneObject root, SceneFileOptions options)
    {
        _root = root;
        _options = options;
    }

    public WorldContents Read()
    {
        SceneNode node = _root.Take("world");
        var contents = new WorldContents(ReadWorld(new SceneObject(node)));
        foreach (SceneNode item in _root.TakeItems("bodies"))
        {
            var members = new SceneObject(item);
            contents.Bodies.Add(ReadBody(members, contents));
            _bodies.Add(members);
        }

        foreach (SceneNode item in _root.TakeItems("shapes"))
        {
            contents.Shapes.Add(ReadShape(new SceneObject(item), contents));
        }

        for (int i = 0; i < _bodies.Count; i++)
        {
            SceneObject.Try(_bodies[i].Node, contents.Bodies[i], _bodies[i], SetMass);
        }

        foreach (SceneNode item in _root.TakeItems("joints"))
        {
            contents.Joints.Add(ReadJoint(new SceneObject(item), contents));
        }

        for (int i = 0; i < _bodies.Count; i++)
        {
            SceneObject.Try(_bodies[i].Node, contents.Bodies[i], _bodies[i], SetMotion);
            _bodies[i].Finish();
        }

        return contents;
    }

    private static b2World ReadWorld(SceneObject members)
    {
        var box = new b2AABB
        {
            lowerBound = WorldTables.Of(members.Take("lowerBound").Vector()),
            upperBound = WorldTables.Of(members.Take("upperBound").Vector()),
        };
        b2Vec2 gravity = WorldTables.Of(members.Take("gravity").Vector());
        bool sleeps = members.Take("doSleep").Flag();
        b2World? made = null;
        SceneObject.Try(members.Node, box, gravity, (b, g) => made = new b2World(b, g, sleeps));
        WorldTables.World.Read(made!, members);
        members.Finish();
        return made!;
    }

    private b2Body ReadBody(SceneObject members, WorldContents contents)
    {
        bool isGround = members.TryTake("isGround", out SceneNode ground) && ground.Flag();
        bool isAttached = !members.TryTake("isAttached", out SceneNode attached) || attached.Flag();
        b2Body ofWorld = contents.World.GetGroundBody();
        if (isGround && contents.Bodies.Contains(ofWorld))
        {
            throw ground.Error("is said of two bodies");
        }

        var def = new b2BodyDef
        {
            position = WorldTables.Of(members.TryTake("position", out SceneNode position) ? position.Vector() : Vector2.Zero),
            angle = members.TryTake("angle", out SceneNode angle) ? angle.Single() : 0,
            fixedRotation = members.TryTake("fixedRotation", out SceneNode rotation) && rotation.Flag(),
        };
        b2Body? body = isGround ? ofWorld : null;
        if (body is null)
        {
            SceneObject.Try(members.Node, def, contents, (d, c) => body = c.World.CreateBody(d));
        }
        else if (isAttached)
        {
            body.Link.Attach();
        }

        WorldTables.Body.Read(body!, members);
        if (members.TryTake("userData", out SceneNode data))
        {
            body!.SetUserData(_options.Tag(data.Text()));
        }

        return body!;
    }

    private b2Shape ReadShape(SceneObject members, WorldContents contents)
    {
        SceneNode place = members.Take("body");
        b2Body body = Scenes.SceneReader.ItemAt(place, contents.Bodies, place.Whole());
        b2ShapeDef def;
        if (members.TryTake("radius", out SceneNode radius))
        {
            def = new b2CircleDef
            {
                radius = radius.Single(),
                localPosition = WorldTables.Of(members.TryTake("center", out SceneNode center) ? center.Vector() : Vector2.Zero),
            };
        }
        else
        {
            b2Vec2[] corners = Array.ConvertAll(members.Take("vertices").Vectors(), WorldTables.Of);
            def = new b2PolygonDef { vertices = corners, vertexCount = corners.Length };
        }

        var filter = new b2FilterData();
        filter.categoryBits = members.TryTake("categoryBits", out SceneNode category) ? Bits(category) : filter.categoryBits;
        filter.maskBits = members.TryTake("maskBits", out SceneNode mask) ? Bits(mask) : filter.maskBits;
        filter.groupIndex = members.TryTake("groupIndex", out SceneNode group) ? group.Whole() : filter.groupIndex;
        def.filter = filter;
        b2Shape? shape = null;
        SceneObject.Try(members.Node, body, def, (b, d) => shape = b.CreateShape(d));
        WorldTables.Shape.Read(shape!, members);
        if (members.TryTake("userData", out SceneNode data))
        {
            shape!.SetUserData(_options.Tag(data.Text()));
        }

        members.Finish();
        return shape!;
    }

    private static uint Bits(SceneNode node)
    {
        long bits = node.Long();
        return bits >= 0 && bits <= uint.MaxValue ? (uint)bits : throw node.Error("must be 32 bits");
    }

    private static void SetMass(b2Body body, SceneObject members)
    {
        float mass = members.TryTake("mass", out SceneNode m) ? m.Single() : 0;
        float inertia = members.TryTake("inertia", out SceneNode i) ? i.Single() : 0;
        double x = members.TryTake("centerX", out SceneNode cx) ? cx.Finite() : 0;
        double y = members.TryTake("centerY", out SceneNode cy) ? cy.Finite() : 0;
        if (mass != body.Link.Mass || inertia != body.Link.Inertia || x != body.Link.CenterX || y != body.Link.CenterY)
        {
            b2Body.CheckMass(new b2MassData { mass = mass, I = inertia, center = new b2Vec2((float)x, (float)y) });
            body.ApplyMass(mass, inertia, x, y);
        }

        bool hasPlace = members.TryTake("worldCenterX", out SceneNode wx) & members.TryTake("worldCenterY", out SceneNode wy);
        bool hasAngle = members.TryTake("fullAngle", out SceneNode angle);
        if (hasPlace && hasAngle)
        {
            body.Link.Put(Place(wx), Place(wy), Place(angle));
        }
    }

    // As far as places reach in a world.
    private static double Place(SceneNode node) =>
        Math.Abs(node.Finite()) <= 9.2e18 ? node.Double() : throw node.Error("must be a place within 9.2e18");

    private static void SetMotion(b2Body body, SceneObject members)
    {
        Vector2 velocity = members.TryTake("linearVelocity", out SceneNode v) ? v.Vector() : Vector2.Zero;
        float spin = members.TryTake("angularVelocity", out SceneNode s) ? s.Single() : 0;
        bool keeps = members.TryTake("keepsVelocity", out SceneNode k) && k.Flag();
        var force = new BodyForce
        {
            Force = members.TryTake("force", out SceneNode f) ? f.Vector() : Vector2.Zero,
            Torque = members.TryTake("torque", out SceneNode t) ? t.Single() : 0,
        };
        bool isFrozen = members.TryTake("isFrozen", out SceneNode frozen) && frozen.Flag();
        bool isSleeping = members.TryTake("isSleeping", out SceneNode sleeping) && sleeping.Flag();
        if (keeps)
        {
            body.Link.KeepVelocity(velocity, spin);
        }
        else if (velocity != body.Link.Velocity || spin != body.Link.Spin)
        {
            body.Link.Velocity = velocity;
            body.Link.Spin = spin;
        }

        body.Link.Force = force;
        if (isFrozen && !body.IsFrozen())
        {
            body.Freeze();
        }
        else if (isSleeping && !body.IsSleeping())
        {
            body.Link.PutToSleep();
        }
    }

    private b2Joint ReadJoint(SceneObject members, WorldContents contents)
    {
        b2JointDef def = WorldJoints.Define(members, contents, out Vector2 local2);
        if (members.TryTake("body1", out SceneNode first))
        {
            def.body1 = Scenes.SceneReader.ItemAt(first, contents.Bodies, first.Whole());
        }

        if (members.TryTake("body2", out SceneNode second))
        {
            def.body2 = Scenes.SceneReader.ItemAt(second, contents.Bodies, second.Whole());
        }

        def.collideConnected = members.TryTake("collideConnected", out SceneNode collide) ? collide.Flag() : def.collideConnected;
        b2Joint? made = null;
        SceneObject.Try(members.Node, def, contents, (d, c) => made = c.World.CreateJoint(d));
        b2Joint joint = made!;
        JointSettings settings = joint.Link.Held;
        JointValues.Read(ref settings, members);
        JointFlags flags = joint.Link.Flags;
        Set(members, "isLimitEnabled", JointFlags.Limit, ref flags);
        Set(members, "isMotorEnabled", JointFlags.Motor, ref flags);
        Set(members, "isSpring", JointFlags.Spring, ref flags);
        CheckValues(joint, settings, members.Node);
        SceneObject.Try(members.Node, joint, settings, (j, v) => j.Link.Put(v, flags));
        if (joint is b2MouseJoint mouse)
        {
            mouse.Place(settings.AnchorAX, settings.AnchorAY, local2);
        }

        if (members.TryTake("userData", out SceneNode data))
        {
            joint.SetUserData(_options.Tag(data.Text()));
        }

        members.Finish();
        return joint;
    }

    private static void Set(SceneObject members, string name, JointFlags flag, ref JointFlags flags)
    {
        if (members.TryTake(name, out SceneNode node))
        {
            flags = node.Flag() ? flags | flag : flags & ~flag;
        }
    }

    // What the doors of the facade keep out as well.
    private static void CheckValues(b2Joint joint, in JointSettings s, SceneNode node)
    {
        bool isRight = s.Lower <= s.Upper || joint is b2PulleyJoint || !joint.Link.Limit;
        isRight &= s.Frequency >= 0 && s.DampingRatio >= 0 && s.MotorLimit >= 0;
        isRight &= joint is not b2PulleyJoint || s.Ratio > 0;
        isRight &= joint is not b2GearJoint || s.Ratio != 0;
        isRight &= joint is not b2PrismaticJoint || s.AxisX != 0 || s.AxisY != 0;
        if (!isRight)
        {
            throw node.Error("has numbers that no joint of its kind has");
        }
    }
}
