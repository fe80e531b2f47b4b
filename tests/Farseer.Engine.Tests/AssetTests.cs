using System.Linq;
using System.Reflection;
using System.Runtime.Versioning;
using Xunit;

namespace Farseer.Engine.Tests;

/// <summary>These sources are built twice, once against each asset of the library; this proves which one is running.</summary>
public sealed class AssetTests
{
#if NETSTANDARD_ASSET
    private const string ExpectedFramework = ".NETStandard,Version=v2.0";
#else
    private const string ExpectedFramework = ".NETCoreApp,Version=v8.0";
#endif

    [Theory]
    [InlineData("Farseer.Engine")]
    public void LoadedAssembly_IsTheAssetUnderTest(string assembly)
    {
        TargetFrameworkAttribute framework = Assembly.Load(new AssemblyName(assembly))
            .GetCustomAttributes<TargetFrameworkAttribute>()
            .Single();

        Assert.Equal(ExpectedFramework, framework.FrameworkName);
    }
}
