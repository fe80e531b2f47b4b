using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>
/// What a joint wishes for is where a contact does not let the body go: the contact holds, whatever the force, the dials and the masses,
/// and what the two do to each other ends with the joint.
/// </summary>
public class ContactsBeforeWishesTests
{
    private const float Face = 4.5f;
    private const float Beyond = 9;
    private static readonly float[] Forces = { 15, 50, 100, 300, 1000, 1e4f, 1e6f, 1e12f, 1e25f, float.MaxValue };
    private static readonly float[] Thicknesses = { 0.02f, 0.05f, 0.2f, 1 };
    private static readonly int[] Iterations = { 1, 2, 3, 5, 8, 10, 15, 20, 40 };
    private static readonly int[] Rates = { 30, 60, 120, 240 };

    /// <summary>What holds the body's wish.</summary>
    public enum Wish
    {
        Target,
        TargetBesideASpring,
        Motor,
        RopeToWhatIsDrawn,
        SliderToWhatIsDrawn,
        Spring,
        Force,
    }

    /// <summary>What is in the way.</summary>
    public enum Way
    {
        Wall,
        KinematicWall,
        Corner,
        BoxAtAWall,
    }

    [Theory]
    [InlineData(Wish.Target, Way.Wall, 60)]
    [InlineData(Wish.Target, Way.KinematicWall, 40)]
    [InlineData(Wish.Target, Way.Corner, 60)]
    [InlineData(Wish.Target, Way.BoxAtAWall, 60)]
    [InlineData(Wish.TargetBesideASpring, Way.Wall, 40)]
    [InlineData(Wish.Motor, Way.Wall, 60)]
    [InlineData(Wish.Motor, Way.Corner, 40)]
    [InlineData(Wish.Motor, Way.BoxAtAWall, 40)]
    [InlineData(Wish.RopeToWhatIsDrawn, Way.Wall, 30)]
    [InlineData(Wish.SliderToWhatIsDrawn, Way.Wall, 30)]
    [InlineData(Wish.Spring, Way.Wall, 30)]
    [InlineData(Wish.Force, Way.Wall, 30)]
    public void Body_DrawnBeyondWhatIsInItsWay_StaysBeforeIt(Wish wish, Way way, int seeds)
    {
        int whole = 0;
        for (int seed = 0; seed < seeds; seed++)
        {
            using Scene scene = new(wish, way, seed);
            float most = 0;
            int last = 0;
            for (int i = 0; i < scene.Steps && !scene.IsFast; i++)
            {
                last = i;
                scene.Step(swings: seed % 4 == 3 && i > scene.Steps / 2 ? 1 + (seed % 7) : 0, i);
                Assert.True(float.IsFinite(scene.Body.Position.X), $"{scene}: not finite in step {i}");
                most = Math.Max(most, scene.Body.Position.X);
            }

            // What comes to a surface faster than a contact sees it coming is for continuous collision to see to.
            whole += last == scene.Steps - 1 ? 1 : 0;

            // A body is through when its middle is behind the face, or behind the box that stands before it.
            Assert.True(most < Face, $"{scene}: came to {most}");
            Assert.True(scene.Between == null || scene.Body.Position.X < scene.Between.Position.X, $"{scene}: past the box");
            Assert.Equal(0, scene.Quarantined);
        }

        Assert.True(whole > seeds / 4, $"only {whole} of {seeds} to the end");
    }

    /// <summary>
    /// The joint gives a substep no more than F·h/m; what the contacts hold against that is as much, and until they have found that it is
    /// gone they may give it back, once for each of the two surfaces that press.
    /// </summary>
    [Theory]
    [InlineData(Wish.Target, Way.Wall)]
    [InlineData(Wish.Target, Way.Corner)]
    [InlineData(Wish.Motor, Way.Wall)]
    [InlineData(Wish.Motor, Way.Corner)]
    public void Body_LetGoOf_DoesNotFlyOff(Wish wish, Way way)
    {
        for (int seed = 0; seed < 40; seed++)
        {
            using Scene scene = new(wish, way, seed);
            for (int i = 0; i < scene.Steps; i++)
            {
                scene.Step(0, i);
            }

            float before = scene.Body.LinearVelocity.Length();
            scene.LetGo();
            scene.Simulator.Update(scene.Dt);
            float most = before + (2 * scene.MostOfASubstep) + (11 * scene.Dt);
            Assert.True(scene.Body.LinearVelocity.Length() < most, $"{scene}: {scene.Body.LinearVelocity} of {most}");
        }
    }

    /// <summary>A hundred newtons on a kilogram against a wall: no deeper than the weight of ten such would press it.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(5)]
    [InlineData(20)]
    public void Box_DrawnAgainstAWall_RestsAtItsFace(int iterations)
    {
        using PhysicsSimulator simulator = new(new Vector2(0, -10)) { AllowedPenetration = 0.001f, Iterations = iterations };
        Scene.Box(simulator, 0, -0.5f, 40, 1, 1).IsStatic = true;
        Scene.Box(simulator, 5, 2, 1, 6, 1).IsStatic = true;
        Body box = Scene.Box(simulator, 0, 0.5f, 1, 1, 1);
        TargetJoint drag = new(box, box.Position) { MaxForce = 100, Target = new Vector2(Beyond, 0.6f) };
        simulator.Add(drag);
        Sandbox.Run(simulator, 600, 1 / 60f);
        Assert.InRange(box.Position.X, 3.99f, 4.01f);
        Assert.InRange(box.LinearVelocity.Length(), 0, 1e-3f);
        simulator.Remove(drag);
        Sandbox.Run(simulator, 60, 1 / 60f);
        Assert.InRange(box.Position.X, 3.9f, 4.01f);
    }

    private sealed class Scene : IDisposable
    {
        private readonly Random _random;
        private readonly Wish _wish;
        private readonly Way _way;
        private readonly int _seed;
        private readonly float _force;
        private readonly float _mass;
        private readonly float _thickness;
        private readonly int _kind;
        private readonly Vector2 _target;
        private readonly Body _end;
        private readonly Joint? _joint;

        public Scene(Wish wish, Way way, int seed)
        {
            _random = new Random((7919 * (int)wish) + (104729 * (int)way) + seed);
            _wish = wish;
            _way = way;
            _seed = seed;
            Dt = 1f / Pick(Rates);
            _force = Pick(Forces);
            _mass = Pick(new[] { 0.1f, 1, 10, 100 });
            _thickness = Pick(Thicknesses);
            _kind = _random.Next(4);
            Simulator = new PhysicsSimulator(new Vector2(0, _random.Next(4) > 0 ? -10 : 0))
            {
                AllowedPenetration = Pick(new[] { 0.001f, 0.005f }),
                Iterations = Pick(Iterations),
            };
            Simulator.BodyQuarantined += (_, _) => Quarantined++;
            Box(Simulator, 0, -0.5f, 40, 1, 1).IsStatic = true;
            Body wall = Box(Simulator, Face + (_thickness / 2), 4, _thickness, 8, 1);
            wall.IsStatic = true;
            if (way == Way.KinematicWall)
            {
                wall.IsStatic = false;
                wall.IsKinematic = true;
            }

            if (way == Way.Corner)
            {
                Box(Simulator, Face - 3, 3 + (_thickness / 2), 8, _thickness, 1).IsStatic = true;
            }

            float before = 0;
            if (way == Way.BoxAtAWall)
            {
                Between = Box(Simulator, Face - 0.5f, 0.5f, 1, 1, _mass * Pick(new[] { 0.3f, 1, 3 }));
                before = 1;
            }

            float half = _kind == 2 ? 0.1f : 0.5f;
            Body = Shape(Face - before - half - (0.05f * _random.Next(3)), _kind == 3 ? 0.1f : 0.5f);
            Simulator.Update(Dt);
            _target = new Vector2(Beyond, way == Way.Corner ? Pick(new[] { 6f, 9f }) : 0.6f);
            _end = BodyFactory.Instance.CreateBody(Simulator, _mass, 1);
            _end.Position = IsDrawn ? Body.Position + Vector2.UnitX : _target;
            _end.IsStatic = !IsDrawn;
            _joint = MakeJoint();
            if (_joint != null)
            {
                Simulator.Add(_joint);
            }
        }

        public PhysicsSimulator Simulator { get; }

        public Body Body { get; }

        public Body? Between { get; }

        public float Dt { get; }

        public int Quarantined { get; private set; }

        /// <summary>Its surface moves by more than half its thickness in a step.</summary>
        public bool IsFast =>
            (Body.LinearVelocity.Length() + (0.5f * Math.Abs(Body.AngularVelocity))) * Dt > (_kind >= 2 ? 0.1f : 0.5f);

        public int Steps => (int)(2 / Dt);

        /// <summary>Speed that the joint gives in a substep, with what a body that touches something takes at most.</summary>
        public float MostOfASubstep =>
            Math.Min(_force / _mass, (0.25f * 0.71f / (Dt * Dt)) + 160) * Dt / Simulator.Iterations;

        private bool IsDrawn => _wish is Wish.RopeToWhatIsDrawn or Wish.SliderToWhatIsDrawn;

        public static Body Box(PhysicsSimulator simulator, float x, float y, float width, float height, float mass)
        {
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, mass);
            body.Position = new Vector2(x, y);
            Sandbox.WithoutDrag(body);
            Surface(GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height));
            return body;
        }

        public void Step(int swings, int step)
        {
            Vector2 target = swings > 0 && step / swings % 2 == 1 ? new Vector2(-Beyond, 0.6f) : _target;
            if (_joint is TargetJoint joint)
            {
                joint.Target = target;
            }

            // What nothing bounds but the user stays within a hundred times the weight.
            if (_wish == Wish.Force || IsDrawn)
            {
                Body drawn = IsDrawn ? _end : Body;
                Vector2 way = _target - drawn.Position;
                drawn.ApplyForce(way * (Math.Min(_force, 1000 * _mass) / Math.Max(1, way.Length())));
            }

            Simulator.Update(Dt);
        }

        public void LetGo() => Simulator.Remove(_joint!);

        public void Dispose() => Simulator.Dispose();

        public override string ToString() =>
            $"{_wish} {_way} seed {_seed}: shape {_kind}, {_force} on {_mass}, wall {_thickness}, {Simulator.Iterations} at {1 / Dt}";

        private static void Surface(Geom geom)
        {
            geom.FrictionCoefficient = 0.5f;
            geom.RestitutionCoefficient = 0;
        }

        private T Pick<T>(T[] from) => from[_random.Next(from.Length)];

        private Joint? MakeJoint()
        {
            float frequency = Pick(new[] { 1f, 5, 30 });
            switch (_wish)
            {
                case Wish.TargetBesideASpring:
                    Simulator.Add(new FixedLinearSpring(Body, Vector2.Zero, Body.Position, _mass, 0));
                    goto case Wish.Target;
                case Wish.Target:
                    return new TargetJoint(Body, Body.Position)
                    {
                        MaxForce = _force, Frequency = frequency, DampingRatio = Pick(new[] { 0.1f, 0.7f, 1, 5 }), Target = _target,
                    };
                case Wish.Motor:
                    return new MotorJoint(_end, Body) { MaxForce = _force, MaxTorque = _seed % 2 == 0 ? _force : 0, Offset = Vector2.Zero };
                case Wish.RopeToWhatIsDrawn:
                    return new RopeJoint(_end, Vector2.Zero, Body, Vector2.Zero, 1.2f);
                case Wish.SliderToWhatIsDrawn:
                    return new SliderJoint(_end, Vector2.Zero, Body, Vector2.Zero, 0, 1.2f);
                case Wish.Spring:
                    float stiffness = Math.Min(_force, 1000 * _mass) / 5;
                    Simulator.Add(new FixedLinearSpring(Body, Vector2.Zero, _target, stiffness, _mass) { RestLength = 0 });
                    return null;
                default:
                    return null;
            }
        }

        private Body Shape(float x, float y)
        {
            if (_kind != 1)
            {
                return Box(Simulator, x, y, _kind == 2 ? 0.2f : 1, _kind == 3 ? 0.2f : 1, _mass);
            }

            Body body = BodyFactory.Instance.CreateCircleBody(Simulator, 0.5f, _mass);
            body.Position = new Vector2(x, y);
            Sandbox.WithoutDrag(body);
            Surface(GeomFactory.Instance.CreateCircleGeom(Simulator, body, 0.5f, 16));
            return body;
        }
    }
}
