using System;
using System.Collections.Generic;
using Farseer.Testbed.Scenes;

namespace Farseer.Testbed;

/// <summary>The scenes, each made anew.</summary>
public static class SceneList
{
    public static IReadOnlyList<Func<TestScene>> Makers { get; } =
    [
        () => new HelloBox2D(), () => new Stack(), () => new Bridge(), () => new CompoundShapes(), () => new CrankGearsPulley(),
        () => new Ragdolls(), () => new Walker(), () => new FastBodies(), () => new Breakable(), () => new Buoyancy(),
        () => new OneWayPlatform(), () => new RayCast(),
    ];
}
