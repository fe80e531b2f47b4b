using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// Bodies that fell asleep in a world that had never had a pair wrote down where their corners are, in a column that the first narrow phase
/// makes room in: beyond a hundred pieces it ran over the memory behind, and the next collection of garbage ended the process.
/// </summary>
public class SleepWithoutPairsTests
{
    private const int Bodies = 2000;
    private const float Apart = 50f;

    [Fact]
    public void Sleep_OfManyBodiesThatNeverMet_LeavesMemoryAlone()
    {
        var simulator = new PhysicsSimulator(Vector2.Zero) { AllowSleep = true };
        for (int i = 0; i < Bodies; i++)
        {
            Sandbox.Box(simulator, new Vector2(i % 50 * Apart, i / 50 * Apart));
        }

        Sandbox.Run(simulator, 200);
        Assert.Equal(Bodies, simulator.SleepingBodyCount);

        // What lies behind the column is looked at here.
        GC.Collect();
        Geom struck = simulator.GeomList[Bodies / 2];
        Geom bullet = Sandbox.Ball(simulator, struck.Body.Position - new Vector2(20f, 0f));
        bullet.Body.LinearVelocity = new Vector2(100f, 0f);
        Sandbox.Run(simulator, 30);

        Assert.True(struck.Body.Awake);
        Assert.True(struck.Body.LinearVelocity.X > 1f, $"It moves at {struck.Body.LinearVelocity}.");
    }
}
