using System;
using System.Linq;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>
/// The part of a recording's error that is its integrator's. The original moves a body with the
/// velocity at the END of a step; the exact path uses the mean. The two differ by dt/2 times the
/// change of velocity in that step, hence after any number of steps by at most dt/2 times the total
/// variation of the velocity (exactly that for a free fall from rest: g dt t / 2). At an impact the
/// moment itself is only known to one step, which displaces a body by up to dt times the jump, and whose speed is that of
/// a step earlier or later from then on.
/// The same holds one derivative up, where the acceleration changes smoothly (drag, springs, joints). What it changes within an
/// interval shows in the difference of the means of that interval and the one before. Where there is none before (the start) or
/// the one before knows nothing of it (a force is switched on), it shows in the difference to the next interval only: that
/// share, which the next row has anyway, is then due a row earlier.
/// </summary>
/// <remarks>
/// An example is a bob on a pin: pulled with 900 for two updates of 0.01 s it is 0.27 along in the original and 0.18 in truth,
/// so a pin of 50 is turned by 0.0018 more, and of the speed of 18 there is 0.032 more along y.
/// </remarks>
public sealed class Discretisation
{
    /// <summary>Largest change of acceleration, against its size, that counts as smooth and not as a force switched on or off.</summary>
    private const double SmoothShare = 0.5;

    private readonly double[] _position;
    private readonly double[] _rotation;
    private readonly double[] _velocity;
    private readonly double[] _angular;
    private readonly double[] _earlyVelocity;
    private readonly double[] _earlyAngular;
    private readonly double[] _earlyPosition;
    private readonly double _struck;

    public Discretisation(SceneFile file, Row[] rows, Impacts impacts)
    {
        _position = new double[rows.Length];
        _rotation = new double[rows.Length];
        _velocity = new double[rows.Length];
        _angular = new double[rows.Length];
        _earlyVelocity = new double[rows.Length];
        _earlyAngular = new double[rows.Length];
        _earlyPosition = new double[rows.Length];
        double gravity = Impacts.Gravity(file);
        for (int k = 1; k < rows.Length; k++)
        {
            if (rows[k].IsAbsent || rows[k - 1].IsAbsent)
            {
                continue;
            }

            bool impact = impacts.Between(k - 1);

            // An impact that comes a step later in the recording: there the body still goes on, into what it strikes.
            _earlyPosition[k - 1] = impact ? file.LongestDt * Speed(rows[k], rows[k - 1]) : 0;
            double share = impact ? file.LongestDt : file.LongestDt / 2;
            double elapsed = (file.SampleSteps[k] - file.SampleSteps[k - 1]) * (double)file.Dt;

            // Where rows are far apart a body may have gained speed between the row and the impact.
            double gained = impact && file.Format == SceneFormat.Box2DFlash ? gravity * elapsed : 0;
            _position[k] = _position[k - 1] + (share * (Speed(rows[k], rows[k - 1]) + gained));
            _rotation[k] = _rotation[k - 1] + (share * Math.Abs(rows[k].AngularVelocity - rows[k - 1].AngularVelocity));

            // What speed an impact left too much or too little moves the body on, by no more than it goes at all.
            double way = Math.Sqrt(Square(rows[k].X - rows[k - 1].X) + Square(rows[k].Y - rows[k - 1].Y));
            _position[k] += Math.Min(way, _struck * elapsed);

            // The speed at an impact is that at a moment known to one step, on either side of it.
            double pull = file.Format == SceneFormat.Box2DFlash ? Math.Max(gravity, Beside(file, rows, k)) : gravity;
            _struck += impact ? 2 * file.Dt * pull : 0;
            _velocity[k] = _velocity[k - 1] + (impact ? 2 * file.Dt * pull : 0);
            _angular[k] = _angular[k - 1];
            double half = file.LongestDt / 2 / elapsed;
            _velocity[k] += half * (Smooth(rows, impacts, k, SpeedChange) ?? 0);
            _angular[k] += half * (Smooth(rows, impacts, k, SpinChange) ?? 0);
            _earlyVelocity[k] = impact ? 0 : half * Early(rows, impacts, k, SpeedChange);
            _earlyAngular[k] = impact ? 0 : half * Early(rows, impacts, k, SpinChange);
        }
    }

    public Difference At(int row) => new(
        _position[row] + _earlyPosition[row], _rotation[row], _velocity[row] + _earlyVelocity[row], _angular[row] + _earlyAngular[row]);

    public static double Speed(Row a, Row b) => Math.Sqrt(Square(a.VelocityX - b.VelocityX) + Square(a.VelocityY - b.VelocityY));

    /// <summary>
    /// The acceleration beside an interval in which the velocity jumps: what acts before or after the jump (a motor, say) acts for up to
    /// a step more or less. 0 where the interval itself is no jump against both of its neighbours.
    /// </summary>
    private static double Beside(SceneFile file, Row[] rows, int k)
    {
        double Mean(int end) => end < 1 || end >= rows.Length || rows[end].IsAbsent || rows[end - 1].IsAbsent
            ? 0
            : Speed(rows[end], rows[end - 1]) / ((file.SampleSteps[end] - file.SampleSteps[end - 1]) * (double)file.Dt);
        double beside = Math.Max(Mean(k - 1), Mean(k + 1));
        return beside < SmoothShare * Mean(k) ? beside : 0;
    }

    /// <summary>The smooth change that ends with row <paramref name="k"/>; null: there is none before, or it is a jump.</summary>
    private static double? Smooth(Row[] rows, Impacts impacts, int k, Func<Row, Row, Row, (double Change, double Size)> measure)
    {
        if (k < 2 || k >= rows.Length || impacts.Between(k - 1) || impacts.Between(k - 2))
        {
            return null;
        }

        (double change, double size) = measure(rows[k - 2], rows[k - 1], rows[k]);
        return change <= SmoothShare * size ? change : null;
    }

    /// <summary>The change from this interval to the next, where that is the first to show it.</summary>
    private static double Early(Row[] rows, Impacts impacts, int k, Func<Row, Row, Row, (double Change, double Size)> measure)
        => Smooth(rows, impacts, k, measure) is null ? Smooth(rows, impacts, k + 1, measure) ?? 0 : 0;

    private static (double Change, double Size) SpeedChange(Row a, Row b, Row c) => (
        Math.Sqrt(Square(c.VelocityX - (2 * b.VelocityX) + a.VelocityX) + Square(c.VelocityY - (2 * b.VelocityY) + a.VelocityY)),
        Math.Max(Speed(b, a), Speed(c, b)));

    private static (double Change, double Size) SpinChange(Row a, Row b, Row c) => (
        Math.Abs(c.AngularVelocity - (2 * b.AngularVelocity) + a.AngularVelocity),
        Math.Max(Math.Abs(b.AngularVelocity - a.AngularVelocity), Math.Abs(c.AngularVelocity - b.AngularVelocity)));

    private static double Square(double value) => value * value;
}

/// <summary>Between which rows of a body its velocity jumps, as no force of the scene could make it.</summary>
public sealed class Impacts
{
    /// <summary>A change of velocity above this many times gravity's is an impact: weight and friction together stay below it.</summary>
    private const double GravityShare = 2;

    private readonly bool[] _between;

    public Impacts(SceneFile file, Row[] rows, FloatTolerance rounding)
    {
        _between = new bool[Math.Max(0, rows.Length - 1)];
        if (!SceneSizes.MayTouch(file))
        {
            if (file.Joints.Any(j => j.Factory is "CreateSliderJoint" or "CreateAngleLimitJoint" or "CreateFixedAngleLimitJoint"))
            {
                FindJumps(rows, rounding);
            }

            return;
        }

        double gravity = Gravity(file);
        double halfWidth = SceneSizes.SmallestHalfWidth(file);
        for (int j = 0; j < _between.Length; j++)
        {
            double smooth = GravityShare * gravity * (file.SampleSteps[j + 1] - file.SampleSteps[j]) * file.Dt;
            bool linear = Discretisation.Speed(rows[j + 1], rows[j]) > smooth + rounding.LinearVelocity;
            bool angular =
                Math.Abs(rows[j + 1].AngularVelocity - rows[j].AngularVelocity) > (smooth / halfWidth) + rounding.AngularVelocity;
            _between[j] = linear || angular;
        }
    }

    /// <summary>Whether there is an impact between row <paramref name="row"/> and the next.</summary>
    public bool Between(int row) => row >= 0 && row < _between.Length && _between[row];

    public static double Gravity(SceneFile file)
    {
        double x = file.Gravity[0].GetDouble();
        double y = file.Gravity[1].GetDouble();
        return Math.Sqrt((x * x) + (y * y));
    }

    /// <summary>
    /// Where nothing touches, an end of a joint's way may be struck: the velocity changes by more than twice what it does in the
    /// intervals beside.
    /// </summary>
    private void FindJumps(Row[] rows, FloatTolerance rounding)
    {
        double Linear(int j) => j < 0 || j >= _between.Length ? 0 : Discretisation.Speed(rows[j + 1], rows[j]);
        double Angular(int j) => j < 0 || j >= _between.Length ? 0 : Math.Abs(rows[j + 1].AngularVelocity - rows[j].AngularVelocity);
        for (int j = 0; j < _between.Length; j++)
        {
            _between[j] = Linear(j) > (GravityShare * Math.Max(Linear(j - 1), Linear(j + 1))) + rounding.LinearVelocity
                || Angular(j) > (GravityShare * Math.Max(Angular(j - 1), Angular(j + 1))) + rounding.AngularVelocity;
        }
    }
}
