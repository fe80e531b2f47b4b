using System;
using System.Collections.Generic;

namespace Farseer.Scenes;

/// <summary>The scenes by name. A list written by hand: what a program runs should be seen by reading it.</summary>
public static class SceneLibrary
{
    /// <summary>The scene a newcomer sees first.</summary>
    public const string DefaultName = "falling-stack";

    /// <summary>Fresh instances at every read, because a scene keeps the bodies it built.</summary>
    public static IReadOnlyList<Scene> All =>
    [
        new FallingStack(),
        new UntouchedDefaults(),
        new SimpleBody(),
        new Pyramid(),
        new Dominoes(),
        new BouncingLadder(),
        new FrictionRamp(),
        new Tumbler(),
        new Gears(),
        new Cups(),
        new ChainTerrain(),
        new NewtonsLine(),
        new SensorGate(),
        new CollisionCategories(),
        new OneWayPlatform(),
        new KinematicPlatform(),
        new CirclePile(),
        new Projectiles(),
        new LinearAndAngularSprings(),
        new WeighingPan(),
        new FixedJoints(),
        new DynamicAngleJoints(),
        new GearTrain(),
        new BreakableWall(),
        new Ragdoll(),
        new OwnJoint(),
        new JointKinds(),
        new ForceKinds(),
        new Water(),
        new HangingChain(),
        new Rope100(),
        new PlankBridge(),
        new SoftPath(),
        new RigidPath(),
        new TankTrack(),
        new BitmapBody(),
        new Inactivity(),
        new PhysicsThread(),
        new FarFromOrigin(),
        new PixelsAndMetres(),
    ];

    /// <summary>A fresh scene of that name (case does not matter), or null.</summary>
    public static Scene? Find(string name)
    {
        foreach (Scene scene in All)
        {
            if (string.Equals(scene.Name, name, StringComparison.OrdinalIgnoreCase))
            {
                return scene;
            }
        }

        return null;
    }
}
