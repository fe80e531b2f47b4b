using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

using PhysicsSimulator simulator = new(new Vector2(0, -10));
Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 20, 1, 1);
floor.IsStatic = true;
GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 20, 1);
Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 0.5f, 1);
ball.Position = new Vector2(0, 5);
Geom ballGeom = GeomFactory.Instance.CreateCircleGeom(simulator, ball, 0.5f, 16);
int touches = 0;
ballGeom.OnCollision += (_, _, _) =>
{
    touches++;
    return true;
};

for (int step = 0; step < 240; step++)
{
    simulator.Update(1f / 60f);
}

Console.WriteLine(FormattableString.Invariant($"y {ball.Position.Y:F3} touched {touches > 0}"));
