using System.Collections.Generic;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>A hero who runs and jumps only from the ground, collects coins, and books the geoms that carry it.</summary>
    public class PlatformerHero
    {
        private const float MaxSpeed = 120;

        private readonly HashSet<Geom> _ground = new HashSet<Geom>();
        private readonly List<Geom> _collected = new List<Geom>();
        private readonly PhysicsSimulator _physicsSimulator;
        private readonly Body _heroBody;
        private readonly Geom _heroGeom;

        public PlatformerHero()
        {
            _physicsSimulator = new PhysicsSimulator(new Vector2(0, 400));
            AddBlock(new Vector2(0, 200), 400, 20);
            AddBlock(new Vector2(300, 160), 120, 20);

            _heroBody = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 16, 32, 2);
            _heroBody.Position = new Vector2(-100, 100);
            _heroBody.MomentOfInertia = float.MaxValue;
            _heroBody.LinearDragCoefficient = .1f;
            _heroGeom = GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, _heroBody, 16, 32);
            _heroGeom.FrictionCoefficient = .6f;
            _heroGeom.CollisionCategories = CollisionCategory.Cat1;
            _heroGeom.OnCollision += OnCollision;
            _heroGeom.OnSeparation += OnSeparation;

            for (int i = 0; i < 3; i++)
            {
                Body coin = BodyFactory.Instance.CreateCircleBody(_physicsSimulator, 6, 1);
                coin.IsStatic = true;
                coin.Position = new Vector2(-40 + (i * 40), 174);
                Geom coinGeom = GeomFactory.Instance.CreateCircleGeom(_physicsSimulator, coin, 6, 12);
                coinGeom.CollisionCategories = CollisionCategory.Cat3;
                coinGeom.CollisionResponseEnabled = false;
                coinGeom.Tag = "coin";
            }
        }

        public int Jumps { get; private set; }

        public int Coins
        {
            get { return _collected.Count; }
        }

        public bool IsOnGround
        {
            get { return _ground.Count > 0; }
        }

        public Vector2 Position
        {
            get { return _heroBody.Position; }
        }

        public float Rotation
        {
            get { return _heroBody.Rotation; }
        }

        public void Update(float dt, bool right, bool jump)
        {
            if (right && _heroBody.LinearVelocity.X < MaxSpeed)
            {
                _heroBody.ApplyForce(new Vector2(1200, 0));
            }

            if (jump && IsOnGround)
            {
                _heroBody.LinearVelocity.Y = -190;
                Jumps++;
            }

            _physicsSimulator.Update(dt);
            foreach (Geom coin in _collected)
            {
                if (!coin.IsDisposed)
                {
                    coin.Body.Dispose();
                }
            }
        }

        private void AddBlock(Vector2 position, float width, float height)
        {
            Body block = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, width, height, 1);
            block.Position = position;
            block.IsStatic = true;
            Geom geom = GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, block, width, height);
            geom.FrictionCoefficient = .4f;
            geom.CollisionCategories = CollisionCategory.Cat2;
        }

        private bool OnCollision(Geom geom1, Geom geom2, ContactList contactList)
        {
            if ((string)geom2.Tag == "coin")
            {
                if (!_collected.Contains(geom2))
                {
                    _collected.Add(geom2);
                }

                return false;
            }

            // Only what is below carries: the normal points from the hero to the block.
            Vector2 normal = contactList[0].Normal;
            if (geom1 != _heroGeom)
            {
                Vector2.Multiply(ref normal, -1, out normal);
            }

            Vector2 toBlock;
            Vector2 blockPosition = geom2.Body.Position, heroPosition = _heroBody.Position;
            Vector2.Subtract(ref blockPosition, ref heroPosition, out toBlock);
            if (System.Math.Abs(normal.Y) > .7f && toBlock.Y > 0)
            {
                _ground.Add(geom2);
            }

            return true;
        }

        private void OnSeparation(Geom geom1, Geom geom2)
        {
            _ground.Remove(geom2);
        }
    }
}
