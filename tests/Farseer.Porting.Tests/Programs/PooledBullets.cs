using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>A turret whose bullets come from a pool, hit a wall of targets, and go back into the pool.</summary>
    public class PooledBullets
    {
        private readonly PhysicsSimulator _physicsSimulator = new PhysicsSimulator(Vector2.Zero);
        private readonly Pool<Bullet> _pool = new Pool<Bullet>();
        private readonly List<Bullet> _flying = new List<Bullet>();
        private readonly List<Bullet> _spent = new List<Bullet>();
        private readonly Body _target;

        public PooledBullets()
        {
            _target = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 20, 200, 50);
            _target.Position = new Vector2(300, 0);
            GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, _target, 20, 200);
        }

        public int Fired { get; private set; }

        public int Hits { get; private set; }

        public int Made { get; private set; }

        public int Flying
        {
            get { return _flying.Count; }
        }

        public float TargetSpeed
        {
            get { return _target.LinearVelocity.Length(); }
        }

        public void Fire(float angle)
        {
            Bullet bullet = _pool.Fetch();
            if (bullet.Body == null)
            {
                bullet.Body = BodyFactory.Instance.CreateCircleBody(3, .1f);
                bullet.Geom = GeomFactory.Instance.CreateCircleGeom(bullet.Body, 3, 8);
                bullet.Geom.OnCollision += delegate
                {
                    if (!_spent.Contains(bullet))
                    {
                        _spent.Add(bullet);
                    }

                    return true;
                };
                Made++;
            }

            Matrix turn = Matrix.CreateRotationZ(angle);
            Vector2 muzzle = new Vector2(20, 0);
            Vector2 direction;
            Vector2.Transform(ref muzzle, ref turn, out muzzle);
            Vector2.Normalize(ref muzzle, out direction);
            bullet.Body.ResetDynamics();
            bullet.Body.Position = muzzle;
            bullet.Body.LinearVelocity = direction * 400;
            _physicsSimulator.Add(bullet.Body);
            _physicsSimulator.Add(bullet.Geom);
            _flying.Add(bullet);
            Fired++;
        }

        public void Update(float dt)
        {
            _physicsSimulator.Update(dt);
            foreach (Bullet bullet in _spent)
            {
                Hits++;
                Retire(bullet);
            }

            _spent.Clear();
            foreach (Bullet bullet in _flying.ToArray())
            {
                if (Vector2.Distance(bullet.Body.Position, Vector2.Zero) > 600)
                {
                    Retire(bullet);
                }
            }
        }

        private void Retire(Bullet bullet)
        {
            _physicsSimulator.Remove(bullet.Geom);
            _physicsSimulator.Remove(bullet.Body);
            _flying.Remove(bullet);
            _pool.Insert(bullet);
        }

        public class Bullet
        {
            public Body Body;
            public Geom Geom;
        }
    }
}
