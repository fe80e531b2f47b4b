using System.Collections.Generic;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes;

/// <summary>The things that a scene file does while it runs: forces, changed properties, removals.</summary>
internal sealed class SceneActions
{
    private readonly Dictionary<string, Body> _bodies;
    private readonly Dictionary<string, Geom> _geoms;
    private readonly List<(int First, int Last, SceneNode Node)> _actions = [];

    public SceneActions(SceneNode? list, Dictionary<string, Body> bodies, Dictionary<string, Geom> geoms)
    {
        _bodies = bodies;
        _geoms = geoms;
        if (list is null)
        {
            return;
        }

        foreach (SceneNode action in list.Value.Items())
        {
            int first = action["step"].Whole();
            int last = action.Find("until")?.Whole() ?? first;
            if (first < 0)
            {
                throw action["step"].Fault("must be 0 or more");
            }

            if (last < first)
            {
                throw action["until"].Fault("must not be before step");
            }

            _actions.Add((first, last, action));
        }
    }

    public void Run(PhysicsSimulator simulator, int step)
    {
        foreach ((int first, int last, SceneNode action) in _actions)
        {
            if (step >= first && step <= last)
            {
                Run(simulator, action);
            }
        }
    }

    private void Run(PhysicsSimulator simulator, SceneNode action)
    {
        if (action.Find("remove") is SceneNode removed)
        {
            Take(removed, simulator.Remove, simulator.Remove);
        }
        else if (action.Find("dispose") is SceneNode disposed)
        {
            Take(disposed, body => body.Dispose(), geom => geom.Dispose());
        }
        else if (action.Find("set") is SceneNode set)
        {
            SetAll(simulator, action["target"], set);
        }
        else
        {
            Call(action);
        }
    }

    private void Take(SceneNode id, System.Action<Body> body, System.Action<Geom> geom)
    {
        if (_bodies.TryGetValue(id.Text(), out Body? b))
        {
            body(b);
        }
        else if (_geoms.TryGetValue(id.Text(), out Geom? g))
        {
            geom(g);
        }
        else
        {
            throw id.Fault($"names nothing: '{id.Text()}'");
        }
    }

    private void SetAll(PhysicsSimulator simulator, SceneNode target, SceneNode values)
    {
        string id = target.Text();
        foreach ((string name, SceneNode value) in values.Members())
        {
            bool known = id == "simulator" ? SceneProperties.Set(simulator, name, value)
                : _bodies.TryGetValue(id, out Body? body) ? SceneProperties.Set(body, name, value)
                : _geoms.TryGetValue(id, out Geom? geom) ? SceneProperties.Set(geom, name, value)
                : throw target.Fault($"names nothing: '{id}'");
            if (!known)
            {
                throw value.Fault("is no property that a scene file can set");
            }
        }
    }

    private void Call(SceneNode action)
    {
        SceneNode target = action["target"];
        if (!_bodies.TryGetValue(target.Text(), out Body? body))
        {
            throw target.Fault($"is no body: '{target.Text()}'");
        }

        SceneNode call = action["call"];
        List<SceneNode> args = action.Find("args")?.Items() ?? [];
        switch (call.Text(), args.Count)
        {
            case ("ApplyForce", 1): body.ApplyForce(args[0].Vector()); break;
            case ("ApplyForceAtLocalPoint", 2): body.ApplyForceAtLocalPoint(args[0].Vector(), args[1].Vector()); break;
            case ("ApplyForceAtWorldPoint", 2): body.ApplyForceAtWorldPoint(args[0].Vector(), args[1].Vector()); break;
            case ("ApplyTorque", 1): body.ApplyTorque(args[0].Number()); break;
            case ("ApplyImpulse", 1): body.ApplyImpulse(args[0].Vector()); break;
            case ("ApplyAngularImpulse", 1): body.ApplyAngularImpulse(args[0].Number()); break;
            case ("ClearForce", 0): body.ClearForce(); break;
            case ("ClearImpulse", 0): body.ClearImpulse(); break;
            case ("ClearTorque", 0): body.ClearTorque(); break;
            case ("ResetDynamics", 0): body.ResetDynamics(); break;
            default: throw call.Fault($"'{call.Text()}' with {args.Count} arguments is no call that a scene file can make");
        }
    }
}
