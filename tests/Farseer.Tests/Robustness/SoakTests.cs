using System;
using System.IO;
using Farseer.Hunt.Soaking;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>A few seconds of the soak; by command it runs for hours.</summary>
[Collection("What the collector counts")]
public class SoakTests
{
    [Fact]
    public void WorldsOnManyThreads_MadeAndDropped_LeaveNothing()
    {
        var log = new StringWriter();

        string? left = new Soak(log).Run(TimeSpan.FromSeconds(9), long.MaxValue, 3, TimeSpan.FromSeconds(1));

        Assert.True(left is null, left + "\n" + log);
    }
}
