using System;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Ported
{
    public static class Program
    {
        public static void Main()
        {
            PhysicsSimulator simulator = new PhysicsSimulator(new Vector2(0, 100));
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 128, 128, 1);
            body.LinearDragCoefficient = 0;
            for (int step = 0; step < 100; step++)
            {
                simulator.Update(.01f);
            }

            Console.WriteLine(body.Position.Y.ToString("F2"));
        }
    }
}
