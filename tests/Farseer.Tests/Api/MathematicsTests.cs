using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Mathematics;
using Xunit;

namespace Farseer.Tests.Api;

public class MathematicsTests
{
    [Fact]
    public void SinAndCos_OfAngles_AreTheNearestFloats()
    {
        var random = new Random(1);
        for (var i = 0; i < 20000; i++)
        {
            var angle = (float)((random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-6, 6)));
            NearestFloat(Math.Sin(angle), Calculator.Sin(angle));
            NearestFloat(Math.Cos(angle), Calculator.Cos(angle));
        }

        Assert.Equal(0f, Calculator.Sin(0f));
        Assert.Equal(1f, Calculator.Cos(0f));
        Assert.True(float.IsNaN(Calculator.Sin(float.PositiveInfinity)));
        Assert.True(float.IsNaN(Calculator.Cos(float.NaN)));

        // Far out the angle itself is uncertain by more than a turn; the functions stay within their range all the same.
        Assert.InRange(Calculator.Sin(1e30f), -1f, 1f);
        Assert.InRange(Calculator.Cos(float.MaxValue), -1f, 1f);
    }

    [Fact]
    public void ATan2AndACos_OfValues_AreTheNearestFloats()
    {
        var random = new Random(2);
        for (var i = 0; i < 20000; i++)
        {
            var y = (float)((random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-20, 20)));
            var x = (float)((random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-20, 20)));
            NearestFloat(Math.Atan2(y, x), Calculator.ATan2(y, x));
            var value = (float)((random.NextDouble() * 2) - 1);
            NearestFloat(Math.Acos(value), Calculator.ACos(value));
        }

        Assert.Equal(0f, Calculator.ATan2(0, 0));
        Assert.Equal(MathHelper.Pi, Calculator.ATan2(0, -1));
        Assert.Equal(-MathHelper.PiOver2, Calculator.ATan2(-1, 0));
        Assert.True(float.IsNaN(Calculator.ACos(1.1f)));
        Assert.True(float.IsNaN(Calculator.ATan2(float.NaN, 1)));
    }

    [Fact]
    public void Headings_OfVectors_StartUpOnTheScreen()
    {
        Assert.Equal(0f, Calculator.VectorToRadians(new Vector2(0, -5)));
        Assert.Equal(MathHelper.PiOver2, Calculator.VectorToRadians(new Vector2(5, 0)));
        Near(new Vector2(1, 0), Calculator.RadiansToVector(MathHelper.PiOver2));
        var vector = Vector2.Zero;
        Calculator.RadiansToVector(0, ref vector);
        Near(new Vector2(0, -1), vector);
        vector = new Vector2(2, 0);
        Calculator.RotateVector(ref vector, MathHelper.PiOver2);
        Near(new Vector2(0, 2), vector);
    }

    [Fact]
    public void Cross_InAllForms_AgreesWithTheDefinition()
    {
        var a = new Vector2(2, 3);
        var b = new Vector2(-5, 7);
        var w = 4f;
        Assert.Equal(29f, Calculator.Cross(a, b));
        Assert.Equal(new Vector2(12, -8), Calculator.Cross(a, w));
        Assert.Equal(new Vector2(-12, 8), Calculator.Cross(w, a));
        Calculator.Cross(ref a, ref b, out var z);
        Calculator.Cross(ref a, ref w, out var first);
        Calculator.Cross(ref w, ref a, out var second);
        Assert.Equal(29f, z);
        Assert.Equal(new Vector2(12, -8), first);
        Assert.Equal(new Vector2(-12, 8), second);
    }

    [Fact]
    public void Distances_ToPointAndSegment_AreTheShortest()
    {
        Vector2 a = new(0, 0), b = new(10, 0);
        Assert.Equal(10f, Calculator.DistanceBetweenPointAndPoint(a, b));
        Assert.Equal(10f, Calculator.DistanceBetweenPointAndPoint(ref a, ref b));
        Assert.Equal(3f, Calculator.DistanceBetweenPointAndLineSegment(new Vector2(4, -3), a, b));
        Assert.Equal(5f, Calculator.DistanceBetweenPointAndLineSegment(new Vector2(-3, 4), a, b));
        Assert.Equal(5f, Calculator.DistanceBetweenPointAndLineSegment(new Vector2(13, 4), a, b));
        Assert.Equal(5f, Calculator.DistanceBetweenPointAndLineSegment(new Vector2(3, 4), a, a));
    }

    [Fact]
    public void ProjectAndTruncate_OfVectors_KeepTheirArguments()
    {
        Assert.Equal(new Vector2(3, 0), Calculator.Project(new Vector2(3, 4), new Vector2(2, 0)));
        Assert.Equal(Vector2.Zero, Calculator.Project(new Vector2(3, 4), Vector2.Zero));
        var vector = new Vector2(3, 4);
        Calculator.Truncate(ref vector, 10, out var same);
        Calculator.Truncate(ref vector, 1, out var unit);
        Assert.Equal(vector, same);
        Near(new Vector2(0.6f, 0.8f), unit);
        Assert.Equal(new Vector2(3, 4), vector);
        Assert.Throws<ArgumentOutOfRangeException>(() => Calculator.Truncate(ref vector, -1, out _));
        var points = new[] { new Vector2(1, 5), new Vector2(4, -2) };
        var axis = new Vector2(2, 0);
        Calculator.ProjectToAxis(ref points, ref axis, out var min, out var max);
        Assert.Equal((1f, 4f), (min, max));
        axis = Vector2.Zero;
        Assert.Equal(
            "axis",
            Assert.Throws<ArgumentOutOfRangeException>(
                () => Calculator.ProjectToAxis(ref points, ref axis, out _, out _)).ParamName);
    }

    [Fact]
    public void Curves_AtTheirEnds_AreAtTheEnds()
    {
        Vector2 a = new(0, 0), b = new(1, 3), c = new(4, 3), d = new(6, 0);
        var heading = 0f;
        Assert.Equal(a, Calculator.CubicBezierCurve(a, b, c, d, 0));
        Assert.Equal(d, Calculator.CubicBezierCurve(a, b, c, d, 1));
        Near(new Vector2(2.625f, 2.25f), Calculator.CubicBezierCurve(a, b, c, d, 0.5f));
        Near(new Vector2(2.625f, 2.25f), Calculator.CubicBezierCurve(a, b, c, d, 0.5f, ref heading));

        // The tangent at 1/2 is 3/4 (d + c - b - a) = (6.75, 0).
        Assert.Equal(MathHelper.PiOver2, heading, 1e-6f);
        Near(new Vector2(2.625f, 2.25f), Calculator.CubicBezierCurve2(a, b - a, d, c - d, 0.5f));
        Near(new Vector2(2.625f, 2.25f), Calculator.CubicBezierCurve2(a, b - a, d, c - d, 0.5f, ref heading));
        Near(
            new Vector2(2.625f, 2.25f),
            Calculator.CubicBezierCurve2(
                a,
                Calculator.VectorToRadians(b - a),
                (b - a).Length(),
                d,
                Calculator.VectorToRadians(c - d),
                (c - d).Length(),
                0.5f,
                ref heading));
        Near(new Vector2(1.5f, 2.25f), Calculator.QuadraticBezierCurve(a, b, c, 0.5f));
        Near(new Vector2(1.5f, 2.25f), Calculator.QuadraticBezierCurve(a, b, c, 0.5f, ref heading));
        Near(new Vector2(3, 0), Calculator.LinearBezierCurve(a, d, 0.5f));
    }

    [Fact]
    public void Interpolation_OfNormalsAndAngles_GoesTheShortWay()
    {
        var half = Calculator.InterpolateNormal(Vector2.UnitX, Vector2.UnitY, 0.5f);
        Near(Vector2.Normalize(Vector2.One), half);
        Calculator.InterpolateNormal(Vector2.UnitX, Vector2.UnitY, 0.5f, out var second);
        var third = Vector2.UnitX;
        Calculator.InterpolateNormal(ref third, Vector2.UnitY, 0.5f);
        Assert.Equal(half, second);
        Assert.Equal(half, third);
        Assert.Equal(Vector2.Zero, Calculator.InterpolateNormal(Vector2.UnitX, -Vector2.UnitX, 0.5f));
        Assert.Equal(MathHelper.Pi, Math.Abs(Calculator.InterpolateRotation(3f, MathHelper.TwoPi - 3f, 0.5f)), 1e-5f);
    }

    [Fact]
    public void Numbers_OfSmallFunctions_AreRight()
    {
        Assert.Equal(MathHelper.Pi, Calculator.DegreesToRadians(180), 1e-6f);
        Assert.Equal(MathHelper.Pi, MathHelper.ToRadians(180), 1e-6f);
        Assert.Equal(2f, Calculator.Clamp(5, 1, 2));
        Assert.Equal(1f, MathHelper.Clamp(-5f, 1f, 2f));
        Assert.Equal(2d, MathHelper.Clamp(5d, 1d, 2d));
        Assert.Equal(3f, MathHelper.Distance(1, -2));
        Assert.Equal(2.5f, MathHelper.Lerp(2, 4, 0.25f));
        Assert.Equal(2f, MathHelper.Max(1, 2));
        Assert.Equal(1f, MathHelper.Min(1, 2));
        Assert.Equal(180f, MathHelper.ToDegrees(MathHelper.Pi), 1e-4f);
        Assert.True(Calculator.IsBetweenNonInclusive(1, 0, 2));
        Assert.False(Calculator.IsBetweenNonInclusive(2, 0, 2));
        for (var i = 0; i < 100; i++)
        {
            Assert.InRange(Calculator.RandomNumber(-1, 3), -1f, 3f);
        }

        Assert.Equal("max", Assert.Throws<ArgumentOutOfRangeException>(() => Calculator.RandomNumber(1, 0)).ParamName);
    }

    [Fact]
    public void BilinearInterpolator_OfCorners_GivesThemAndTheMean()
    {
        var values = new BilinearInterpolator(Vector2.Zero, new Vector2(2, 4), 1, 2, 3, 6, 0, 5);
        Assert.Equal(1f, values.GetValue(Vector2.Zero));
        Assert.Equal(2f, values.GetValue(0, 4));
        Assert.Equal(3f, values.GetValue(9, 9));
        Assert.Equal(5f, values.GetValue(2, 0));
        Assert.Equal(3f, values.GetValue(1, 2));
        Assert.Equal(0f, new BilinearInterpolator().GetValue(1, 1));
        Assert.Equal(new Vector2(2, 4), values.Max);
        Assert.Equal(Vector2.Zero, values.Min);
        Assert.Throws<ArgumentOutOfRangeException>(() => new BilinearInterpolator(Vector2.Zero, Vector2.One, 0, 0, 0, 0, 1, 0));
    }

    [Fact]
    public void CircularInterpolator_OnTheCircle_GivesThePointsAndIsContinuous()
    {
        var values = new CircularInterpolator(1, 2, 3, 6, -10, 10);
        Assert.Equal(1f, values.GetValue(1, 0), 1e-5f);
        Assert.Equal(2f, values.GetValue(0, 1), 1e-5f);
        Assert.Equal(3f, values.GetValue(-1, 0), 1e-5f);
        Assert.Equal(6f, values.GetValue(0, -1), 1e-5f);
        Assert.Equal(3f, values.GetValue(Vector2.Zero));
        Assert.Equal(2f, values.GetValue(1e-6f, 0), 1e-3f);
        Assert.Equal(values.GetValue(0.5f, 0), values.GetValue(0.5f, -1e-6f), 1e-4f);
        Assert.Equal(values.GetValue(0, 0.5f), values.GetValue(-1e-6f, 0.5f), 1e-4f);
    }

    [Fact]
    public void ConvertUnits_BothWays_UsesTheRatio()
    {
        Assert.Equal(100f, ConvertUnits.ToDisplayUnits(2));
        Assert.Equal(100f, ConvertUnits.ToDisplayUnits(2f));
        Assert.Equal(new Vector2(50, 100), ConvertUnits.ToDisplayUnits(1, 2));
        Assert.Equal(2f, ConvertUnits.ToSimUnits(100));
        Assert.Equal(2f, ConvertUnits.ToSimUnits(100d));
        Assert.Equal(new Vector2(1, 2), ConvertUnits.ToSimUnits(50d, 100d));
        Assert.Equal(new Vector2(1, 2), ConvertUnits.ToSimUnits(new Vector2(50, 100)));
        var vector = new Vector2(1, 2);
        ConvertUnits.ToDisplayUnits(ref vector, out var display);
        ConvertUnits.ToSimUnits(ref display, out var back);
        Assert.Equal(vector, back);
        ConvertUnits.ToDisplayUnits(1, 2, out display);
        ConvertUnits.ToSimUnits(50, 100, out back);
        Assert.Equal(new Vector2(50, 100), display);
        Assert.Equal(vector, back);
        Assert.Throws<ArgumentOutOfRangeException>(() => ConvertUnits.SetDisplayUnitToSimUnitRatio(0));
        ConvertUnits.SetDisplayUnitToSimUnitRatio(50);
    }

    private static void NearestFloat(double exact, float actual)
    {
        // The platform's function may be off by a unit of the last place of a double, which can tip a tie.
        var slack = Math.Abs(exact) * 4e-16;
        Assert.True(
            actual == (float)exact || actual == (float)(exact + slack) || actual == (float)(exact - slack),
            $"{actual:R} is not the nearest float to {exact:R}");
    }

    [Fact]
    public void Splines_OfNumbers_PassThroughTheirEnds()
    {
        Assert.Equal(4f, MathHelper.Barycentric(2, 4, 9, 1, 0));
        Assert.Equal(2f, MathHelper.CatmullRom(9, 2, 4, 7, 0));
        Assert.Equal(4f, MathHelper.CatmullRom(9, 2, 4, 7, 1));

        // Through numbers on a line the spline is the line.
        Assert.Equal(2.5f, MathHelper.CatmullRom(1, 2, 3, 4, 0.5f), 1e-6f);
        Assert.Equal(2f, MathHelper.Hermite(2, 5, 4, -5, 0));
        Assert.Equal(4f, MathHelper.Hermite(2, 5, 4, -5, 1));
        Assert.Equal(3f, MathHelper.SmoothStep(2, 4, 0.5f));
        Assert.Equal(2.3125f, MathHelper.SmoothStep(2, 4, 0.25f));
        Assert.Equal(4f, MathHelper.SmoothStep(2, 4, 7));
        Assert.Equal(2f, MathHelper.SmoothStep(2, 4, -7));
    }

    // The turn that is taken away is TwoPi, a float: it is off by 1.7e-7, times 16.
    [Theory]
    [InlineData(0f, 0f)]
    [InlineData(1f, 1f)]
    [InlineData(-3f, -3f)]
    [InlineData(4f, 4f - (2 * Math.PI))]
    [InlineData(-4f, (2 * Math.PI) - 4)]
    [InlineData(100f, 100 - (32 * Math.PI))]
    [InlineData(MathHelper.Pi, Math.PI)]
    [InlineData(-MathHelper.Pi, Math.PI)]
    public void WrapAngle_OfAnAngle_IsLessThanATurn(float angle, double expected) =>
        Assert.Equal(expected, MathHelper.WrapAngle(angle), 1e-5);

    private static void Near(Vector2 expected, Vector2 actual)
    {
        Assert.InRange(actual.X, expected.X - 1e-5f, expected.X + 1e-5f);
        Assert.InRange(actual.Y, expected.Y - 1e-5f, expected.Y + 1e-5f);
    }
}
