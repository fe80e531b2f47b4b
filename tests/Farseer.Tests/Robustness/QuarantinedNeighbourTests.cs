using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>
/// One body of a group that joints, springs and contacts hold together is made infinite. It is taken out and reported; the others go on,
/// and everything that they report of themselves is a number.
/// </summary>
public class QuarantinedNeighbourTests
{
    private const int Seeds = 160;
    private const float Dt = 1 / 60f;

    [Fact]
    public void OneBodyOfAGroup_MadeInfinite_LeavesReportsOfNumbersAndTheOthersGoingOn()
    {
        for (int seed = 0; seed < Seeds; seed++)
        {
            new Group(seed).Run();
        }
    }

    /// <summary>What hung on it holds on to where it was, as on any body that is disabled; enabled again, it moves as before.</summary>
    [Fact]
    public void JointOfTheBody_HoldsOnToWhereItWas_AndActsAgainWithIt()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10)) { EnableReport = true };
        Body hook = Link(simulator, Vector2.Zero);
        Body load = Link(simulator, new Vector2(0, -1));
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, hook, new Vector2(0, 0.5f));
        RevoluteJoint joint = JointFactory.Instance.CreateRevoluteJoint(simulator, hook, load, new Vector2(0, -0.5f));
        Run(simulator, 30);
        hook.ApplyForce(new Vector2(3e38f, 0));
        Run(simulator, 60);

        Assert.True(hook.IsQuarantined);
        Assert.False(load.IsQuarantined);
        Assert.Equal(load.Mass * 10, joint.ReactionForce.Length(), 0.05f);
        hook.Enabled = true;
        Run(simulator, 60);
        Assert.Equal(load.Mass * 10, joint.ReactionForce.Length(), 0.05f);
        Assert.InRange(joint.JointError, 0, 1e-3f);
    }

    private static Body Link(PhysicsSimulator simulator, Vector2 place)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 0.4f, 0.9f, 2);
        body.Position = place;
        Sandbox.WithoutDrag(body);
        return body;
    }

    private static void Run(PhysicsSimulator simulator, int steps) => Sandbox.Run(simulator, steps, Dt);

    /// <summary>
    /// A chain, tree or net of bodies with joints of any kind, which may lie on a floor, and a body that has nothing to do with them.
    /// </summary>
    private sealed class Group
    {
        private readonly Random _random;
        private readonly int _seed;
        private readonly List<Body> _bodies = new List<Body>();
        private readonly List<Body> _out = new List<Body>();
        private readonly PhysicsSimulator _simulator = new PhysicsSimulator(new Vector2(0, -10)) { EnableReport = true };
        private readonly Body _free;

        public Group(int seed)
        {
            _seed = seed;
            _random = new Random(seed);
            _simulator.BodyQuarantined += (_, e) => _out.Add(e.Body);
            _simulator.Iterations = _random.Next(1, 9);
            int count = _random.Next(2, 9);
            bool floor = _random.Next(2) == 0;
            for (int i = 0; i < count; i++)
            {
                Body body = Link(_simulator, new Vector2(i, 0.1f * Next()));
                body.LinearVelocity = new Vector2(Next(), Next());
                body.LinearDragCoefficient = _random.Next(2) * 0.01f;
                body.RotationalDragCoefficient = _random.Next(2) * 0.01f;
                _bodies.Add(body);
                if (floor || _random.Next(2) == 0)
                {
                    GeomFactory.Instance.CreateRectangleGeom(_simulator, body, 0.9f, 0.4f).RestitutionCoefficient = _random.Next(2) * 0.5f;
                }
            }

            if (floor)
            {
                Body ground = BodyFactory.Instance.CreateRectangleBody(_simulator, 60, 1, 1);
                ground.Position = new Vector2(0, -0.75f);
                ground.IsStatic = true;
                GeomFactory.Instance.CreateRectangleGeom(_simulator, ground, 60, 1);
            }

            for (int i = 1; i < count; i++)
            {
                _simulator.Add(MakeJoint(_bodies[_random.Next(3) == 0 ? _random.Next(i) : i - 1], _bodies[i]));
            }

            if (count > 3 && _random.Next(3) == 0)
            {
                // A closed loop: a net.
                JointFactory.Instance.CreateRevoluteJoint(_simulator, _bodies[0], _bodies[count - 1], _bodies[0].Position);
            }

            if (_random.Next(2) == 0)
            {
                JointFactory.Instance.CreateFixedRevoluteJoint(_simulator, _bodies[0], _bodies[0].Position);
            }

            if (_random.Next(3) == 0)
            {
                _simulator.Add(new LinearSpring(_bodies[0], Vector2.Zero, _bodies[count - 1], Vector2.Zero, 10, 1));
            }

            _free = Link(_simulator, new Vector2(0, 500));
        }

        public void Run()
        {
            Step(_random.Next(1, 20));
            Body lost = _bodies[_random.Next(_bodies.Count)];
            int how = _random.Next(7);
            switch (how)
            {
                case 0: lost.LinearVelocity = new Vector2(float.NaN, 0); break;
                case 1: lost.AngularVelocity = float.PositiveInfinity; break;
                case 2: lost.LinearVelocity = new Vector2(1e19f, 0); break;
                case 3: lost.ApplyForce(new Vector2(3e38f, 1)); break;
                case 4: lost.ApplyTorque(3e38f); break;
                case 5: lost.ApplyImpulse(new Vector2(0, 3e38f)); break;
                default: lost.ApplyForceAtLocalPoint(new Vector2(3e38f, -3e38f), new Vector2(0.2f, 0.1f)); break;
            }

            Step(1);
            Check(lost.IsQuarantined, how, "the body was not taken out");
            Step(20);
            Check(_out.SequenceEqual(new[] { lost }), how, $"{_out.Count} bodies were taken out");
            Check(_free.LinearVelocity.Y < -3, how, "the others do not go on");
        }

        private void Step(int steps)
        {
            for (int i = 0; i < steps; i++)
            {
                _simulator.Update(Dt);
                foreach (Joint joint in _simulator.JointList)
                {
                    Vector2 force = joint.ReactionForce;
                    float sum = force.X + force.Y + joint.ReactionTorque + joint.JointError;
                    Check(float.IsFinite(sum), i, $"{joint} answers with {force}, {joint.ReactionTorque}, {joint.JointError}");
                }

                foreach (Spring spring in _simulator.SpringList)
                {
                    Check(float.IsFinite(spring.SpringError), i, "the spring tells no number");
                }

                foreach (Body body in _simulator.BodyList)
                {
                    float sum = body.Position.X + body.Position.Y + body.LinearVelocity.X + body.LinearVelocity.Y + body.AngularVelocity;
                    Check(float.IsFinite(sum), i, "a body has no numbers");
                }

                Check(_simulator.Report);
            }
        }

        /// <summary>Error and its share are infinite by rule in the step in which a body is lost.</summary>
        private void Check(StepReport report)
        {
            double[] numbers =
            {
                report.KineticEnergy, report.KineticEnergyChange, report.GravityWork, report.ForceWork, report.ImpulseWork,
                report.DragWork, report.SpringWork, report.MotorWork, report.JointWork, report.ContactWork, report.BounceWork,
                report.EnergyError, report.MomentumX, report.MomentumY, report.SupportImpulseX, report.SupportImpulseY,
                report.MomentumError, report.LargestSeparation, report.RmsSeparation, report.LargestTurn,
                report.LargestPenetration, report.RmsPenetration, report.ResidualJointSpeed, report.ResidualContactSpeed,
            };
            for (int i = 0; i < numbers.Length; i++)
            {
                // Far more than a few bodies of 2 kg do in a step.
                Check(Math.Abs(numbers[i]) < 1e9, i, $"number {i} of the report is {numbers[i]}");
            }
        }

        private Joint MakeJoint(Body one, Body other)
        {
            Vector2 middle = (one.Position + other.Position) / 2;
            return _random.Next(12) switch
            {
                0 => new PinJoint(one, new Vector2(0.5f, 0), other, new Vector2(-0.5f, 0)),
                1 => new WeldJoint(one, other, middle) { Frequency = _random.Next(2) * 5 },
                2 => new DistanceJoint(one, Vector2.Zero, other, Vector2.Zero),
                3 => new PrismaticJoint(one, other, middle, Vector2.UnitX) { IsMotorEnabled = true, MotorSpeed = 1, MaxMotorForce = 20 },
                4 => new RevoluteJoint(one, other, middle) { AreLimitsEnabled = true, LowerLimit = -0.2f, UpperLimit = 0.2f },
                5 => new SliderJoint(one, Vector2.Zero, other, Vector2.Zero, 0.8f, 1.2f),
                6 => new RopeJoint(one, Vector2.Zero, other, Vector2.Zero, 1.3f),
                7 => new GearJoint(one, other, 2),
                8 => new AngleLimitJoint(one, other, -0.3f, 0.3f),
                9 => new MotorJoint(one, other) { MaxForce = 30, MaxTorque = 10 },
                _ => new RevoluteJoint(one, other, middle),
            };
        }

        private float Next() => (2 * _random.NextSingle()) - 1;

        private void Check(bool holds, int where, string what) =>
            Assert.True(holds, string.Create(CultureInfo.InvariantCulture, $"seed {_seed}, {where}: {what}"));
    }
}
