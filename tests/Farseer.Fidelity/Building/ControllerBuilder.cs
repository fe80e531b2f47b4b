using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Building;

/// <summary>Builds the controllers of a scene.</summary>
internal static class ControllerBuilder
{
    private static readonly string[] NotProperties = ["id", "type", "initialize", "geoms"];

    public static void AddAll(BuiltScene scene)
    {
        foreach (JsonElement element in Json.Items(scene.File.Root, "controllers"))
        {
            Add(scene, element);
        }
    }

    private static void Add(BuiltScene scene, JsonElement element)
    {
        Type type = Facade.Type(Json.Text(element, "type"));
        object controller = Activator.CreateInstance(type)!;
        string id = Json.Text(element, "id");
        scene.Add(id, controller);
        foreach (JsonProperty property in element.EnumerateObject().Where(p => !NotProperties.Contains(p.Name)))
        {
            SceneBuilder.SetProperty(scene, controller, property.Name, property.Value);
        }

        JsonElement arguments = Json.Optional(element, "initialize");
        if (arguments.ValueKind == JsonValueKind.Undefined)
        {
            scene.Caller.Call(type, controller, "Initialize", []);
        }
        else
        {
            Initialize(scene, controller, arguments);
        }

        foreach (JsonElement geom in Json.Items(element, "geoms"))
        {
            scene.Caller.Call(type, controller, "AddGeom", [geom]);
        }

        if (Facade.HasMember(controller, "Entry"))
        {
            Facade.Subscribe(controller, "Entry", args =>
            {
                scene.Events.Add(
                    "Entry", args.Select(scene.IdOf).FirstOrDefault(name => name is not null && name != id) ?? "?", string.Empty);
                return null;
            });
        }

        MethodInfo add = Facade.Methods(scene.Simulator.GetType(), "Add", isStatic: false)
            .First(m => m.GetParameters() is [{ } only] && only.ParameterType.IsAssignableFrom(type));
        Facade.Invoke(add, scene.Simulator, [controller]);
    }

    private static void Initialize(BuiltScene scene, object controller, JsonElement arguments)
    {
        MethodInfo initialize = Facade.Methods(controller.GetType(), "Initialize", isStatic: false)
            .FirstOrDefault(m => m.GetParameters().All(p => Json.Optional(arguments, p.Name!).ValueKind != JsonValueKind.Undefined))
            ?? throw new MissingPartException(controller.GetType().Name + ".Initialize");
        List<object?> values = [];
        foreach (ParameterInfo parameter in initialize.GetParameters())
        {
            JsonElement value = Json.Required(arguments, parameter.Name!);
            values.Add(parameter.Name == "fluidContainer" ? Container(scene, value) : scene.Values.Read(value, parameter.ParameterType));
        }

        Facade.Invoke(initialize, controller, values.ToArray());
    }

    private static object Container(BuiltScene scene, JsonElement value)
    {
        string? controller = Json.OptionalText(value, "controller");
        if (controller is not null)
        {
            return scene[controller];
        }

        object aabb = scene.Values.Read(Json.Required(value, "aabb"), Facade.Type("AABB"))!;
        return Activator.CreateInstance(Facade.Type("AABBFluidContainer"), aabb)!;
    }
}
