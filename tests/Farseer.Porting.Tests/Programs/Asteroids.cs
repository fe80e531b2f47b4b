using System.Collections.Generic;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Mathematics;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>A ship that turns and thrusts among drifting rocks in a world that wraps around.</summary>
    public class Asteroids
    {
        private const float Half = 300;

        private readonly PhysicsSimulator _physicsSimulator = new PhysicsSimulator(new Vector2());
        private readonly List<Body> _all = new List<Body>();

        public Asteroids()
        {
            Vertices hull = new Vertices();
            hull.Add(new Vector2(12, 0));
            hull.Add(new Vector2(-8, 8));
            hull.Add(new Vector2(-4, 0));
            hull.Add(new Vector2(-8, -8));
            Ship = BodyFactory.Instance.CreatePolygonBody(_physicsSimulator, new Vertices(hull), 1);
            Ship.Position = Vector2.Zero;
            ShipGeom = GeomFactory.Instance.CreatePolygonGeom(_physicsSimulator, Ship, hull, 0);
            _all.Add(Ship);
            for (int i = 0; i < 8; i++)
            {
                float angle = MathHelper.ToRadians(45 * i);
                Body rock = BodyFactory.Instance.CreateCircleBody(_physicsSimulator, 20, 10);
                rock.Position = 200 * Calculator.RadiansToVector(angle);
                rock.LinearVelocity = Calculator.RadiansToVector(angle + MathHelper.PiOver2) * 30;
                GeomFactory.Instance.CreateCircleGeom(_physicsSimulator, rock, 20, 12).RestitutionCoefficient = 1;
                _all.Add(rock);
            }
        }

        public Body Ship { get; private set; }

        public Geom ShipGeom { get; private set; }

        public void Update(float dt, float turn, bool thrust)
        {
            Ship.ApplyTorque(turn * 400);
            if (thrust)
            {
                Matrix matrix;
                Ship.GetBodyMatrix(out matrix);
                Vector2 force = Vector2.TransformNormal(new Vector2(80, 0), matrix);
                Ship.ApplyForce(ref force);
            }

            _physicsSimulator.Update(dt);
            foreach (Body body in _all)
            {
                Vector2 position = body.Position;
                if (position.X > Half || position.X < -Half)
                {
                    position.X = MathHelper.Clamp(-position.X, -Half, Half);
                }

                if (position.Y > Half || position.Y < -Half)
                {
                    position.Y = MathHelper.Clamp(-position.Y, -Half, Half);
                }

                if (position != body.Position)
                {
                    body.Position = position;
                }
            }
        }

        /// <summary>Where the ship's nose is, by its matrix.</summary>
        public Vector2 Nose()
        {
            Matrix matrix = Ship.GetBodyMatrix();
            Vector3 right = matrix.Right;
            return Ship.Position + (12 * new Vector2(right.X, right.Y));
        }
    }
}
