using System.Collections.Generic;
using Box2D.Dynamics;

namespace Farseer.Fidelity.Flash;

/// <summary>The scenes that show a wrong of the original which the library has only on request.</summary>
internal static class FlashQuirks
{
    private static readonly Dictionary<string, Box2DFlash202Quirks> _byScene = new()
    {
        ["callback_lock"] = Box2DFlash202Quirks.LockedCallsDoNothing,
        ["debug_draw"] = Box2DFlash202Quirks.SettersWakeNobody,
        ["gravity_change"] = Box2DFlash202Quirks.SettersWakeNobody,
        ["mouse_joint"] = Box2DFlash202Quirks.MouseJointSlowsTurn | Box2DFlash202Quirks.MouseJointStiffness,
        ["polygon_geometry"] = Box2DFlash202Quirks.BoxOfTurnedBox,
        ["query_aabb"] = Box2DFlash202Quirks.BoxOfTurnedBox,
        ["pulley"] = Box2DFlash202Quirks.PulleyForceSign,
        ["pulley_limits"] = Box2DFlash202Quirks.PulleyForceSign,
        ["reactions"] = Box2DFlash202Quirks.PrismaticForceSquared | Box2DFlash202Quirks.PulleyForceSign
            | Box2DFlash202Quirks.RevoluteTorqueOfLimitOnly | Box2DFlash202Quirks.MouseJointStiffness | Box2DFlash202Quirks.MouseJointSlowsTurn,
        ["set_mass"] = Box2DFlash202Quirks.StaticKeepsVelocity,
        ["sleep_wake"] = Box2DFlash202Quirks.SettersWakeNobody,
        ["transforms"] = Box2DFlash202Quirks.LocalPointVelocity,
        ["velocity_limits"] = Box2DFlash202Quirks.SpeedLimits,
    };

    public static Box2DFlash202Quirks For(string scene) => _byScene.GetValueOrDefault(scene);
}
