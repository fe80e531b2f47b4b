using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Xunit;

namespace Farseer.Engine.Tests.Bodies;

public sealed class BodyRecordTests
{
    [Fact]
    public void BodyState_IsTwoHalvesOf16Bytes()
    {
        Assert.Equal(32, Unsafe.SizeOf<BodyState>());
        Assert.Equal(0, (int)Marshal.OffsetOf<BodyState>(nameof(BodyState.LinearVelocity)));
        Assert.Equal(16, (int)Marshal.OffsetOf<BodyState>(nameof(BodyState.DeltaPosition)));
    }

    [Fact]
    public void BodyPose_Is32Bytes()
    {
        Assert.Equal(32, Unsafe.SizeOf<BodyPose>());
    }
}
