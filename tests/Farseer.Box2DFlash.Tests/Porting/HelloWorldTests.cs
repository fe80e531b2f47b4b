using System.Collections.Generic;
using System.Globalization;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Porting;

public sealed class HelloWorldTests
{
    [Fact]
    [ManualRow("B040", "B041", "B044")]
    public void HelloWorld_After60Steps_RestsOnTheGround()
    {
        List<string> lines = HelloWorld.Run();
        string[] last = lines[^1].Split(' ');

        Assert.Equal(60, lines.Count);
        Assert.Equal(0, double.Parse(last[0], CultureInfo.InvariantCulture), 0.005);
        Assert.Equal(1, double.Parse(last[1], CultureInfo.InvariantCulture), 0.0101); // the slop, 0.005, and a hundredth's rounding
        Assert.Equal(0, double.Parse(last[2], CultureInfo.InvariantCulture), 0.005);
    }
}
