using System;
using System.Collections.Generic;
using Xunit.Abstractions;
using Xunit.Sdk;

namespace Farseer.Tests;

/// <summary>
/// Names a row of tests/data/manual-farseer.tsv that a test proves; the test can be selected with <c>--filter ManualRow=F307</c>.
/// </summary>
[TraitDiscoverer("Farseer.Tests.ManualRowDiscoverer", AssemblyName)]
[AttributeUsage(AttributeTargets.Method | AttributeTargets.Class, AllowMultiple = true)]
public sealed class ManualRowAttribute : Attribute, ITraitAttribute
{
    /// <summary>The discoverer is looked up by the name of the assembly, and these sources are compiled into two.</summary>
#if NETSTANDARD_ASSET
    internal const string AssemblyName = "Farseer.Tests.NetStandard";
#else
    internal const string AssemblyName = "Farseer.Tests";
#endif

    public ManualRowAttribute(string id)
    {
        Id = id;
    }

    public string Id { get; }
}

public sealed class ManualRowDiscoverer : ITraitDiscoverer
{
    public IEnumerable<KeyValuePair<string, string>> GetTraits(IAttributeInfo traitAttribute)
    {
        foreach (var argument in traitAttribute.GetConstructorArguments())
        {
            yield return new KeyValuePair<string, string>("ManualRow", (string)argument);
        }
    }
}
