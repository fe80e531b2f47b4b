using System.Numerics;
using System.Threading.Tasks;
using FarseerGames.FarseerPhysics;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>
/// What <see cref="PhysicsSimulator.WarmUp"/> spares a new process is told by Farseer.Samples.Tests; here: nobody notices it otherwise.
/// </summary>
public class WarmUpTests
{
    private const int Steps = 60;

    [Fact]
    public void WarmUp_BesideASimulator_ChangesNoBitOfIt()
    {
        Assert.Equal(Hash(warmUpAt: -1), Hash(warmUpAt: Steps / 2));
    }

    [Fact]
    public void WarmUp_OnSeveralThreadsAtOnce_ChangesNoBit()
    {
        ulong expected = Hash(warmUpAt: -1);
        var hashes = new ulong[4];

        Parallel.For(0, hashes.Length, i => hashes[i] = Hash(warmUpAt: i));

        Assert.All(hashes, h => Assert.Equal(expected, h));
    }

    private static ulong Hash(int warmUpAt)
    {
        PhysicsSimulator simulator = Sandbox.WithFloor(out _);
        for (int i = 0; i < 12; i++)
        {
            Sandbox.Box(simulator, new Vector2(i % 3 * 22f, -25f * (i / 3)));
        }

        for (int step = 0; step < Steps; step++)
        {
            if (step == warmUpAt)
            {
                PhysicsSimulator.WarmUp();
            }

            simulator.Update(Sandbox.Step);
        }

        return simulator.MotionHash();
    }
}
