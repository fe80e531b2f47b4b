using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Tests.Behavior;

/// <summary>
/// A box full of falling shapes of all kinds and sizes. Every length, gravity and AllowedPenetration is multiplied by a power of
/// two, so that the same pile can be run at another size without any rounding of the scene itself.
/// </summary>
internal sealed class RandomPile
{
    private readonly float _scale;
    private readonly List<Body> _bodies = new();

    public RandomPile(
        int seed,
        int count,
        float scale,
        Func<PhysicsSimulator, FarseerGames.FarseerPhysics.Interfaces.IBroadPhaseCollider>? collider = null)
    {
        _scale = scale;
        Simulator = new PhysicsSimulator(scale * new Vector2(0, 100));
        Simulator.AllowedPenetration *= scale;
        if (collider is not null)
        {
            Simulator.BroadPhaseCollider = collider(Simulator);
        }

        Wall(new Vector2(0, 10), 300, 20);
        Wall(new Vector2(-110, -100), 20, 240);
        Wall(new Vector2(110, -100), 20, 240);
        var random = new Random(seed);
        for (int i = 0; i < count; i++)
        {
            var place = new Vector2(((i % 5) - 2) * 36, -30 - (36 * (i / 5)));
            Geom geom = Shape(i % 6, (float)(6 + (8 * random.NextDouble())));
            Body body = geom.Body;
            Sandbox.WithoutDrag(body);
            body.Position = scale * (place + new Vector2((float)random.NextDouble(), (float)random.NextDouble()));
            body.Rotation = (float)(6 * random.NextDouble());
            body.LinearVelocity = scale * new Vector2((float)(20 * random.NextDouble()) - 10, 0);
            body.AngularVelocity = (float)random.NextDouble() - 0.5f;
            geom.FrictionCoefficient = (float)random.NextDouble();
            geom.RestitutionCoefficient = i % 3 == 0 ? 0.5f : 0;
            _bodies.Add(body);
        }
    }

    public PhysicsSimulator Simulator { get; }

    public IReadOnlyList<Body> Bodies => _bodies;

    /// <summary>
    /// All places, turned back to the size of scale 1, which is exact, and all angles and velocities. Velocities that die away end below
    /// the smallest normal number, 1.2e-38, where bits are lost and how many depends on the scale: up to 2^30 times that they are 0.
    /// </summary>
    public double[] State()
    {
        var state = new List<double>();
        foreach (Body body in _bodies)
        {
            state.Add(body.PositionX / _scale);
            state.Add(body.PositionY / _scale);
            state.Add(body.TotalRotation);
            state.Add(Speed(body.LinearVelocity.X / _scale));
            state.Add(Speed(body.LinearVelocity.Y / _scale));
            state.Add(Speed(body.AngularVelocity));
        }

        return state.ToArray();
    }

    private static double Speed(float value) => Math.Abs(value) < 1e-29f ? 0 : value;

    private Geom Shape(int kind, float size)
    {
        size *= _scale;
        BodyFactory bodies = BodyFactory.Instance;
        GeomFactory geoms = GeomFactory.Instance;
        switch (kind)
        {
            case 0:
                return geoms.CreateRectangleGeom(
                    Simulator, bodies.CreateRectangleBody(Simulator, 2 * size, size, 1), 2 * size, size, 0.25f * size);
            case 1:
                return geoms.CreateCircleGeom(Simulator, bodies.CreateCircleBody(Simulator, size, 2), size, 12, 0.25f * size);
            case 2:
                return geoms.CreateEllipseGeom(
                    Simulator, bodies.CreateEllipseBody(Simulator, size, size / 2, 1), size, size / 2, 10, 0.25f * size);
            case 3:
                Vertices outline =
                    Sandbox.Outline(0, 0, 2 * size, 0, 2 * size, size / 2, size / 2, size / 2, size / 2, 2 * size, 0, 2 * size);
                return geoms.CreatePolygonGeom(Simulator, bodies.CreatePolygonBody(Simulator, outline, 1.5f), outline, 0.25f * size);
            case 4:
                Body rod = bodies.CreateRectangleBody(Simulator, 3 * size, size, 1);
                return geoms.CreateCapsuleGeom(Simulator, rod, new Vector2(-size, 0), new Vector2(size, 0), size / 2);
            default:
                Body dumbbell = bodies.CreateRectangleBody(Simulator, 2 * size, size, 1);
                geoms.CreateCircleGeom(Simulator, dumbbell, size / 2, 8, new Vector2(-size, 0), 0);
                return geoms.CreateRectangleGeom(Simulator, dumbbell, size, size, new Vector2(size, 0), 0.5f);
        }
    }

    private void Wall(Vector2 place, float width, float height)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(Simulator, _scale * width, _scale * height, 1);
        body.Position = _scale * place;
        body.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(Simulator, body, _scale * width, _scale * height);
    }
}
