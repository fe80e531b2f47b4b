using System;
using System.Linq;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;
using Xunit;

namespace Farseer.Tests.Fidelity;

public sealed class FallingBodyTests
{
    /// <summary>Of values from 1 to 300, against limits of 2e-4 and more. Runge-Kutta steps leave 1e-11; the rest is the rounding of events.</summary>
    private const double Converged = 1e-9;

    [Theory]
    [InlineData("geom_compound")]
    [InlineData("geom_offset")]
    public void At_WithHalfTheStep_IsTheSame(string name)
    {
        SceneFile file = ReferenceData.Scene(name);
        foreach (double time in file.SampleSteps.Select(s => s * (double)file.Dt))
        {
            Row row = FallingBody.At(file, "a", time);
            Row finer = FallingBody.At(file, "a", time, FallingBody.DefaultStep / 2);

            Assert.Equal(finer.X, row.X, Converged);
            Assert.Equal(finer.Y, row.Y, Converged);
            Assert.Equal(finer.Rotation, row.Rotation, Converged);
            Assert.Equal(finer.VelocityX, row.VelocityX, Converged);
            Assert.Equal(finer.VelocityY, row.VelocityY, Converged);
            Assert.Equal(finer.AngularVelocity, row.AngularVelocity, Converged);
        }
    }

    /// <summary>
    /// Once its corner sticks, the box of geom_offset is a pendulum about it: one equation in the angle alone, with the centre
    /// p from the corner, (I + m p.p) w' = px m g - c (p.p) w - c w|w|. The fall of 24 before it and the impact, which keeps
    /// the moment of momentum about the corner, are closed forms: v = (m g / c)(1 - e^(-c t / m)), w = px v m / (I + m p.p).
    /// </summary>
    [Fact]
    public void At_WhenACornerSticks_IsThePendulumAboutIt()
    {
        const double Drag = 0.001;
        const double Gravity = 100;
        const double Fall = 24;
        const double End = 1.2;
        const double MidpointError = 1e-8; // the square of its step, 2.5e-5, times derivatives of about 10
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

        Row row = FallingBody.At(ReferenceData.Scene("geom_offset"), "a", End);

        Assert.Equal(spin, row.AngularVelocity, MidpointError);
        Assert.Equal(angle, row.Rotation, MidpointError);
        Assert.Equal(startX * Math.Cos(angle) - (startY * Math.Sin(angle)) - startX, row.X, MidpointError);
    }
}
