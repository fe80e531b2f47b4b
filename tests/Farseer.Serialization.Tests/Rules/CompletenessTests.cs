using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.Json;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Serialization;
using FarseerGames.FarseerPhysics.Serialization.Tables;
using Xunit;

namespace Farseer.Serialization.Tests.Rules;

/// <summary>Whatever can be set is in a file, or the tables say why not: a new property without either fails here.</summary>
public sealed class CompletenessTests
{
    /// <summary>Properties that stand in a file in another way than by their own name.</summary>
    private static readonly Dictionary<string, string> _otherwise = new()
    {
        [nameof(WindController.Area)] = "areaMin",
        [nameof(AABBFluidContainer.AABB)] = "containerMin",
    };

    [Fact]
    public void Property_ThatCanBeSet_IsInAFileOrLeftOutForAReason()
    {
        var missing = new List<string>();
        JsonElement root = Root();
        Look(typeof(PhysicsSimulator), root.GetProperty("simulator"), SimulatorTables.Settings);
        Look(typeof(SimulatorDefaults), root.GetProperty("simulator").GetProperty("defaults"), SimulatorTables.Defaults);
        Look(typeof(Scaling), root.GetProperty("simulator").GetProperty("scaling"), SimulatorTables.Scaling);
        Look(typeof(Body), First("bodies", "tag"), BodyTable.All);
        Look(typeof(Geom), First("geoms", "tag"), GeomTable.All);
        foreach (JointKindOfFile kind in JointTables.Kinds)
        {
            Look(kind.Type, Kind("joints", kind.Name), kind.Table);
        }

        foreach (SpringKindOfFile kind in SpringTables.Kinds)
        {
            Look(kind.Type, Kind("springs", kind.Name), kind.Table);
        }

        foreach (ControllerKindOfFile kind in ControllerTables.Kinds)
        {
            Look(kind.Type, Kind("controllers", kind.Name), kind.Table);
        }

        Assert.Empty(missing);

        void Look(Type type, JsonElement item, Table table)
        {
            foreach (PropertyInfo property in type.GetProperties()
                .Where(p => p.SetMethod is { IsPublic: true } && !IsOtherName(p) && p.GetIndexParameters().Length == 0))
            {
                string name = _otherwise.TryGetValue(property.Name, out string? other)
                    ? other
                    : JsonNamingPolicy.CamelCase.ConvertName(property.Name);
                bool isIn = item.TryGetProperty(name, out _);
                if (isIn == table.LeftOut.ContainsKey(property.Name))
                {
                    missing.Add(
                        $"{type.Name}.{property.Name} is {(isIn ? "in a file, and left out" : "not in a file, and nobody says why")}");
                }
            }
        }

        JsonElement First(string list, string with) => root.GetProperty(list).EnumerateArray().First(i => i.TryGetProperty(with, out _));

        JsonElement Kind(string list, string kind) =>
            root.GetProperty(list).EnumerateArray().First(i => i.GetProperty("kind").GetString() == kind);
    }

    [Fact]
    public void Type_OfTheLibrary_IsAKindOfFiles()
    {
        Type[] all = typeof(PhysicsSimulator).Assembly.GetExportedTypes();

        Assert.Equal(Of(typeof(Joint)), JointTables.Kinds.Select(k => k.Type.Name).Order());
        Assert.Equal(Of(typeof(Spring)), SpringTables.Kinds.Select(k => k.Type.Name).Order());
        Assert.Equal(Of(typeof(Controller)), ControllerTables.Kinds.Select(k => k.Type.Name).Order());
        Assert.Equal(
            ["BruteForceCollider", "GridCollider", "SelectiveSweepCollider", "SweepAndPruneCollider"], Of(typeof(LibraryCollider)));

        IEnumerable<string> Of(Type type) => all.Where(t => t.IsSubclassOf(type) && !t.IsAbstract).Select(t => t.Name).Order();
    }

    [Fact]
    public void Table_LeavesOut_OnlyPropertiesThatAreThere()
    {
        foreach ((Type type, Table table) in JointTables.Kinds.Select(k => (k.Type, k.Table))
            .Concat(SpringTables.Kinds.Select(k => (k.Type, k.Table))).Concat(ControllerTables.Kinds.Select(k => (k.Type, k.Table)))
            .Append((typeof(Body), BodyTable.All)).Append((typeof(Geom), GeomTable.All))
                .Append((typeof(PhysicsSimulator), SimulatorTables.Settings)))
        {
            Assert.All(table.LeftOut.Keys, name => Assert.NotNull(type.GetProperty(name)));
        }
    }

    /// <summary>A name of a manual for what has another one: it holds nothing of its own.</summary>
    private static bool IsOtherName(PropertyInfo property) => property.GetCustomAttribute<ObsoleteAttribute>() is not null;

    /// <summary>Definitions of the other facade, of which a file holds what was made of them.</summary>
    [Fact]
    public void Definition_OfTheOtherFacade_IsInAFile()
    {
        var known = new Dictionary<string, string>
        {
            ["massData"] = "mass", ["linearVelocity"] = "linearVelocity", ["isSleeping"] = "isSleeping", ["filter"] = "maskBits",
            ["vertexCount"] = "vertices",
            ["localPosition"] = "center", ["length"] = "target", ["frequencyHz"] = "frequency", ["localAxis1"] = "axisX",
            ["referenceAngle"] = "target",
            ["enableLimit"] = "isLimitEnabled", ["lowerTranslation"] = "lower", ["upperTranslation"] = "upper",
            ["enableMotor"] = "isMotorEnabled",
            ["maxMotorForce"] = "motorLimit", ["maxMotorTorque"] = "motorLimit", ["lowerAngle"] = "lower", ["upperAngle"] = "upper",
            ["groundAnchor1"] = "ground1X", ["groundAnchor2"] = "ground2X", ["length1"] = "target", ["length2"] = "target",
            ["maxLength1"] = "upper",
            ["maxLength2"] = "lower", ["maxForce"] = "motorLimit", ["timeStep"] = "frequency",
        };
        JsonElement root = JsonDocument.Parse(SceneFile.Save(FlashEverything.Build())).RootElement;
        HashSet<string> names = [.. new[] { "bodies", "shapes", "joints" }
            .SelectMany(list => root.GetProperty(list).EnumerateArray().SelectMany(i => i.EnumerateObject().Select(m => m.Name)))];

        IEnumerable<string> missing = typeof(Box2D.Dynamics.b2World).Assembly.GetExportedTypes()
            .Where(t => t.Name.EndsWith("Def", StringComparison.Ordinal)).SelectMany(t => t.GetProperties())
            .Where(p => p.SetMethod is { IsPublic: true } && !IsOtherName(p)).Select(p => p.Name).Distinct()
            .Where(name => !names.Contains(known.TryGetValue(name, out string? other) ? other : name));

        Assert.Empty(missing);
    }

    private static JsonElement Root()
    {
        PhysicsSimulator simulator = Everything.Build();
        simulator.Update(0);
        foreach (Body body in simulator.BodyList)
        {
            body.Tag = "tag";
        }

        foreach (Controller controller in simulator.ControllerList)
        {
            controller.Tag = "tag";
        }

        return JsonDocument.Parse(SceneFile.Save(simulator)).RootElement;
    }
}
