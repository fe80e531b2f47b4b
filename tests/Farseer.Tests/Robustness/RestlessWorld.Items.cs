using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Tests.Robustness;

/// <content>What it is made of.</content>
internal sealed partial class RestlessWorld
{
    private const float Room = 6;

    private void AddFloor()
    {
        Body floor = BodyFactory.Instance.CreateRectangleBody(_simulator, 60, 2, 1);
        floor.Position = new Vector2(0, -Room - 1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(_simulator, floor, 60, 2);
    }

    private void AddBody()
    {
        float size = Next(0.3f, 1.4f);
        Body body = BodyFactory.Instance.CreateRectangleBody(size, Often() ? size : Next(0.3f, 1.4f), MathF.Exp(Next(-2.3f, 2.3f)));
        body.Position = Room * Around();
        body.Rotation = Next(-3, 3);
        body.LinearVelocity = (_random.Next(3) == 0 ? 20 : 2) * Around();
        body.AngularVelocity = Next(-4, 4);
        int kind = _random.Next(16);
        body.IsStatic = kind == 0;
        body.IsKinematic = kind == 1;
        body.IsBullet = kind == 2;
        body.IterationFactor = _random.Next(8) == 0 ? 1 << _random.Next(5) : 0;
        body.Updated += (ref Vector2 _, ref float _) => Act("Body.Updated", body, null);
        body.Disposed += (_, _) => Act("Body.Disposed", null, null);
        _bodies.Add(body);
        _simulator.Add(body);
        for (int i = _random.Next(6) == 0 ? 2 : 1; i > 0; i--)
        {
            AddGeom(body);
        }
    }

    private void AddGeom(Body body)
    {
        float size = Next(0.3f, 1.4f);
        Vector2 offset = _random.Next(4) == 0 ? Around() : Vector2.Zero;
        GeomFactory factory = GeomFactory.Instance;
        Geom geom = _random.Next(9) switch
        {
            0 => factory.CreateCircleGeom(body, size / 2, 12, offset, 0),
            1 => factory.CreateCapsuleGeom(body, offset, offset + new Vector2(size, 0), 0.2f),
            2 => factory.CreateSegmentGeom(body, offset, offset + (size * Around())),
            3 => factory.CreatePolygonGeom(body, Star(size), offset, 0, 0),
            4 => factory.CreateEllipseGeom(body, size / 2, size / 3, 10, offset, 0.3f),
            5 => factory.CreateRoundedRectangleGeom(body, size, size, size / 5),
            _ => factory.CreateRectangleGeom(body, size, Often() ? size : size / 3, offset, Next(-1, 1)),
        };
        geom.FrictionCoefficient = Next(0, 2);
        geom.RestitutionCoefficient = _random.Next(3) == 0 ? Next(0, 1) : 0;
        geom.IsSensor = _random.Next(20) == 0;
        geom.OnCollision += (one, _, contacts) =>
        {
            Act("Geom.OnCollision", null, one);
            if (!_calm && _random.Next(64) == 0)
            {
                contacts.Clear();
            }

            return _calm || _random.Next(16) != 0;
        };
        geom.OnSeparation += (one, _) => Act("Geom.OnSeparation", null, one);
        _geoms.Add(geom);
        _simulator.Add(geom);
    }

    /// <summary>A star of five to eight points, which is concave.</summary>
    private Vertices Star(float size)
    {
        var star = new Vertices();
        int points = _random.Next(5, 9);
        for (int i = 0; i < 2 * points; i++)
        {
            float angle = MathF.PI * i / points;
            star.Add(size * (i % 2 == 0 ? 0.5f : Next(0.25f, 0.45f)) * new Vector2(MathF.Cos(angle), MathF.Sin(angle)));
        }

        return star;
    }

    private void AddJoint()
    {
        Body? one = Pick(_bodies, b => b.IsDisposed);
        Body? other = Pick(_bodies, b => b.IsDisposed);
        if (one is null || other is null || !_ties)
        {
            return;
        }

        try
        {
            Joint joint = MakeJoint(one, other);
            joint.Softness = _random.Next(8) == 0 ? 0.1f : 0;
            joint.Breakpoint = _random.Next(8) == 0 ? Next(0.01f, 0.5f) : float.MaxValue;
            joint.BreakForce = _random.Next(8) == 0 ? Next(1, 1000) : float.MaxValue;
            joint.CollideConnected = _random.Next(3) == 0;
            joint.Broke += (_, _) => Act("Joint.Broke", one, null);
            _joints.Add(joint);
            _simulator.Add(joint);
        }
        catch (ArgumentException)
        {
            // Both are one body, or nothing can move; or one has left the simulator.
        }
    }

    private Joint MakeJoint(Body one, Body other)
    {
        Vector2 anchor = ((one.Position + other.Position) / 2) + (0.2f * Around());
        Vector2 axis = Vector2.Normalize(Around() + new Vector2(2, 0));
        Vector2 end1 = 0.3f * Around();
        Vector2 end2 = 0.3f * Around();
        float apart = (other.GetWorldPosition(end2) - one.GetWorldPosition(end1)).Length();
        float angle = other.TotalRotation - one.TotalRotation;
        if (_random.Next(60) == 0)
        {
            return new Kinds.OwnJoint(one, other)
            {
                InPreStep = () => Act("Joint.PreStep", one, null),
                InUpdate = () => Act("Joint.Update", one, null),
            };
        }

        return _random.Next(18) switch
        {
            0 => new AngleJoint(one, other, angle),
            1 => new AngleLimitJoint(one, other, angle - Next(0, 1), angle + Next(0, 1)),
            2 => new DistanceJoint(one, end1, other, end2) { Frequency = Often() ? Next(1, 8) : 0 },
            3 => new FixedAngleJoint(one, one.TotalRotation),
            4 => new FixedAngleLimitJoint(one, one.TotalRotation - Next(0, 1), one.TotalRotation + Next(0, 1)),
            5 => Drive(new FixedPrismaticJoint(one, anchor, axis) { MaxMotorForce = Next(0, 50) }),
            6 => Drive(new FixedRevoluteJoint(one, one.Position + (0.5f * Around())) { MaxMotorTorque = Next(0, 50) }),
            7 => new GearJoint(one, other, Next(0.5f, 2)),
            8 => new MotorJoint(one, other) { MaxForce = Next(0, 50), MaxTorque = Next(0, 50) },
            9 => new PinJoint(one, end1, other, end2),
            10 => Drive(new PrismaticJoint(one, other, anchor, axis) { MaxMotorForce = Next(0, 50) }),
            11 => new PulleyJoint(one, end1, one.Position + new Vector2(0, 2), other, end2, other.Position + new Vector2(0, 2)),
            12 => new RopeJoint(one, end1, other, end2, apart + Next(0, 1)),
            13 => new SliderJoint(one, end1, other, end2, MathF.Max(0, apart - Next(0, 1)), apart + Next(0, 1)),
            14 => new TargetJoint(one, one.Position + Around()) { MaxForce = Next(0, 200) },
            15 => new WeldJoint(one, other, anchor) { Frequency = Often() ? Next(1, 8) : 0 },
            16 => Drive(new WheelJoint(one, other, anchor, axis) { Frequency = Next(1, 8), MaxMotorTorque = Next(0, 50) }),
            _ => Drive(new RevoluteJoint(one, other, anchor) { MaxMotorTorque = Next(0, 50) }),
        };
    }

    private DrivenPairJoint Drive(DrivenPairJoint joint)
    {
        joint.AreLimitsEnabled = Often();
        joint.LowerLimit = -Next(0, 1);
        joint.UpperLimit = Next(0, 1);
        joint.IsMotorEnabled = _random.Next(3) == 0;
        joint.MotorSpeed = Next(-6, 6);
        return joint;
    }

    private DrivenWorldJoint Drive(DrivenWorldJoint joint)
    {
        joint.AreLimitsEnabled = Often();
        joint.LowerLimit = -Next(0, 1);
        joint.UpperLimit = Next(0, 1);
        joint.IsMotorEnabled = _random.Next(3) == 0;
        joint.MotorSpeed = Next(-6, 6);
        return joint;
    }

    private void AddSpring()
    {
        Body? one = Pick(_bodies, b => b.IsDisposed);
        Body? other = Pick(_bodies, b => b.IsDisposed);
        if (one is null || other is null || ReferenceEquals(one, other) || !_ties)
        {
            return;
        }

        Spring spring = _random.Next(5) switch
        {
            4 => new Kinds.OwnSpring(one) { InUpdate = () => Act("Spring.Update", one, null) },
            0 => new AngleSpring(one, other, Next(0, 50), Next(0, 5)),
            1 => new FixedAngleSpring(one, Next(0, 50), Next(0, 5)),
            2 => new FixedLinearSpring(one, Vector2.Zero, one.Position + Around(), Next(0, 80), Next(0, 5)),
            _ => new LinearSpring(one, Vector2.Zero, other, 0.1f * Vector2.One, Next(0, 80), Next(0, 5)),
        };
        spring.Breakpoint = _random.Next(6) == 0 ? Next(0, 2) : float.MaxValue;
        spring.Broke += (_, _) => Act("Spring.Broke", one, null);
        _springs.Add(spring);
        _simulator.Add(spring);
    }

    private void AddController()
    {
        Body? one = Pick(_bodies, b => b.IsDisposed);
        Body? other = Pick(_bodies, b => b.IsDisposed);
        if (one is null || other is null)
        {
            return;
        }

        Controller controller = _random.Next(5) switch
        {
            0 => new WindController(3 * Around(), 0.5f),
            1 => new GravityController(Room * Around(), 20, 1),
            2 => new VelocityLimitController(20, 10),
            3 => Blast(),
            _ => new Kinds.OwnController(one, other) { InUpdate = () => Act("Controller.Update", one, null) },
        };
        _controllers.Add(controller);
        _simulator.Add(controller);
    }

    private ExplosionController Blast()
    {
        var blast = new ExplosionController();
        blast.Explode(Room * Around(), 5, 20);
        return blast;
    }
}
