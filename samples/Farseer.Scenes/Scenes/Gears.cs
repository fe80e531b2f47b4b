using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>Two toothed wheels, concave outlines: the small one is driven, the big one runs on a hub in a square bearing.</summary>
public sealed class Gears : Scene
{
    private const int DriverTeeth = 12;
    private const int DrivenTeeth = 18;

    /// <summary>Pitch diameter over tooth count.</summary>
    private const float Module = 0.4f;
    private const float Hub = 0.5f;
    private const float Spin = 1f;
    private Body? _driver;
    private Geom? _driven;
    private Vector2 _axle;

    public override string Name => "gears";

    public override string Title => "Concave gears";

    public override string Description => "12 teeth drive 18: the big wheel turns the other way at two thirds of the speed.";

    public override SceneView View => new(new Vector2(-4f, -5f), new Vector2(11f, 5f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Geom driver = Make.Polygon(simulator, Vector2.Zero, Wheel(DriverTeeth), 5f, 0.1f);
        _driver = driver.Body;
        _driver.IsKinematic = true;
        _driver.AngularVelocity = Spin;

        _axle = new Vector2(0.5f * Module * (DriverTeeth + DrivenTeeth), 0f);
        _driven = Make.Polygon(simulator, _axle, Wheel(DrivenTeeth), 10f, 0.1f);

        // A gap of this wheel faces a tooth of the other.
        _driven.Body.Rotation = (float)(Math.PI / DrivenTeeth);
        AddBearing(simulator, _driven, _axle);
        driver.CollisionCategories = CollisionCategory.Cat1;
        driver.CollidesWith = CollisionCategory.Cat1;
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double driven = _driven!.Body.TotalRotation - (Math.PI / DrivenTeeth);
        double ideal = -(double)_driver!.TotalRotation * DriverTeeth / DrivenTeeth;

        // A tooth is 0.45 of the pitch wide at the pitch circle, so a wheel has a play of a tenth of the pitch either way.
        double play = 0.1 * 2.0 * Math.PI / DrivenTeeth;
        return
        [
            SceneOutcome.Error("turn of the driver (rad)", _driver.TotalRotation, Spin * Steps * (double)Dt, 1e-3),
            SceneOutcome.Error("turn of the driven wheel against the ratio (rad)", driven, ideal, play),

            // The bearing has a play of 1 mm and each of its contacts rests up to 1 mm deep.
            SceneOutcome.AtMost("hub off the axle (m)", (_driven.Body.Position - _axle).Length(), 4f * Make.Tolerance),
        ];
    }

    /// <summary>Teeth are trapezia: 0.45 of the pitch wide at the pitch circle, 0.25 at the tip, 0.65 at the root.</summary>
    private static Vector2[] Wheel(int teeth)
    {
        Vector2[] outline = new Vector2[4 * teeth];
        double pitch = 2.0 * Math.PI / teeth;
        double root = (0.5 * Module * teeth) - (0.9 * Module);
        double tip = (0.5 * Module * teeth) + (0.75 * Module);
        for (int i = 0; i < teeth; i++)
        {
            outline[4 * i] = Polar(root, pitch * (i - 0.325));
            outline[(4 * i) + 1] = Polar(tip, pitch * (i - 0.125));
            outline[(4 * i) + 2] = Polar(tip, pitch * (i + 0.125));
            outline[(4 * i) + 3] = Polar(root, pitch * (i + 0.325));
        }

        return outline;
    }

    private static Vector2 Polar(double radius, double angle) =>
        new((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle)));

    /// <summary>A round hub on the wheel in a square hole of four static boxes; teeth and bearing do not see each other.</summary>
    private static void AddBearing(PhysicsSimulator simulator, Geom wheel, Vector2 axle)
    {
        Geom hub = GeomFactory.Instance.CreateCircleGeom(simulator, wheel.Body, Hub, 24);
        hub.FrictionCoefficient = 0f;
        hub.CollisionCategories = CollisionCategory.Cat2;
        hub.CollidesWith = CollisionCategory.Cat2;
        wheel.CollisionCategories = CollisionCategory.Cat1;
        wheel.CollidesWith = CollisionCategory.Cat1;
        float distance = Hub + Make.Tolerance + 0.25f;
        Vector2[] sides = [new(1f, 0f), new(-1f, 0f), new(0f, 1f), new(0f, -1f)];
        foreach (Vector2 side in sides)
        {
            Vector2 centre = axle + (distance * side);
            Geom block = side.Y == 0f
                ? Make.Wall(simulator, centre, 0.5f, 2f * Hub, 0f, 0f)
                : Make.Wall(simulator, centre, 2f * Hub, 0.5f, 0f, 0f);
            block.CollisionCategories = CollisionCategory.Cat2;
            block.CollidesWith = CollisionCategory.Cat2;
        }
    }
}
