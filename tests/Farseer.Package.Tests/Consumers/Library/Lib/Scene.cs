using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Lib
{
    public static class Scene
    {
        public static Vector2 Throw(float seconds)
        {
            using (PhysicsSimulator simulator = new PhysicsSimulator(new Vector2(0, -10)))
            {
                Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
                body.LinearDragCoefficient = 0;
                body.LinearVelocity.X = 3;
                body.LinearVelocity.Y = 20;
                for (int step = 0; step < 64; step++)
                {
                    simulator.Update(seconds / 64);
                }

                return body.Position;
            }
        }
    }
}
