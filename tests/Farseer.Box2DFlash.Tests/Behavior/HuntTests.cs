using Farseer.Shared;
using Xunit.Abstractions;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>Worlds of Box2DFlash 2.0.2.</summary>
public sealed class HuntTests(ITestOutputHelper output) : HuntedWorlds("flash", output);
