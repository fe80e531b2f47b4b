using System;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Box2D.Bridge;

/// <summary>The velocity of a body itself: what is written to it is the body's.</summary>
internal sealed class VelocityView : b2Vec2
{
    private readonly b2Body _body;

    public VelocityView(b2Body body) => _body = body;

    public override float x
    {
        get => _body.Link.Velocity.X;
        set => Set(value, y);
    }

    public override float y
    {
        get => _body.Link.Velocity.Y;
        set => Set(x, value);
    }

    public override void Set(float x_ = 0, float y_ = 0) => _body.SetLinearVelocity(new b2Vec2(x_, y_));
}

/// <summary>The gravity of a world itself: what is written to it is the world's.</summary>
internal sealed class GravityView : b2Vec2
{
    private readonly b2World _world;

    public GravityView(b2World world) => _world = world;

    public override float x
    {
        get => _world.Engine.Gravity.X;
        set => Set(value, y);
    }

    public override float y
    {
        get => _world.Engine.Gravity.Y;
        set => Set(x, value);
    }

    public override void Set(float x_ = 0, float y_ = 0) => _world.SetGravity(new b2Vec2(x_, y_));
}

/// <summary>What a vector shows of a body.</summary>
internal enum Shown
{
    Position,
    WorldCenter,
    LocalCenter,
    FirstColumn,
    SecondColumn,
}

/// <summary>
/// A place or direction of a body that follows it. Writing to it is refused: in the original it would change a number that the next
/// step overwrites.
/// </summary>
internal sealed class PlaceView : b2Vec2
{
    private readonly BodyLink _link;
    private readonly Shown _shown;

    public PlaceView(BodyLink link, Shown shown)
    {
        _link = link;
        _shown = shown;
    }

    public override float x
    {
        get => (float)(_shown switch
        {
            Shown.Position => _link.OriginX,
            Shown.WorldCenter => _link.WorldCenterX,
            Shown.LocalCenter => _link.CenterX,
            Shown.FirstColumn => _link.Cos,
            _ => -_link.Sin,
        });
        set => throw Refused();
    }

    public override float y
    {
        get => (float)(_shown switch
        {
            Shown.Position => _link.OriginY,
            Shown.WorldCenter => _link.WorldCenterY,
            Shown.LocalCenter => _link.CenterY,
            Shown.FirstColumn => _link.Sin,
            _ => _link.Cos,
        });
        set => throw Refused();
    }

    private static InvalidOperationException Refused() =>
        new InvalidOperationException(
            "This vector shows where the body is and cannot be set: use b2Body.SetXForm or SetMass, or Copy() it.");
}
