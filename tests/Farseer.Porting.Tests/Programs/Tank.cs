using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Mathematics;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>A tank on four wheels with a turret: wheels on revolute joints, the barrel held by an angle joint that aims it.</summary>
    public class Tank
    {
        private readonly PhysicsSimulator _physicsSimulator = new PhysicsSimulator(new Vector2(0, 200));
        private readonly Body[] _wheels = new Body[4];
        private readonly AngleJoint _aim;
        private readonly RevoluteJoint _hinge;

        public Tank()
        {
            Body ground = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 4000, 40, 1);
            ground.IsStatic = true;
            ground.Position = new Vector2(0, 100);
            GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, ground, 4000, 40).FrictionCoefficient = 1;

            Hull = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 100, 20, 4);
            Hull.Position = new Vector2(0, 50);
            GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, Hull, 100, 20).CollisionGroup = 5;
            for (int i = 0; i < 4; i++)
            {
                _wheels[i] = BodyFactory.Instance.CreateCircleBody(_physicsSimulator, 12, 1);
                _wheels[i].Position = new Vector2(-45 + (i * 30), 65);
                Geom wheel = GeomFactory.Instance.CreateCircleGeom(_physicsSimulator, _wheels[i], 12, 20);
                wheel.CollisionGroup = 5;
                wheel.FrictionCoefficient = 1;
                JointFactory.Instance.CreateRevoluteJoint(_physicsSimulator, Hull, _wheels[i], _wheels[i].Position);
            }

            Barrel = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 60, 6, .5f);
            Barrel.Position = new Vector2(30, 40);
            GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, Barrel, 60, 6).CollisionGroup = 5;
            _hinge = JointFactory.Instance.CreateRevoluteJoint(_physicsSimulator, Hull, Barrel, new Vector2(0, 40));
            _aim = JointFactory.Instance.CreateAngleJoint(_physicsSimulator, Hull, Barrel);
            _aim.TargetAngle = 0;
            _aim.MaxImpulse = 20000;
        }

        public Body Hull { get; private set; }

        public Body Barrel { get; private set; }

        public float HingeError
        {
            get { return _hinge.JointError; }
        }

        public float BarrelAngle
        {
            get { return Barrel.TotalRotation - Hull.TotalRotation; }
        }

        public void Update(float dt, float drive, float degrees)
        {
            _aim.TargetAngle = MathHelper.ToRadians(degrees);
            foreach (Body wheel in _wheels)
            {
                wheel.ApplyTorque(drive);
            }

            _physicsSimulator.Update(dt);
        }
    }
}
