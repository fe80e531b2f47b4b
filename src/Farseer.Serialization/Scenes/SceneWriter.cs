using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Interfaces;
using FarseerGames.FarseerPhysics.Serialization.Documents;
using FarseerGames.FarseerPhysics.Serialization.Tables;

namespace FarseerGames.FarseerPhysics.Serialization.Scenes;

/// <summary>Writes a simulator and what belongs to it.</summary>
internal sealed class SceneWriter
{
    private readonly SceneContents _contents;
    private readonly SceneFileOptions _options;
    private readonly SceneSink _sink;

    public SceneWriter(SceneContents contents, SceneFileOptions options, SceneSink sink)
    {
        _contents = contents;
        _options = options;
        _sink = sink;
    }

    /// <summary>The members of the root, but for what tells which file it is and for the state.</summary>
    public void Write()
    {
        Member("simulator", WriteSimulator);
        WriteItems("bodies", _contents.BodyItems, WriteBody);
        WriteItems("geoms", _contents.GeomItems, WriteGeom);
        WriteItems("joints", _contents.JointItems, WriteJoint);
        WriteItems("springs", _contents.SpringItems, WriteSpring);
        WriteItems("controllers", _contents.ControllerItems, WriteController);
        WriteItems("paths", _contents.PathItems, WritePath);
    }

    private void Member(string name, Action write)
    {
        _sink.Name(name);
        _sink.BeginObject();
        write();
        _sink.EndObject();
    }

    private void WriteItems<T>(string name, List<T> items, Action<T> write)
    {
        _sink.Name(name);
        _sink.BeginArray();
        foreach (T item in items)
        {
            _sink.BeginObject();
            write(item);
            _sink.EndObject();
        }

        _sink.EndArray();
    }

    private void WriteSimulator()
    {
        PhysicsSimulator simulator = _contents.Simulator;
        SimulatorTables.Settings.Write(simulator, _sink);
        Text("broadPhaseCollider", KindOf(simulator.BroadPhaseCollider));
        Member("errorBudget", () => WriteBudget(simulator.ErrorBudget));
        Member("scaling", () =>
        {
            Number("preferredUpdateInterval", simulator.Scaling.PreferredUpdateInterval);
            SimulatorTables.Scaling.Write(simulator.Scaling, _sink);
            simulator.Scaling.VisitHidden(new HiddenWriter(_sink));
        });
        SceneMembers members = SceneMembers.Of(simulator);
        Places("bodies", members.Bodies);
        Places("geoms", members.Geoms);
        Places("joints", members.Joints);
        Places("springs", members.Springs);
        Places("controllers", members.Controllers);
    }

    private static string KindOf(IBroadPhaseCollider collider) => collider switch
    {
        SelectiveSweepCollider => nameof(SelectiveSweepCollider),
        SweepAndPruneCollider => nameof(SweepAndPruneCollider),
        BruteForceCollider => nameof(BruteForceCollider),
        GridCollider => nameof(GridCollider),
        _ => throw Unknown(collider),
    };

    private void WriteBudget(ErrorBudget budget)
    {
        Number("length", budget.Length);
        Number("share", budget.Share);
        _sink.Name("mostIterations");
        _sink.Whole(budget.MostIterations);
        _sink.Name("timeLimit");
        _sink.Whole(budget.TimeLimit.Ticks);
    }

    private void WriteBody(Body body)
    {
        BodyTable.All.Write(body, _sink);
        body.VisitHidden(new HiddenWriter(_sink));
        Tag(body.Tag);
    }

    private void WriteGeom(Geom geom)
    {
        Place("body", geom.Body);
        WriteShape(geom.Form!, geom.LocalVertices);
        if (geom.Offset != Vector2.Zero || geom.RotationOffset != 0)
        {
            _sink.Name("offset");
            _sink.Vector(geom.Offset);
            Number("rotationOffset", geom.RotationOffset);
        }

        Number("collisionGridCellSize", geom.CollisionGridCellSize);
        GeomTable.All.Write(geom, _sink);
        if (geom.HasSegments)
        {
            WriteSegments(geom);
        }

        Tag(geom.Tag);
    }

    private void WriteShape(GeomForm form, Vertices outline)
    {
        Text("shape", form.Kind.ToString());
        switch (form.Kind)
        {
            case FormKind.Box:
                Vector("size", form.Size);
                return;
            case FormKind.Circle:
                Number("radius", form.Radius);
                _sink.Name("numberOfEdges");
                _sink.Whole(outline.Count);
                return;
            case FormKind.Rounded:
                // The corner at the upper right is half the size.
                Vector("size", 2 * form.Points[2]);
                Number("radius", form.Radius);
                return;
            case FormKind.Capsule:
                Number("radius", form.Radius);
                break;
            case FormKind.Chain:
                _sink.Name("isLoop");
                _sink.Flag(form.IsLoop);
                break;
        }

        _sink.Name("points");
        _sink.Vectors(form.Points);
    }

    private void WriteSegments(Geom geom)
    {
        _sink.Name("segmentMaterials");
        _sink.BeginArray();
        for (int i = 0; i < geom.SegmentCount; i++)
        {
            if (geom.OwnMaterial(i) is not { } material)
            {
                _sink.Null();
                continue;
            }

            _sink.BeginObject();
            Number("friction", material.Friction);
            Number("restitution", material.Restitution);
            Number("speed", material.Speed);
            Number("rollingResistance", material.RollingResistance);
            _sink.EndObject();
        }

        _sink.EndArray();
    }

    private void WriteJoint(Joint joint)
    {
        JointKindOfFile kind = JointTables.Kinds.FirstOrDefault(k => k.Type == joint.GetType()) ?? throw Unknown(joint);
        Text("kind", kind.Name);
        if (kind.OfPair is not null)
        {
            Place("body1", joint.FirstBody);
            Place("body2", joint.SecondBody);
        }
        else
        {
            Place("body", joint.SecondBody);
        }

        kind.Table.Write(joint, _sink);
        joint.VisitHidden(new HiddenWriter(_sink));
        Tag(joint.Tag);
    }

    private void WriteSpring(Spring spring)
    {
        SpringKindOfFile kind = SpringTables.Kinds.FirstOrDefault(k => k.Type == spring.GetType()) ?? throw Unknown(spring);
        Text("kind", kind.Name);
        bool isPair = spring is AngleSpring or LinearSpring;
        if (isPair)
        {
            Place("body1", spring.FirstBody);
        }

        Place(isPair ? "body2" : "body", spring.SecondBody);
        kind.Table.Write(spring, _sink);
        spring.VisitHidden(new HiddenWriter(_sink));
        Tag(spring.Tag);
    }

    private void WriteController(Controller controller)
    {
        ControllerKindOfFile kind = ControllerTables.Kinds.FirstOrDefault(k => k.Type == controller.GetType()) ?? throw Unknown(controller);
        Text("kind", kind.Name);
        kind.Table.Write(controller, _sink);
        controller.VisitHidden(new HiddenWriter(_sink));
        switch (controller)
        {
            case InactivityController when ReferenceEquals(controller, _contents.Simulator.InactivityController):
                _sink.Name("isOfSimulator");
                _sink.Flag(true);
                break;
            case WindController { Area: { } area }:
                Vector("areaMin", area.Min);
                Vector("areaMax", area.Max);
                break;
            case FluidDragController fluid:
                WriteFluid(fluid);
                break;
        }

        Tag(controller.Tag);
    }

    private void WriteFluid(FluidDragController fluid)
    {
        switch (fluid.Container)
        {
            case null:
                break;
            case WaveController wave:
                Place("wave", wave);
                break;
            case AABBFluidContainer container when container.GetType() == typeof(AABBFluidContainer):
                if (container.AABB is { } box)
                {
                    Vector("containerMin", box.Min);
                    Vector("containerMax", box.Max);
                }

                break;
            case { } other:
                throw Unknown(other);
        }

        List<int> geoms = Enumerable.Range(0, fluid.Geoms.Count).Where(i => _contents.PlaceOf(fluid.Geoms[i]) >= 0).ToList();
        _sink.Name("geoms");
        _sink.Wholes(geoms.ConvertAll(i => _contents.PlaceOf(fluid.Geoms[i])).ToArray());
        _sink.Name("entered");
        _sink.Wholes(geoms.ConvertAll(i => fluid.Entered[i] ? 1 : 0).ToArray());
    }

    private void WritePath(Path path)
    {
        Number("width", path.Width);
        Number("height", path.Height);
        Number("mass", path.Mass);
        _sink.Name("isEndless");
        _sink.Flag(path.IsEndless);
        _sink.Name("controlPoints");
        _sink.Vectors(path.ControlPoints.ToArray());
        _sink.Name("placed");
        _sink.Vectors(path.Placed.ToArray());
        Places("bodies", path.Bodies);
        Places("geoms", path.Geoms);
        Places("joints", path.Joints);
        Places("springs", path.Springs);
        Places("madeBodies", path.Made.OfType<Body>());
        Places("madeGeoms", path.Made.OfType<Geom>());
        Places("madeJoints", path.Made.OfType<Joint>());
        Places("madeSprings", path.Made.OfType<Spring>());
    }

    private void Places(string name, IEnumerable<object> items)
    {
        _sink.Name(name);
        _sink.Wholes(items.Select(_contents.PlaceOf).Where(static place => place >= 0).ToArray());
    }

    private void Place(string name, object? item)
    {
        if (item is not null)
        {
            _sink.Name(name);
            _sink.Whole(_contents.PlaceOf(item));
        }
    }

    private void Tag(object? tag)
    {
        if (_options.Text(tag) is { } text)
        {
            Text("tag", text);
        }
    }

    private void Text(string name, string value)
    {
        _sink.Name(name);
        _sink.Text(value);
    }

    private void Number(string name, float value)
    {
        _sink.Name(name);
        _sink.Number(value);
    }

    private void Vector(string name, Vector2 value)
    {
        _sink.Name(name);
        _sink.Vector(value);
    }

    private static NotSupportedException Unknown(object item) =>
        new NotSupportedException(item.GetType().FullName + " is not of the library, and no file holds it: take it out before saving, and add it after loading.");
}
