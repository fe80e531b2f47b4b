using System;
using System.Collections.Generic;
using Xunit.Abstractions;
using Xunit.Sdk;

namespace Farseer.Tests;

/// <summary>
/// Names a row of tests/data/manual-farseer.tsv that a test proves; the test can be selected with <c>--filter ManualRow=F307</c>.
/// </summary>
[TraitDiscoverer("Farseer.Tests.ManualRowDiscoverer", "Farseer.Tests")]
[AttributeUsage(AttributeTargets.Method | AttributeTargets.Class, AllowMultiple = true)]
public sealed class ManualRowAttribute : Attribute, ITraitAttribute
{
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
