using System.Collections.Generic;
using System.Globalization;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Box2DFlash.Tests.Porting;

/// <summary>The Hello Box2D program of the manual, word by word; "trace" collects lines.</summary>
internal static class HelloWorld
{
    public static List<string> Run()
    {
        var lines = new List<string>();
        void trace(params float[] values) =>
            lines.Add(string.Join(" ", System.Array.ConvertAll(values, v => v.ToString("0.00", CultureInfo.InvariantCulture))));

        var worldAABB = new b2AABB();
        worldAABB.lowerBound.Set(-100.0f, -100.0f);
        worldAABB.upperBound.Set(100.0f, 100.0f);

        // Define the gravity vector.
        var gravity = new b2Vec2(0.0f, -10.0f);

        // Do we want to let bodies sleep?
        var doSleep = true;

        // Construct a world object, which will hold and simulate the rigid bodies.
        var world = new b2World(worldAABB, gravity, doSleep);

        // Define the ground body.
        var groundBodyDef = new b2BodyDef();
        groundBodyDef.position.Set(0.0f, -10.0f);

        // Call the body factory.
        var groundBody = world.CreateBody(groundBodyDef);

        // Define the ground box shape.
        var groundShapeDef = new b2PolygonDef();
        groundShapeDef.SetAsBox(50.0f, 10.0f);

        // Add the ground shape to the ground body.
        groundBody.CreateShape(groundShapeDef);

        // Define the dynamic body.
        var bodyDef = new b2BodyDef();
        bodyDef.position.Set(0.0f, 4.0f);
        var body = world.CreateBody(bodyDef);

        // Define another box shape for our dynamic body.
        var shapeDef = new b2PolygonDef();
        shapeDef.SetAsBox(1.0f, 1.0f);
        shapeDef.density = 1.0f;
        shapeDef.friction = 0.3f;
        body.CreateShape(shapeDef);

        // Now tell the dynamic body to compute its mass properties based on its shape.
        body.SetMassFromShapes();

        // Prepare for simulation.
        var timeStep = 1.0f / 60.0f;
        var iterations = 10;

        // This is our little game loop.
        for (var i = 0; i < 60; ++i)
        {
            world.Step(timeStep, iterations);
            var position = body.GetPosition();
            var angle = body.GetAngle();
            trace(position.x, position.y, angle);
        }

        return lines;
    }
}
