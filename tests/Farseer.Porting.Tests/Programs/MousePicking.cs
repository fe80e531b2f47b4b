using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>The mouse takes hold of the geom under it with a spring, drags it, and lets it go.</summary>
    public class MousePicking
    {
        private readonly PhysicsSimulator _physicsSimulator = new PhysicsSimulator(new Vector2(0, 50));
        private FixedLinearSpring _mousePickSpring;
        private Geom _pickedGeom;

        public MousePicking()
        {
            Box = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 40, 20, 1);
            Box.Position = new Vector2(100, 100);
            Box.LinearDragCoefficient = 1;
            Box.RotationalDragCoefficient = 200;
            BoxGeom = GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, Box, 40, 20);
            _physicsSimulator.Update(.0001f);
        }

        public Body Box { get; private set; }

        public Geom BoxGeom { get; private set; }

        public bool IsHolding
        {
            get { return _mousePickSpring != null && !_mousePickSpring.IsDisposed; }
        }

        public Geom MouseDown(Vector2 point)
        {
            _pickedGeom = _physicsSimulator.Collide(point);
            if (_pickedGeom != null)
            {
                _mousePickSpring = SpringFactory.Instance.CreateFixedLinearSpring(
                    _physicsSimulator, _pickedGeom.Body, _pickedGeom.Body.GetLocalPosition(point), point, 20, 10);
            }

            return _pickedGeom;
        }

        public void MouseMove(Vector2 point)
        {
            if (_mousePickSpring != null)
            {
                _mousePickSpring.WorldAttachPoint = point;
            }
        }

        public void MouseUp()
        {
            if (_mousePickSpring != null && _mousePickSpring.IsDisposed == false)
            {
                _mousePickSpring.Dispose();
                _mousePickSpring = null;
            }
        }

        /// <summary>How far the picked point is from the mouse.</summary>
        public float Stretch()
        {
            return Vector2.Distance(
                _mousePickSpring.Body.GetWorldPosition(_mousePickSpring.BodyAttachPoint), _mousePickSpring.WorldAttachPoint);
        }

        public void Update(float dt)
        {
            _physicsSimulator.Update(dt);
        }
    }
}
