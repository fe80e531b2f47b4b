using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Lanes;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Loose;

/// <summary>
/// The rows of loose joints at their bodies' poses, as the kinds write them for one joint; what does not change with the pose stays.
/// </summary>
internal static unsafe class LooseForms
{
    /// <summary>The rows of a joint of this kind can be written here.</summary>
    public static bool Knows(JointKind kind) => kind switch
    {
        JointKind.Revolute or JointKind.Pin or JointKind.Distance or JointKind.Target or JointKind.Motor => true,
        JointKind.Angle or JointKind.Gear or JointKind.AngleLimit or JointKind.Rope or JointKind.Slider or JointKind.Pulley => true,
        _ => false,
    };

    /// <summary>Jacobians and errors.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Write(LooseBundle* bundle, LooseRow* rows, LoosePlace* place, LooseBody* bodies)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LooseFrame f = default;
            f.Set(DoubleLanes.Shift(bundle, lane), bodies, place->BodyA + lane, place->BodyB + lane);
            Write(f, DoubleLanes.Shift(bundle, lane), DoubleLanes.Shift(rows, lane), place);
        }
    }

    private static void Write(in LooseFrame f, LooseBundle* bundle, LooseRow* rows, LoosePlace* place)
    {
        f.RBX.Store(bundle->ArmB);
        f.RBY.Store(bundle->ArmB + 4);
        switch (place->Kind)
        {
            case JointKind.Revolute:
                WritePoint(f, rows);
                if (place->Rows > 3)
                {
                    WriteLimits(bundle, rows + 2, f.BAngle - f.AAngle - WideDouble.Load(bundle->Target));
                }

                break;
            case JointKind.AngleLimit:
                WriteLimits(bundle, rows, f.BAngle - f.AAngle);
                break;
            case JointKind.Motor:
                WriteOffset(f, rows);
                break;
            case JointKind.Pulley:
                WritePulley(f, bundle, rows, place->Rows);
                break;
            case JointKind.Pin when place->Rows > 1:
                WritePoint(f, rows);
                break;
            case JointKind.Angle:
            case JointKind.Gear:
                break;
            default:
                WriteDistances(f, bundle, rows, place);
                break;
        }
    }

    /// <summary>Of the rows of two points that are one only the arms change.</summary>
    private static void WritePoint(in LooseFrame f, LooseRow* rows)
    {
        f.RAY.Store(rows[0].Soft.A + 8);
        WideDouble.Negate(f.RBY).Store(rows[0].Soft.B + 8);
        WideDouble.Negate(f.RAX).Store(rows[1].Soft.A + 8);
        f.RBX.Store(rows[1].Soft.B + 8);
    }

    /// <summary>The arm of A reaches to B.</summary>
    private static void WriteOffset(in LooseFrame f, LooseRow* rows)
    {
        f.DY.Store(rows[0].Soft.A + 8);
        WideDouble.Negate(f.DX).Store(rows[1].Soft.A + 8);
    }

    private static void WriteLimits(LooseBundle* bundle, LooseRow* rows, WideDouble way)
    {
        (way - WideDouble.Load(bundle->Lower)).Store(rows[0].Error);
        (WideDouble.Load(bundle->Upper) - way).Store(rows[1].Error);
    }

    private static void WriteDistances(in LooseFrame f, LooseBundle* bundle, LooseRow* rows, LoosePlace* place)
    {
        WideDouble length = WideDouble.Sqrt((f.DX * f.DX) + (f.DY * f.DY));
        WideDoubleMask apart = length > WideDouble.Zero;
        WideDouble x = WideDouble.Select(apart, f.DX / length, WideDouble.Splat(1));
        WideDouble y = WideDouble.Select(apart, f.DY / length, WideDouble.Zero);
        switch (place->Kind)
        {
            case JointKind.Target:
                WriteDirection(f, rows, x, y);
                WriteDirection(f, rows + 1, WideDouble.Negate(y), x);
                length.Store(rows[0].Error);
                break;
            case JointKind.Rope:
                WriteOpposite(f, rows, x, y);
                (WideDouble.Load(bundle->Upper) - length).Store(rows[0].Error);
                break;
            case JointKind.Slider:
                WriteDirection(f, rows, x, y);
                WriteOpposite(f, rows + 1, x, y);
                WriteLimits(bundle, rows, length);
                break;
            default:
                WriteDirection(f, rows, x, y);
                (length - WideDouble.Load(bundle->Target)).Store(rows[0].Error);
                if (place->Rows > 1)
                {
                    WriteDirection(f, rows + 1, x, y);
                    WriteOpposite(f, rows + 2, x, y);
                    WriteLimits(bundle, rows + 1, length);
                }

                break;
        }
    }

    private static void WriteDirection(in LooseFrame f, LooseRow* row, WideDouble x, WideDouble y)
    {
        LaneRows.WriteRow(row->Soft.A, WideDouble.Negate(x), WideDouble.Negate(y), WideDouble.Negate((f.RAX * y) - (f.RAY * x)));
        LaneRows.WriteRow(row->Soft.B, x, y, (f.RBX * y) - (f.RBY * x));
    }

    private static void WriteOpposite(in LooseFrame f, LooseRow* row, WideDouble x, WideDouble y)
    {
        LaneRows.WriteRow(row->Soft.A, x, y, (f.RAX * y) - (f.RAY * x));
        LaneRows.WriteRow(row->Soft.B, WideDouble.Negate(x), WideDouble.Negate(y), WideDouble.Negate((f.RBX * y) - (f.RBY * x)));
    }

    private static void WritePulley(in LooseFrame f, LooseBundle* bundle, LooseRow* rows, int count)
    {
        WideDouble ax = f.AX + f.RAX - WideDouble.Load(bundle->GroundA);
        WideDouble ay = f.AY + f.RAY - WideDouble.Load(bundle->GroundA + 4);
        WideDouble bx = f.BX + f.RBX - WideDouble.Load(bundle->GroundB);
        WideDouble by = f.BY + f.RBY - WideDouble.Load(bundle->GroundB + 4);
        WideDouble lengthA = Unit(ref ax, ref ay);
        WideDouble lengthB = Unit(ref bx, ref by);
        WideDouble armA = (f.RAX * ay) - (f.RAY * ax);
        WideDouble armB = (f.RBX * by) - (f.RBY * bx);
        WideDouble ratio = WideDouble.Load(bundle->Ratio);
        WideDouble back = WideDouble.Negate(ratio);
        LaneRows.WriteRow(rows->Soft.A, WideDouble.Negate(ax), WideDouble.Negate(ay), WideDouble.Negate(armA));
        LaneRows.WriteRow(rows->Soft.B, back * bx, back * by, back * armB);
        (WideDouble.Load(bundle->Target) - lengthA - (ratio * lengthB)).Store(rows->Error);
        if (count > 1)
        {
            LaneRows.WriteRow(rows[1].Soft.A, WideDouble.Negate(ax), WideDouble.Negate(ay), WideDouble.Negate(armA));
            LaneRows.WriteRow(rows[2].Soft.B, WideDouble.Negate(bx), WideDouble.Negate(by), WideDouble.Negate(armB));
            (WideDouble.Load(bundle->Upper) - lengthA).Store(rows[1].Error);
            (WideDouble.Load(bundle->Lower) - lengthB).Store(rows[2].Error);
        }
    }

    private static WideDouble Unit(ref WideDouble x, ref WideDouble y)
    {
        WideDouble length = WideDouble.Sqrt((x * x) + (y * y));
        WideDoubleMask apart = length > WideDouble.Zero;
        x = WideDouble.Select(apart, x / length, WideDouble.Zero);
        y = WideDouble.Select(apart, y / length, WideDouble.Zero);
        return length;
    }
}
