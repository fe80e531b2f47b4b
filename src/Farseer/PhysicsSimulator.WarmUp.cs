using System;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics;

/// <content>What a process's first updates wait for. (An addition to the original.)</content>
public partial class PhysicsSimulator
{
    /// <summary>
    /// Makes the runtime compile now what the first updates of a simulator would wait for. It makes small worlds of its own with shapes,
    /// joints, a spring, a bullet and queries, updates them a few times and forgets them. In a process that compiles as it goes this takes
    /// about half a second, once; a second call, or a process that was published as native code, takes about ten milliseconds. It does not
    /// touch other simulators and changes no bit of theirs. Call it from any thread, also while others update simulators:
    /// <c>Task.Run(PhysicsSimulator.WarmUp)</c> while a level loads. (An addition to the original.)
    /// </summary>
    /// <exception cref="PlatformNotSupportedException"><c>DOTNET_MaxVectorTBitWidth</c> asks for vectors of 512 bits, and the processor has
    /// them.</exception>
    public static void WarmUp() => WarmUpWorld.Run();
}
