using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>A scene read from a JSON file; docs/SceneFormat.md describes it.</summary>
public sealed class SceneFile : Scene
{
    private static readonly string[] _notBuilt = ["paths", "joints", "springs", "controllers"];
    private readonly SceneNode _root;
    private readonly Dictionary<string, Body> _bodies = [];
    private readonly Dictionary<string, Geom> _geoms = [];
    private SceneActions? _actions;

    private SceneFile(SceneNode root)
    {
        _root = root;
        Name = root.Find("name")?.Text() ?? "scene";
        Title = Name;
        Description = root.Find("description")?.Text() ?? string.Empty;
        Steps = root["steps"].Whole();
        Dt = root["dt"].Number();
        if (Steps < 0)
        {
            throw root["steps"].Fault("must be 0 or more");
        }

        if (!(Dt > 0f))
        {
            throw root["dt"].Fault("must be above 0");
        }
    }

    public override string Name { get; }

    public override string Title { get; }

    public override string Description { get; }

    public override int Steps { get; }

    public override float Dt { get; }

    public override SceneView View
    {
        get
        {
            Vector2 min = new(float.PositiveInfinity);
            Vector2 max = new(float.NegativeInfinity);
            foreach (Geom geom in _geoms.Values)
            {
                min = Vector2.Min(min, geom.AABB.Min);
                max = Vector2.Max(max, geom.AABB.Max);
            }

            foreach (Body body in _bodies.Values)
            {
                min = Vector2.Min(min, body.Position);
                max = Vector2.Max(max, body.Position);
            }

            return min.X <= max.X ? new SceneView(min, max) : new SceneView(-Vector2.One, Vector2.One);
        }
    }

    /// <summary>Reads a file and checks all of it by building it once.</summary>
    /// <exception cref="SceneFileException">The file is missing, broken, or asks for something that is not there.</exception>
    public static SceneFile Load(string path)
    {
        SceneFile scene = new(new SceneSource(path).Root());
        scene.Build(new PhysicsSimulator());
        return scene;
    }

    public override void Build(PhysicsSimulator simulator)
    {
        foreach (string part in _notBuilt)
        {
            if (_root.Find(part) is SceneNode node && node.Items().Count > 0)
            {
                throw node.Fault("are not supported in scene files yet");
            }
        }

        _bodies.Clear();
        _geoms.Clear();
        simulator.Gravity = _root.Find("gravity")?.Vector() ?? Vector2.Zero;
        foreach ((string name, SceneNode value) in Members(_root.Find("settings")))
        {
            Guard(value, () => Known(SceneProperties.Set(simulator, name, value), value));
        }

        foreach (SceneNode node in List("bodies"))
        {
            AddBody(simulator, node);
        }

        foreach (SceneNode node in List("geoms"))
        {
            AddGeom(simulator, node);
        }

        _actions = new SceneActions(_root.Find("actions"), _bodies, _geoms);
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt) => _actions!.Run(simulator, step);

    /// <summary>A file says what to build, not what must come out.</summary>
    public override IReadOnlyList<SceneOutcome> Check() => [];

    private static IEnumerable<(string Name, SceneNode Value)> Members(SceneNode? node) => node is null ? [] : node.Value.Members();

    private static void Known(bool known, SceneNode value)
    {
        if (!known)
        {
            throw value.Fault("is no property that a scene file can set");
        }
    }

    /// <summary>What the library itself refuses is the file's fault as well.</summary>
    private static void Guard(SceneNode node, Action action)
    {
        try
        {
            action();
        }
        catch (ArgumentException e)
        {
            throw node.Fault("is refused: " + e.Message.ReplaceLineEndings(" "));
        }
    }

    private List<SceneNode> List(string name) => _root.Find(name)?.Items() ?? [];

    private void AddBody(PhysicsSimulator simulator, SceneNode node)
    {
        Body? body = null;
        Guard(node, () => body = CreateBody(simulator, node["factory"], node["args"]));
        Keep(_bodies, node["id"], node["id"].Text(), body!);
        foreach ((string name, SceneNode value) in node.Members())
        {
            if (name is not ("id" or "factory" or "args"))
            {
                Guard(value, () => Known(SceneProperties.Set(body!, name, value), value));
            }
        }
    }

    private Body CreateBody(PhysicsSimulator simulator, SceneNode factory, SceneNode args)
    {
        BodyFactory make = BodyFactory.Instance;
        switch (factory.Text())
        {
            case "CreateRectangleBody": return make.CreateRectangleBody(
                simulator, args["width"].Number(), args["height"].Number(), args["mass"].Number());
            case "CreateCircleBody": return make.CreateCircleBody(simulator, args["radius"].Number(), args["mass"].Number());
            case "CreateEllipseBody": return make.CreateEllipseBody(
                simulator, args["xRadius"].Number(), args["yRadius"].Number(), args["mass"].Number());
            case "CreatePolygonBody": return make.CreatePolygonBody(simulator, Outline(args["vertices"]), args["mass"].Number());
            case "CreateBody" when args.Find("body") is SceneNode copied: return make.CreateBody(simulator, BodyOf(copied));
            case "CreateBody": return make.CreateBody(simulator, args["mass"].Number(), args["momentOfInertia"].Number());
            default: throw factory.Fault($"is no body factory: '{factory.Text()}'");
        }
    }

    private void AddGeom(PhysicsSimulator simulator, SceneNode node)
    {
        Geom? geom = null;
        Guard(node, () => geom = CreateGeom(simulator, node["factory"], node["args"], BodyOf(node["body"])));
        Keep(_geoms, node, node.Find("id")?.Text() ?? "g" + node["body"].Text(), geom!);
        foreach ((string name, SceneNode value) in node.Members())
        {
            if (name is not ("id" or "body" or "factory" or "args"))
            {
                Guard(value, () => Known(SceneProperties.Set(geom!, name, value), value));
            }
        }
    }

    private Geom CreateGeom(PhysicsSimulator simulator, SceneNode factory, SceneNode args, Body body)
    {
        GeomFactory make = GeomFactory.Instance;
        Vector2 offset = args.Find("offset")?.Vector() ?? Vector2.Zero;
        float turn = args.Find("rotationOffset")?.Number() ?? 0f;
        float cell = args.Find("collisionGridCellSize")?.Number() ?? 0f;
        int edges = args.Find("numberOfEdges")?.Whole() ?? 0;
        switch (factory.Text())
        {
            case "CreateRectangleGeom": return make.CreateRectangleGeom(
                simulator, body, args["width"].Number(), args["height"].Number(), offset, turn, cell);
            case "CreateCircleGeom": return make.CreateCircleGeom(simulator, body, args["radius"].Number(), edges, offset, turn, cell);
            case "CreateEllipseGeom": return make.CreateEllipseGeom(
                simulator, body, args["xRadius"].Number(), args["yRadius"].Number(), edges, offset, turn, cell);
            case "CreatePolygonGeom": return make.CreatePolygonGeom(simulator, body, Outline(args["vertices"]), offset, turn, cell);
            case "CreateGeom": return make.CreateGeom(simulator, body, GeomOf(args["geometry"]), offset, turn);
            default: throw factory.Fault($"is no geom factory: '{factory.Text()}'");
        }
    }

    private static void Keep<T>(Dictionary<string, T> table, SceneNode node, string id, T item)
    {
        if (!table.TryAdd(id, item))
        {
            throw node.Fault($"uses the id '{id}' a second time");
        }
    }

    /// <summary>A name out of "vertices", or a list of points. Always new: a factory moves the points it is given.</summary>
    private Vertices Outline(SceneNode node)
    {
        SceneNode list = node;
        if (node.IsText)
        {
            list = _root.Find("vertices")?.Find(node.Text()) ?? throw node.Fault($"names no vertices: '{node.Text()}'");
        }

        Vertices vertices = new();
        foreach (SceneNode point in list.Items())
        {
            vertices.Add(point.Vector());
        }

        return vertices;
    }

    private Body BodyOf(SceneNode id) =>
        _bodies.TryGetValue(id.Text(), out Body? body) ? body : throw id.Fault($"is no body: '{id.Text()}'");

    private Geom GeomOf(SceneNode id) =>
        _geoms.TryGetValue(id.Text(), out Geom? geom) ? geom : throw id.Fault($"is no geom: '{id.Text()}'");
}
