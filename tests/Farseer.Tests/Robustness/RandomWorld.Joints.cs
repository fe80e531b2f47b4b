using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Tests.Robustness;

/// <content>Its joints.</content>
internal sealed partial class RandomWorld
{
    private const int JointKinds = 18;

    private enum Kind
    {
        Angle,
        AngleLimit,
        Distance,
        FixedAngle,
        FixedAngleLimit,
        FixedPrismatic,
        FixedRevolute,
        Gear,
        Motor,
        Pin,
        Prismatic,
        Pulley,
        Revolute,
        Rope,
        Slider,
        Target,
        Weld,
        Wheel,
    }

    /// <summary>A joint between two bodies, or of one with the world, as they stand.</summary>
    private void AddJoint()
    {
        int kind = _random.Next(JointKinds);
        Body one = Any();
        Body other = Any();
        Vector2 middle = (one.Position + other.Position) / 2;
        Vector2 anchor = middle + (0.2f * Around());
        Vector2 axis = Vector2.Normalize(Around());
        Vector2 end1 = 0.2f * Around();
        Vector2 end2 = 0.2f * Around();
        float low = Next(0, 1);
        float high = Next(0, 1);
        float strength = Next(0, 20);
        bool limited = _random.Next(2) == 0;
        bool driven = _random.Next(4) == 0;
        bool springy = _random.Next(3) == 0;
        bool soft = _random.Next(8) == 0;
        float frequency = Next(1, 8);
        float breaks = _random.Next(10) == 0 ? Next(0.05f, 0.5f) : float.MaxValue;
        bool collide = _random.Next(6) == 0;
        bool keeps = Keeps($"joint {(Kind)kind} of {_bodies.IndexOf(one)} and {_bodies.IndexOf(other)} limited {limited} driven {driven} "
            + $"springy {springy} soft {soft}");
        bool alone = (Kind)kind is Kind.FixedAngle or Kind.FixedAngleLimit or Kind.FixedPrismatic or Kind.FixedRevolute or Kind.Target;
        if ((one == other && !alone) || (one.IsStatic && (alone || other.IsStatic)))
        {
            return;
        }

        float apart = (other.GetWorldPosition(end2) - one.GetWorldPosition(end1)).Length();
        float turned = other.TotalRotation - one.TotalRotation;
        Joint joint = (Kind)kind switch
        {
            Kind.Angle => new AngleJoint(one, other, turned),
            Kind.AngleLimit => new AngleLimitJoint(one, other, turned - low, turned + high),
            Kind.Distance => new DistanceJoint(one, end1, other, end2)
            {
                Frequency = springy ? frequency : 0,
                AreLimitsEnabled = limited,
                LowerLimit = MathF.Max(0, apart - low),
                UpperLimit = apart + high,
            },
            Kind.FixedAngle => new FixedAngleJoint(one, one.TotalRotation),
            Kind.FixedAngleLimit => new FixedAngleLimitJoint(one, one.TotalRotation - low, one.TotalRotation + high),
            Kind.FixedPrismatic =>
                Limit(new FixedPrismaticJoint(one, anchor, axis) { MaxMotorForce = strength }, limited, driven, low, high),
            Kind.FixedRevolute => Limit(new FixedRevoluteJoint(one, anchor) { MaxMotorTorque = strength }, limited, driven, low, high),
            Kind.Gear => new GearJoint(one, other, 0.5f + high),
            Kind.Motor => new MotorJoint(one, other) { MaxForce = strength, MaxTorque = strength },
            Kind.Pin => new PinJoint(one, end1, other, end2),
            Kind.Prismatic => Limit(new PrismaticJoint(one, other, anchor, axis) { MaxMotorForce = strength }, limited, driven, low, high),
            Kind.Pulley => new PulleyJoint(one, end1, one.Position + new Vector2(0, 2), other, end2, other.Position + new Vector2(0, 2)),
            Kind.Revolute => Limit(new RevoluteJoint(one, other, anchor) { MaxMotorTorque = strength }, limited, driven, low, high),
            Kind.Rope => new RopeJoint(one, end1, other, end2, apart + high),
            Kind.Slider => new SliderJoint(one, end1, other, end2, MathF.Max(0, apart - low), apart + high),
            Kind.Target => new TargetJoint(one, one.Position) { MaxForce = 10 * strength },
            Kind.Weld => new WeldJoint(one, other, anchor) { Frequency = springy ? frequency : 0 },
            _ => Limit(
                new WheelJoint(one, other, anchor, axis) { Frequency = frequency, MaxMotorTorque = strength }, limited, driven, low, high),
        };
        joint.Softness = soft ? 0.1f : 0;
        joint.Breakpoint = breaks;
        joint.CollideConnected = collide;
        _joints.Add(joint);
        if (keeps && !_absent.Contains(one) && (alone || !_absent.Contains(other)))
        {
            _simulator.Add(joint);
        }
        else
        {
            _out.Add(joint);
        }
    }

    private static DrivenPairJoint Limit(DrivenPairJoint joint, bool limited, bool driven, float low, float high)
    {
        joint.AreLimitsEnabled = limited;
        joint.LowerLimit = -low;
        joint.UpperLimit = high;
        joint.IsMotorEnabled = driven;
        joint.MotorSpeed = 8 * (low - high);
        return joint;
    }

    private static DrivenWorldJoint Limit(DrivenWorldJoint joint, bool limited, bool driven, float low, float high)
    {
        joint.AreLimitsEnabled = limited;
        joint.LowerLimit = -low;
        joint.UpperLimit = high;
        joint.IsMotorEnabled = driven;
        joint.MotorSpeed = 8 * (low - high);
        return joint;
    }
}
