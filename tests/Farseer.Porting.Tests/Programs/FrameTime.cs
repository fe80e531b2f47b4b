using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>A game on a slow machine: Update(dt, dtReal) with scaling, and bodies at rest put aside.</summary>
    public class FrameTime
    {
        private readonly PhysicsSimulator _physicsSimulator = new PhysicsSimulator(new Vector2(0, 100));
        private readonly Body[] _boxes = new Body[30];

        public FrameTime()
        {
            _physicsSimulator.Scaling.Enabled = true;
            _physicsSimulator.Scaling.MaximumUpdateInterval = .05f;
            _physicsSimulator.InactivityController.Enabled = true;
            _physicsSimulator.InactivityController.MaxIdleTime = 200;
            _physicsSimulator.InactivityController.ActivationDistance = 50;

            Body floor = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 4000, 20, 1);
            floor.IsStatic = true;
            floor.Position = new Vector2(1500, 30);
            GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, floor, 4000, 20).FrictionCoefficient = .5f;
            for (int i = 0; i < _boxes.Length; i++)
            {
                _boxes[i] = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 10, 10, 1);
                _boxes[i].Position = new Vector2(100 * i, 14);
                _boxes[i].IsAutoIdle = true;
                GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, _boxes[i], 10, 10).FrictionCoefficient = .5f;
            }
        }

        public int Awake
        {
            get
            {
                int awake = 0;
                foreach (Body box in _boxes)
                {
                    if (box.Enabled)
                    {
                        awake++;
                    }
                }

                return awake;
            }
        }

        public float Interval
        {
            get { return _physicsSimulator.Scaling.UpdateInterval; }
        }

        public void Visit(int box)
        {
            Body visitor = BodyFactory.Instance.CreateCircleBody(_physicsSimulator, 5, 1);
            visitor.Position = _boxes[box].Position + new Vector2(-30, -2);
            visitor.LinearVelocity = new Vector2(60, 0);
            visitor.IsAutoIdle = true;
            GeomFactory.Instance.CreateCircleGeom(_physicsSimulator, visitor, 5, 12);
        }

        public void Frame(float dt, float real)
        {
            _physicsSimulator.Update(dt, real);
        }
    }
}
