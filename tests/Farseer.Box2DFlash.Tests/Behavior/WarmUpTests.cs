using System.Threading.Tasks;
using Box2D.Dynamics;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

public class WarmUpTests
{
    private const int Steps = 60;

    [Fact]
    public void WarmUp_BesideAWorld_ChangesNoBitOfIt()
    {
        ulong expected = Hash(warmUpAt: -1);
        var hashes = new ulong[3];

        Parallel.For(0, hashes.Length, i => hashes[i] = Hash(warmUpAt: i * 20));

        Assert.All(hashes, h => Assert.Equal(expected, h));
    }

    private static ulong Hash(int warmUpAt)
    {
        b2World world = Bench.World();
        Bench.Static(world, 0, -1, 50, 1);
        for (int i = 0; i < 12; i++)
        {
            Bench.Dynamic(world, i % 3 * 1.1f, 0.6f + (i / 3 * 1.1f));
        }

        for (int step = 0; step < Steps; step++)
        {
            if (step == warmUpAt)
            {
                b2World.WarmUp();
            }

            world.Step(1f / 60f, 10);
        }

        return world.MotionHash();
    }
}
