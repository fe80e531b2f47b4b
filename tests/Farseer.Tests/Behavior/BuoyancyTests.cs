using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Lift is the weight of what is displaced, at its centroid: Archimedes, for every shape and every surface.</summary>
public class BuoyancyTests
{
    private const int Surveyed = 200;

    /// <summary>Corners of the polygon that stands for a circle here: its area is off by a millionth.</summary>
    private const int RoundCorners = 4096;

    [Fact]
    public void Box_LyingFlat_FloatsAsDeepAsItsDensitySays()
    {
        var random = new Random(1);
        for (int i = 0; i < Surveyed; i++)
        {
            float scale = MathF.Pow(10, (float)random.NextDouble() * 3 - 1);
            float height = scale * (0.5f + (float)random.NextDouble());
            float width = height * (2 + (3 * (float)random.NextDouble()));
            float ratio = 0.05f + (0.9f * (float)random.NextDouble());
            float depth = Settle(
                ratio,
                width * height,
                (simulator, mass) => BodyFactory.Instance.CreateRectangleBody(simulator, width, height, mass),
                (simulator, body) => GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height),
                height,
                width,
                out float speed);
            Assert.Equal(ratio * height, depth, 1e-3f * height);
            Assert.True(speed < 1e-3f * height, $"{i}: still at {speed / height} heights a second");
        }
    }

    [Fact]
    public void Circle_FloatsAsDeepAsTheSegmentSays()
    {
        var random = new Random(2);
        for (int i = 0; i < Surveyed; i++)
        {
            float radius = MathF.Pow(10, (float)random.NextDouble() * 3 - 1);
            float ratio = 0.05f + (0.9f * (float)random.NextDouble());
            int edges = random.Next(3, 40);
            float depth = Settle(
                ratio,
                MathF.PI * radius * radius,
                (simulator, mass) => BodyFactory.Instance.CreateCircleBody(simulator, radius, mass),
                (simulator, body) => GeomFactory.Instance.CreateCircleGeom(simulator, body, radius, edges),
                2 * radius,
                2 * radius,
                out _);

            // (θ − sin θ) / 2π is the share of a segment of the angle θ; it rises with θ.
            double low = 0;
            double high = 2 * Math.PI;
            for (int k = 0; k < 60; k++)
            {
                double middle = (low + high) / 2;
                (low, high) = middle - Math.Sin(middle) < 2 * Math.PI * ratio ? (middle, high) : (low, middle);
            }

            Assert.Equal(radius * (1 - Math.Cos(low / 2)), depth, 1e-3 * radius);
        }
    }

    [Fact]
    public void TiltedBox_IsRightedByTheMomentOfItsWallSides()
    {
        var random = new Random(3);
        for (int i = 0; i < Surveyed; i++)
        {
            double height = 1 + random.NextDouble();
            double width = height * (0.5 + (3 * random.NextDouble()));
            double draft = height * (0.2 + (0.6 * random.NextDouble()));

            // No corner comes out of the water, none goes in.
            double most = 0.95 * 2 * Math.Min(draft, height - draft) / width;
            double tangent = most * ((2 * random.NextDouble()) - 1);
            double tilt = Math.Atan(tangent);
            var simulator = new PhysicsSimulator(Vector2.Zero);
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, (float)width, (float)height, 1);
            Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, body, (float)width, (float)height);
            Water(simulator, new AABBFluidContainer(new AABB(new Vector2(-100, 0), new Vector2(100, 100))), 1, 10, 0, geom);

            // The point of its axis at the waterline is in the surface.
            double below = draft - (height / 2);
            body.Position = new Vector2((float)(-below * Math.Sin(tilt)), (float)(below * Math.Cos(tilt)));
            body.Rotation = (float)tilt;
            const float Dt = 1e-3f;
            simulator.Update(Dt);

            // GZ = sin φ (GM + BM tan² φ / 2), BM = w³ / 12 over the area.
            double area = width * draft;
            double metacentre = width * width * width / (12 * area);
            double arm = Math.Sin(tilt) * ((draft / 2) + metacentre - (height / 2) + (0.5 * metacentre * tangent * tangent));
            double torque = body.AngularVelocity * (double)body.MomentOfInertia / Dt;
            Assert.Equal(-10 * area * arm, torque, 1e-4 * 10 * area * width);
            Assert.Equal(-10 * area, body.LinearVelocity.Y / (double)Dt, 1e-4 * 10 * area);
        }
    }

    [Fact]
    public void AnyShapeInAnyFluid_IsLiftedByTheIntersection()
    {
        var random = new Random(4);
        for (int i = 0; i < 3 * Surveyed; i++)
        {
            var simulator = new PhysicsSimulator(Vector2.Zero);
            var body = BodyFactory.Instance.CreateBody(simulator, 1, 1);
            body.LinearDragCoefficient = 0;
            body.RotationalDragCoefficient = 0;
            Geom geom = Shape(random, simulator, body, out List<Vector2> outline);
            body.Position = new Vector2((8 * (float)random.NextDouble()) - 4, (8 * (float)random.NextDouble()) - 4);
            body.Rotation = 6 * (float)random.NextDouble();
            IFluidContainer container = i % 2 == 0 ? Pool(random, out List<double[]> parts) : Wave(random, out parts);
            Water(simulator, container, 1, 1, 0, geom);
            double cos = Math.Cos(body.Rotation);
            double sin = Math.Sin(body.Rotation);
            double whole = 0;
            double area = 0;
            double torque = 0;
            var world = new List<double[]>();
            foreach (Vector2 p in outline)
            {
                world.Add([body.Position.X + (cos * p.X) - (sin * p.Y), body.Position.Y + (sin * p.X) + (cos * p.Y)]);
            }

            Measure(world, ref whole, body.Position.X, out _);
            foreach (double[] part in parts)
            {
                List<double[]> inside = Cut(world, -1, 0, -part[0]);
                inside = Cut(inside, 1, 0, part[1]);
                inside = Cut(inside, 0, 1, part[2]);
                double slope = (part[4] - part[3]) / (part[1] - part[0]);
                inside = Cut(inside, slope, -1, (slope * part[0]) - part[3]);
                Measure(inside, ref area, body.Position.X, out double moment);
                torque -= moment;
            }

            const float Dt = 1e-3f;
            simulator.Update(Dt);

            // A float has seven digits, the polygon of a circle here as many.
            string what = $"{i}: {geom.LocalVertices.Count} vertices, {area} of {whole}";
            Assert.True(Math.Abs((-body.LinearVelocity.Y / Dt) - area) < 1e-5 * whole, what + $", lift {-body.LinearVelocity.Y / Dt}");
            Assert.True(
                Math.Abs((body.AngularVelocity / Dt) - torque) < 3e-5 * whole * 3,
                what + $", torque {body.AngularVelocity / Dt}, not {torque}");
        }
    }

    [Fact]
    public void ContainerOfOnesOwn_CutsStraightSurfacesExactly()
    {
        var random = new Random(5);
        for (int i = 0; i < Surveyed; i++)
        {
            float level = (2 * (float)random.NextDouble()) - 1;
            float turn = 6 * (float)random.NextDouble();
            Assert.Equal(
                Lift(new Deep(level), turn),
                Lift(new AABBFluidContainer(new AABB(new Vector2(-50, level), new Vector2(50, 50))), turn),
                1e-4f);
        }

        static float Lift(IFluidContainer container, float turn)
        {
            var simulator = new PhysicsSimulator(Vector2.Zero);
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 3, 1, 1);
            body.Rotation = turn;
            Geom geom = GeomFactory.Instance.CreateCapsuleGeom(simulator, body, new Vector2(-1, 0), new Vector2(1, 0), 0.5f);
            Water(simulator, container, 1, 1, 0, geom);
            simulator.Update(1e-3f);
            return body.LinearVelocity.Y * 1000;
        }
    }

    private static float Settle(
        float ratio,
        float area,
        Func<PhysicsSimulator, float, Body> makeBody,
        Func<PhysicsSimulator, Body, Geom> makeGeom,
        float height,
        float width,
        out float speed)
    {
        // Gravity such that it bobs about once a second; drag that takes away some two thirds of the speed in as long.
        float gravity = 40 * height * ratio;
        var simulator = new PhysicsSimulator(new Vector2(0, gravity));
        Body body = makeBody(simulator, ratio * area);
        Geom geom = makeGeom(simulator, body);
        Water(
            simulator,
            new AABBFluidContainer(new AABB(new Vector2(-20 * width, 0), new Vector2(20 * width, 20 * height))),
            1,
            gravity,
            4 / (width * ratio),
            geom);
        body.Position = new Vector2(0, 0.3f * height);
        for (int step = 0; step < 1200; step++)
        {
            simulator.Update(1 / 60f);
        }

        speed = body.LinearVelocity.Length();
        return body.Position.Y + (height / 2);
    }

    private static void Water(PhysicsSimulator simulator, IFluidContainer container, float density, float gravity, float drag, Geom geom)
    {
        var water = new FluidDragController();
        water.Initialize(container, density, drag, 0, new Vector2(0, gravity));
        water.AddGeom(geom);
        simulator.Add(water);
    }

    /// <summary>A geom, and its outline as a polygon of many corners in body coordinates.</summary>
    private static Geom Shape(Random random, PhysicsSimulator simulator, Body body, out List<Vector2> outline)
    {
        outline = [];
        float radius = 0.5f + (2 * (float)random.NextDouble());
        float length = 3 * (float)random.NextDouble();
        switch (random.Next(5))
        {
            case 0:
                float width = 0.2f + length;
                outline.AddRange([new(-width / 2, -radius), new(width / 2, -radius), new(width / 2, radius), new(-width / 2, radius)]);
                return GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, 2 * radius);
            case 1:
                AddRound(outline, default, radius, 0, 2 * Math.PI);
                return GeomFactory.Instance.CreateCircleGeom(simulator, body, radius, random.Next(3, 30));
            case 2:
                AddRound(outline, new Vector2(length, 0), radius, -Math.PI / 2, Math.PI / 2);
                AddRound(outline, new Vector2(-length, 0), radius, Math.PI / 2, 3 * Math.PI / 2);
                return GeomFactory.Instance.CreateCapsuleGeom(simulator, body, new Vector2(-length, 0), new Vector2(length, 0), radius);
            case 3:
                Star(random, outline);
                return new Geom(body, new Vertices(outline.ToArray()), 0).AddedTo(simulator);
            default:
                Star(random, outline);
                return GeomFactory.Instance.CreateChainGeom(simulator, body, new Vertices(outline.ToArray()), true);
        }
    }

    private static void Star(Random random, List<Vector2> outline)
    {
        int corners = random.Next(3, 12);
        for (int k = 0; k < corners; k++)
        {
            double angle = 2 * Math.PI * k / corners;
            double reach = 0.5 + (2.5 * random.NextDouble());
            outline.Add(new Vector2((float)(reach * Math.Cos(angle)), (float)(reach * Math.Sin(angle))));
        }
    }

    private static void AddRound(List<Vector2> outline, Vector2 centre, float radius, double from, double to)
    {
        for (int k = 0; k <= RoundCorners; k++)
        {
            double angle = from + ((to - from) * k / RoundCorners);
            outline.Add(centre + new Vector2((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle))));
        }
    }

    /// <summary>Parts are left, right, bottom, and the height of the surface at both ends.</summary>
    private static IFluidContainer Pool(Random random, out List<double[]> parts)
    {
        var min = new Vector2(-6 + (6 * (float)random.NextDouble()), -3 + (4 * (float)random.NextDouble()));
        Vector2 max = min + new Vector2(1 + (10 * (float)random.NextDouble()), 1 + (10 * (float)random.NextDouble()));
        parts = [[min.X, max.X, max.Y, min.Y, min.Y]];
        return new AABBFluidContainer(new AABB(min, max));
    }

    private static IFluidContainer Wave(Random random, out List<double[]> parts)
    {
        var wave = new WaveController
        {
            Position = new Vector2(-5 + (float)random.NextDouble(), -2 + (3 * (float)random.NextDouble())),
            Width = 4 + (8 * (float)random.NextDouble()),
            Height = 2 + (6 * (float)random.NextDouble()),
            NodeCount = random.Next(2, 20),
        };
        wave.Initialize();
        for (int k = 0; k < wave.NodeCount; k++)
        {
            wave.Disturb(k, (2 * (float)random.NextDouble()) - 1);
        }

        parts = [];
        for (int k = 0; k + 1 < wave.NodeCount; k++)
        {
            parts.Add([
                wave.XPosition![k], wave.XPosition[k + 1], wave.Position.Y + wave.Height,
                wave.Position.Y + wave.CurrentWave![k], wave.Position.Y + wave.CurrentWave[k + 1]]);
        }

        return wave;
    }

    private static List<double[]> Cut(List<double[]> polygon, double x, double y, double distance)
    {
        List<double[]> inside = [];
        for (int k = 0; k < polygon.Count; k++)
        {
            double[] a = polygon[k];
            double[] b = polygon[(k + 1) % polygon.Count];
            double da = (x * a[0]) + (y * a[1]) - distance;
            double db = (x * b[0]) + (y * b[1]) - distance;
            if (da <= 0)
            {
                inside.Add(a);
            }

            if ((da <= 0) != (db <= 0))
            {
                double t = da / (da - db);
                inside.Add([a[0] + (t * (b[0] - a[0])), a[1] + (t * (b[1] - a[1]))]);
            }
        }

        return inside;
    }

    /// <summary>Adds the area of a polygon, and tells its moment about an upright line.</summary>
    private static void Measure(List<double[]> polygon, ref double area, double x, out double moment)
    {
        moment = 0;
        for (int k = 0; k < polygon.Count; k++)
        {
            double[] a = polygon[k];
            double[] b = polygon[(k + 1) % polygon.Count];
            double triangle = 0.5 * (((a[0] - x) * b[1]) - ((b[0] - x) * a[1]));
            area += triangle;
            moment += triangle * (a[0] + b[0] - (2 * x)) / 3;
        }
    }

    /// <summary>All below a level, known by its points alone.</summary>
    private sealed class Deep(float level) : IFluidContainer
    {
        public bool Intersect(AABB aabb) => aabb.Max.Y >= level;

        public bool Contains(ref Vector2 vector) => vector.Y >= level;
    }
}

file static class GeomAdding
{
    public static Geom AddedTo(this Geom geom, PhysicsSimulator simulator)
    {
        simulator.Add(geom);
        return geom;
    }
}
