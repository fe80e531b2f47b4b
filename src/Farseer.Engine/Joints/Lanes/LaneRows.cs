using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>The rows of the forms for trees side by side, as the kinds write them for one joint: errors, gaps and Jacobians.</summary>
internal static unsafe class LaneRows
{
    private const int Row = LaneMatrix.Row;

    /// <summary>Arms, errors and gaps at two poses: x, y, angle, cosine and sine of each.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Place(LaneJoint* joint, LanePlace* place, double* a, double* b)
    {
        Arm(joint->AnchorA, a, joint->ArmA, out WideDouble ax, out WideDouble ay);
        Arm(joint->AnchorB, b, joint->ArmB, out WideDouble bx, out WideDouble by);
        WideDouble dx = (WideDouble.Load(b) - WideDouble.Load(a)) + (bx - ax);
        WideDouble dy = (WideDouble.Load(b + 4) - WideDouble.Load(a + 4)) + (by - ay);
        if (place->Form == LaneForm.Hinge)
        {
            dx.Store(joint->Error);
            dy.Store(joint->Error + 4);
            if (place->HasMore)
            {
                StoreTravel(joint, Bend(joint, a, b));
            }
        }
        else
        {
            dx.Store(joint->Apart);
            dy.Store(joint->Apart + 4);
            PlaceOther(joint, place, a, b);
        }

        if (place->Second == LaneForm.Range)
        {
            bool same = place->SecondIsA == place->IsA;
            WideDouble turn = WideDouble.Load(b + 8) - WideDouble.Load(a + 8);
            StoreGap(joint, same ? turn : WideDouble.Load(a + 8) - WideDouble.Load(b + 8));
        }
    }

    /// <summary>
    /// The Jacobians at the poses that were placed last, at the child of an edge or the body of an anchor and at the other body.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Write(LaneJoint* joint, double* other, LanePlace* place)
    {
        double* a = place->IsA ? joint->S : other;
        double* b = place->IsA ? other : joint->S;
        WideDouble ax = WideDouble.Load(joint->ArmA);
        WideDouble ay = WideDouble.Load(joint->ArmA + 4);
        WideDouble bx = WideDouble.Load(joint->ArmB);
        WideDouble by = WideDouble.Load(joint->ArmB + 4);
        (WideDouble.Sqrt((ax * ax) + (ay * ay)) + WideDouble.Sqrt((bx * bx) + (by * by))).Store(joint->Size);
        if (place->Form <= LaneForm.Weld)
        {
            WideDouble one = WideDouble.Splat(1);
            WriteRow(a, WideDouble.Negate(one), WideDouble.Zero, ay);
            WriteRow(a + Row, WideDouble.Zero, WideDouble.Negate(one), WideDouble.Negate(ax));
            WriteRow(b, one, WideDouble.Zero, WideDouble.Negate(by));
            WriteRow(b + Row, WideDouble.Zero, one, bx);
            if (place->Form == LaneForm.Weld)
            {
                WriteAngle(a + (2 * Row), b + (2 * Row), WideDouble.Negate(one));
            }

            return;
        }

        WriteOther(joint, a, b, place);
    }

    /// <summary>The row of the limits that hold, behind the others; where none does it is 0.</summary>
    /// <param name="joint">The joint.</param>
    /// <param name="other">The Jacobian at the other body.</param>
    /// <param name="place">What the joint is.</param>
    public static void WriteHeld(LaneJoint* joint, double* other, LanePlace* place)
    {
        int at = place->HardRows * Row;
        double* a = (place->LimitIsA ? joint->S : other) + at;
        double* b = (place->LimitIsA ? other : joint->S) + at;
        WideDoubleMask held = WideDouble.LoadMask(joint->Held);
        WideDoubleMask above = WideDouble.LoadMask(joint->HeldAbove);
        if (place->LimitTurns)
        {
            WideDouble one = WideDouble.Splat(1);
            WideDouble turn = WideDouble.Select(above, WideDouble.Negate(one), one);
            WriteRow(a, WideDouble.Zero, WideDouble.Zero, WideDouble.Select(held, WideDouble.Negate(turn), WideDouble.Zero));
            WriteRow(b, WideDouble.Zero, WideDouble.Zero, WideDouble.Select(held, turn, WideDouble.Zero));
            return;
        }

        for (int k = 0; k < Row; k += LaneMatrix.Step)
        {
            HoldAt(joint->LineA + k, held, above).Store(a + k);
            HoldAt(joint->LineB + k, held, above).Store(b + k);
        }
    }

    private static WideDouble HoldAt(double* line, WideDoubleMask held, WideDoubleMask above)
    {
        WideDouble lower = WideDouble.Load(line);
        return WideDouble.Select(held, WideDouble.Select(above, WideDouble.Negate(lower), lower), WideDouble.Zero);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Bend(LaneJoint* joint, double* a, double* b) =>
        WideDouble.Load(b + 8) - WideDouble.Load(a + 8) - WideDouble.Load(joint->Target);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StoreTravel(LaneJoint* joint, WideDouble way)
    {
        way.Store(joint->Travel);
        StoreGap(joint, way);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StoreGap(LaneJoint* joint, WideDouble way)
    {
        (way - WideDouble.Load(joint->Lower)).Store(joint->Gap);
        (WideDouble.Load(joint->Upper) - way).Store(joint->Gap + 4);
    }

    private static void PlaceOther(LaneJoint* joint, LanePlace* place, double* a, double* b)
    {
        WideDouble dx = WideDouble.Load(joint->Apart);
        WideDouble dy = WideDouble.Load(joint->Apart + 4);
        switch (place->Form)
        {
            case LaneForm.Weld:
                dx.Store(joint->Error);
                dy.Store(joint->Error + 4);
                Bend(joint, a, b).Store(joint->Error + 8);
                break;
            case LaneForm.Rod:
                (Direction(joint, dx, dy) - WideDouble.Load(joint->Target)).Store(joint->Error);
                break;
            case LaneForm.Span:
                StoreTravel(joint, Direction(joint, dx, dy));
                break;
            case LaneForm.Range:
                StoreGap(joint, WideDouble.Load(b + 8) - WideDouble.Load(a + 8));
                break;
            case LaneForm.Gear:
                (WideDouble.Load(b + 8) + (WideDouble.Load(joint->Axis) * WideDouble.Load(a + 8))
                    - WideDouble.Load(joint->Target)).Store(joint->Error);
                break;
            case LaneForm.Turning:
            case LaneForm.Sliding:
                WideDouble wayA = WayOf(joint->LineA, joint->ArmA, a);
                WideDouble wayB = WayOf(joint->LineB, joint->ArmB, b);
                (wayA + (WideDouble.Load(joint->Axis) * wayB) - WideDouble.Load(joint->Target)).Store(joint->Error);
                break;
            case LaneForm.Slide:
            case LaneForm.Track:
                PlaceOnLine(joint, place, a, b);
                break;
        }
    }

    /// <summary>Stores the unit vector from anchor to anchor; the x axis where they coincide.</summary>
    /// <returns>How far they are apart.</returns>
    private static WideDouble Direction(LaneJoint* joint, WideDouble dx, WideDouble dy)
    {
        WideDouble length = WideDouble.Sqrt((dx * dx) + (dy * dy));
        WideDoubleMask apart = length > WideDouble.Zero;
        WideDouble.Select(apart, dx / length, WideDouble.Splat(1)).Store(joint->Way);
        WideDouble.Select(apart, dy / length, WideDouble.Zero).Store(joint->Way + 4);
        return length;
    }

    /// <summary>All bits set for the lanes in which a transmission counts the turn, for want of a line.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDoubleMask CountsTurn(double* line)
    {
        WideDouble most = WideDouble.Abs(WideDouble.Load(line)) + WideDouble.Abs(WideDouble.Load(line + 4));
        return most <= WideDouble.Zero;
    }

    /// <summary>The turn of a body, or where its anchor is along a line of the world.</summary>
    private static WideDouble WayOf(double* line, double* arm, double* pose)
    {
        WideDouble x = WideDouble.Load(line) * (WideDouble.Load(pose) + WideDouble.Load(arm));
        WideDouble y = WideDouble.Load(line + 4) * (WideDouble.Load(pose + 4) + WideDouble.Load(arm + 4));
        return WideDouble.Select(CountsTurn(line), WideDouble.Load(pose + 8), x + y);
    }

    /// <summary>The Jacobian of <see cref="WayOf"/>, times a ratio.</summary>
    private static void WriteWay(double* line, double* arm, WideDouble ratio, double* row)
    {
        WideDouble x = WideDouble.Load(line);
        WideDouble y = WideDouble.Load(line + 4);
        WideDouble turn = (WideDouble.Load(arm) * y) - (WideDouble.Load(arm + 4) * x);
        WriteRow(row, ratio * x, ratio * y, ratio * WideDouble.Select(CountsTurn(line), WideDouble.Splat(1), turn));
    }

    private static void PlaceOnLine(LaneJoint* joint, LanePlace* place, double* a, double* b)
    {
        WideDouble dx = WideDouble.Load(joint->Apart);
        WideDouble dy = WideDouble.Load(joint->Apart + 4);
        Arm(joint->Axis, a, joint->Way, out WideDouble x, out WideDouble y);
        ((dy * x) - (dx * y)).Store(joint->Error);
        if (place->Form == LaneForm.Slide)
        {
            Bend(joint, a, b).Store(joint->Error + 4);
        }

        if (place->HasMore)
        {
            StoreTravel(joint, (dx * x) + (dy * y));
        }
    }

    private static void WriteOther(LaneJoint* joint, double* a, double* b, LanePlace* place)
    {
        WideDouble one = WideDouble.Splat(1);
        WideDouble x = WideDouble.Load(joint->Way);
        WideDouble y = WideDouble.Load(joint->Way + 4);
        switch (place->Form)
        {
            case LaneForm.Rod:
                WriteDirection(a, b, x, y, WideDouble.Load(joint->ArmA), WideDouble.Load(joint->ArmA + 4), joint->ArmB);
                (WideDouble.Load(joint->Size) + WideDouble.Load(joint->Target)).Store(joint->Size);
                break;
            case LaneForm.Servo:
                WriteAngle(a, b, WideDouble.Negate(one));
                break;
            case LaneForm.Gear:
                WriteAngle(a, b, WideDouble.Load(joint->Axis));
                break;
            case LaneForm.Turning:
            case LaneForm.Sliding:
                WriteWay(joint->LineA, joint->ArmA, one, a);
                WriteWay(joint->LineB, joint->ArmB, WideDouble.Load(joint->Axis), b);
                break;
            case LaneForm.Span:
                WriteDirection(
                    joint->LineA, joint->LineB, x, y, WideDouble.Load(joint->ArmA), WideDouble.Load(joint->ArmA + 4), joint->ArmB);
                (WideDouble.Load(joint->Size) + WideDouble.Load(joint->Upper)).Store(joint->Size);
                break;
            case LaneForm.Range:
                break;
            default:
                // The line turns with body A, so that its arm reaches as far as the anchor of B.
                WideDouble armX = WideDouble.Load(joint->ArmA) + WideDouble.Load(joint->Apart);
                WideDouble armY = WideDouble.Load(joint->ArmA + 4) + WideDouble.Load(joint->Apart + 4);
                WriteDirection(a, b, WideDouble.Negate(y), x, armX, armY, joint->ArmB);
                if (place->Form == LaneForm.Slide)
                {
                    WriteAngle(a + Row, b + Row, WideDouble.Negate(one));
                }

                if (place->HasMore)
                {
                    WriteDirection(joint->LineA, joint->LineB, x, y, armX, armY, joint->ArmB);
                }

                break;
        }
    }

    /// <summary>A row along a unit vector.</summary>
    private static void WriteDirection(double* a, double* b, WideDouble x, WideDouble y, WideDouble armX, WideDouble armY, double* armB)
    {
        WriteRow(a, WideDouble.Negate(x), WideDouble.Negate(y), WideDouble.Negate((armX * y) - (armY * x)));
        WriteRow(b, x, y, (WideDouble.Load(armB) * y) - (WideDouble.Load(armB + 4) * x));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void WriteAngle(double* a, double* b, WideDouble ofA)
    {
        WriteRow(a, WideDouble.Zero, WideDouble.Zero, ofA);
        WriteRow(b, WideDouble.Zero, WideDouble.Zero, WideDouble.Splat(1));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void WriteRow(double* row, WideDouble x, WideDouble y, WideDouble w)
    {
        x.Store(row);
        y.Store(row + 4);
        w.Store(row + 8);
    }

    /// <summary>A vector of a body's frame in world axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Arm(double* own, double* pose, double* arm, out WideDouble x, out WideDouble y)
    {
        WideDouble ox = WideDouble.Load(own);
        WideDouble oy = WideDouble.Load(own + 4);
        WideDouble cos = WideDouble.Load(pose + 12);
        WideDouble sin = WideDouble.Load(pose + 16);
        x = (cos * ox) - (sin * oy);
        y = (sin * ox) + (cos * oy);
        x.Store(arm);
        y.Store(arm + 4);
    }
}
