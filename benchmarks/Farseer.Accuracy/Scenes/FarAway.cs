using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>Motion far from the origin. The far stack is with the other stacks.</summary>
internal static class FarAway
{
    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S22b_far_bounce", "distance, m", new(-2e7, 2e7), ["0", "1000", "10000", "100000", "1e6"], ["apex1_rel_error"], Bounce),
        new("S22c_far_crawl", "distance, m", new(-2e7, 2e7), ["0", "1000", "10000", "100000", "1e6"], ["displacement_rel_error"], Crawl),
    ];

    private static void Bounce(Trial trial) => trial.World(rig =>
    {
        const double Restitution = 0.8;
        List<double> heights = Impacts.ApexHeights(rig, Restitution, trial.Parameter, 1);
        trial.Record("apex1_rel_error", Impacts.ApexError(heights, Restitution, 1));
    });

    private static void Crawl(Trial trial) => trial.World(
        rig =>
        {
            Actor ball = rig.AddCircle(trial.Parameter, trial.Parameter, 0.5);
            ball.Velocity = new Vec(0.5, 0.3);
            rig.Run(10);

            // The reference distance is (5, 3) at the speed that a float holds and at the float steps' time.
            Vec exact = rig.Time * new Vec(0.5f, 0.3f);
            trial.Record("displacement_rel_error", (ball.Displacement - exact).Length / exact.Length);
        },
        gravity: 0);
}
