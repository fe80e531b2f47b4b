using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>Planks joined by revolute joints between two banks, with crates on them.</summary>
    public class RopeBridge
    {
        private readonly PhysicsSimulator _physicsSimulator = new PhysicsSimulator(new Vector2(0, 100));
        private readonly Body[] _planks = new Body[20];
        private readonly Body[] _crates = new Body[3];

        public RopeBridge()
        {
            for (int i = 0; i < _planks.Length; i++)
            {
                if (i == 0)
                {
                    _planks[i] = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 20, 6, 1);
                }
                else
                {
                    _planks[i] = BodyFactory.Instance.CreateBody(_physicsSimulator, _planks[0]);
                }

                _planks[i].Position = new Vector2(i * 20, 0);
                Geom geom = i == 0
                    ? GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, _planks[0], 20, 6)
                    : GeomFactory.Instance.CreateGeom(_physicsSimulator, _planks[i], FirstGeom);
                FirstGeom = FirstGeom ?? geom;
                geom.CollisionGroup = 1;
                geom.FrictionCoefficient = .5f;
                if (i > 0)
                {
                    JointFactory.Instance.CreateRevoluteJoint(
                        _physicsSimulator, _planks[i - 1], _planks[i], new Vector2((i * 20) - 10, 0));
                }
            }

            JointFactory.Instance.CreateFixedRevoluteJoint(_physicsSimulator, _planks[0], new Vector2(-10, 0));
            JointFactory.Instance.CreateFixedRevoluteJoint(_physicsSimulator, _planks[19], new Vector2(390, 0));
            for (int i = 0; i < _crates.Length; i++)
            {
                _crates[i] = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 16, 16, 5);
                _crates[i].Position = new Vector2(150 + (40 * i), -30);
                GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, _crates[i], 16, 16).FrictionCoefficient = .8f;
            }
        }

        public float LargestError()
        {
            float error = 0;
            foreach (Joint joint in _physicsSimulator.JointList)
            {
                error = System.Math.Max(error, joint.JointError);
            }

            return error;
        }

        public float Sag()
        {
            return _planks[10].Position.Y;
        }

        public bool CratesAreUp()
        {
            foreach (Body crate in _crates)
            {
                if (crate.Position.Y > Sag() + 10)
                {
                    return false;
                }
            }

            return true;
        }

        public void Update(float dt)
        {
            _physicsSimulator.Update(dt);
        }

        private Geom FirstGeom { get; set; }
    }
}
