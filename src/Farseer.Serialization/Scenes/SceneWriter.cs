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
        _sink.Member("simulator", WriteSimulator);
        _sink.Items("bodies", _contents.BodyItems, WriteBody);
        _sink.Items("geoms", _contents.GeomItems, WriteGeom);
        _sink.Items("joints", _contents.JointItems, WriteJoint);
        _sink.Items("springs", _contents.SpringItems, WriteSpring);
        _sink.Items("controllers", _contents.ControllerItems, WriteController);
        _sink.Items("paths", _contents.PathItems, WritePath);
    }

    private void WriteSimulator()
    {
        PhysicsSimulator simulator = _contents.Simulator;
        SimulatorTables.Settings.Write(simulator, _sink);
        _sink.Text("broadPhaseCollider", KindOf(simulator.BroadPhaseCollider));
        _sink.Member("errorBudget", () => WriteBudget(simulator.ErrorBudget));
        _sink.Member("defaults", () => SimulatorTables.Defaults.Write(simulator.Defaults, _sink));
        _sink.Member("scaling", () =>
        {
            _sink.Number("preferredUpdateInterval", simulator.Scaling.PreferredUpdateInterval);
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
        _sink.Number("length", budget.Length);
        _sink.Number("share", budget.Share);
        _sink.Whole("mostIterations", budget.MostIterations);
        _sink.Whole("timeLimit", budget.TimeLimit.Ticks);
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
        WriteShape(geom.Form!);
        if (geom.Offset != Vector2.Zero || geom.RotationOffset != 0)
        {
            _sink.Vector("offset", geom.Offset);
            _sink.Number("rotationOffset", geom.RotationOffset);
        }

        _sink.Number("collisionGridCellSize", geom.CollisionGridCellSize);
        GeomTable.All.Write(geom, _sink);
        if (geom.HasSegments)
        {
            WriteSegments(geom);
        }

        Tag(geom.Tag);
    }

    private void WriteShape(GeomForm form)
    {
        _sink.Text("shape", form.Kind.ToString());
        switch (form.Kind)
        {
            case FormKind.Box:
                _sink.Vector("size", form.Size);
                return;
            case FormKind.Circle:
                _sink.Number("radius", form.Radius);
                _sink.Whole("numberOfEdges", form.Edges);
                return;
            case FormKind.Rounded:
                // The corner at the upper right is half the size.
                _sink.Vector("size", 2 * form.Points[2]);
                _sink.Number("radius", form.Radius);
                return;
            case FormKind.Capsule:
                _sink.Number("radius", form.Radius);
                break;
            case FormKind.Chain:
                _sink.Flag("isLoop", form.IsLoop);
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
            _sink.Number("friction", material.Friction);
            _sink.Number("restitution", material.Restitution);
            _sink.Number("speed", material.Speed);
            _sink.Number("rollingResistance", material.RollingResistance);
            _sink.EndObject();
        }

        _sink.EndArray();
    }

    private void WriteJoint(Joint joint)
    {
        JointKindOfFile kind = JointTables.Kinds.FirstOrDefault(k => k.Type == joint.GetType()) ?? throw Unknown(joint);
        _sink.Text("kind", kind.Name);
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
        _sink.Text("kind", kind.Name);
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
        _sink.Text("kind", kind.Name);
        kind.Table.Write(controller, _sink);
        controller.VisitHidden(new HiddenWriter(_sink));
        switch (controller)
        {
            case InactivityController when ReferenceEquals(controller, _contents.Simulator.InactivityController):
                _sink.Flag("isOfSimulator", true);
                break;
            case WindController { Area: { } area }:
                _sink.Vector("areaMin", area.Min);
                _sink.Vector("areaMax", area.Max);
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
                    _sink.Vector("containerMin", box.Min);
                    _sink.Vector("containerMax", box.Max);
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
        _sink.Number("width", path.Width);
        _sink.Number("height", path.Height);
        _sink.Number("mass", path.Mass);
        _sink.Flag("isEndless", path.IsEndless);
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
            _sink.Whole(name, _contents.PlaceOf(item));
        }
    }

    private void Tag(object? tag)
    {
        if (_options.Text(tag) is { } text)
        {
            _sink.Text("tag", text);
        }
    }

    private static NotSupportedException Unknown(object item) =>
        new NotSupportedException(
            item.GetType().FullName + " is not of the library, and no file holds it: take it out before saving, and add it after loading.");
}
