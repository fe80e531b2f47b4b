using System.Collections.Generic;
using System.Linq;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

public sealed class DrawTests
{
    [Fact]
    [ManualRow("B337")]
    public void TurnedBoxes_AreDrawnRoundPolygonsAlone_CornerByCorner()
    {
        for (int i = 0; i < 8; i++)
        {
            b2World world = Bench.World(0, 100);
            Bench.Ball(world, 20, 0);

            // A triangle of 5 by 2, turned in its body by the angle of 3, 4 and 5: its smallest turned box lies on the longest side. The
            // body is turned as well.
            b2PolygonDef def = new() { density = 1, vertexCount = 3 };
            def.vertices[0].Set(0, 0);
            def.vertices[1].Set(4, 3);
            def.vertices[2].Set(1.2f, 3.4f);
            b2Body body = Bench.Body(world, 3, 4, def);
            body.SetXForm(new b2Vec2(3, 4), 0.7f * i);
            Graphics graphics = new();
            b2DebugDraw draw = new() { m_sprite = graphics, m_drawScale = 1, m_drawFlags = b2DebugDraw.e_obbBit };
            world.SetDebugDraw(draw);
            world.DrawDebugData();

            Assert.Empty(graphics.Circles);
            b2Vec2[] corners = [new(0, 0), new(4, 3), new(2.8f, 4.6f), new(-1.2f, 1.6f)];
            corners = [.. corners.Select(body.GetWorldPoint)];
            Assert.NotEmpty(graphics.Points);
            Assert.All(corners, corner => Assert.Contains(graphics.Points, p => Near(p, corner)));
            Assert.All(graphics.Points, p => Assert.Contains(corners, corner => Near(p, corner)));
        }

        static bool Near((float X, float Y) p, b2Vec2 corner) => System.Math.Abs(p.X - corner.x) + System.Math.Abs(p.Y - corner.y) < 1e-4f;
    }

    [Fact]
    [ManualRow("B327-B336", "B338-B341")]
    public void DebugDraw_DrawsWhatTheFlagsSay_AtEachStep()
    {
        b2World world = Bench.World(0, 10);
        b2Body box = Bench.Dynamic(world, 0, 0);
        Bench.Ball(world, 0.9f, 0);
        b2RevoluteJointDef def = new();
        def.Initialize(world.GetGroundBody(), box, new b2Vec2(0, 2));
        world.CreateJoint(def);
        Graphics graphics = new();
        b2DebugDraw draw = new() { m_sprite = graphics, m_drawScale = 30, m_fillAlpha = 0.3f, m_lineThickness = 1 };
        world.SetDebugDraw(draw);
        Dictionary<uint, int> lines = [];
        foreach (uint flag in new[]
        {
            0u, b2DebugDraw.e_shapeBit, b2DebugDraw.e_jointBit, b2DebugDraw.e_coreShapeBit, b2DebugDraw.e_aabbBit, b2DebugDraw.e_obbBit,
            b2DebugDraw.e_pairBit, b2DebugDraw.e_centerOfMassBit, b2DebugDraw.e_shapeBit | b2DebugDraw.e_coreShapeBit,
        })
        {
            draw.m_drawFlags = flag;
            world.Step(0f, 1);
            lines[flag] = graphics.Calls.Count;
        }

        Assert.Equal(0, lines[0]);
        Assert.Equal(0, lines[b2DebugDraw.e_coreShapeBit]);
        Assert.True(lines[b2DebugDraw.e_shapeBit | b2DebugDraw.e_coreShapeBit] > lines[b2DebugDraw.e_shapeBit]);
        Assert.All(lines.Where(l => l.Key is not (0 or b2DebugDraw.e_coreShapeBit)), l => Assert.True(l.Value > 0, "flag " + l.Key));
        draw.SetFlags(b2DebugDraw.e_shapeBit);
        world.DrawDebugData();
        Assert.Contains("drawCircle 27 0 15", graphics.Calls);
        Assert.Contains("beginFill e5e5e5 0.3", graphics.Calls);
        draw.AppendFlags(2);
        draw.ClearFlags(1);
        Assert.Equal(2u, draw.GetFlags());
        world.SetDebugDraw(null);
        graphics.Calls.Clear();
        world.Step(Bench.Dt, 1);
        Assert.Empty(graphics.Calls);
    }

    private sealed class Graphics : IGraphics
    {
        public List<string> Calls { get; } = [];

        public List<(float X, float Y)> Points { get; } = [];

        public List<(float X, float Y)> Circles { get; } = [];

        public void lineStyle(float thickness, uint color, float alpha) => Calls.Add($"lineStyle {color:x6}");

        public void moveTo(float x, float y)
        {
            Calls.Add("moveTo");
            Points.Add((x, y));
        }

        public void lineTo(float x, float y)
        {
            Calls.Add("lineTo");
            Points.Add((x, y));
        }

        public void beginFill(uint color, float alpha) => Calls.Add($"beginFill {color:x6} {alpha:0.#}");

        public void endFill() => Calls.Add("endFill");

        public void drawCircle(float x, float y, float radius)
        {
            Calls.Add($"drawCircle {x:0.##} {y:0.##} {radius:0.##}");
            Circles.Add((x, y));
        }

        public void clear() => Calls.Clear();
    }
}
