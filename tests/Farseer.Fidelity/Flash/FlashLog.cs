using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using System.Text.Json.Nodes;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>What listeners and filter heard, by step, in the notation of the scene files.</summary>
internal sealed class FlashLog
{
    private readonly FlashScene _scene;

    public FlashLog(FlashScene scene) => _scene = scene;

    /// <summary>The step under way, counted from 1; 0 while the scene is built.</summary>
    public int Step { get; set; }

    public PairEvents Contacts { get; } = new();

    public JsonArray Boundary { get; } = [];

    public JsonArray Destruction { get; } = [];

    public JsonArray Filter { get; } = [];

    public JsonArray Callbacks { get; } = [];

    /// <summary>Registers the listeners that the scene names, before anything is made.</summary>
    public void Register()
    {
        HashSet<string> names = [.. Json.Items(_scene.File.Root, "listeners").Select(e => e.GetString()!)];
        if (names.Contains("contact"))
        {
            _scene.World.SetContactListener(new ContactListener(this));
        }

        if (names.Contains("boundary"))
        {
            _scene.World.SetBoundaryListener(new BoundaryListener(this));
        }

        if (names.Contains("destruction"))
        {
            _scene.World.SetDestructionListener(new DestructionListener(this));
        }

        if (Json.Optional(_scene.File.Root, "contactFilter").ValueKind == JsonValueKind.Object)
        {
            _scene.World.SetContactFilter(new ContactFilter(this));
        }
    }

    private string Id(object value) => _scene.IdOf(value) ?? "?";

    private void Contact(string kind, b2Shape shape1, b2Shape shape2) => Contacts.Add(Step, kind, Id(shape1), Id(shape2));

    private sealed class ContactListener(FlashLog log) : b2ContactListener
    {
        private bool _called;

        public override void Add(b2ContactPoint point)
        {
            log.Contact("Add", point.shape1, point.shape2);
            if (!_called)
            {
                _called = true;
                CallBack();
            }
        }

        public override void Persist(b2ContactPoint point) => log.Contact("Persist", point.shape1, point.shape2);

        public override void Remove(b2ContactPoint point) => log.Contact("Remove", point.shape1, point.shape2);

        public override void Result(b2ContactResult point) => log.Contact("Result", point.shape1, point.shape2);

        private void CallBack()
        {
            foreach (JsonElement action in Json.Items(log._scene.File.Root, "inAddCallback"))
            {
                string? target = Json.OptionalText(action, "target");
                if (Json.OptionalText(action, "create") is { } kind)
                {
                    log.Callbacks.Add(new JsonArray(target, kind, log._scene.Create(kind, target, action.GetProperty("value"))));
                }
                else
                {
                    string call = Json.Text(action, "call");
                    object? result = FlashValues.Call(log._scene, log._scene[target!], call, Json.Items(action, "args").ToList());
                    log.Callbacks.Add(new JsonArray(target, call, FlashValues.Write(log._scene, result)));
                }
            }
        }
    }

    private sealed class BoundaryListener(FlashLog log) : b2BoundaryListener
    {
        public override void Violation(b2Body body) => log.Boundary.Add(new JsonArray(log.Step, log.Id(body)));
    }

    private sealed class DestructionListener(FlashLog log) : b2DestructionListener
    {
        public override void SayGoodbyeJoint(b2Joint joint) =>
            log.Destruction.Add(new JsonArray(log.Step, nameof(SayGoodbyeJoint), log.Id(joint)));

        public override void SayGoodbyeShape(b2Shape shape) =>
            log.Destruction.Add(new JsonArray(log.Step, nameof(SayGoodbyeShape), log.Id(shape)));
    }

    private sealed class ContactFilter(FlashLog log) : b2ContactFilter
    {
        public override bool ShouldCollide(b2Shape shape1, b2Shape shape2)
        {
            string first = log.Id(shape1);
            string second = log.Id(shape2);
            bool rejected = Json.Items(log._scene.File.Root.GetProperty("contactFilter"), "reject")
                .Any(p =>
                    (p[0].GetString() == first && p[1].GetString() == second) || (p[0].GetString() == second && p[1].GetString() == first));
            bool answer = !rejected && base.ShouldCollide(shape1, shape2);
            log.Filter.Add(new JsonArray(log.Step, first, second, answer));
            return answer;
        }
    }
}
