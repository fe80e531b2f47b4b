using System;
using Box2D.Collision.Shapes;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

public sealed class BodyTests
{
    [Fact]
    [ManualRow("B002", "B038")]
    public void Shapes_OfOneBody_MoveTogether()
    {
        b2World world = Bench.World();
        b2Body body = Bench.Dynamic(world, 0, 5);
        body.CreateShape(new b2CircleDef { localPosition = new b2Vec2(2, 0), radius = 0.5f, density = 1 });
        body.SetMassFromShapes();
        body.SetAngularVelocity(3);
        Bench.Step(world, 30);

        Assert.Equal(2, b2Math.b2Distance(body.GetPosition(), body.GetWorldPoint(new b2Vec2(2, 0))), 1e-5);
    }

    [Fact]
    [ManualRow("B034-B037", "B130", "B140", "B174")]
    public void SetMassFromShapes_UsesDensities_AndNoDensityIsStatic()
    {
        b2World world = Bench.World();
        b2Body box = Bench.Body(world, 0, 0, Bench.BoxDef(1, 2, 3));
        b2Body none = Bench.Body(world, 5, 0, Bench.BoxDef(1, 2, 0));
        none.SetMassFromShapes();

        Assert.Equal(24, box.GetMass(), 1e-4);
        Assert.Equal(24 * (4 + 16) / 12.0, box.GetInertia(), 1e-4);
        Assert.True(none.IsStatic());
        Assert.Equal(0, new b2CircleDef().density);
        Assert.Equal(0.2f, new b2PolygonDef { friction = 0.2f }.friction);
        Bench.AssertOldName(typeof(b2Body).GetMethod("SetMassFromShape"), "SetMassFromShapes");
        b2Shape second = box.CreateShape(Bench.BoxDef(1, 1, 1));
        box.SetMassFromShapes();
        Assert.Equal(28, box.GetMass(), 1e-4);
        box.DestroyShape(second);
        box.SetMassFromShapes();
        Assert.Equal(24, box.GetMass(), 1e-4);
    }

    [Fact]
    [ManualRow("B051")]
    public void Sizes_OfCentimetresAndKilometres_RestToo()
    {
        foreach (float size in new[] { 0.05f, 500f })
        {
            b2World world = Bench.World(-10, 1e5f);
            Bench.Static(world, 0, -size, 10 * size, size);
            b2Body box = Bench.Dynamic(world, 0, size, size, size);
            Bench.Step(world, 60);

            Assert.Equal(size, box.GetPosition().y, 0.006);
        }
    }

    [Fact]
    [ManualRow("B069-B075", "B098-B101")]
    public void MassData_SetsMassCentreAndInertia()
    {
        b2World world = Bench.World(0);
        b2BodyDef def = new() { angle = 0.25f * b2Settings.b2_pi };
        def.massData.mass = 2;
        def.massData.I = 0.5f;
        def.massData.center.Set(0.4f, 0);
        b2Body body = world.CreateBody(def);

        Assert.Equal((2f, 0.5f), (body.GetMass(), body.GetInertia()));
        Assert.Equal(0.4f, body.GetLocalCenter().x, 1e-6f);
        Assert.Equal(0.4 * Math.Sqrt(0.5), body.GetWorldCenter().y, 1e-5);
        Assert.Equal(0.25 * Math.PI, body.GetAngle(), 1e-6);
        body.SetMass(new b2MassData { mass = 3, I = 1 });
        Assert.Equal(3, body.GetMass());
        Assert.Equal(0, body.GetWorldCenter().y, 1e-5);
        Assert.Equal((0f, 0f, 0f), (new b2MassData().mass, new b2MassData().I, new b2MassData().center.x));
        Assert.Throws<ArgumentOutOfRangeException>(() => body.SetMass(new b2MassData { mass = -1 }));
    }

    [Fact]
    [ManualRow("B077", "B078", "B111", "B112")]
    public void ChangedMass_MovesTheCentre_NotOriginShapesAndJoints()
    {
        b2World world = Bench.World(0);
        b2Body body = Bench.Dynamic(world, 3, 4);
        b2RevoluteJointDef def = new();
        def.Initialize(world.GetGroundBody(), body, new b2Vec2(3.5f, 4));
        b2Joint joint = world.CreateJoint(def);
        body.SetMass(new b2MassData { mass = 2, I = 1, center = new b2Vec2(0.25f, 0.25f) });
        Bench.Step(world, 30);

        Assert.Equal((3f, 4f), (body.GetXForm().position.x, body.GetXForm().position.y));
        Assert.Equal(3.5f, joint.GetAnchor2().x, 1e-5f);
        Assert.Equal(3.25f, body.GetWorldCenter().x, 1e-5f);
        b2Shape[] found = new b2Shape[1];
        Assert.Equal(1, world.Query(new() { lowerBound = new b2Vec2(2.51f, 3.51f), upperBound = new b2Vec2(2.52f, 3.52f) }, found, 1));
    }

    [Fact]
    [ManualRow("B079-B082")]
    public void Damping_DiesAwayAsAnExponential()
    {
        b2World world = Bench.World(0);
        b2BodyDef def = new() { linearDamping = 0.5f, angularDamping = 0.1f };
        b2Body body = world.CreateBody(def);
        body.CreateShape(Bench.BoxDef(0.5f, 0.5f, 1));
        body.SetMassFromShapes();
        body.SetLinearVelocity(new b2Vec2(10, 0));
        body.SetAngularVelocity(2);
        Bench.Step(world, 120);

        Assert.Equal(10 * Math.Exp(-1), body.GetLinearVelocity().x, 1e-4);
        Assert.Equal(2 * Math.Exp(-0.2), body.GetAngularVelocity(), 1e-4);
        Assert.Equal((0f, 0f), (new b2BodyDef().linearDamping, new b2BodyDef().angularDamping));
    }

    [Fact]
    [ManualRow("B088", "B089", "B092", "B102", "B103")]
    public void Bullet_IsAFlag_OffByDefault()
    {
        b2World world = Bench.World();
        b2Body body = world.CreateBody(new b2BodyDef { isBullet = true });

        Assert.True(body.IsBullet());
        body.SetBullet(false);
        Assert.False(body.IsBullet());
        Assert.False(Bench.Ball(world, 0, 0).IsBullet());
    }

    [Fact]
    [ManualRow("B090", "B093")]
    public void FastBody_DoesNotPassAThinWall_AndGoesOnFromTheImpact()
    {
        foreach (float speed in new[] { 50f, 150f, 1000f })
        {
            b2World world = Bench.World(0, 1e5f);
            Bench.Static(world, 5, 0, 0.01f, 50);
            b2Body ball = Bench.Ball(world, -10, 0, 0.2f, 1);
            ball.SetLinearVelocity(new b2Vec2(speed, 0));
            Bench.Step(world, 60);

            Assert.True(ball.GetPosition().x < 4.8, $"at {speed} m/s it is at {ball.GetPosition()}");
            Assert.Equal(-speed, ball.GetLinearVelocity().x, 0.01 * speed);
        }
    }

    [Fact]
    [ManualRow("B091")]
    public void Bullet_DoesNotPassAMovingPlank()
    {
        b2World world = Bench.World(0, 1e5f);
        b2Body plank = Bench.Dynamic(world, 6, 0, 0.05f, 2);
        b2Body bullet = Bench.Ball(world, -10, 0, 0.2f);
        bullet.SetBullet(true);
        bullet.SetLinearVelocity(new b2Vec2(300, 0));
        Bench.Step(world, 60);

        Assert.True(bullet.GetPosition().x < plank.GetPosition().x);
    }

    [Fact]
    [ManualRow("B026", "B094", "B104", "B105")]
    public void Mass_DecidesWhetherABodyMoves()
    {
        b2World world = Bench.World();
        b2Body body = Bench.Dynamic(world, 0, 0);
        Assert.True(body.IsDynamic());
        body.SetMass(new b2MassData());

        Assert.True(body.IsStatic());
        Assert.Equal(0, body.GetMass());
        Bench.Step(world, 10);
        Assert.Equal(0, body.GetPosition().y);
    }

    [Fact]
    [ManualRow("B095")]
    public void StaticBody_MovedByHand_CarriesUpButNotAlong()
    {
        b2World world = Bench.World();
        b2PolygonDef plate = Bench.BoxDef(20, 0.5f, 0);
        plate.friction = 1;
        b2Body platform = Bench.Body(world, 0, 0, plate);
        b2PolygonDef def = Bench.BoxDef(0.5f, 0.5f, 1);
        def.friction = 1;
        b2Body box = Bench.Body(world, 0, 0.9975f, def);
        Bench.Step(world, 10);
        for (int step = 1; step <= 60; step++)
        {
            // Six metres aside in a second: it has no velocity that friction could know of.
            platform.SetXForm(new b2Vec2(0.1f * step, 0), 0);
            world.Step(Bench.Dt, 10);
        }

        Assert.Equal(6, platform.GetPosition().x, 1e-5);
        Assert.Equal(0, box.GetPosition().x, 1e-3);
        for (int step = 1; step <= 60; step++)
        {
            platform.SetXForm(new b2Vec2(6, 0.01f * step), 0);
            world.Step(Bench.Dt, 10);
        }

        // Lifted by 0.6 m; it lags behind by what it is pushed out in the last steps.
        Assert.InRange(box.GetPosition().y, 1.55f, 1.65f);
    }

    [Fact]
    [ManualRow("B109", "B110")]
    public void StaticBody_IsMovedByHand()
    {
        b2World world = Bench.World();
        b2Body platform = Bench.Static(world, 0, 0, 5, 0.5f);
        b2Body box = Bench.Dynamic(world, 0, 0.998f);
        Bench.Step(world, 10);

        Assert.True(platform.SetXForm(new b2Vec2(0, -2), 0.1f));
        Assert.Equal(-2, platform.GetXForm().position.y);
        Assert.Equal(0.1f, platform.GetAngle(), 1e-6f);
        Bench.Step(world, 60);
        Assert.True(box.GetPosition().y < 0);
        Assert.Throws<ArgumentNullException>(() => platform.SetXForm(null!, 0));
    }

    [Fact]
    [ManualRow("B113-B119")]
    public void Loads_ChangeTheMotion()
    {
        b2World world = Bench.World(0);
        b2Body body = Bench.Dynamic(world, 0, 0, 1, 1);
        body.ApplyForce(new b2Vec2(4 * 60, 0), new b2Vec2(0, 1));
        body.ApplyTorque(60);
        world.Step(Bench.Dt, 10);

        Assert.Equal(1, body.GetLinearVelocity().x, 1e-4);
        double inertia = body.GetInertia();
        Assert.Equal((-4 + 1) / inertia, body.GetAngularVelocity(), 1e-4);
        world.Step(Bench.Dt, 10);
        Assert.Equal(1, body.GetLinearVelocity().x, 1e-4);
        body.ApplyImpulse(new b2Vec2(0, 4), body.GetWorldCenter());
        Assert.Equal(1, body.GetLinearVelocity().y, 1e-5);
        body.SetAngularVelocity(5);
        Assert.Equal(5, body.GetAngularVelocity());
    }

    [Fact]
    [ManualRow("B121-B124")]
    public void Frames_TurnIntoEachOther()
    {
        b2World world = Bench.World(0);
        b2Body body = Bench.Dynamic(world, 3, 4);
        body.SetXForm(new b2Vec2(3, 4), 0.5f * b2Settings.b2_pi);

        Assert.Equal(5, body.GetWorldPoint(new b2Vec2(1, 0)).y, 1e-5);
        Assert.Equal(1, body.GetWorldVector(new b2Vec2(1, 0)).y, 1e-5);
        Assert.Equal(1, body.GetLocalPoint(new b2Vec2(3, 5)).x, 1e-5);
        Assert.Equal(1, body.GetLocalVector(new b2Vec2(0, 1)).x, 1e-5);
    }

    [Fact]
    [ManualRow("B125", "B126", "B128")]
    public void ShapesAndJoints_OfABody_AreLists()
    {
        b2World world = Bench.World();
        b2Body body = Bench.Ball(world, 0, 0);
        b2Shape first = body.GetShapeList()!;
        b2Shape second = body.CreateShape(new b2CircleDef());
        b2Body other = Bench.Ball(world, 5, 0);
        b2DistanceJointDef def = new();
        def.Initialize(body, other, body.GetPosition(), other.GetPosition());
        b2Joint joint = world.CreateJoint(def);

        Assert.Same(second, body.GetShapeList());
        Assert.Same(first, second.GetNext());
        Assert.Null(first.GetNext());
        b2JointEdge edge = body.GetJointList()!;
        Assert.Same(joint, edge.joint);
        Assert.Same(other, edge.other);
        Assert.Null(edge.next);
    }

    [Fact]
    public void Quirk_LocalPointVelocity_IsTheOriginals()
    {
        b2World world = Bench.World(0);
        b2Body body = Bench.Dynamic(world, 0, 0);
        body.SetLinearVelocity(new b2Vec2(1, 2));
        body.SetAngularVelocity(3);

        Assert.Equal(2 + (3 * 0.5), body.GetLinearVelocityFromLocalPoint(new b2Vec2(0.5f, 0)).y, 1e-5);
        Assert.Equal(2 + (3 * 0.5), body.GetLinearVelocityFromWorldPoint(new b2Vec2(0.5f, 0)).y, 1e-5);
        world.Quirks = Box2DFlash202Quirks.LocalPointVelocity;
        Assert.Equal(1 - (3 * 0.5), body.GetLinearVelocityFromLocalPoint(new b2Vec2(0.5f, 0)).y, 1e-5);
    }
}
