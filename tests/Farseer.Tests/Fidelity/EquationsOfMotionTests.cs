using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Fine;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;
using Xunit;

namespace Farseer.Tests.Fidelity;

/// <summary>The equations of motion that scenes are judged by, against closed forms.</summary>
public sealed class EquationsOfMotionTests
{
    private const double Drag = 0.001;

    /// <summary>
    /// Once its corner sticks, the box of this scene is a pendulum about it: one equation in the angle alone, with the centre
    /// p from the corner, (I + m p.p) w' = px m g - c (p.p) w - c w|w|. The fall of 24 before it and the impact, which keeps
    /// the moment of momentum about the corner, are closed forms: v = (m g / c)(1 - e^(-c t / m)), w = px v m / (I + m p.p).
    /// </summary>
    [Fact]
    public void Of_ABoxWhoseCornerSticks_AreThoseOfThePendulumAboutIt()
    {
        const double Gravity = 100;
        const double Fall = 24;
        const double End = 1.2;
        const double SmallStep = 1e-5;
        (double startX, double startY) = (-4, -16);
        double square = (startX * startX) + (startY * startY);
        double inertia = (1600.0 / 6) + square;
        double meeting = Math.Sqrt(2 * Fall / Gravity);
        for (int i = 0; i < 20; i++)
        {
            double way = Gravity / Drag * (meeting - ((1 - Math.Exp(-Drag * meeting)) / Drag));
            meeting += (Fall - way) / (Gravity / Drag * (1 - Math.Exp(-Drag * meeting)));
        }

        double spin = startX * Gravity / Drag * (1 - Math.Exp(-Drag * meeting)) / inertia;
        double angle = 0;
        const int Steps = 20_000;
        double step = (End - meeting) / Steps;
        double Torque(double a, double w) =>
            ((((startX * Math.Cos(a)) - (startY * Math.Sin(a))) * Gravity) - (Drag * square * w) - (Drag * w * Math.Abs(w))) / inertia;
        for (int i = 0; i < Steps; i++)
        {
            double middleSpin = spin + (step / 2 * Torque(angle, spin));
            double middleAngle = angle + (step / 2 * spin);
            angle += step * middleSpin;
            spin += step * Torque(middleAngle, middleSpin);
        }

        Row row = Of("geom_offset")["a"][^1];

        // First order in the small step, times the acceleration of gravity and the time since.
        const double Error = SmallStep * Gravity * End;
        Assert.Equal(spin, row.AngularVelocity, Error);
        Assert.Equal(angle, row.Rotation, Error);
        Assert.Equal(startX * Math.Cos(angle) - (startY * Math.Sin(angle)) - startX, row.X, Error);
    }

    /// <summary>
    /// A cylinder that rolls down a slope s from rest, on an arm a: v = (m g sin s / c)(1 - e^(-c t / (m + I / a^2))). It starts 0.2
    /// deep in the
    /// slope and stays so; the point it rolls on is in the middle of that.
    /// </summary>
    [Fact]
    public void Of_ACylinderOnASlope_AreThoseOfRolling()
    {
        SceneFile file = ReferenceData.Scene("incline_circle_rolls");
        double slope = file.Bodies[1].Properties.Single(p => p.Key == "rotation").Value.GetDouble();
        double mass = file.Bodies[0].Args.GetProperty("mass").GetDouble();
        double radius = file.Bodies[0].Args.GetProperty("radius").GetDouble();
        double time = file.Steps * (double)file.Dt;
        double arm = radius - 0.1;
        double inert = mass * (1 + (radius * radius / 2 / (arm * arm)));
        double pull = mass * Impacts.Gravity(file) * Math.Sin(slope);
        double speed = pull / Drag * (1 - Math.Exp(-Drag * time / inert));

        Row row = Of("incline_circle_rolls")["a"][^1];

        Assert.Equal(speed, Math.Sqrt((row.VelocityX * row.VelocityX) + (row.VelocityY * row.VelocityY)), 1e-2);
        Assert.Equal(speed / arm, row.AngularVelocity, 1e-3);
    }

    /// <summary>Elastic, without friction: momentum and energy are kept, and nothing turns.</summary>
    [Theory]
    [InlineData("head_on_equal")]
    [InlineData("head_on_unequal")]
    public void Of_CirclesThatMeet_KeepMomentumAndEnergy(string name)
    {
        SceneFile file = ReferenceData.Scene(name);
        double[] masses = [.. file.Bodies.Select(b => b.Args.GetProperty("mass").GetDouble())];
        IReadOnlyDictionary<string, Row[]> rows = Of(name);
        double Energy(int k) => file.Bodies.Select((b, i) => masses[i] * Square(rows[b.Id][k]) / 2).Sum();
        double Momentum(int k) => file.Bodies.Select((b, i) => masses[i] * rows[b.Id][k].VelocityX).Sum();
        bool hasDrag = !file.Bodies.All(b => b.Properties.Any(p => p.Key == "linearDragCoefficient" && p.Value.GetDouble() == 0));
        double kept = hasDrag ? 5e-3 : 1e-9;

        Assert.Equal(1, Energy(file.SampleSteps.Length - 1) / Energy(0), kept);
        Assert.Equal(1, Momentum(file.SampleSteps.Length - 1) / Momentum(0), kept);
        Assert.All(file.Bodies, b => Assert.Equal(0, rows[b.Id][^1].AngularVelocity, 1e-12));
    }

    private static double Square(Row row) => (row.VelocityX * row.VelocityX) + (row.VelocityY * row.VelocityY);

    private static IReadOnlyDictionary<string, Row[]> Of(string name)
        => FineMotion.Run(ReferenceData.Scene(name)) ?? throw new InvalidOperationException("The scene cannot be expressed.");
}
