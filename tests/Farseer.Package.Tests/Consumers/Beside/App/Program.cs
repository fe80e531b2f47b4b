using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Microsoft.Xna.Framework;
using Vector3 = Microsoft.Xna.Framework.Vector3;

namespace Beside
{
    public static class Program
    {
        public static void Main()
        {
            PhysicsSimulator simulator = new PhysicsSimulator(new Vector2(0, 100));
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 128, 128, 1);
            body.Name = "faller";
            body.LinearDragCoefficient = 0;
            body.Rotation = MathHelper.PiOver2;
            Path path = new Path(10, 10, 1, false);
            path.Add(new Vector2(0, 0));
            Curve curve = new Curve();
            curve.Keys.Add(new CurveKey(0, 7));
            Vector3 deep = new Vector3 { Depth = 3 };
            CurveTangent tangent = CurveTangent.OfTheFramework;
            for (int step = 0; step < 100; step++)
            {
                simulator.Update(.01f);
            }

            List<string> words = new List<string> { body.Name, body.Position.Y.ToString("F2") };
            words.Add(body.GetBodyMatrix().Right.Y.ToString("F2"));
            words.Add(curve.Evaluate(3).ToString("F0"));
            words.Add(deep.Depth.ToString("F0"));
            words.Add(tangent.ToString());
            Console.WriteLine(string.Join(" ", words));
        }
    }
}
