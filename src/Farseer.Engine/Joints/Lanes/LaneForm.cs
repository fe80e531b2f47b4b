namespace Farseer.Engine.Joints.Lanes;

/// <summary>What trees on lanes know a joint as: the rows that always hold, as the kinds write them.</summary>
internal enum LaneForm : byte
{
    /// <summary>None of them: its tree is solved by itself.</summary>
    None,

    /// <summary>Two anchors in one place: two rows.</summary>
    Hinge,

    /// <summary>A hinge that does not turn: a third row, of the angle.</summary>
    Weld,

    /// <summary>Anchor B on a line of body A, without turning: a row across the line, and one of the angle.</summary>
    Slide,

    /// <summary>Anchor B on a line of body A: one row across the line.</summary>
    Track,

    /// <summary>Two anchors at a distance: one row along it.</summary>
    Rod,

    /// <summary>A turn at a speed that is set for the step: one row.</summary>
    Servo,

    /// <summary>Two angles in a ratio: one row.</summary>
    Gear,

    /// <summary>
    /// Two turns in a ratio, or with <see cref="Sliding"/> a turn or a way along a line of the world at either body: one row.
    /// </summary>
    Turning,
    Sliding,

    /// <summary>A range of the turn between two bodies: no row but that of a limit that holds.</summary>
    Range,

    /// <summary>
    /// A range of the distance of two anchors, of which a rope has the upper end only: no row but that of a limit that holds.
    /// </summary>
    Span,
}

/// <summary>What follows from the form alone.</summary>
internal static class LaneForms
{
    /// <summary>The form of a joint of a tree.</summary>
    /// <param name="kind">Its kind.</param>
    /// <param name="rows">Its rows; those behind the hard ones are not looked at.</param>
    public static LaneForm Of(JointKind kind, in JointRows rows)
    {
        LaneForm form = kind switch
        {
            JointKind.Revolute => LaneForm.Hinge,
            JointKind.Pin => rows.Hard == 2 ? LaneForm.Hinge : LaneForm.Rod,
            JointKind.Weld => rows.Hard == 2 ? LaneForm.Hinge : LaneForm.Weld,
            JointKind.Prismatic => LaneForm.Slide,
            JointKind.Wheel => LaneForm.Track,
            JointKind.Distance => LaneForm.Rod,
            JointKind.Angle => LaneForm.Servo,
            JointKind.Gear => LaneForm.Gear,
            JointKind.Transmission => rows.Turns(0) ? LaneForm.Turning : LaneForm.Sliding,
            JointKind.AngleLimit => LaneForm.Range,
            JointKind.Slider or JointKind.Rope => LaneForm.Span,
            _ => LaneForm.None,
        };
        return rows.Hard == RowsOf(form) ? form : LaneForm.None;
    }

    /// <summary>Rows that always hold.</summary>
    public static int RowsOf(LaneForm form) => form switch
    {
        LaneForm.Weld => 3,
        LaneForm.Hinge or LaneForm.Slide => 2,
        LaneForm.Range or LaneForm.Span => 0,
        _ => 1,
    };

    /// <summary>
    /// It may have limits, motors and springs, all along one line or all of one angle; of a track, motors turn its wheel.
    /// </summary>
    public static bool MayHaveMore(LaneForm form) =>
        form == LaneForm.Hinge || form == LaneForm.Slide || form == LaneForm.Track || RowsOf(form) == 0;

    /// <summary>It may stand between the two bodies of another joint as well: it has neither arms nor errors.</summary>
    public static bool MayBeSecond(LaneForm form) => form == LaneForm.Range || form == LaneForm.Servo;

    /// <summary>Its limits bound a turn; else a way along its line.</summary>
    public static bool BoundsTurn(LaneForm form) => form == LaneForm.Hinge || form == LaneForm.Range;

    /// <summary>A bit for each row of angles; the others are of lengths.</summary>
    public static int TurningRowsOf(LaneForm form) => form switch
    {
        LaneForm.Weld => 1 << 2,
        LaneForm.Slide => 1 << 1,
        LaneForm.Gear or LaneForm.Servo or LaneForm.Turning => 1,
        _ => 0,
    };
}
