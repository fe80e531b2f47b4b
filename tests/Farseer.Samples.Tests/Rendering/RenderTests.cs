using System;
using System.IO;
using System.Linq;
using System.Numerics;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Views;
using Xunit;

namespace Farseer.Samples.Tests.Rendering;

/// <summary>Pictures of the debug view as a browser shows them.</summary>
public sealed class RenderTests : IDisposable
{
    private const int Side = 400;

    /// <summary>Blends of two colours are rounded, at times twice.</summary>
    private const int Rounding = 3;
    private readonly string _folder = Directory.CreateTempSubdirectory("farseer-render").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [BrowserTheory]
    [InlineData(true)]
    [InlineData(false)]
    public void Picture_OfEveryKind_ShowsItInItsPlaceAndColour(bool yUp)
    {
        PhysicsSimulator simulator = EveryKind(yUp ? -1f : 1f, out Geom free, out Geom sensor);
        SvgDebugDraw svg = new(Vector2.Zero, new Vector2(200f, 200f), Side, Side, yUp);
        PhysicsSimulatorView view = new(simulator, svg)
        {
            EnableVerticeView = true,
            EnableGridView = true,
            EnableAABBView = true,
            EnableCoordinateAxisView = true,
            PointSize = 6f,
        };
        view.Draw();

        PngPicture picture = Rendered(svg, Side, Side);

        DebugColor[] areas = [
            view.FreeColor, view.TouchingColor, view.StaticColor, view.KinematicColor, view.SleepingColor, view.SensorColor,
            view.FluidColor,
        ];
        Assert.All(
            areas, color => Assert.True(picture.Count(OnWhite(color, 60), Rounding) > 100, $"{color.R}, {color.G}, {color.B} is no area."));

        // Marks of 6 pixels have some that nothing blends with.
        DebugColor[] marks = [view.VerticeColor, view.GridColor, view.ContactColor, view.SpringColor, view.JointColor, view.AxisColor];
        Assert.All(
            marks, color => Assert.True(picture.Count(OnWhite(color, 255), Rounding) > 3, $"{color.R}, {color.G}, {color.B} is no mark."));

        // Lines of a box lie between two pixels or on one: half of the colour at least.
        Assert.True(picture.Count(OnWhite(view.AABBColor, 255), 60) > 100, "There are no boxes.");

        // Two pixels a length. A point of the ball beside its radius and its axes, and one of the sensor.
        Assert.True(IsNear(picture, free.Position + new Vector2(-4f, -4f * (yUp ? -1f : 1f)), yUp, OnWhite(view.FreeColor, 60)));
        Assert.True(IsNear(picture, sensor.Position + new Vector2(-5f, 3f), yUp, OnWhite(view.SensorColor, 60)));
        Assert.Equal((255, 255, 255), picture.At(Side - 4, 4));
    }

    [BrowserTheory]
    [InlineData("ragdoll", 60)]
    [InlineData("breakable-wall", 40)]
    [InlineData("springs", 30)]
    [InlineData("water", 400)]
    [InlineData("pixels-and-metres", 100)]
    public void Picture_OfAScene_IsNotBlankAndFitsItsFrame(string name, int steps)
    {
        Scene scene = SceneLibrary.Find(name)!;
        PhysicsSimulator simulator = new();
        scene.Build(simulator);
        for (int step = 0; step < steps; step++)
        {
            scene.Step(simulator, step, scene.Dt);
        }

        SvgDebugDraw svg = new(scene.View.Min, scene.View.Max, 500, 300, simulator.Gravity.Y <= 0f);
        new PhysicsSimulatorView(simulator, svg).Draw();

        PngPicture picture = Rendered(svg, 500, 300);

        Assert.Equal((500, 300), (picture.Width, picture.Height));
        double share = 1.0 - (picture.Count((255, 255, 255), 0) / (500.0 * 300.0));
        Assert.InRange(share, 0.01, 0.9);
    }

    /// <summary>One of each: what moves, touches, stands, is driven, sleeps, senses, is wet, is held by a joint or a spring.</summary>
    private static PhysicsSimulator EveryKind(float down, out Geom free, out Geom sensor)
    {
        PhysicsSimulator simulator = new(new Vector2(0f, 100f * down));
        float ground = down > 0f ? 190f : 10f;
        Geom floor = Box(simulator, new Vector2(100f, ground), 180f, 20f);
        floor.Body.IsStatic = true;
        Box(simulator, new Vector2(40f, ground - (20f * down)), 20f, 20f);
        free = Ball(simulator, new Vector2(40f, 100f));
        Geom driven = Box(simulator, new Vector2(80f, 100f), 20f, 20f);
        driven.Body.IsKinematic = true;
        Geom asleep = Box(simulator, new Vector2(120f, 100f), 20f, 20f);
        sensor = Box(simulator, new Vector2(160f, 100f), 20f, 20f);
        sensor.IsSensor = true;
        sensor.Body.IsStatic = true;

        Geom hung = Ball(simulator, new Vector2(80f, 50f));
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, hung.Body, new Vector2(60f, 50f));
        Geom sprung = Ball(simulator, new Vector2(120f, 50f));
        SpringFactory.Instance.CreateFixedLinearSpring(simulator, sprung.Body, Vector2.Zero, new Vector2(150f, 50f), 10f, 1f);
        FluidDragController water = new();
        water.Initialize(
            new AABBFluidContainer(new AABB(new Vector2(150f, 130f), new Vector2(190f, 160f))), 0.001f, 1f, 1f, simulator.Gravity);
        simulator.Add(water);
        for (int step = 0; step < 6; step++)
        {
            simulator.Update(0.01f);
        }

        asleep.Body.Enabled = false;
        return simulator;
    }

    private static Geom Box(PhysicsSimulator simulator, Vector2 position, float width, float height)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, 1f);
        body.Position = position;
        return GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height);
    }

    private static Geom Ball(PhysicsSimulator simulator, Vector2 position)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, 10f, 1f);
        body.Position = position;
        return GeomFactory.Instance.CreateCircleGeom(simulator, body, 10f, 16);
    }

    private static (int Red, int Green, int Blue) OnWhite(DebugColor color, int alpha) =>
        (Blend(color.R, alpha), Blend(color.G, alpha), Blend(color.B, alpha));

    private static int Blend(int channel, int alpha) => ((channel * alpha) + (255 * (255 - alpha))) / 255;

    /// <summary>Grid points cover many pixels of a geom, so one within three pixels will do.</summary>
    private static bool IsNear(PngPicture picture, Vector2 place, bool yUp, (int Red, int Green, int Blue) color)
    {
        int x = (int)(2f * place.X);
        int y = (int)(yUp ? Side - (2f * place.Y) : 2f * place.Y);
        return Enumerable.Range(0, 49).Select(i => picture.At(x + (i % 7) - 3, y + (i / 7) - 3)).Any(found =>
            Math.Abs(found.Red - color.Red) <= Rounding
                && Math.Abs(found.Green - color.Green) <= Rounding
                && Math.Abs(found.Blue - color.Blue) <= Rounding);
    }

    private PngPicture Rendered(SvgDebugDraw svg, int width, int height)
    {
        string path = System.IO.Path.Combine(_folder, "picture.svg");
        svg.Save(path);
        return Browser.Render(path, width, height);
    }
}
