using System;
using System.Collections.Generic;
using Farseer.Engine.Bodies;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Simulation;

/// <summary>
/// Many light bodies at one that outweighs them by far: their rows lie side by side, and what comes of them is as if they did not.
/// </summary>
public sealed class HeavyBodyTests
{
    private const int Boxes = 60;
    private const float BoxMass = 0.01f;
    private const float PlateMass = 100;
    private const float PlateWidth = 75;

    /// <summary>
    /// Of impacts that are found one after the other each sees what the plate has got by then, up to 9 mm/s of 1 m/s: the square of that.
    /// </summary>
    private const double OneAfterTheOther = 8e-5;

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void BoxesThatMeetAHeavyPlate_GoOnWithItAsOne(int workers)
    {
        SleepScene scene = Plate(gravity: 0, restitution: 0, out Handle plate, out List<Handle> boxes);
        scene.World.SetWorkers(workers, workers, null);
        foreach (Handle box in boxes)
        {
            scene.SetVelocity(box, 0, -1);
        }

        scene.Step(60);

        double common = -Boxes * BoxMass / (PlateMass + (Boxes * BoxMass));
        double momentum = PlateMass * VelocityOf(scene, plate);
        Assert.Equal(common, VelocityOf(scene, plate), OneAfterTheOther);
        foreach (Handle box in boxes)
        {
            momentum += BoxMass * VelocityOf(scene, box);
        }

        // A hundred times the last place of the plate's speed.
        Assert.Equal(-Boxes * BoxMass, momentum, 1e-6);

        scene.World.Dispose();
    }

    [Fact]
    public void BoxesThatBounceOffAHeavyPlate_PartAsNewtonSays()
    {
        SleepScene scene = Plate(gravity: 0, restitution: 0.5f, out Handle plate, out List<Handle> boxes);
        foreach (Handle box in boxes)
        {
            scene.SetVelocity(box, 0, -1);
        }

        scene.Step(60);

        double pushed = -1.5 * Boxes * BoxMass / (PlateMass + (Boxes * BoxMass));
        Assert.Equal(pushed, VelocityOf(scene, plate), OneAfterTheOther);
        foreach (Handle box in boxes)
        {
            // From what the plate has got by its turn, up to all of it.
            Assert.InRange(VelocityOf(scene, box), 0.5 + (1.5 * pushed) - OneAfterTheOther, 0.5 + OneAfterTheOther);
        }
    }

    [Fact]
    public void BoxesOnAHeavyPlate_AsleepAndStruckAgain_LieOnIt()
    {
        SleepScene scene = Plate(gravity: 10, restitution: 0, out Handle plate, out List<Handle> boxes);
        scene.World.Settings.AllowSleep = true;
        scene.Settle();
        scene.World.Sleep.WakeUp(plate);
        scene.SetVelocity(plate, 0, 1);
        scene.Step(240);
        double top = scene.World.Bodies.Pose[plate.Index].Y + 0.5;
        foreach (Handle box in boxes)
        {
            Assert.Equal(top + 0.5, scene.World.Bodies.Pose[box.Index].Y, 0.01);
        }
    }

    /// <summary>
    /// A plate under a row of boxes, none of which touches another; it rests on the ground, or flies where there is no weight.
    /// </summary>
    private static SleepScene Plate(float gravity, float restitution, out Handle plate, out List<Handle> boxes)
    {
        var scene = new SleepScene(allowSleep: false, gravity: gravity);
        scene.World.Settings.BounceThreshold = 0.1f;
        float base0 = gravity > 0 ? 0 : 20;
        plate = Cover(scene, scene.Bare(0, base0 + 0.5f, PlateWidth, 1), PlateWidth, restitution);
        scene.World.SetMass(plate, PlateMass, PlateMass * PlateWidth * PlateWidth / 12);
        boxes = new List<Handle>();
        for (int i = 0; i < Boxes; i++)
        {
            Handle box =
                Cover(scene, scene.Bare(1.2f * (i - (0.5f * (Boxes - 1))), base0 + 1.5f + (gravity > 0 ? 0 : 0.1f), 1, 1), 1, restitution);
            scene.World.SetMass(box, BoxMass, BoxMass / 6);
            boxes.Add(box);
        }

        return scene;
    }

    private static Handle Cover(SleepScene scene, Handle body, float width, float restitution)
    {
        scene.World.CreateCollider(body, ShapeBuilder.Box(width, 1), new ColliderDef
        {
            Flags = ColliderFlags.CollisionEnabled | ColliderFlags.ResponseEnabled,
            Friction = 0.6f,
            Restitution = restitution,
            Categories = 1,
            CollidesWith = 1,
        });
        return body;
    }

    private static double VelocityOf(SleepScene scene, Handle body) => scene.World.Bodies.State[body.Index].LinearVelocity.Y;
}
