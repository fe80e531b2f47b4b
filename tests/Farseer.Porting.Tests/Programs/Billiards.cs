using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>Fifteen balls racked and broken on a table without gravity.</summary>
    public class Billiards
    {
        private const float Radius = 8;

        private readonly PhysicsSimulator _physicsSimulator = new PhysicsSimulator();
        private readonly Body[] _balls = new Body[16];

        public Billiards()
        {
            _physicsSimulator.Gravity = Vector2.Zero;
            Cushion(new Vector2(0, -110), 440, 20);
            Cushion(new Vector2(0, 110), 440, 20);
            Cushion(new Vector2(-220, 0), 20, 240);
            Cushion(new Vector2(220, 0), 20, 240);

            int ball = 1;
            for (int row = 0; row < 5; row++)
            {
                for (int i = 0; i <= row; i++)
                {
                    Vector2 spot = new Vector2(80 + (row * Radius * 1.8f), ((2 * i) - row) * Radius * 1.01f);
                    _balls[ball++] = Ball(spot);
                }
            }

            _balls[0] = Ball(new Vector2(-120, 1));
        }

        public Body Cue
        {
            get { return _balls[0]; }
        }

        public int Moved { get; private set; }

        public void Shoot(float power)
        {
            Vector2 aim = _balls[1].Position - Cue.Position;
            aim.Normalize();
            Vector2 impulse;
            Vector2.Multiply(ref aim, power, out impulse);
            Cue.ApplyImpulse(ref impulse);
        }

        public float Energy()
        {
            float energy = 0;
            foreach (Body ball in _balls)
            {
                energy += .5f * ball.Mass * ball.LinearVelocity.LengthSquared();
            }

            return energy;
        }

        public bool AllOnTable()
        {
            foreach (Body ball in _balls)
            {
                Vector2 position = ball.Position, low = new Vector2(-210, -100), high = new Vector2(210, 100), clamped;
                Vector2.Clamp(ref position, ref low, ref high, out clamped);
                if (clamped != position)
                {
                    return false;
                }
            }

            return true;
        }

        public void Update(float dt)
        {
            _physicsSimulator.Update(dt);
            Moved = 0;
            foreach (Body ball in _balls)
            {
                if (ball.LinearVelocity != Vector2.Zero)
                {
                    Moved++;
                }
            }
        }

        private void Cushion(Vector2 position, float width, float height)
        {
            Body body = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, width, height, 1);
            body.IsStatic = true;
            body.Position = position;
            GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, body, width, height).RestitutionCoefficient = .8f;
        }

        private Body Ball(Vector2 position)
        {
            Body body = BodyFactory.Instance.CreateCircleBody(_physicsSimulator, Radius, 1);
            body.Position = position;
            body.LinearDragCoefficient = .2f;
            Geom geom = GeomFactory.Instance.CreateCircleGeom(_physicsSimulator, body, Radius, 16);
            geom.RestitutionCoefficient = .95f;
            geom.FrictionCoefficient = .05f;
            return body;
        }
    }
}
