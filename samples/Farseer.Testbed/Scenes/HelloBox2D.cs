using System;
using System.Collections.Generic;
using Box2D.Dynamics;

namespace Farseer.Testbed.Scenes;

/// <summary>The program of the manual: it prints position and angle of the box after each step.</summary>
public sealed class HelloBox2D : TestScene
{
    private readonly b2Body _body;

    public HelloBox2D()
    {
        // Define the ground body.
        var groundBodyDef = new b2BodyDef();
        groundBodyDef.position.Set(0.0f, -10.0f);
        var groundBody = World.CreateBody(groundBodyDef);
        groundBody.CreateShape(Box(50.0f, 10.0f, 0));

        // Define the dynamic body.
        var bodyDef = new b2BodyDef();
        bodyDef.position.Set(0.0f, 4.0f);
        _body = World.CreateBody(bodyDef);
        _body.CreateShape(Box(1.0f, 1.0f));
        _body.SetMassFromShapes();
    }

    public override string Name => "hello";

    public override string Description => "Hello Box2D of the manual: a box falls on the ground.";

    public override int Steps => 60;

    public override IEnumerable<Outcome> Check()
    {
        yield return Near("height", _body.GetPosition().y, 1, 0.01);
        yield return Near("angle", _body.GetAngle(), 0, 0.01);
    }

    protected override void After(int step) =>
        Console.WriteLine($"{_body.GetPosition().x:0.00} {_body.GetPosition().y:0.00} {_body.GetAngle():0.00}");
}
