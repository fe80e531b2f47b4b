using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;
using Xunit;

namespace Farseer.Tests.Fidelity;

/// <summary>The judge itself: it must accept the original and refuse what is wrong.</summary>
public sealed class JudgeTests
{
    public static TheoryData<string> AllScenes => new(ReferenceData.Scenes.Select(s => s.Name));

    public static TheoryData<string> MovingScenes =>
        new(ReferenceData.Scenes.Where(s => s.SampleSteps.Length > 1 && s.Recordings[5].Rows.Count > 0).Select(s => s.Name));

    [Theory]
    [MemberData(nameof(AllScenes))]
    public void Judge_OriginalAtFiveIterations_Passes(string name)
    {
        SceneFile scene = ReferenceData.Scene(name);
        Recording original = scene.Recordings[5];

        IEnumerable<Check> checks = RowJudge.Judge(scene, 5, original)
            .Concat(EventJudge.Judge(scene, 5, original))
            .Concat(ObservationJudge.Judge(scene, 5, original))
            .Concat(QueryJudge.Queries(scene, 5, original, exactly: false));

        Assert.All(checks, c => Assert.True(c.Passed, c.ToString()));
    }

    [Theory]
    [MemberData(nameof(MovingScenes))]
    public void Judge_BodyMovedByThreeLimits_Fails(string name)
    {
        SceneFile scene = ReferenceData.Scene(name);
        string body = scene.Recordings[5].Rows.Keys.First();
        double limit = RowJudge.LargestLimits(scene, 5).Position;
        Recording moved = With(scene.Recordings[5], body, r => r with { X = r.X + (3 * limit) + 1e-6 });

        Assert.Contains(RowJudge.Judge(scene, 5, moved), c => c.What == "position" && !c.Passed);
    }

    /// <summary>The share of a row after the start, or after a force is switched on, is that of the row after it and no more.</summary>
    [Theory]
    [InlineData("joint_break", "breaks", 31)]
    [InlineData("joint_softness", "s6", 1)]
    public void Limit_OfTheFirstRowUnderAForce_IsThatOfTheNextRow(string name, string body, int row)
    {
        SceneFile scene = ReferenceData.Scene(name);
        Row[] rows = scene.Recordings[5].Rows[body];
        Discretisation limits = new(scene, rows, new Impacts(scene, rows, FloatTolerance.Of(scene, [rows])));

        Assert.Equal(limits.At(row + 1).LinearVelocity, limits.At(row).LinearVelocity, 1e-9);
        Assert.True(limits.At(row + 2).LinearVelocity > limits.At(row).LinearVelocity);
    }

    [Fact]
    public void Judge_PinThatHoldsOneUpdateLess_Fails()
    {
        SceneFile scene = ReferenceData.Scene("joint_break");

        // The pull of one update after the break: 1500 and the weight of 100, for 0.01 s.
        int broken = Array.IndexOf(scene.SampleSteps, 76);
        Recording early = scene.Recordings[5] with
        {
            Rows = scene.Recordings[5].Rows.ToDictionary(
                p => p.Key,
                p => p.Value.Select((r, i) => i >= broken && p.Key == "breaks" ? r with { VelocityY = r.VelocityY + 16 } : r).ToArray()),
        };

        Assert.Contains(RowJudge.Judge(scene, 5, early), c => c.What == "linearVelocity" && !c.Passed);
    }

    [Fact]
    public void Judge_BodyThatShouldStandStill_MayNotMove()
    {
        SceneFile scene = ReferenceData.Scene("track");
        Recording still = scene.Recordings[5];
        string body = still.Rows.Keys.First();
        double speed = FloatTolerance.OfStanding(scene, scene.Refined!.Rows[body]).LinearVelocity;

        Assert.InRange(speed, 1e-6, 1e-2);
        Assert.Contains(RowJudge.Judge(scene, 5, With(still, body, r => r with { VelocityX = r.VelocityX + (2 * speed) })), c => !c.Passed);
        Assert.Contains(RowJudge.Judge(scene, 5, With(still, body, r => r with { X = r.X + 1e-3 })), c => !c.Passed);
        Assert.Equal(default, FloatTolerance.OfStanding(scene, [still.Rows[body][0], still.Rows[body][1] with { X = 0 }]));
    }

    [Fact]
    public void Judge_NotANumber_Fails()
    {
        SceneFile scene = ReferenceData.Scene("free_fall");
        Recording broken = With(scene.Recordings[5], scene.Recordings[5].Rows.Keys.First(), r => r with { VelocityY = double.NaN });

        Assert.Contains(RowJudge.Judge(scene, 5, broken), c => c.What == "linearVelocity" && !c.Passed);
    }

    [Fact]
    public void Judge_EventMissingExtraLateOrOutOfOrder_Fails()
    {
        SceneFile scene = ReferenceData.Scene("remove_geom");
        Recording original = scene.Recordings[5];
        IReadOnlyList<SceneEvent> events = original.Events!;
        SceneEvent late = events[0] with { Runs = [(events[0].Runs[0].First + 20, events[0].Runs[0].Last)] };
        SceneEvent extra = events[0] with { Type = "OnSeparation" };

        Assert.True(Passes(scene, original with { Events = events }));
        Assert.False(Passes(scene, original with { Events = events.Skip(1).ToList() }));
        Assert.False(Passes(scene, original with { Events = events.Append(extra).ToList() }));
        Assert.False(Passes(scene, original with { Events = events.Skip(1).Prepend(late).ToList() }));
        Assert.False(Passes(scene, original with { Events = events.Reverse().ToList() }));
    }

    private static bool Passes(SceneFile scene, Recording recording) => EventJudge.Judge(scene, 5, recording).All(c => c.Passed);

    private static Recording With(Recording recording, string body, Func<Row, Row> change)
    {
        Dictionary<string, Row[]> rows =
            recording.Rows.ToDictionary(p => p.Key, p => p.Key == body ? p.Value.Select(change).ToArray() : p.Value);
        return recording with { Rows = rows };
    }
}
