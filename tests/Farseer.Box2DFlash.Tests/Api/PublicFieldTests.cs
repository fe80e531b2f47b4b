using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;
using Xunit;

// Old names are what is tested here.
#pragma warning disable CS0618

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>Fields that were public in the original are there for old sources, and say what to call instead.</summary>
public sealed class PublicFieldTests
{
    private static readonly Type[] _drawing = [typeof(b2DebugDraw)];

    /// <summary>The loop of the original's own first program, with the truth of objects that ActionScript has.</summary>
    [Fact]
    public void Bodies_WalkedByTheirFields_AreAllThere()
    {
        b2World world = Bench.World();
        for (int i = 0; i < 5; i++)
        {
            Bench.Ball(world, 3 * i, 0).m_userData = "body " + i;
        }

        List<string> names = [];
        int shapes = 0;
        for (b2Body? bb = world.m_bodyList; bb; bb = bb!.m_next)
        {
            if (bb!.m_userData is string name)
            {
                names.Add(name);
            }

            for (b2Shape? s = bb.m_shapeList; s; s = s!.m_next)
            {
                shapes++;
            }
        }

        Assert.Equal(["body 4", "body 3", "body 2", "body 1", "body 0"], names);
        Assert.Equal(5, shapes);
        Assert.Equal(6, world.m_bodyCount);
        Assert.Equal("body 4", world.m_bodyList!.GetUserData());
        b2Body? none = null;
        Assert.True(!none);
        Assert.False(!world.m_bodyList);
        Assert.True(none ? false : true);
    }

    [Fact]
    public void Fields_ThatWereRead_TellWhatTheMethodsTell()
    {
        b2World world = Bench.World();
        b2Body ground = Bench.Static(world, 0, -1, 10, 1);
        b2Body box = Bench.Dynamic(world, 0, 0.49f, 0.5f, 0.5f);
        b2Body ball = Bench.Ball(world, 3, 0.49f);
        b2RevoluteJointDef def = new() { enableLimit = true, lowerAngle = -1, upperAngle = 2, enableMotor = true, motorSpeed = 3 };
        def.maxMotorTorque = 4;
        def.Initialize(box, ball, new b2Vec2(1.5f, 0.5f));
        var joint = (b2RevoluteJoint)world.CreateJoint(def);
        Ears ears = new();
        world.SetContactListener(ears);
        Bench.Step(world, 5);
        b2Shape shape = box.m_shapeList!;
        var polygon = (b2PolygonShape)shape;
        var circle = (b2CircleShape)ball.m_shapeList!;

        Assert.Equal((1f, box.GetInertia()), (box.m_mass, box.m_I));
        Assert.Equal((1f, 1 / box.GetInertia(), 0f, 0f), (box.m_invMass, box.m_invI, ground.m_invMass, ground.m_invI));
        Assert.Equal((b2Body.e_dynamicType, b2Body.e_staticType), (box.m_type, ground.m_type));
        Assert.Same(box.GetXForm(), box.m_xf);
        Assert.Same(world, box.m_world);
        Assert.Same(world.GetGroundBody(), world.m_groundBody);
        Assert.Equal((1, 1), (box.m_shapeCount, world.m_jointCount));
        Assert.True(world.m_allowSleep);
        Assert.Same(joint, world.m_jointList);
        Assert.Same(joint.m_node2, ball.m_jointList);
        Assert.Same(box, joint.m_node2.other);
        Assert.Same(ball, joint.m_node1.other);
        Assert.Null(joint.m_next);
        Assert.Same(box, joint.m_body1);
        Assert.Same(ball, joint.m_body2);
        Assert.Equal((b2Joint.e_revoluteJoint, false), (joint.m_type, joint.m_collideConnected));
        Assert.Equal((-1f, 2f, 0f), (joint.m_lowerAngle, joint.m_upperAngle, joint.m_referenceAngle));
        Assert.Equal((3f, 4f), (joint.m_motorSpeed, joint.m_maxMotorTorque));
        Assert.True(joint.m_enableLimit && joint.m_enableMotor);
        Assert.Equal(1.5f, joint.m_localAnchor1.x, 1e-5f);
        Assert.Equal(0.01f, joint.m_localAnchor1.y, 1e-5f);
        Assert.Equal(-1.5f, joint.m_localAnchor2.x, 1e-5f);
        Assert.Equal((b2Shape.e_polygonShape, b2Shape.e_circleShape), (polygon.m_type, circle.m_type));
        Assert.Same(box, polygon.m_body);
        Assert.Equal((4, 0.5f, 0f), (polygon.m_vertexCount, polygon.m_vertices[2].x, polygon.m_centroid.x));
        Assert.Equal((1f, 0.46f, 0.5f), (polygon.m_normals[1].x, polygon.m_coreVertices[2].x, polygon.m_obb.extents.x));
        Assert.Equal((0.5f, 0f), (circle.m_radius, circle.m_localPosition.x));
        Assert.Equal(polygon.GetSweepRadius(), polygon.m_sweepRadius);
        b2Contact contact = world.m_contactList!;
        Assert.NotSame(contact.m_shape1, contact.m_shape2);
        Assert.Equal(2, world.m_contactCount);
        int touching = 0;
        for (b2Contact? c = contact; c; c = c!.m_next)
        {
            touching += c!.m_manifoldCount;
        }

        Assert.Equal(2, touching);
        Assert.Equal((false, true), (world.m_lock, ears.WasLocked));
    }

    [Fact]
    public void Flags_SayWhatTheBodyIs()
    {
        b2World world = Bench.World(0);
        b2Body body = world.CreateBody(new b2BodyDef { fixedRotation = true, isBullet = true });
        body.CreateShape(Bench.BoxDef(1, 1, 1));
        body.SetMassFromShapes();
        Assert.Equal(b2Body.e_allowSleepFlag | b2Body.e_bulletFlag | b2Body.e_fixedRotationFlag, body.m_flags);
        body.AllowSleeping(false);
        body.SetBullet(false);
        Assert.Equal(b2Body.e_fixedRotationFlag, body.m_flags);
        body.AllowSleeping(true);
        body.PutToSleep();
        Assert.Equal(b2Body.e_allowSleepFlag | b2Body.e_fixedRotationFlag | b2Body.e_sleepFlag, body.m_flags);
        body.SetXForm(new b2Vec2(1000, 0), 0);
        Assert.NotEqual(0u, body.m_flags & b2Body.e_frozenFlag);
    }

    [Fact]
    public void Friction_Written_ActsOnContactsThatThereAre()
    {
        var random = new Random(3);
        for (int i = 0; i < 120; i++)
        {
            float ground = 0.1f + (0.9f * (float)random.NextDouble());
            float friction = 0.1f + (0.9f * (float)random.NextDouble());
            b2World world = Bench.World(-10, 1000);
            b2PolygonDef floor = Bench.BoxDef(500, 1, 0);
            floor.friction = 0;
            b2Shape under = world.GetGroundBody().CreateShape(floor);
            b2PolygonDef def = Bench.BoxDef(0.5f, 0.1f, 1);
            def.friction = 0;
            b2Body box = Bench.Body(world, 0, 1.0975f, def);
            box.m_linearVelocity = new b2Vec2(6, 0);
            Bench.Step(world, 20);
            Assert.Equal(6, box.m_linearVelocity.x, 1e-3f);
            if (i % 2 == 0)
            {
                under.m_friction = ground;
                box.m_shapeList!.m_friction = friction;
            }
            else
            {
                under.SetFriction(ground);
                box.m_shapeList!.SetFriction(friction);
            }

            Assert.Equal((friction, ground), (box.m_shapeList.m_friction, under.GetFriction()));
            float from = box.GetPosition().x;
            Bench.Step(world, 600);

            // v²/(2 μ g) with μ = √(μ₁ μ₂); the box rocks a little as it is braked.
            double way = 36 / (2 * Math.Sqrt(ground * friction) * 10);
            Assert.Equal(way, box.GetPosition().x - from, 0.02 * way);
        }
    }

    [Fact]
    public void Restitution_AndSensor_Written_Act()
    {
        var random = new Random(4);
        for (int i = 0; i < 120; i++)
        {
            float restitution = 0.1f + (0.9f * (float)random.NextDouble());
            b2World world = Bench.World(0);
            Bench.Static(world, 5, 0, 0.5f, 20);
            b2Body ball = Bench.Ball(world, 0, 0);
            ball.m_linearVelocity.x = 5;
            Bench.Step(world, 3);
            b2Shape shape = ball.m_shapeList!;
            if (i % 2 == 0)
            {
                shape.m_restitution = restitution;
                Bench.Step(world, 90);
                Assert.Equal(-5 * restitution, ball.m_linearVelocity.x, 0.02f);
                Assert.Equal(restitution, shape.GetRestitution());
            }
            else
            {
                shape.m_isSensor = true;
                Bench.Step(world, 90);
                Assert.Equal(5, ball.m_linearVelocity.x);
                Assert.True(shape.IsSensor());
                ball.SetXForm(new b2Vec2(0, 0), 0);
                shape.m_isSensor = false;
                Bench.Step(world, 90);
                Assert.True(ball.GetPosition().x < 4.01f);
            }
        }
    }

    [Fact]
    public void Damping_AndDensity_Written_Act()
    {
        var random = new Random(5);
        for (int i = 0; i < 120; i++)
        {
            float damping = 3 * (float)random.NextDouble();
            float spin = 3 * (float)random.NextDouble();
            float density = 0.5f + (5 * (float)random.NextDouble());
            b2World world = Bench.World(0);
            b2Body body = Bench.Dynamic(world, 0, 0, 0.5f, 1);
            body.m_shapeList!.m_density = density;
            Assert.Equal(2, body.m_mass, 1e-5f);
            body.SetMassFromShapes();
            Assert.Equal(2 * density, body.m_mass, 1e-4f);
            body.m_linearDamping = damping;
            body.m_angularDamping = spin;
            body.m_linearVelocity = new b2Vec2(4, 0);
            body.m_angularVelocity = 2;
            Assert.Equal((damping, spin), (body.GetLinearDamping(), body.GetAngularDamping()));
            Bench.Step(world, 60);

            // v = v₀ e^(−c·t) after a second.
            Assert.Equal(4 * Math.Exp(-damping), body.m_linearVelocity.x, 1e-3);
            Assert.Equal(2 * Math.Exp(-spin), body.m_angularVelocity, 1e-3);
            body.SetMass(new b2MassData { mass = 7, I = 3 });
            body.m_angularVelocity = 2;
            Bench.Step(world, 60);
            Assert.Equal(2 * Math.Exp(-spin), body.m_angularVelocity, 1e-3);
        }
    }

    [Fact]
    public void Gravity_IsTheVectorItself()
    {
        b2World world = Bench.World();
        b2Body ball = Bench.Ball(world, 0, 0);
        world.m_gravity.y = -20;
        world.m_gravity.x = 3;
        Bench.Step(world, 60);
        Assert.Equal(1.5f, ball.GetPosition().x, 1e-3f);
        Assert.Equal(-10, ball.GetPosition().y, 1e-3f);
        world.m_gravity = new b2Vec2(0, 5);
        Assert.Equal((0f, 5f), (world.GetGravity().x, world.GetGravity().y));
        Assert.Throws<ArgumentOutOfRangeException>(() => world.m_gravity.x = float.NaN);
    }

    [Fact]
    public void DistanceJoint_Written_TakesItsLengthAndItsSpring()
    {
        var random = new Random(6);
        for (int i = 0; i < 120; i++)
        {
            b2World world = Bench.World();
            b2Body ball = Bench.Ball(world, 0, -3);
            b2DistanceJointDef def = new();
            def.Initialize(world.GetGroundBody(), ball, new b2Vec2(0, 0), ball.GetPosition());
            var rod = (b2DistanceJoint)world.CreateJoint(def);
            float length = 2 + (3 * (float)random.NextDouble());
            rod.m_length = length;
            Bench.Step(world, 200);
            Assert.Equal(length, ball.GetPosition().Length(), 1e-2f);

            // A spring hangs lower by g/ω².
            float hz = 1 + (2 * (float)random.NextDouble());
            rod.m_frequencyHz = hz;
            rod.m_dampingRatio = 1;
            Bench.Step(world, 400);
            Assert.Equal(length + (10 / Math.Pow(2 * Math.PI * hz, 2)), ball.GetPosition().Length(), 2e-2);
            Assert.Equal((length, hz, 1f), (rod.GetLength(), rod.GetFrequency(), rod.GetDampingRatio()));
        }
    }

    [Fact]
    public void Listeners_AreFieldsToo()
    {
        b2World world = Bench.World();
        Ears ears = new();
        world.m_contactListener = ears;
        Assert.Same(ears, world.m_contactListener);
        Assert.Same(b2ContactFilter.b2_defaultFilter, world.m_contactFilter);
        b2DebugDraw draw = new();
        world.m_debugDraw = draw;
        Assert.Same(draw, world.m_debugDraw);
        world.m_debugDraw = null;
        world.m_contactFilter = null;
        world.m_destructionListener = null;
        world.m_boundaryListener = null;
        Bench.Static(world, 0, -1, 5, 1);
        Bench.Dynamic(world, 0, 0.6f);
        Bench.Step(world, 60);
        Assert.True(ears.WasLocked);
    }

    [Fact]
    public void Step_OfWholeSeconds_WarnsTheCompiler_AndMeansWhatItSays()
    {
        b2World world = Bench.World();
        b2Body ball = Bench.Ball(world, 0, 0);
        world.Step(1 / 30, 10);
        Assert.Equal(0, ball.GetPosition().y);
        world.Step(1, 10);
        Assert.Equal(-5, ball.GetPosition().y, 1e-4f);
        MethodInfo whole = typeof(b2World).GetMethod(nameof(b2World.Step), [typeof(int), typeof(int)])!;
        Assert.Contains("1f/30", whole.GetCustomAttribute<ObsoleteAttribute>()!.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void EveryField_IsMarked_AndNamesMembersThatThereAre()
    {
        Type[] types = [.. typeof(b2World).Assembly.GetExportedTypes().Except(_drawing)];
        const BindingFlags Own = BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly;
        PropertyInfo[] fields = [.. types.SelectMany(t => t.GetProperties(Own))
            .Where(p => p.Name.StartsWith("m_", StringComparison.Ordinal))];

        Assert.True(fields.Length > 70, fields.Length + " fields");
        Assert.All(fields, field =>
        {
            string message = field.GetCustomAttribute<ObsoleteAttribute>()?.Message ?? "";
            foreach (Match name in Regex.Matches(message, @"\b((Get|Set|Is|Enable)\w+)"))
            {
                bool isThere = types.Any(t => t.GetMethods().Any(m => m.Name == name.Value));
                Assert.True(isThere, $"{field.DeclaringType!.Name}.{field.Name}: there is no {name.Value}");
            }

            Assert.Matches("^(Use|Count|Keep) ", message);
        });
    }

    private sealed class Ears : b2ContactListener
    {
        public bool WasLocked { get; private set; }

        public override void Add(b2ContactPoint point) => WasLocked = point.shape1.GetBody()!.GetWorld().IsLocked();
    }
}
