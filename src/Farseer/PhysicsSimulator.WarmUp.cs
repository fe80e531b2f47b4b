using System;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics;

/// <content>What a process's first updates wait for. (An addition to the original.)</content>
public partial class PhysicsSimulator
{
    /// <summary>
    /// Has the runtime compile now what the first updates of a simulator would wait for: it makes small worlds of its own with shapes,
    /// joints, a spring, a bullet and queries, updates them some times and forgets them. In a process that compiles as it goes this takes
    /// some half a second, once; called again, and in one that was published as native code, some ten milliseconds. Simulators that exist
    /// are not touched, and what they do stays the same to the last bit. It may be called from any thread, while others update simulators
    /// of theirs: <c>Task.Run(PhysicsSimulator.WarmUp)</c> while a level loads. (An addition to the original.)
    /// </summary>
    /// <exception cref="PlatformNotSupportedException"><c>DOTNET_MaxVectorTBitWidth</c> asks for vectors of 512 bits, and the processor has
    /// them.</exception>
    public static void WarmUp() => WarmUpWorld.Run();
}
