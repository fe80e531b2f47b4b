using System;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;

var worldAABB = new b2AABB();
worldAABB.lowerBound.Set(-100f, -100f);
worldAABB.upperBound.Set(100f, 100f);
var world = new b2World(worldAABB, new b2Vec2(0f, -10f), true);

var groundBodyDef = new b2BodyDef();
groundBodyDef.position.Set(0f, -10f);
b2Body groundBody = world.CreateBody(groundBodyDef);
var groundShapeDef = new b2PolygonDef();
groundShapeDef.SetAsBox(50f, 10f);
groundBody.CreateShape(groundShapeDef);

var bodyDef = new b2BodyDef();
bodyDef.position.Set(0f, 4f);
b2Body body = world.CreateBody(bodyDef);
var shapeDef = new b2PolygonDef();
shapeDef.SetAsBox(1f, 1f);
shapeDef.density = 1f;
shapeDef.friction = 0.3f;
body.CreateShape(shapeDef);
body.SetMassFromShapes();

for (int i = 0; i < 60; ++i)
{
    world.Step(1f / 60f, 10);
}

Console.WriteLine(FormattableString.Invariant($"y {body.GetPosition().y:F3} angle {body.GetAngle():F3}"));
