using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>A flipper on a fixed revolute joint between two angle limits throws a ball; bumpers count hits.</summary>
    public class Pinball
    {
        private readonly PhysicsSimulator _physicsSimulator = new PhysicsSimulator(new Vector2(0, 100));
        private readonly Body _flipper;
        private readonly FixedRevoluteJoint _axle;

        public Pinball()
        {
            _flipper = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 60, 8, 2);
            _flipper.Position = new Vector2(30, 0);
            Geom flipperGeom = GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, _flipper, 60, 8);
            flipperGeom.CollisionCategories = CollisionCategory.Cat2;
            flipperGeom.CollidesWith = CollisionCategory.All & ~CollisionCategory.Cat2;
            _axle = JointFactory.Instance.CreateFixedRevoluteJoint(_physicsSimulator, _flipper, new Vector2(0, 0));
            JointFactory.Instance.CreateFixedAngleLimitJoint(_physicsSimulator, _flipper, -.6f, .4f);

            Ball = BodyFactory.Instance.CreateCircleBody(_physicsSimulator, 6, .3f);
            Ball.Position = new Vector2(40, -20);
            Geom ballGeom = GeomFactory.Instance.CreateCircleGeom(_physicsSimulator, Ball, 6, 16);
            ballGeom.RestitutionCoefficient = .1f;

            Body bumper = BodyFactory.Instance.CreateCircleBody(_physicsSimulator, 30, 1);
            bumper.IsStatic = true;
            bumper.Position = new Vector2(20, -110);
            Geom bumperGeom = GeomFactory.Instance.CreateCircleGeom(_physicsSimulator, bumper, 30, 24);
            bumperGeom.RestitutionCoefficient = 1;
            bumperGeom.OnCollision += delegate { Hits++; return true; };
        }

        public Body Ball { get; private set; }

        public int Hits { get; private set; }

        public float Angle
        {
            get { return _flipper.TotalRotation; }
        }

        public float AxleError
        {
            get { return _axle.JointError; }
        }

        public void Update(float dt, bool flip)
        {
            if (flip)
            {
                _flipper.ApplyTorque(-400000);
            }

            _physicsSimulator.Update(dt);
        }
    }
}
