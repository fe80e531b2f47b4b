using System;
using System.Collections.Generic;
using System.Linq;

namespace Farseer.Fidelity.Building;

/// <summary>
/// Which compatibility flag brings back what a scene shows. A scene that is not listed here, or whose
/// flag does not exist because the library does the same without one, runs without flags.
/// </summary>
public static class Quirks
{
    private static readonly Dictionary<string, string[]> FlagsByScene = new(StringComparer.Ordinal)
    {
        ["chain_pin"] = ["PathLinkedAtFarEnds"],
        ["collision_category"] = ["OneSidedCategoryFilter"],
        ["fluid_circle"] = ["BuoyancyOfVertices"],
        ["friction_changed_in_contact"] = ["PairFrictionFrozen"],
        ["geom_rotation_offset"] = ["OffsetTurnedByRotationOffset"],
        ["impulses"] = ["ImpulseDividedByMassTwice"],
        ["joint_break"] = ["JointBreaksLate"],
        ["moi_factories"] = ["EllipseInertiaFromRectangle", "PolygonInertiaUnsigned"],
        ["oncollision_false"] = ["SeparationWithoutContact"],
        ["onseparation"] = ["SeparationWithoutContact"],
        ["remove_geom"] = ["NoSeparationOnRemoval"],
        ["rest_L"] = ["PolygonInertiaUnsigned"],
        ["rotation_set"] = ["RotationSetAddsRevolutions"],
        ["sensor"] = ["SensorMakesBodyStatic", "SeparationWithoutContact"],
        ["simulator_paused"] = ["ForcesAccumulateWhilePaused"],
        ["spring_break"] = ["SpringBreaksLate"],
    };

    private static Type? EnumType => Facade.FindType("Farseer201Quirks");

    /// <summary>The flags for a scene as the library's enum, or null when it needs none.</summary>
    public static object? For(string scene)
    {
        if (EnumType is not { } type || !FlagsByScene.TryGetValue(scene, out string[]? names))
        {
            return null;
        }

        long bits = names.Aggregate(0L, (sum, name) => sum | (Enum.TryParse(type, name, out object? flag)
            ? Convert.ToInt64(flag, System.Globalization.CultureInfo.InvariantCulture)
            : throw new MissingPartException(type.Name + "." + name)));
        return Enum.ToObject(type, bits);
    }

    public static void Set(object simulator, object quirks)
    {
        string? member = simulator.GetType().GetProperties().FirstOrDefault(p => p.PropertyType == quirks.GetType())?.Name;
        Facade.Set(simulator, member ?? throw new MissingPartException("PhysicsSimulator." + quirks.GetType().Name), quirks);
    }
}
