using System;
using System.Collections.Generic;
using System.Globalization;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// A body that a handler takes out of motion in the middle of an update, with a spring or a joint at it and others on it: it stays where it
/// is from then on, and what holds on to it goes on. (It was solved to the update's end as one that moves, without a mass: springs divided
/// by that, and all that hung together had no numbers.)
/// </summary>
public class SwitchedWithinAStepTests
{
    private const int Seeds = 24;

    public static TheoryData<string, string> Cases
    {
        get
        {
            var cases = new TheoryData<string, string>();
            foreach (string place in new[] { "OnCollision", "OnBroadPhaseCollision", "Controller.Update", "Spring.Update", "Joint.Broke" })
            {
                foreach (string what in new[] { "static", "kinematic", "disabled" })
                {
                    cases.Add(place, what);
                }
            }

            return cases;
        }
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Body_TakenOutOfMotionInAHandler_StaysThere_AndTheOthersGoOn(string place, string what)
    {
        for (int seed = 0; seed < Seeds; seed++)
        {
            new Yard(seed).Run(place, what, string.Create(CultureInfo.InvariantCulture, $"{what} in {place}, {seed}"));
        }
    }

    /// <summary>
    /// Three boxes fall on a floor one upon the other; something ties the lowest to the uppermost, and a spring each to a body beside them.
    /// </summary>
    private sealed class Yard
    {
        private readonly PhysicsSimulator _simulator = new PhysicsSimulator(new Vector2(0, -10));
        private readonly Random _random;
        private readonly List<Body> _boxes = new List<Body>();
        private readonly Body _beside;
        private readonly Kinds.OwnSpring _spring;
        private readonly Kinds.OwnController _controller;
        private readonly PinJoint _weak;
        private int _quarantined;

        public Yard(int seed)
        {
            _random = new Random(seed);
            _simulator.BodyQuarantined += (_, _) => _quarantined++;
            _simulator.Iterations = _random.Next(1, 8);
            Body floor = BodyFactory.Instance.CreateRectangleBody(_simulator, 100, 2, 1);
            floor.IsStatic = true;
            floor.Position = new Vector2(0, -1);
            GeomFactory.Instance.CreateRectangleGeom(_simulator, floor, 100, 2);
            for (int i = 0; i < 3; i++)
            {
                Body box = BodyFactory.Instance.CreateRectangleBody(_simulator, 1, 1, 0.5f + (3 * _random.NextSingle()));
                box.Position = new Vector2(0.2f * _random.NextSingle(), 0.7f + (1.1f * i));
                GeomFactory.Instance.CreateRectangleGeom(_simulator, box, 1, 1).RestitutionCoefficient = 0.4f * _random.Next(2);
                _boxes.Add(box);
            }

            _beside = BodyFactory.Instance.CreateRectangleBody(_simulator, 1, 1, 1);
            _beside.Position = new Vector2(4, 3);
            _beside.IsKinematic = _random.Next(3) == 0;
            _beside.IgnoreGravity = true;
            _simulator.Add(new LinearSpring(_boxes[0], Vector2.Zero, _beside, Vector2.Zero, 40, 1));
            _simulator.Add(new AngleSpring(_boxes[1], _beside, 5, 1));
            switch (_random.Next(4))
            {
                case 0: _simulator.Add(new RevoluteJoint(_boxes[0], _boxes[2], _boxes[1].Position)); break;
                case 1: _simulator.Add(new DistanceJoint(_boxes[0], Vector2.Zero, _boxes[2], Vector2.Zero)); break;
                case 2: _simulator.Add(new RopeJoint(_boxes[0], Vector2.Zero, _boxes[2], Vector2.Zero, 3)); break;
            }

            Body far = BodyFactory.Instance.CreateRectangleBody(_simulator, 1, 1, 1);
            far.Position = new Vector2(40, 30);
            _weak = new PinJoint(_beside, Vector2.Zero, far, Vector2.Zero);
            _simulator.Add(_weak);
            _spring = new Kinds.OwnSpring(far);
            _controller = new Kinds.OwnController(far, _beside);
            _simulator.Add(_spring);
            _simulator.Add(_controller);
        }

        public void Run(string place, string what, string which)
        {
            Body body = _boxes[_random.Next(2)];
            int wait = _random.Next(30);
            Vector2? stayed = null;
            void Switch()
            {
                if (stayed is null && --wait < 0)
                {
                    stayed = body.Position;
                    body.IsStatic = what == "static";
                    body.IsKinematic = what == "kinematic";
                    body.Enabled = what != "disabled";
                    body.LinearVelocity = Vector2.Zero;
                    body.AngularVelocity = 0;
                }
            }

            Hook(place, Switch);
            for (int i = 0; i < 80; i++)
            {
                if (i == 20)
                {
                    // From here on the joint is to break, in the next update.
                    _weak.BreakForce = 0;
                }

                _simulator.Update(1 / 60f);
                Assert.True(_quarantined == 0, which + ": a body was taken out");
                Assert.True(stayed is null || body.Position == stayed, $"{which}: it went from {stayed} to {body.Position}");
                Assert.True(stayed is null || body.LinearVelocity == Vector2.Zero, $"{which}: it has {body.LinearVelocity}");
            }

            Assert.True(stayed is not null, which + ": the handler was not called");
            Assert.All(_boxes, box => Assert.True(box.Position.Length() < 20 && float.IsFinite(box.AngularVelocity), which));
        }

        private void Hook(string place, Action act)
        {
            switch (place)
            {
                case "OnCollision":
                    _boxes[0].GeomAt(0).OnCollision += (_, _, _) =>
                    {
                        act();
                        return true;
                    };
                    break;
                case "OnBroadPhaseCollision":
                    _simulator.BroadPhaseCollider.OnBroadPhaseCollision += (_, _) =>
                    {
                        // There are few such pairs: at once, and again whenever something comes near.
                        for (int i = 0; i < 30; i++)
                        {
                            act();
                        }

                        return true;
                    };
                    break;
                case "Controller.Update":
                    _controller.InUpdate = act;
                    break;
                case "Spring.Update":
                    _spring.InUpdate = act;
                    break;
                default:
                    _weak.Broke += (_, _) =>
                    {
                        for (int i = 0; i < 30; i++)
                        {
                            act();
                        }
                    };
                    break;
            }
        }
    }
}
