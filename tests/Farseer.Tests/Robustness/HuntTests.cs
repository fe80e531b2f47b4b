using Farseer.Shared;
using Xunit.Abstractions;

namespace Farseer.Tests.Robustness;

/// <summary>Worlds of Farseer Physics 2.0.</summary>
public sealed class HuntTests(ITestOutputHelper output) : HuntedWorlds("farseer", output);
