using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Springs that share bodies move them as their equations say, at any stiffness, and keep their energy.</summary>
public class SpringMeshTests
{
    private const float Dt = 1 / 60f;

    /// <summary>Masses of 1 between two walls: mode j swings at 2·√k·sin(jπ/2(n + 1)), with the shape of a sine.</summary>
    [Theory]
    [InlineData(1e2, 1)]
    [InlineData(1e2, 10)]
    [InlineData(1e2, 20)]
    [InlineData(1e4, 1)]
    [InlineData(1e4, 10)]
    [InlineData(1e4, 20)]
    [InlineData(1e6, 1)]
    [InlineData(1e6, 10)]
    [InlineData(1e6, 20)]
    public void ModeOfARow_AtAnyStiffness_KeepsAmplitudeAndFrequency(double k, int mode)
    {
        const int Count = 20;
        const double Amplitude = 0.1;
        var simulator = new PhysicsSimulator(Vector2.Zero);
        var bodies = new Body[Count + 2];
        for (int i = 0; i <= Count + 1; i++)
        {
            bodies[i] = Ball(simulator, i, 0, 1);
            bodies[i].IsStatic = i == 0 || i == Count + 1;
            if (i > 0)
            {
                simulator.Add(new LinearSpring(bodies[i - 1], Vector2.Zero, bodies[i], Vector2.Zero, (float)k, 0));
            }
        }

        double shape = mode * Math.PI / (Count + 1);
        double omega = 2 * Math.Sqrt(k) * Math.Sin(shape / 2);
        for (int i = 1; i <= Count; i++)
        {
            bodies[i].LinearVelocity = new Vector2((float)(Amplitude * omega * Math.Sin(shape * i)), 0);
        }

        // Ten periods, and steps enough to tell amplitude and phase where a step spans several. At the end both parts of the swing are
        // fitted: x = p·sin ωt + q·cos ωt, p = 1 - the loss, q = the phase.
        int steps = Math.Max(30, (int)Math.Ceiling(20 * Math.PI / omega / Dt));
        double ss = 0;
        double sc = 0;
        double cc = 0;
        double xs = 0;
        double xc = 0;
        for (int step = 1; step <= steps; step++)
        {
            simulator.Update(Dt);
            if (step > steps - 20)
            {
                double x = 0;
                for (int i = 1; i <= Count; i++)
                {
                    x += (bodies[i].PositionX - i) * Math.Sin(shape * i) * 2 / (Count + 1) / Amplitude;
                }

                double sin = Math.Sin(omega * step * (double)Dt);
                double cos = Math.Cos(omega * step * (double)Dt);
                ss += sin * sin;
                sc += sin * cos;
                cc += cos * cos;
                xs += x * sin;
                xc += x * cos;
            }
        }

        double determinant = (ss * cc) - (sc * sc);
        double p = ((xs * cc) - (xc * sc)) / determinant;
        double q = ((xc * ss) - (xs * sc)) / determinant;
        double phase = Math.Atan2(q, p);

        // A hundredth of the amplitude; and of the frequency less than a thousandth, taken over all the time: so the phase does not go
        // round.
        Assert.InRange(Math.Sqrt((p * p) + (q * q)), 0.99, 1.01);
        Assert.InRange(Math.Abs(phase) / (omega * steps * Dt), 0, 3e-4);
    }

    /// <summary>
    /// Rows, grids and triangles of 3 to 60 masses, stiffness over six decades, some damped, some hung, some beside the centres.
    /// </summary>
    [Fact]
    public void RandomMesh_OverAFewSteps_GoesTheWayOfAThousandTimesFinerSteps()
    {
        const int Steps = 12;
        for (int seed = 0; seed < 120; seed++)
        {
            var mesh = new RandomMesh(seed, seed % 2 == 0);
            double[] fine = mesh.Reference(Steps, 1000);
            double size = 0;
            double off = 0;
            for (int step = 0; step < Steps; step++)
            {
                mesh.Simulator.Update(Dt);
            }

            for (int i = 0; i < mesh.Bodies.Count; i++)
            {
                double x = fine[3 * i];
                double y = fine[(3 * i) + 1];
                Vector2 p = mesh.Bodies[i].Position;
                off = Math.Max(off, Math.Sqrt(((p.X - x) * (p.X - x)) + ((p.Y - y) * (p.Y - y))));
                Vector2 start = mesh.Starts[i];
                size = Math.Max(size, Math.Sqrt(((start.X - x) * (start.X - x)) + ((start.Y - y) * (start.Y - y))));
            }

            // A thousandth of the longest way: what the fastest swings are off in phase, at the small share that they have of it.
            Assert.True(off <= 1e-3 * size, $"seed {seed}: {off} of {size}");
        }
    }

    [Fact]
    public void RandomMesh_Undamped_NeverGainsEnergy()
    {
        for (int seed = 0; seed < 120; seed++)
        {
            var mesh = new RandomMesh(seed, false);
            double before = mesh.Energy();
            double scale = mesh.Moving();
            double most = before;
            for (int step = 0; step < 300; step++)
            {
                mesh.Simulator.Update(Dt);
                most = Math.Max(most, mesh.Energy());
                scale = Math.Max(scale, mesh.Moving());
            }

            // A thousandth of what moves, be it that the mesh falls by metres on weak springs.
            Assert.True(most - before <= 1e-3 * scale, $"seed {seed}: {(most - before) / scale}");
        }
    }

    /// <summary>Angle springs in a row: twists go along it with modes of their own, and each body's spin is damped by what it is.</summary>
    [Theory]
    [InlineData(10, 0)]
    [InlineData(1e3, 0)]
    [InlineData(1e5, 0)]
    [InlineData(1e3, 4)]
    [InlineData(1e5, 4)]
    public void ModeOfARowOfAngleSprings_SwingsAndFadesAsItsConstantsSay(double k, double damping)
    {
        const int Count = 8;
        const int Mode = 3;
        var simulator = new PhysicsSimulator(Vector2.Zero);
        var bodies = new Body[Count + 2];
        for (int i = 0; i <= Count + 1; i++)
        {
            bodies[i] = Ball(simulator, i, 0, 1);
            bodies[i].MomentOfInertia = 2;
            bodies[i].IsStatic = i == 0 || i == Count + 1;
            if (i > 0)
            {
                simulator.Add(new AngleSpring(bodies[i - 1], bodies[i], (float)k, (float)(damping / 2)));
            }
        }

        // Each body has a spring on both sides: damping c/2 twice on an inertia of 2 decays by c/4.
        double shape = Mode * Math.PI / (Count + 1);
        double natural = 2 * Math.Sqrt(k / 2) * Math.Sin(shape / 2);
        double decay = damping / 4;
        double omega = Math.Sqrt((natural * natural) - (decay * decay));
        for (int i = 1; i <= Count; i++)
        {
            bodies[i].AngularVelocity = (float)(0.2 * omega * Math.Sin(shape * i));
        }

        for (int step = 1; step <= 30; step++)
        {
            simulator.Update(Dt);
            double time = step * (double)Dt;
            double swing = 0.2 * Math.Exp(-decay * time) * Math.Sin(omega * time);
            for (int i = 1; i <= Count; i++)
            {
                // A thousandth of the amplitude, which holds what 400 radians of phase and the floats of the velocities add up to.
                Assert.Equal(swing * Math.Sin(shape * i), bodies[i].TotalRotation, 2e-4);
            }
        }
    }

    /// <summary>
    /// A spring that is alone but pulls beside the centre of its body, whatever its stiffness: the sag of the body below its anchor.
    /// </summary>
    [Theory]
    [InlineData(1e2f)]
    [InlineData(1e4f)]
    [InlineData(1e6f)]
    public void BodyHungBesideItsCentre_RestsWhereTheForcesBalance(float k)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10));
        Body body = Ball(simulator, 0, 0, 1);
        body.MomentOfInertia = 0.5f;
        simulator.Add(new FixedLinearSpring(body, new Vector2(0, 0.5f), new Vector2(0, 2), k, 2 * MathF.Sqrt(k)));
        for (int step = 0; step < 600; step++)
        {
            simulator.Update(Dt);
        }

        // A ten-thousandth of the sag, and a float's rounding at 2.
        Assert.Equal(-10 / k, body.Position.Y, (1e-3 / k) + 1e-6);
    }

    private static Body Ball(PhysicsSimulator simulator, float x, float y, float mass)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, 0.1f, mass);
        body.Position = new Vector2(x, y);
        Sandbox.WithoutDrag(body);
        return body;
    }

    private sealed class RandomMesh
    {
        private readonly List<(int A, int B, Vector2 ArmA, Vector2 ArmB, double K, double C, double Slack)> _springs = new();
        private readonly double _gravity;

        public RandomMesh(int seed, bool damped)
        {
            var random = new Random(seed);
            _gravity = seed % 3 == 0 ? 10 : 0;
            bool arms = seed % 5 == 0;
            Simulator = new PhysicsSimulator(new Vector2(0, (float)-_gravity));
            int count = random.Next(3, 61);
            bool row = seed % 4 == 0;
            int wide = random.Next(2, 9);
            double decades = 6 * random.NextDouble();
            for (int i = 0; i < count; i++)
            {
                Vector2 place = new Vector2(i % wide, -(i / wide)) + (0.2f * Vector(random));
                Body body = Ball(Simulator, place.X, place.Y, (float)Math.Exp((2 * random.NextDouble()) - 1));
                body.MomentOfInertia = 0.1f * body.Mass;
                body.LinearVelocity = Vector(random);
                body.AngularVelocity = Vector(random).X;
                body.IsStatic = i == 0 && _gravity > 0;
                if (body.IsStatic)
                {
                    body.LinearVelocity = Vector2.Zero;
                    body.AngularVelocity = 0;
                }

                Bodies.Add(body);
                Starts.Add(body.Position);
                if (i % wide > 0 || (row && i > 0))
                {
                    Tie(random, i - 1, i, decades, damped, arms);
                }

                if (i >= wide && !row)
                {
                    Tie(random, i - wide, i, decades, damped, arms);
                    if (i % wide > 0 && seed % 2 == 0)
                    {
                        Tie(random, i - wide - 1, i, decades, damped, arms);
                    }
                }
            }
        }

        public PhysicsSimulator Simulator { get; }

        public List<Body> Bodies { get; } = new();

        public List<Vector2> Starts { get; } = new();

        public double Moving()
        {
            double sum = 0;
            foreach (Body body in Bodies)
            {
                double spin = body.AngularVelocity;
                double speed = body.LinearVelocity.Length();
                sum += body.IsStatic ? 0 : 0.5 * ((body.Mass * speed * speed) + (body.MomentOfInertia * spin * spin));
            }

            return sum;
        }

        public double Energy()
        {
            double sum = Moving();
            foreach (Body body in Bodies)
            {
                sum += body.IsStatic ? 0 : body.Mass * _gravity * body.Position.Y;
            }

            foreach (var spring in _springs)
            {
                double stretch = Distance(spring) - spring.Slack;
                sum += 0.5 * spring.K * stretch * stretch;
            }

            return sum;
        }

        /// <summary>Places and angles after so many steps, each by so many of the fourth-order Runge-Kutta method.</summary>
        public double[] Reference(int steps, int finer)
        {
            int size = 3 * Bodies.Count;
            double[] x = new double[size];
            double[] v = new double[size];
            double[][] k = new double[4][];
            double[][] l = new double[4][];
            for (int i = 0; i < Bodies.Count; i++)
            {
                x[3 * i] = Bodies[i].Position.X;
                x[(3 * i) + 1] = Bodies[i].Position.Y;
                x[(3 * i) + 2] = Bodies[i].TotalRotation;
                v[3 * i] = Bodies[i].LinearVelocity.X;
                v[(3 * i) + 1] = Bodies[i].LinearVelocity.Y;
                v[(3 * i) + 2] = Bodies[i].AngularVelocity;
            }

            for (int s = 0; s < 4; s++)
            {
                k[s] = new double[size];
                l[s] = new double[size];
            }

            double h = (double)Dt / finer;
            double[] y = new double[size];
            double[] w = new double[size];
            double[] share = { 0, 0.5, 0.5, 1 };
            for (int step = 0; step < steps * finer; step++)
            {
                for (int s = 0; s < 4; s++)
                {
                    for (int i = 0; i < size; i++)
                    {
                        y[i] = x[i] + (s > 0 ? share[s] * h * k[s - 1][i] : 0);
                        w[i] = v[i] + (s > 0 ? share[s] * h * l[s - 1][i] : 0);
                        k[s][i] = w[i];
                    }

                    Accelerate(y, w, l[s]);
                }

                for (int i = 0; i < size; i++)
                {
                    x[i] += h / 6 * (k[0][i] + (2 * k[1][i]) + (2 * k[2][i]) + k[3][i]);
                    v[i] += h / 6 * (l[0][i] + (2 * l[1][i]) + (2 * l[2][i]) + l[3][i]);
                }
            }

            return x;
        }

        private static Vector2 Vector(Random random) =>
            new Vector2((float)((2 * random.NextDouble()) - 1), (float)((2 * random.NextDouble()) - 1));

        private void Tie(Random random, int a, int b, double decades, bool damped, bool arms)
        {
            double k = Math.Pow(10, decades * random.NextDouble());
            double c = damped ? 0.5 * Math.Sqrt(k) * random.NextDouble() : 0;
            Vector2 armA = arms ? 0.2f * Vector(random) : Vector2.Zero;
            Vector2 armB = arms ? 0.2f * Vector(random) : Vector2.Zero;
            var spring = new LinearSpring(Bodies[a], armA, Bodies[b], armB, (float)k, (float)c);
            Simulator.Add(spring);
            _springs.Add((a, b, armA, armB, (float)k, (float)c, spring.RestLength));
        }

        private double Distance((int A, int B, Vector2 ArmA, Vector2 ArmB, double K, double C, double Slack) spring)
        {
            Vector2 a = Bodies[spring.A].GetWorldPosition(spring.ArmA);
            Vector2 b = Bodies[spring.B].GetWorldPosition(spring.ArmB);
            return Math.Sqrt((((double)b.X - a.X) * ((double)b.X - a.X)) + (((double)b.Y - a.Y) * ((double)b.Y - a.Y)));
        }

        private void Accelerate(double[] x, double[] v, double[] into)
        {
            for (int i = 0; i < Bodies.Count; i++)
            {
                into[3 * i] = 0;
                into[(3 * i) + 1] = -_gravity * Bodies[i].Mass;
                into[(3 * i) + 2] = 0;
            }

            foreach (var spring in _springs)
            {
                int a = 3 * spring.A;
                int b = 3 * spring.B;
                Arm(x[a + 2], spring.ArmA, out double ax, out double ay);
                Arm(x[b + 2], spring.ArmB, out double bx, out double by);
                double dx = x[b] + bx - x[a] - ax;
                double dy = x[b + 1] + by - x[a + 1] - ay;
                double length = Math.Sqrt((dx * dx) + (dy * dy));
                dx /= length;
                dy /= length;
                double across = v[b] - (v[b + 2] * by) - v[a] + (v[a + 2] * ay);
                double up = v[b + 1] + (v[b + 2] * bx) - v[a + 1] - (v[a + 2] * ax);
                double speed = (dx * across) + (dy * up);
                double pull = (spring.K * (length - spring.Slack)) + (spring.C * speed);
                into[a] += pull * dx;
                into[a + 1] += pull * dy;
                into[a + 2] += pull * ((ax * dy) - (ay * dx));
                into[b] -= pull * dx;
                into[b + 1] -= pull * dy;
                into[b + 2] -= pull * ((bx * dy) - (by * dx));
            }

            for (int i = 0; i < Bodies.Count; i++)
            {
                bool moves = !Bodies[i].IsStatic;
                into[3 * i] = moves ? into[3 * i] / Bodies[i].Mass : 0;
                into[(3 * i) + 1] = moves ? into[(3 * i) + 1] / Bodies[i].Mass : 0;
                into[(3 * i) + 2] = moves ? into[(3 * i) + 2] / Bodies[i].MomentOfInertia : 0;
            }
        }

        private static void Arm(double angle, Vector2 arm, out double x, out double y)
        {
            double sin = Math.Sin(angle);
            double cos = Math.Cos(angle);
            x = (cos * arm.X) - (sin * arm.Y);
            y = (sin * arm.X) + (cos * arm.Y);
        }
    }
}
