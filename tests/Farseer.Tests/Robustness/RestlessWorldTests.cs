using System;
using System.Globalization;
using System.Linq;
using System.Threading;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>
/// Worlds whose handlers change everything that an update works on: it ends, in bounded time, and leaves a world of numbers. In the guarded
/// build the same tests find what is written past its end or read after it moved.
/// </summary>
public class RestlessWorldTests
{
    private const int Seeds = 160;
    private const int Part = 20;
    private const int Updates = 120;

    /// <summary>A world takes well under a second, and in the guarded build some ten: what takes longer than this does not end.</summary>
    private static readonly TimeSpan _patience = TimeSpan.FromSeconds(120);

    public static TheoryData<int> Parts => new TheoryData<int>(Enumerable.Range(0, Seeds / Part));

    [Theory]
    [MemberData(nameof(Parts))]
    public void HandlersThatChangeEverything_LeaveAnUpdateThatEnds(int part)
    {
        for (int seed = part * Part; seed < (part + 1) * Part; seed++)
        {
            Run(new RestlessWorld(seed, seed % 4 == 0 ? 3 : 1));
        }
    }

    /// <summary>
    /// Bodies of ordinary sizes and speeds, which handlers make static, kinematic and movable again, put into each other and reshape, in
    /// steps of 10⁻⁵ to 0.4 s: contacts drive none of them out of range.
    /// </summary>
    [Theory]
    [MemberData(nameof(Parts))]
    public void ContactsOfARestlessWorld_DriveNobodyOutOfRange(int part)
    {
        for (int seed = part * Part; seed < (part + 1) * Part; seed++)
        {
            var world = new RestlessWorld(seed, ties: false);
            Run(world);
            Assert.Empty(world.Quarantined);
        }
    }

    /// <summary>Nothing is read that was never written, and no order is one of threads.</summary>
    [Theory]
    [InlineData(7)]
    [InlineData(31)]
    [InlineData(118)]
    public void SameSeed_WithAnyNumberOfWorkers_EndsInTheSameState(int seed)
    {
        var one = new RestlessWorld(seed);
        var other = new RestlessWorld(seed, workers: 3);

        Run(one);
        Run(other);

        Assert.Equal(one.StateHash(), other.StateHash());
    }

    [Fact]
    public void EveryHandler_ChangesSomething()
    {
        string[] handlers =
        {
            "Body.Updated", "BodyList.Added", "Geom.OnCollision", "Geom.OnSeparation", "GeomList.Added", "Joint.Broke", "OnBroadPhaseCollision",
        };
        var worlds = new RestlessWorld[Part];
        for (int seed = 0; seed < Part; seed++)
        {
            worlds[seed] = new RestlessWorld(seed);
            Run(worlds[seed]);
        }

        Assert.All(handlers, handler => Assert.Contains(worlds, world => world.Changes.ContainsKey(handler)));
    }

    /// <summary>By a thread of its own, so that an update without end is seen as such.</summary>
    private static void Run(RestlessWorld world)
    {
        Exception? thrown = null;
        var thread = new Thread(() =>
        {
            try
            {
                world.Run(Updates);
            }
            catch (Exception exception)
            {
                thrown = exception;
            }
        })
        {
            IsBackground = true,
        };
        thread.Start();
        bool ended = thread.Join(_patience);
        Assert.True(ended, string.Create(CultureInfo.InvariantCulture, $"{world.Where} has not ended after {_patience.TotalSeconds} s"));
        if (thrown is not null)
        {
            Assert.Fail(world.Where + ": " + thrown);
        }
    }
}
