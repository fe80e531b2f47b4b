using System;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>The memory of steps, which the small worlds that a thread steps share.</summary>
internal static class SharedScratch
{
    [ThreadStatic]
    private static Scratch? _free;

    public static void Step(World world, float dt) => world.Step(dt, ref _free);
}
