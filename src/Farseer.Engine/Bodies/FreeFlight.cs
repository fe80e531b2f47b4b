using System.Numerics;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Bodies;

/// <summary>
/// Moves a body without constraints over a whole step, exactly: constant acceleration and linear drag in closed form, in
/// double precision. Quadratic and rotational drag, whose laws are exact by themselves, act in two halves around it.
/// </summary>
internal static class FreeFlight
{
    private const double LogSeriesLimit = 1e-3;

    /// <param name="bodies">The store.</param>
    /// <param name="body">Index of a body that can move.</param>
    /// <param name="gravity">Gravity that acts on it.</param>
    /// <param name="dt">The step, seconds.</param>
    /// <param name="substep">What a substep would be: the motion is noted as if the solver had done it.</param>
    public static void Advance(BodyStore bodies, int body, Vector2 gravity, double dt, double substep)
    {
        ref BodyState state = ref bodies.State[body];
        ref BodyMass mass = ref bodies.Mass[body];
        ref BodyForce force = ref bodies.Force[body];
        ref BodyDrag drag = ref bodies.Drag[body];
        ref BodyPose pose = ref bodies.Pose[body];
        ref BodyResidual rest = ref bodies.Residual[body];
        double vx = state.LinearVelocity.X + (rest.OfX == state.LinearVelocity.X ? rest.X : 0.0);
        double vy = state.LinearVelocity.Y + (rest.OfY == state.LinearVelocity.Y ? rest.Y : 0.0);
        double w = state.AngularVelocity + (rest.OfW == state.AngularVelocity ? rest.W : 0.0);
        double ax = gravity.X + ((double)force.Force.X * mass.InverseMass);
        double ay = gravity.Y + ((double)force.Force.Y * mass.InverseMass);
        double alpha = (double)force.Torque * mass.InverseInertia;

        double quadratic = (bodies.Flags[body] & BodyFlags.QuadraticDrag) != 0 ? (double)drag.Quadratic * mass.InverseMass : 0;
        HalfQuadratic(ref vx, ref vy, quadratic, dt / 2);
        var law = new DragLaw((double)drag.Linear * mass.InverseMass, dt);
        pose.X += (vx * law.First) + (ax * law.Second);
        pose.Y += (vy * law.First) + (ay * law.Second);
        vx = (vx * law.Keep) + (ax * law.First);
        vy = (vy * law.Keep) + (ay * law.First);
        HalfQuadratic(ref vx, ref vy, quadratic, dt / 2);

        pose.Angle += drag.Angular > 0
            ? Spin(ref w, alpha, (double)drag.Angular * mass.InverseInertia, dt)
            : Turn(ref w, alpha, (double)drag.Rotational * mass.InverseInertia, dt);
        Store(ref state, ref rest, vx, vy, w);
        ref BodyMotion motion = ref bodies.Motion[body];
        motion.StartX = (float)(vx - (ax * substep));
        motion.StartY = (float)(vy - (ay * substep));
        motion.StartW = (float)(w - (alpha * substep));
    }

    // dω/dt = α - k·ω, exactly.
    private static double Spin(ref double w, double alpha, double k, double dt)
    {
        var law = new DragLaw(k, dt);
        double angle = (w * law.First) + (alpha * law.Second);
        w = (w * law.Keep) + (alpha * law.First);
        return angle;
    }

    private static double Turn(ref double w, double alpha, double rotational, double dt)
    {
        double angle = HalfRotational(ref w, rotational, dt / 2);
        w += alpha * dt;
        return angle + HalfRotational(ref w, rotational, dt / 2);
    }

    private static void Store(ref BodyState state, ref BodyResidual rest, double vx, double vy, double w)
    {
        float x = (float)vx;
        float y = (float)vy;
        float z = (float)w;
        state.LinearVelocity = new Vector2(x, y);
        state.AngularVelocity = z;
        rest.X = (float)(vx - x);
        rest.Y = (float)(vy - y);
        rest.W = (float)(w - z);
        rest.OfX = x;
        rest.OfY = y;
        rest.OfW = z;
    }

    // dv/dt = -q·|v|·v gives v/(1 + q·|v|·t).
    private static void HalfQuadratic(ref double vx, ref double vy, double q, double t)
    {
        if (q > 0)
        {
            double keep = 1 / (1 + (q * System.Math.Sqrt((vx * vx) + (vy * vy)) * t));
            vx *= keep;
            vy *= keep;
        }
    }

    // dω/dt = -r·|ω|·ω gives ω/(1 + x) and an angle of ω·t·ln(1 + x)/x, with x = r·|ω|·t.
    private static double HalfRotational(ref double w, double r, double t)
    {
        double x = r * System.Math.Abs(w) * t;
        double mean = x < LogSeriesLimit ? 1 - (x / 2) + (x * x / 3) - (x * x * x / 4) : StableMath.Log(1 + x) / x;
        double angle = w * t * mean;
        w /= 1 + x;
        return angle;
    }
}
