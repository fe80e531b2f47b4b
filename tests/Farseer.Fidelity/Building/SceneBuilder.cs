using System;
using System.Collections.Generic;
using System.Numerics;
using System.Reflection;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Building;

/// <summary>Builds a scene in the order the format prescribes: settings, bodies, paths, geoms, joints, springs, controllers.</summary>
public static class SceneBuilder
{
    private static readonly Dictionary<string, object> Nothing = [];

    /// <param name="file">The scene.</param>
    /// <param name="iterations">The simulator's <c>Iterations</c>.</param>
    /// <param name="quirks">The value of the simulator's quirk flags, or null to leave them off.</param>
    public static BuiltScene Build(SceneFile file, int iterations, object? quirks)
    {
        Vector2 gravity = new(file.Gravity[0].GetSingle(), file.Gravity[1].GetSingle());
        Type type = Facade.Type("PhysicsSimulator");
        ConstructorInfo constructor = type.GetConstructor([typeof(Vector2)]) ?? throw new MissingPartException("PhysicsSimulator(Vector2)");
        BuiltScene scene = new(file, Facade.Invoke(constructor, null, [gravity])!);
        if (quirks is not null)
        {
            Quirks.Set(scene.Simulator, quirks);
        }

        foreach (JsonProperty setting in Json.Members(file.Root, "settings"))
        {
            Apply(scene, setting.Name, setting.Value);
        }

        Facade.Set(scene.Simulator, "Iterations", iterations);
        foreach (MadeObject body in file.Bodies)
        {
            AddMade(scene, "BodyFactory", body, Nothing);
        }

        foreach (JsonElement path in Json.Items(file.Root, "paths"))
        {
            PathBuilder.Add(scene, path);
        }

        foreach (MadeObject geom in file.Geoms)
        {
            object body = scene[geom.Body ?? throw new BadSceneException($"geom '{geom.Id}' has no 'body'.")];
            AddMade(scene, "GeomFactory", geom, new Dictionary<string, object> { ["body"] = body });
        }

        foreach (MadeObject joint in file.Joints)
        {
            WatchBreak(scene, joint.Id, AddMade(scene, "JointFactory", joint, Nothing));
        }

        foreach (MadeObject spring in file.Springs)
        {
            WatchBreak(scene, spring.Id, AddMade(scene, "SpringFactory", spring, Nothing));
        }

        ControllerBuilder.AddAll(scene);
        return scene;
    }

    private static void Apply(BuiltScene scene, string name, JsonElement value)
    {
        switch (name)
        {
            case "broadPhaseCollider":
                Type collider = Facade.Type(value.GetString()!);
                ConstructorInfo? constructor = collider.GetConstructor([scene.Simulator.GetType()]);
                object made =
                    constructor is null ? Activator.CreateInstance(collider)! : Facade.Invoke(constructor, null, [scene.Simulator])!;
                Facade.Set(scene.Simulator, name, made);
                break;
            case "inactivityController":
                object controller = Facade.Get(scene.Simulator, "InactivityController")!;
                foreach (JsonProperty property in value.EnumerateObject())
                {
                    SetProperty(scene, controller, property.Name, property.Value);
                }

                break;
            default:
                SetProperty(scene, scene.Simulator, name, value);
                break;
        }
    }

    public static void SetProperty(BuiltScene scene, object target, string name, JsonElement value)
        => Facade.Set(target, name, scene.Values.Read(value, Facade.MemberType(target, name)));

    private static object AddMade(BuiltScene scene, string factoryName, MadeObject made, Dictionary<string, object> known)
    {
        object factory = Facade.Factory(factoryName);
        Dictionary<string, object> withSimulator = new(known) { ["physicsSimulator"] = scene.Simulator };
        object result = scene.Caller.Make(factory, made.Factory, made.Args, withSimulator);
        scene.Add(made.Id, result);
        foreach ((string name, JsonElement value) in made.Properties)
        {
            switch (name)
            {
                case "onCollision":
                    bool answer = value.GetBoolean();
                    Facade.Subscribe(result, name, args => Log(scene, "OnCollision", args, answer));
                    break;
                case "onSeparation":
                    Facade.Subscribe(result, name, args => Log(scene, "OnSeparation", args, null));
                    break;
                default:
                    SetProperty(scene, result, name, value);
                    break;
            }
        }

        return result;
    }

    private static object? Log(BuiltScene scene, string type, object?[] args, bool? answer)
    {
        scene.Events.Add(type, scene.IdOf(args[0]) ?? "?", scene.IdOf(args[1]) ?? "?");
        return answer;
    }

    private static void WatchBreak(BuiltScene scene, string id, object breakable)
    {
        if (Facade.HasMember(breakable, "Broke"))
        {
            Facade.Subscribe(breakable, "Broke", _ =>
            {
                scene.Events.Add("Broke", id, string.Empty);
                return null;
            });
        }
    }
}
