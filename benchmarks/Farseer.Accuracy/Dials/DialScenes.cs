using System;
using System.Collections.Generic;
using Farseer.Accuracy.General;
using Farseer.Accuracy.Scenes;

namespace Farseer.Accuracy.Dials;

/// <summary>
/// Motions without a closed form: each tells where a body is in the end, to be held against a run with far more substeps. The
/// parameter is the number of a throw or the mass of a load, so a kind of scene can be asked about with many of them.
/// </summary>
internal static class DialScenes
{
    private const double Longest = 10;

    /// <summary>A box slower than this for as many steps as said is at rest.</summary>
    private const double Still = 1e-5;
    private const int StillSteps = 10;

    private static readonly Range _numbers = new(1, 1000, WholeNumber: true);
    private static readonly string[] _place = ["x_mm", "y_mm"];

    /// <summary>Where a thrown box comes to rest after it has landed, tumbled and slid.</summary>
    public static SceneInfo Throw { get; } = new("D01_throw", "number of the throw", _numbers, ["1"], _place, Thrown);

    /// <summary>Where a box is that bounces and spins, two seconds after it was let go.</summary>
    public static SceneInfo Bounce { get; } = new("D02_bounce", "number of the drop", _numbers, ["1"], _place, Bounced);

    /// <summary>Where the weight of a rope is that was let go level, before the whip makes its motion chaotic.</summary>
    public static SceneInfo Rope { get; } = new("D03_rope", "mass of the weight, kg", new(1, 1e4), ["100"], _place, Swung);

    /// <summary>Where the trunk of a ragdoll is after it has landed.</summary>
    public static SceneInfo Ragdoll { get; } = new("D04_ragdoll", "number of the drop", _numbers, ["1"], _place, Dropped);

    private static void Thrown(Trial trial) => trial.World(rig =>
    {
        var dice = new Dice((uint)trial.Parameter, "throw");
        rig.Friction = 0.5;
        rig.Restitution = 0.3;
        rig.AddGround();
        Actor box = AddMovingBox(rig, dice, -20);
        int still = 0;
        int most = rig.StepsIn(Longest);
        while (still < StillSteps && rig.Steps < most)
        {
            rig.Step();
            still = box.Velocity.Length < Still && Math.Abs(box.Spin) < Still ? still + 1 : 0;
        }

        Record(trial, box);
    });

    private static void Bounced(Trial trial) => trial.World(rig =>
    {
        var dice = new Dice((uint)trial.Parameter, "bounce");
        rig.Friction = 0.3;
        rig.Restitution = 0.8;
        rig.AddGround();
        Actor box = AddMovingBox(rig, dice, 0);
        rig.Run(2);
        Record(trial, box);
    });

    private static void Swung(Trial trial) => trial.World(
        rig =>
        {
            Actor weight = Chains.MakeRope(rig, trial.Parameter, new Vec(1, 0));
            rig.Run(3);
            Record(trial, weight);
        });

    private static void Dropped(Trial trial) => trial.World(
        rig =>
        {
            var dice = new Dice((uint)trial.Parameter, "ragdoll");
            rig.AddGround();
            List<Actor> limbs = Ragdolls.Add(rig, dice, new Vec(0, 1), dice.Between(-0.5, 0.5));
            rig.Run(1);
            Record(trial, limbs[0]);
        });

    private static Actor AddMovingBox(Rig rig, Dice dice, double x)
    {
        Actor box = rig.AddBox(x, dice.Between(1, 3), 1, 1, dice.Angle());
        box.Velocity = new Vec(dice.Between(2, 8), dice.Between(-3, 3));
        box.Spin = dice.Between(-10, 10);
        return box;
    }

    private static void Record(Trial trial, Actor body)
    {
        trial.Record(_place[0], 1000 * body.Position.X);
        trial.Record(_place[1], 1000 * body.Position.Y);
    }
}
