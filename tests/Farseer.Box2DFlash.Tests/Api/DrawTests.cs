using System.Collections.Generic;
using System.Linq;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

public sealed class DrawTests
{
    [Fact]
    [ManualRow("B327-B341")]
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
            world.Step(0, 1);
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

        public void lineStyle(float thickness, uint color, float alpha) => Calls.Add($"lineStyle {color:x6}");

        public void moveTo(float x, float y) => Calls.Add("moveTo");

        public void lineTo(float x, float y) => Calls.Add("lineTo");

        public void beginFill(uint color, float alpha) => Calls.Add($"beginFill {color:x6} {alpha:0.#}");

        public void endFill() => Calls.Add("endFill");

        public void drawCircle(float x, float y, float radius) => Calls.Add($"drawCircle {x:0.##} {y:0.##} {radius:0.##}");

        public void clear() => Calls.Clear();
    }
}
