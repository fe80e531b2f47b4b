using System.Collections.Generic;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>One body of many bricks; a brick hit hard enough leaves it and becomes a body of its own.</summary>
    public class BreakableWall
    {
        private readonly PhysicsSimulator _physicsSimulator = new PhysicsSimulator(new Vector2(0, 100));
        private readonly Body _wall;
        private readonly Body _ball;
        private readonly List<Geom> _bricks = new List<Geom>();
        private readonly List<Geom> _broken = new List<Geom>();

        public BreakableWall(float speed)
        {
            Body floor = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 1000, 40, 1);
            floor.Position = new Vector2(0, 120);
            floor.IsStatic = true;
            GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, floor, 1000, 40).FrictionCoefficient = .8f;

            _wall = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 20, 200, 40);
            _wall.IsStatic = true;
            for (int i = 0; i < 10; i++)
            {
                Geom brick = GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, _wall, 20, 20, new Vector2(0, -90 + (i * 20)), 0);
                brick.OnCollision += OnBrickHit;
                _bricks.Add(brick);
            }

            _ball = BodyFactory.Instance.CreateCircleBody(_physicsSimulator, 12, 5);
            _ball.Position = new Vector2(-150, -20);
            _ball.LinearVelocity = new Vector2(speed, -60);
            GeomFactory.Instance.CreateCircleGeom(_physicsSimulator, _ball, 12, 20).RestitutionCoefficient = .2f;
        }

        public int Bricks
        {
            get { return _bricks.Count; }
        }

        public List<Body> Debris { get; } = new List<Body>();

        public void Update(float dt)
        {
            _physicsSimulator.Update(dt);
            foreach (Geom brick in _broken)
            {
                _bricks.Remove(brick);
                Vector2 place = brick.Position;
                brick.Dispose();
                Body piece = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 20, 20, 1);
                piece.Position = place;
                GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, piece, 20, 20);
                Debris.Add(piece);
            }

            _broken.Clear();
        }

        private bool OnBrickHit(Geom brick, Geom other, ContactList contactList)
        {
            if (other.Body != _ball || _broken.Contains(brick))
            {
                return true;
            }

            Vector2 velocity = _ball.LinearVelocity;
            Vector2 normal = contactList[0].Normal;
            float approach;
            Vector2.Dot(ref velocity, ref normal, out approach);
            if (System.Math.Abs(approach) > 100)
            {
                _broken.Add(brick);
            }

            return true;
        }
    }
}
