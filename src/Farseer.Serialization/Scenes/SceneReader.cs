using System;
using System.Collections.Generic;
using System.Linq;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Interfaces;
using FarseerGames.FarseerPhysics.Serialization.Documents;
using FarseerGames.FarseerPhysics.Serialization.Tables;

namespace FarseerGames.FarseerPhysics.Serialization.Scenes;

/// <summary>Makes a simulator and what belongs to it. What is refused has touched nothing but what was made here.</summary>
internal sealed class SceneReader
{
    private readonly SceneContents _contents;
    private readonly SceneFileOptions _options;
    private readonly SceneObject _root;
    private readonly List<(SceneNode Node, Action<SceneReader, SceneNode> Add)> _adding =
        new List<(SceneNode Node, Action<SceneReader, SceneNode> Add)>();

    public SceneReader(SceneObject root, SceneFileOptions options)
    {
        _root = root;
        _options = options;
        _contents = new SceneContents(new PhysicsSimulator());
    }

    public SceneContents Contents => _contents;

    private PhysicsSimulator Simulator => _contents.Simulator;

    /// <summary>Makes all objects; none is in the simulator yet.</summary>
    public void Read()
    {
        if (_root.TryTake("simulator", out SceneNode node))
        {
            ReadSimulator(new SceneObject(node));
        }

        ReadItems("bodies", _contents.BodyItems, ReadBody);
        ReadItems("geoms", _contents.GeomItems, new GeomReader(_contents, _options).Read);
        ReadItems("joints", _contents.JointItems, ReadJoint);
        ReadItems("springs", _contents.SpringItems, ReadSpring);
        ReadItems("controllers", _contents.ControllerItems, new ControllerReader(_contents, _options).Read);
        ReadItems("paths", _contents.PathItems, new PathReader(_contents).Read);
    }

    /// <summary>Puts into the simulator what was in it, in the order of its lists.</summary>
    public void AddAll()
    {
        foreach ((SceneNode node, Action<SceneReader, SceneNode> add) in _adding)
        {
            add(this, node);
        }
    }

    private void ReadItems<T>(string name, List<T> items, Func<SceneObject, T> read)
        where T : class
    {
        foreach (SceneNode node in _root.TakeItems(name))
        {
            var members = new SceneObject(node);
            _contents.Enter(items, read(members));
            members.Finish();
        }
    }

    private void ReadSimulator(SceneObject members)
    {
        SimulatorTables.Settings.Read(Simulator, members);
        if (members.TryTake("broadPhaseCollider", out SceneNode collider))
        {
            Simulator.BroadPhaseCollider = Collider(collider);
        }

        if (members.TryTake("errorBudget", out SceneNode budget))
        {
            ReadBudget(new SceneObject(budget));
        }

        if (members.TryTake("defaults", out SceneNode defaults))
        {
            var values = new SceneObject(defaults);
            SimulatorTables.Defaults.Read(Simulator.Defaults, values);
            values.Finish();
        }

        if (members.TryTake("scaling", out SceneNode scaling))
        {
            ReadScaling(new SceneObject(scaling));
        }

        Remember(members, "bodies", _contents.BodyItems, Simulator.Add);
        Remember(members, "geoms", _contents.GeomItems, Simulator.Add);
        Remember(members, "joints", _contents.JointItems, Simulator.Add);
        Remember(members, "springs", _contents.SpringItems, Simulator.Add);
        if (members.TryTake("controllers", out SceneNode controllers))
        {
            // The simulator's own is in it from the start, and may have stood elsewhere.
            _adding.Add((controllers, static (reader, _) => reader.Simulator.Remove(reader.Simulator.InactivityController)));
            _adding.Add((controllers, static (reader, node) => reader.Add(node, reader._contents.ControllerItems, reader.Simulator.Add)));
        }

        members.Finish();
    }

    private void Remember<T>(SceneObject members, string name, List<T> items, Action<T> add)
        where T : class
    {
        if (members.TryTake(name, out SceneNode node))
        {
            _adding.Add((node, (reader, places) => reader.Add(places, items, add)));
        }
    }

    private void Add<T>(SceneNode node, List<T> items, Action<T> add)
        where T : class
    {
        foreach (int place in node.Wholes())
        {
            T item = ItemAt(node, items, place);
            SceneObject.Try(node, add, item, static (act, value) => act(value));
        }
    }

    private IBroadPhaseCollider Collider(SceneNode node) => node.Text() switch
    {
        nameof(SelectiveSweepCollider) => new SelectiveSweepCollider(Simulator),
        nameof(SweepAndPruneCollider) => new SweepAndPruneCollider(Simulator),
        nameof(BruteForceCollider) => new BruteForceCollider(Simulator),
        nameof(GridCollider) => new GridCollider(Simulator),
        _ => throw node.Error("is no collider of the library"),
    };

    private void ReadBudget(SceneObject members)
    {
        float length = members.Take("length").Single();
        float share = members.Take("share").Single();
        int most = members.Take("mostIterations").Whole();
        long limit = members.Take("timeLimit").Long();
        members.Finish();
        SceneObject.Try(members.Node, Simulator, (length, share, most, limit), static (simulator, v) =>
        {
            ErrorBudget budget = v.length != 0 ? ErrorBudget.OfLength(v.length, v.most)
                : v.share != 0 ? ErrorBudget.OfShare(v.share, v.most) : ErrorBudget.None;
            simulator.ErrorBudget = v.limit != 0 ? budget.WithTimeLimit(new TimeSpan(v.limit)) : budget;
        });
    }

    private void ReadScaling(SceneObject members)
    {
        float preferred = members.Take("preferredUpdateInterval").Single();
        SceneObject.Try(
            members.Node,
            Simulator,
            preferred,
            static (simulator, v) => simulator.Scaling = new Scaling(v, simulator.Scaling.MaximumUpdateInterval));
        SimulatorTables.Scaling.Read(Simulator.Scaling, members);
        Simulator.Scaling.VisitHidden(new HiddenReader(members));
        members.Finish();
    }

    private Body ReadBody(SceneObject members)
    {
        var body = new Body();
        BodyTable.All.Read(body, members);
        body.VisitHidden(new HiddenReader(members));
        if (members.TryTake("tag", out SceneNode tag))
        {
            body.Tag = _options.Tag(tag.Text());
        }

        return body;
    }

    private Joint ReadJoint(SceneObject members)
    {
        SceneNode name = members.Take("kind");
        string text = name.Text();
        JointKindOfFile kind = JointTables.Kinds.FirstOrDefault(k => k.Name == text) ?? throw name.Error("is no kind of joint");
        Joint? joint = null;
        if (kind.OfPair is { } ofPair)
        {
            Body first = BodyOf(members, "body1")!;
            Body second = BodyOf(members, "body2")!;
            SceneObject.Try(members.Node, first, second, (a, b) => joint = ofPair(a, b));
        }
        else
        {
            joint = kind.OfOne!(BodyOf(members, "body")!);
        }

        kind.Table.Read(joint!, members);
        joint!.VisitHidden(new HiddenReader(members));
        if (members.TryTake("tag", out SceneNode tag))
        {
            joint.Tag = _options.Tag(tag.Text());
        }

        return joint;
    }

    private Spring ReadSpring(SceneObject members)
    {
        SceneNode name = members.Take("kind");
        string text = name.Text();
        SpringKindOfFile kind = SpringTables.Kinds.FirstOrDefault(k => k.Name == text) ?? throw name.Error("is no kind of spring");
        Spring spring = kind.Make();
        bool isPair = spring is AngleSpring or LinearSpring;
        Body? first = isPair ? BodyOf(members, "body1", isNeeded: false) : null;
        Body? second = BodyOf(members, isPair ? "body2" : "body", isNeeded: false);
        SceneObject.Try(members.Node, spring, kind, (s, k) => k.Tie(s, first, second));
        kind.Table.Read(spring, members);
        spring.VisitHidden(new HiddenReader(members));
        if (members.TryTake("tag", out SceneNode tag))
        {
            spring.Tag = _options.Tag(tag.Text());
        }

        return spring;
    }

    private Body? BodyOf(SceneObject members, string name, bool isNeeded = true)
    {
        if (!members.TryTake(name, out SceneNode node))
        {
            return isNeeded ? throw members.Node.Error("needs the member " + name) : null;
        }

        return ItemAt(node, _contents.BodyItems, node.Whole());
    }

    internal static T ItemAt<T>(SceneNode node, List<T> items, int place) =>
        place >= 0 && place < items.Count ? items[place] : throw node.Error(
            "must be the place of an item, from 0 to below " + items.Count.ToString(System.Globalization.CultureInfo.InvariantCulture));
}
