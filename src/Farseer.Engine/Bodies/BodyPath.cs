using Farseer.Engine.Numerics;

namespace Farseer.Engine.Bodies;

/// <summary>
/// Where a body is in a stretch of time, by the share f of it that has passed, 0 to 1: x + v·f + ½·a·f² for both coordinates and
/// the angle, lengths and radians. Exact for constant acceleration, which is what happens between impacts.
/// </summary>
internal struct BodyPath
{
    public double X;
    public double Y;
    public double Angle;
    public double VelocityX;
    public double VelocityY;
    public double Spin;
    public double AccelerationX;
    public double AccelerationY;
    public double SpinGain;

    public static BodyPath Resting(in BodyPose pose) => new BodyPath { X = pose.X, Y = pose.Y, Angle = pose.Angle };

    /// <summary>Where it is at a share of the time.</summary>
    public readonly BodyPose PoseAt(double f)
    {
        Rotation turn = StableMath.FromAngle(AngleAt(f));
        return new BodyPose { X = XAt(f), Y = YAt(f), Angle = AngleAt(f), Cos = turn.Cos, Sin = turn.Sin };
    }

    public readonly double XAt(double f) => X + (f * (VelocityX + (0.5 * f * AccelerationX)));

    public readonly double YAt(double f) => Y + (f * (VelocityY + (0.5 * f * AccelerationY)));

    public readonly double AngleAt(double f) => Angle + (f * (Spin + (0.5 * f * SpinGain)));

    public readonly double VelocityXAt(double f) => VelocityX + (f * AccelerationX);

    public readonly double VelocityYAt(double f) => VelocityY + (f * AccelerationY);

    public readonly double SpinAt(double f) => Spin + (f * SpinGain);
}
