using System.Numerics;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;

namespace Box2D.Bridge;

/// <summary>
/// Draws what the flags ask for, in the colours and the order of the original: bodies, joints and shapes from the newest on.
/// </summary>
internal static class WorldPainter
{
    public static void Draw(b2World world, b2DebugDraw draw, Vector2 lower, Vector2 upper)
    {
        uint flags = draw.GetFlags();
        draw.m_sprite?.clear();
        if ((flags & b2DebugDraw.e_shapeBit) != 0)
        {
            DrawShapes(world, draw, (flags & b2DebugDraw.e_coreShapeBit) != 0);
        }

        if ((flags & b2DebugDraw.e_jointBit) != 0)
        {
            for (b2Joint? joint = world.GetJointList(); joint is not null; joint = joint.GetNext())
            {
                DrawJoint(world, draw, joint);
            }
        }

        if ((flags & b2DebugDraw.e_pairBit) != 0)
        {
            var color = new b2Color(0.9f, 0.9f, 0.3f);
            world.Engine.VisitPairs((a, b) => draw.DrawSegment(CenterOf(world, a), CenterOf(world, b), color));
        }

        if ((flags & b2DebugDraw.e_aabbBit) != 0)
        {
            DrawBoxes(world, draw, lower, upper);
        }

        if ((flags & b2DebugDraw.e_obbBit) != 0)
        {
            DrawTurnedBoxes(world, draw);
        }

        if ((flags & b2DebugDraw.e_centerOfMassBit) != 0)
        {
            for (b2Body? body = world.GetBodyList(); body is not null; body = body.GetNext())
            {
                draw.DrawXForm(new b2XForm(body.GetWorldCenter(), body.GetXForm().R));
            }
        }
    }

    private static void DrawShapes(b2World world, b2DebugDraw draw, bool core)
    {
        var still = new b2Color(0.5f, 0.9f, 0.5f);
        var asleep = new b2Color(0.5f, 0.5f, 0.9f);
        var awake = new b2Color(0.9f, 0.9f, 0.9f);
        var inner = new b2Color(0.9f, 0.6f, 0.6f);
        for (b2Body? body = world.GetBodyList(); body is not null; body = body.GetNext())
        {
            b2Color color = body.IsStatic() ? still : body.IsSleeping() ? asleep : awake;
            for (b2Shape? shape = body.GetShapeList(); shape is not null; shape = shape.GetNext())
            {
                DrawShape(draw, shape, body.GetXForm(), color, core ? inner : null);
            }
        }
    }

    private static void DrawShape(b2DebugDraw draw, b2Shape shape, b2XForm xf, b2Color color, b2Color? core)
    {
        if (shape is b2CircleShape circle)
        {
            b2Vec2 center = b2Math.b2MulX(xf, circle.GetLocalPosition());
            draw.DrawSolidCircle(center, circle.GetRadius(), xf.R.col1.Copy(), color);
            if (core is not null)
            {
                draw.DrawCircle(center, circle.GetRadius() - b2Settings.b2_toiSlop, core);
            }

            return;
        }

        var polygon = (b2PolygonShape)shape;
        draw.DrawSolidPolygon(InWorld(xf, polygon.GetVertices()), polygon.GetVertexCount(), color);
        if (core is not null)
        {
            draw.DrawPolygon(InWorld(xf, polygon.GetCoreVertices()), polygon.GetVertexCount(), core);
        }
    }

    private static void DrawJoint(b2World world, b2DebugDraw draw, b2Joint joint)
    {
        var color = new b2Color(0.5f, 0.8f, 0.8f);
        b2Vec2 p1 = joint.GetAnchor1();
        b2Vec2 p2 = joint.GetAnchor2();
        switch (joint)
        {
            case b2DistanceJoint or b2MouseJoint:
                draw.DrawSegment(p1, p2, color);
                break;
            case b2PulleyJoint pulley:
                draw.DrawSegment(pulley.GetGroundAnchor1(), p1, color);
                draw.DrawSegment(pulley.GetGroundAnchor2(), p2, color);
                draw.DrawSegment(pulley.GetGroundAnchor1(), pulley.GetGroundAnchor2(), color);
                break;
            default:
                if (!ReferenceEquals(joint.GetBody1(), world.GetGroundBody()))
                {
                    draw.DrawSegment(joint.GetBody1().GetPosition().Copy(), p1, color);
                }

                draw.DrawSegment(p1, p2, color);
                if (!ReferenceEquals(joint.GetBody2(), world.GetGroundBody()))
                {
                    draw.DrawSegment(joint.GetBody2().GetPosition().Copy(), p2, color);
                }

                break;
        }
    }

    private static void DrawBoxes(b2World world, b2DebugDraw draw, Vector2 lower, Vector2 upper)
    {
        var color = new b2Color(0.9f, 0.3f, 0.9f);
        for (b2Body? body = world.GetBodyList(); body is not null; body = body.GetNext())
        {
            for (b2Shape? shape = body.GetShapeList(); shape is not null && !body.IsFrozen(); shape = shape.GetNext())
            {
                world.Engine.BoxOf(shape, out Vector2 min, out Vector2 max);
                DrawBox(draw, min, max, color);
            }
        }

        DrawBox(draw, lower, upper, new b2Color(0.3f, 0.9f, 0.9f));
    }

    private static void DrawBox(b2DebugDraw draw, Vector2 min, Vector2 max, b2Color color) => draw.DrawPolygon(
        new[] { new b2Vec2(min.X, min.Y), new b2Vec2(max.X, min.Y), new b2Vec2(max.X, max.Y), new b2Vec2(min.X, max.Y) },
        4,
        color);

    private static void DrawTurnedBoxes(b2World world, b2DebugDraw draw)
    {
        var color = new b2Color(0.5f, 0.3f, 0.5f);
        for (b2Body? body = world.GetBodyList(); body is not null; body = body.GetNext())
        {
            for (b2Shape? shape = body.GetShapeList(); shape is not null; shape = shape.GetNext())
            {
                if (shape is b2PolygonShape polygon)
                {
                    b2OBB obb = polygon.TurnedBox;
                    b2Vec2 h = obb.extents;
                    b2Vec2[] corners = { new b2Vec2(-h.x, -h.y), new b2Vec2(h.x, -h.y), new b2Vec2(h.x, h.y), new b2Vec2(-h.x, h.y) };
                    foreach (b2Vec2 corner in corners)
                    {
                        corner.MulM(obb.R);
                        corner.Add(obb.center);
                    }

                    draw.DrawPolygon(InWorld(body.GetXForm(), corners), 4, color);
                }
            }
        }
    }

    private static b2Vec2 CenterOf(b2World world, b2Shape shape)
    {
        world.Engine.BoxOf(shape, out Vector2 min, out Vector2 max);
        return new b2Vec2(0.5f * (min.X + max.X), 0.5f * (min.Y + max.Y));
    }

    private static b2Vec2[] InWorld(b2XForm xf, b2Vec2[] points) => System.Array.ConvertAll(points, p => b2Math.b2MulX(xf, p));
}
