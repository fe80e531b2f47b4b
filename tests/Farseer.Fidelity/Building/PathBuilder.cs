using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using System.Text.Json.Nodes;
using Farseer.Fidelity.Running;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Building;

/// <summary>Builds the paths (chains, ropes, tracks) of a scene.</summary>
internal static class PathBuilder
{
    private static readonly (string List, string Part)[] Parts = [
        ("Bodies", "body"), ("Geoms", "geom"), ("Joints", "joint"), ("Springs", "spring"),
    ];

    public static void Add(BuiltScene scene, JsonElement path)
    {
        object factory = Facade.Factory("ComplexFactory");
        foreach (JsonProperty property in Json.Members(path, "complexFactory"))
        {
            SceneBuilder.SetProperty(scene, factory, property.Name, property.Value);
        }

        string id = Json.Text(path, "id");
        Dictionary<string, object> known = new() { ["physicsSimulator"] = scene.Simulator };
        object made = scene.Caller.Make(factory, Json.Text(path, "factory"), Json.Optional(path, "args"), known);
        scene.Add(id, made);
        JsonObject result = [];
        foreach ((string list, string part) in Parts)
        {
            List<object> items = ((IEnumerable)Facade.Get(made, list)!).Cast<object>().ToList();
            for (int i = 0; i < items.Count; i++)
            {
                scene.Add($"{id}.{part}{i}", items[i]);
            }

            result[part + "Count"] = items.Count;
            if (part == "body")
            {
                result["bodies"] = new JsonArray(items.Select(b => (JsonNode?)Pose(scene, b)).ToArray());
            }
        }

        result["controlPoints"] = ResultWriter.Write(scene, Facade.Get(made, "ControlPoints"));
        scene.PathResults.Add(id, JsonSerializer.SerializeToElement(result));
    }

    private static JsonArray Pose(BuiltScene scene, object body)
    {
        JsonArray pose = (JsonArray)ResultWriter.Write(scene, Facade.Get(body, "Position"))!;
        pose.Add(ResultWriter.Write(scene, Facade.Get(body, "Rotation")));
        return pose;
    }
}
