using System;
using System.Linq;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>Curves through keys.</summary>
public class CurveTests
{
    [Fact]
    public void Evaluate_GoesThroughItsKeys_SmoothlyOrInSteps()
    {
        Curve curve = Through((0, 0), (1, 1), (3, 5));
        curve.ComputeTangents(CurveTangent.Linear);
        Assert.Equal(0, curve.Evaluate(0));
        Assert.Equal(1, curve.Evaluate(1));
        Assert.Equal(5, curve.Evaluate(3));

        // With linear tangents a stretch is the straight line.
        Assert.Equal(0.25f, curve.Evaluate(0.25f), 6);
        Assert.Equal(3, curve.Evaluate(2), 6);
        curve.Keys[1].Continuity = CurveContinuity.Step;
        Assert.Equal(1, curve.Evaluate(2.9f));
        curve.ComputeTangents(CurveTangent.Flat);
        Assert.Equal(0.5f, curve.Evaluate(0.5f), 6);
        Assert.Equal(0.15625f, curve.Evaluate(0.25f), 6);
    }

    [Fact]
    public void ComputeTangent_Smooth_IsTheSlopeBetweenTheNeighbours()
    {
        Curve curve = Through((0, 0), (1, 1), (4, 8));
        curve.ComputeTangents(CurveTangent.Smooth);
        Assert.Equal(2, curve.Keys[1].TangentIn);
        Assert.Equal(6, curve.Keys[1].TangentOut);
        Assert.Equal(0, curve.Keys[0].TangentIn);
        Assert.Equal(1, curve.Keys[0].TangentOut);
        curve.ComputeTangent(1, CurveTangent.Flat, CurveTangent.Linear);
        Assert.Equal(0, curve.Keys[1].TangentIn);
        Assert.Equal(7, curve.Keys[1].TangentOut);
    }

    [Theory]
    [InlineData(CurveLoopType.Constant, -0.5f, 0, 4.5f, 4)]
    [InlineData(CurveLoopType.Cycle, -1, 3, 5, 1)]
    [InlineData(CurveLoopType.CycleOffset, -1, -1, 5, 5)]
    [InlineData(CurveLoopType.Oscillate, -1, 1, 5, 3)]
    [InlineData(CurveLoopType.Linear, -1, -1, 6, 6)]
    public void Loops_GoOnOutsideTheKeys(CurveLoopType loop, float before, float valueBefore, float after, float valueAfter)
    {
        Curve curve = Through((0, 0), (1, 1), (2, 2), (3, 3), (4, 4));
        curve.ComputeTangents(CurveTangent.Linear);
        curve.Keys[0].TangentIn = curve.Keys[4].TangentOut = 1;
        curve.PreLoop = curve.PostLoop = loop;
        Assert.Equal(valueBefore, curve.Evaluate(before), 5);
        Assert.Equal(valueAfter, curve.Evaluate(after), 5);
    }

    [Fact]
    public void Keys_StayInOrder_AndCloneIsIndependent()
    {
        Curve curve = Through((3, 0), (1, 1), (2, 2));
        Assert.Equal([1, 2, 3], curve.Keys.Select(k => k.Position));
        curve.Keys[0] = new CurveKey(5, 7);
        Assert.Equal([2, 3, 5], curve.Keys.Select(k => k.Position));
        Assert.Equal(2, curve.Keys.IndexOf(new CurveKey(5, 7)));
        Assert.Contains(new CurveKey(5, 7), curve.Keys);
        Curve clone = curve.Clone();
        clone.Keys[0].Value = 99;
        Assert.Equal(2, curve.Keys[0].Value);
        Assert.True(curve.Keys.Remove(new CurveKey(5, 7)));
        curve.Keys.RemoveAt(0);
        Assert.True(curve.IsConstant);
        Assert.False(clone.IsConstant);
        curve.Keys.Clear();
        Assert.Equal(0, curve.Evaluate(1));
        Assert.False(curve.Keys.IsReadOnly);
        Assert.True(new CurveKey(1, 2) == new CurveKey(1, 2));
        Assert.True(new CurveKey(1, 2) != new CurveKey(1, 3));
        Assert.Equal(new CurveKey(1, 2).GetHashCode(), new CurveKey(1, 3).GetHashCode());
        Assert.True(new CurveKey(1, 2).CompareTo(new CurveKey(2, 0)) < 0);
    }

    private static Curve Through(params (float Position, float Value)[] keys)
    {
        var curve = new Curve();
        foreach ((float position, float value) in keys)
        {
            curve.Keys.Add(new CurveKey(position, value));
        }

        return curve;
    }
}
