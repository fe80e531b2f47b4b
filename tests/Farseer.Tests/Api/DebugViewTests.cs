using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Xml.Linq;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Views;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Api;

/// <summary>The debug view and its picture.</summary>
public class DebugViewTests
{
    [Fact]
    public void Draw_ShowsGeomsInTheColoursOfTheirStates()
    {
        PhysicsSimulator simulator = Pile(out Geom resting, out Geom flying, out Geom sensor, out Geom sleeping);
        var recorder = new Recorder();
        var view = new PhysicsSimulatorView(simulator, recorder);
        view.Draw();
        Assert.Equal(2, recorder.Circles.Count(c => c.Color == view.FreeColor || c.Color == view.TouchingColor));
        Assert.Contains((flying.Body.Position, 5f, view.FreeColor), recorder.Circles);
        Assert.Contains(recorder.Circles, c => c.Color == view.TouchingColor && c.Center == resting.Body.Position);
        Assert.Contains(recorder.Circles, c => c.Color == view.SensorColor && c.Center == sensor.Body.Position);
        Assert.Contains(recorder.Circles, c => c.Color == view.SleepingColor && c.Center == sleeping.Body.Position);
        Assert.Contains(recorder.Polygons, p => p.Color == view.StaticColor && p.Count == 16);
        Assert.Contains(recorder.Points, p => p.Color == view.ContactColor);
    }

    [Fact]
    [ManualRow("F070")]
    public void Draw_ShowsWhatIsSwitchedOn()
    {
        PhysicsSimulator simulator = Pile(out Geom resting, out _, out _, out _);
        SpringFactory.Instance.CreateFixedLinearSpring(simulator, resting.Body, Vector2.Zero, new Vector2(50, -5), 1e-3f, 0);
        SpringFactory.Instance.CreateFixedAngleSpring(simulator, resting.Body, 1e-3f, 0);
        simulator.Update(0.01f);
        var recorder = new Recorder();
        var view = new PhysicsSimulatorView(simulator, recorder)
        {
            EnableEdgeView = false,
            EnableContactView = false,
            EnableSpringView = false,
        };
        view.Draw();
        Assert.Empty(recorder.All);
        view.EnableVerticeView = true;
        view.Draw();
        Assert.Equal(simulator.GeomList.Sum(g => g.WorldVertices.Count), recorder.Points.Count);
        recorder.Clear();
        view.EnableVerticeView = false;
        view.EnableAABBView = true;
        view.Draw();
        Assert.Equal(simulator.GeomList.Count, recorder.Polygons.Count);
        recorder.Clear();
        view.EnableAABBView = false;
        view.EnableGridView = true;
        view.Draw();
        Assert.True(recorder.Points.Count > 100);
        recorder.Clear();
        view.EnableGridView = false;
        view.EnableCoordinateAxisView = true;
        view.Draw();
        Assert.Equal(2 * simulator.BodyList.Count, recorder.Lines.Count);
        recorder.Clear();
        view.EnableCoordinateAxisView = false;
        view.EnableSpringView = true;
        view.Draw();
        Assert.Contains(recorder.Lines, l => l.End == new Vector2(50, -5));
        Assert.Single(recorder.Circles);
    }

    /// <summary>Lines have no inside, and an open chain no way back from its end to its start.</summary>
    [Theory]
    [InlineData(false, 2)]
    [InlineData(true, 3)]
    public void Draw_ShowsChainsAndSegmentsAsLines(bool isLoop, int lines)
    {
        var simulator = new PhysicsSimulator();
        Body ground = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        ground.IsStatic = true;
        ground.Position = new Vector2(10, 20);
        GeomFactory.Instance.CreateChainGeom(simulator, ground, Outline(0, 0, 5, 0, 5, 5), isLoop);
        GeomFactory.Instance.CreateSegmentGeom(simulator, ground, new Vector2(-5, 0), new Vector2(-5, 5));
        var recorder = new Recorder();
        var view = new PhysicsSimulatorView(simulator, recorder);
        view.Draw();

        Assert.Empty(recorder.Polygons);
        Assert.Equal(lines + 1, recorder.Lines.Count);
        Assert.Contains((new Vector2(10, 20), new Vector2(15, 20), view.StaticColor), recorder.Lines);
        Assert.Contains((new Vector2(15, 20), new Vector2(15, 25), view.StaticColor), recorder.Lines);
        Assert.Contains((new Vector2(5, 20), new Vector2(5, 25), view.StaticColor), recorder.Lines);
        Assert.Equal(isLoop, recorder.Lines.Contains((new Vector2(15, 25), new Vector2(10, 20), view.StaticColor)));
    }

    [Fact]
    [ManualRow("F070")]
    public void Draw_ShowsJointsOverTheirAnchors()
    {
        var simulator = new PhysicsSimulator();
        Body a = SpringTests.Free(simulator, 0, 0);
        Body b = SpringTests.Free(simulator, 20, 0);
        JointFactory.Instance.CreateRevoluteJoint(simulator, a, b, new Vector2(10, 3));
        JointFactory.Instance.CreatePinJoint(simulator, a, new Vector2(1, 0), b, new Vector2(-1, 0));
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, a, new Vector2(0, 9));
        JointFactory.Instance.CreateAngleJoint(simulator, a, b);
        JointFactory.Instance.CreateFixedAngleJoint(simulator, b);
        simulator.Update(0.01f);
        var recorder = new Recorder();
        var view = new PhysicsSimulatorView(simulator, recorder);
        view.Draw();
        Assert.Contains(recorder.Points, p => Vector2.Distance(p.Position, new Vector2(10, 3)) < 1e-3f);
        Assert.Contains(
            recorder.Lines,
            l => Vector2.Distance(l.Start, new Vector2(1, 0)) < 1e-3f && Vector2.Distance(l.End, new Vector2(19, 0)) < 1e-3f);
        Assert.Contains(recorder.Points, p => Vector2.Distance(p.Position, new Vector2(0, 9)) < 1e-3f);
        Assert.Single(recorder.Circles);
        recorder.Clear();
        view.EnableJointView = false;
        view.Draw();
        Assert.Empty(recorder.All);
    }

    [Fact]
    public void SvgDebugDraw_WritesADocument_WithEverythingInItsPlace()
    {
        PhysicsSimulator simulator = Pile(out _, out Geom flying, out _, out _);
        var picture = new SvgDebugDraw(new Vector2(-100, -100), new Vector2(100, 50), 400, 300);
        new PhysicsSimulatorView(simulator, picture).Draw();
        XElement root = XDocument.Parse(picture.ToString()).Root!;
        Assert.Equal("400", root.Attribute("width")!.Value);
        XName circle = XName.Get("circle", root.Name.NamespaceName);
        XElement found = root.Elements(circle).First(c => c.Attribute("r")!.Value == "10" && c.Attribute("fill")!.Value == "#2673bf");

        // Two pixels a length, (-100, -100) at the top left.
        float x = float.Parse(found.Attribute("cx")!.Value, System.Globalization.CultureInfo.InvariantCulture);
        float y = float.Parse(found.Attribute("cy")!.Value, System.Globalization.CultureInfo.InvariantCulture);
        Assert.Equal(2 * (flying.Body.Position.X + 100), x, 1);
        Assert.Equal(2 * (flying.Body.Position.Y + 100), y, 1);
        Assert.Contains(root.Elements(), e => e.Name.LocalName == "polygon");
        string path = System.IO.Path.GetTempFileName();
        picture.Save(path);
        Assert.Equal(picture.ToString(), File.ReadAllText(path));
        File.Delete(path);
        var paper = new SvgDebugDraw(Vector2.Zero, new Vector2(10, 10), 10, 10, yUp: true);
        paper.DrawPoint(new Vector2(2, 1), 2, new DebugColor(1, 2, 3));
        Assert.Contains("cx=\"2\" cy=\"9\" r=\"1\" fill=\"#010203\"", paper.ToString());
    }

    [Fact]
    public void BadInput_IsRefusedByName()
    {
        var simulator = new PhysicsSimulator();
        Assert.Throws<ArgumentNullException>("physicsSimulator", () => new PhysicsSimulatorView(null!, new Recorder()));
        Assert.Throws<ArgumentNullException>("debugDraw", () => new PhysicsSimulatorView(simulator, null!));
        Assert.Throws<ArgumentOutOfRangeException>("MarkLength", () => new PhysicsSimulatorView(simulator, new Recorder()).MarkLength = -1);
        Assert.Throws<ArgumentOutOfRangeException>(
            "PointSize", () => new PhysicsSimulatorView(simulator, new Recorder()).PointSize = float.NaN);
        Assert.Throws<ArgumentOutOfRangeException>("max", () => new SvgDebugDraw(Vector2.One, Vector2.One, 5, 5));
        Assert.Throws<ArgumentOutOfRangeException>("min", () => new SvgDebugDraw(new Vector2(float.NaN), Vector2.One, 5, 5));
        Assert.Throws<ArgumentOutOfRangeException>("width", () => new SvgDebugDraw(Vector2.Zero, Vector2.One, 0, 5));
        Assert.Throws<ArgumentNullException>("path", () => new SvgDebugDraw(Vector2.Zero, Vector2.One, 5, 5).Save(null!));
    }

    private static PhysicsSimulator Pile(out Geom resting, out Geom flying, out Geom sensor, out Geom sleeping)
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Sandbox.Floor(simulator);
        resting = Sandbox.Ball(simulator, new Vector2(0, -5));
        flying = Sandbox.Ball(simulator, new Vector2(0, -80));
        sensor = Sandbox.Ball(simulator, new Vector2(60, -40));
        sensor.IsSensor = true;
        sensor.Body.IgnoreGravity = true;
        sleeping = Sandbox.Ball(simulator, new Vector2(-60, -40));
        sleeping.Body.Enabled = false;
        Sandbox.Run(simulator, 5);
        return simulator;
    }

    private sealed class Recorder : IDebugDraw
    {
        public List<(Vector2 Start, Vector2 End, DebugColor Color)> Lines { get; } = [];

        public List<(int Count, DebugColor Color)> Polygons { get; } = [];

        public List<(Vector2 Center, float Radius, DebugColor Color)> Circles { get; } = [];

        public List<(Vector2 Position, DebugColor Color)> Points { get; } = [];

        public IEnumerable<object> All =>
            Lines.Cast<object>().Concat(Polygons.Cast<object>()).Concat(Circles.Cast<object>()).Concat(Points.Cast<object>());

        public void Clear()
        {
            Lines.Clear();
            Polygons.Clear();
            Circles.Clear();
            Points.Clear();
        }

        public void DrawLine(Vector2 start, Vector2 end, DebugColor color) => Lines.Add((start, end, color));

        public void DrawPolygon(Vertices vertices, DebugColor line, DebugColor fill) => Polygons.Add((vertices.Count, line));

        public void DrawCircle(Vector2 center, float radius, DebugColor line, DebugColor fill) => Circles.Add((center, radius, line));

        public void DrawPoint(Vector2 position, float size, DebugColor color) => Points.Add((position, color));
    }
}
