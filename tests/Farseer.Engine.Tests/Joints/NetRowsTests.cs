using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Joints.Nets;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Joints;

/// <summary>
/// The rows of nets on lanes against the scalar truth: Jacobians as the kinds write them at the pose of the substep, the dense response
/// of the block, all in double. Rows are floats: their errors are some roundings of the largest speed or impulse that the pair has had.
/// </summary>
public unsafe class NetRowsTests
{
    private const double H = 1.0 / 300;
    private const double Tolerance = 2e-6;

    [Theory]
    [InlineData("Revolute", 1.0, false)]
    [InlineData("Weld", 1.0, false)]
    [InlineData("Distance", 1.0, false)]
    [InlineData("Revolute", 1e6, false)]
    [InlineData("Weld", 1e-6, false)]
    [InlineData("Distance", 1e6, false)]
    [InlineData("Revolute", 1.0, true)]
    [InlineData("Weld", 1.0, true)]
    [InlineData("Distance", 1.0, true)]
    public void Rows_OfSubstep_AreThoseOfTheScalarFormula(string kind, double mass, bool fromOutside)
    {
        for (int seed = 0; seed < 40; seed++)
        {
            var pair = new Pairs((JointKind)Enum.Parse(typeof(JointKind), kind), seed, mass, fromOutside);
            pair.Compare("placed");
            pair.Rows.WarmStart(0, pair.Rows.BundleCount, pair.Motion);
            pair.WarmStart();
            pair.Compare("warm");
            var step = new JointStep { Substep = H, Dt = H * 1e-9, ErrorScale = 1 };
            pair.Rows.Solve(0, pair.Rows.BundleCount, pair.Motion, NetSoftness.Soft(step));
            pair.Solve(biased: true);
            pair.Compare("biased");
            pair.Move();
            pair.Rows.TurnAndRelax(0, pair.Rows.BundleCount, pair.Motion);
            pair.Solve(biased: false);
            pair.Compare("relaxed");
        }
    }

    [Fact]
    public void Rows_ThatComeAndGo_LeaveTheOthersAsTheyAre()
    {
        var random = new Random(1);
        var rows = new NetPivots(sequential: false);
        var place = new System.Collections.Generic.List<int>();
        for (int i = 0; i < 2000; i++)
        {
            if (place.Count == 0 || random.Next(5) > 1)
            {
                int row = rows.AddRow();
                rows.EndsOf(row)->Joint[rows.LaneOf(row)] = i;
                rows.AnchorsOf(row).AX = i;
                place.Add(i);
            }
            else
            {
                int row = random.Next(place.Count);
                int moved = rows.RemoveRow(row);
                Assert.Equal(row == place.Count - 1 ? -1 : place[^1], moved);
                place[row] = place[^1];
                place.RemoveAt(place.Count - 1);
            }

            Assert.Equal(place.Count, rows.RowCount);
            for (int row = 0; row < place.Count; row++)
            {
                Assert.Equal(place[row], rows.EndsOf(row)->Joint[rows.LaneOf(row)]);
                Assert.Equal(place[row], rows.AnchorsOf(row).AX);
            }
        }
    }

    /// <summary>Pairs of bodies, a joint each: rows on lanes, and the truth beside them.</summary>
    private sealed class Pairs
    {
        private const int Count = 13;

        private readonly Random _random;
        private readonly JointForm _form;
        private readonly JointSettings[] _settings = new JointSettings[Count];
        private readonly BodyStore _bodies = new BodyStore();
        private readonly Column<NetPose> _poses = new Column<NetPose>((2 * Count) + 1);
        private readonly double[,] _velocity = new double[(2 * Count) + 1, 3];
        private readonly double[,] _impulse = new double[Count, 3];
        private readonly double[] _fastest = new double[Count];
        private readonly double[] _largest = new double[Count];
        private readonly double _unit;
        private readonly double _share;

        /// <param name="fromOutside">The errors are as large as the joints: no speed of the rows is to take them out.</param>
        public Pairs(JointKind kind, int seed, double mass, bool fromOutside)
        {
            _random = new Random(seed);
            _unit = mass;
            _share = fromOutside ? 0 : 1;
            _form = new JointKinds().Of(kind);
            _bodies.Set.EnsureCapacity((2 * Count) + 1);
            Rows = kind switch
            {
                JointKind.Weld => new NetWelds(sequential: false),
                JointKind.Distance => new NetRods(sequential: false),
                _ => new NetPivots(sequential: false),
            };
            for (int body = 1; body <= 2 * Count; body++)
            {
                Scatter(body, still: body > Count && _random.Next(4) == 0);
            }

            for (int i = 0; i < Count; i++)
            {
                Tie(i);
            }

            Motion = new NetMotion(_bodies);
            Rows.Place(0, Rows.BundleCount, _poses.Pointer, 1);
            if (!fromOutside)
            {
                // The errors are those that the step before left.
                Rows.Turn(0, Rows.BundleCount, Motion, displaced: false);
            }

            Assert.Equal(fromOutside, Rows.Begin(0, Rows.BundleCount, Motion, 1));
        }

        public NetRows Rows { get; }

        public NetMotion Motion { get; }

        public void WarmStart()
        {
            for (int i = 0; i < Count; i++)
            {
                JointRows rows = At(i);
                for (int k = 0; k < rows.Hard; k++)
                {
                    Push(i, rows, k, _impulse[i, k]);
                }
            }
        }

        public void Solve(bool biased)
        {
            for (int i = 0; i < Count; i++)
            {
                JointRows rows = At(i);
                double[] impulse = Inverse(i, rows, biased);
                for (int k = 0; k < rows.Hard; k++)
                {
                    // Soft: ωh = π/2, ζ = 2, so with P = ωh (2ζ + ωh) the impulse is P/(1 + P) of the rigid one less λ/(1 + P).
                    double p = Math.PI / 2 * (4 + (Math.PI / 2));
                    double change = biased ? ((impulse[k] * p) - _impulse[i, k]) / (1 + p) : impulse[k];
                    _impulse[i, k] += change;
                    Push(i, rows, k, change);
                }
            }
        }

        /// <summary>Moves and turns the bodies as a substep might.</summary>
        public void Move()
        {
            for (int body = 1; body <= 2 * Count; body++)
            {
                if (_poses[body].InverseMass > 0)
                {
                    Displace(body);
                }
            }
        }

        public void Compare(string when)
        {
            for (int i = 0; i < Count; i++)
            {
                for (int body = 1 + i; body <= 2 * Count; body += Count)
                {
                    BodyState state = _bodies.State[body];
                    Near(_velocity[body, 0], state.LinearVelocity.X, _fastest[i], when);
                    Near(_velocity[body, 1], state.LinearVelocity.Y, _fastest[i], when);
                    Near(_velocity[body, 2], state.AngularVelocity, _fastest[i], when);
                }

                JointRows rows = At(i);
                JointState told = default;
                Rows.Report(i, ref told, 1);
                for (int k = 0; k < rows.Hard; k++)
                {
                    Near(_impulse[i, k], told.Impulse[k], _largest[i], when);
                }
            }
        }

        private static void Near(double expected, double actual, double size, string when) =>
            Assert.True(Math.Abs(expected - actual) <= Tolerance * size, when + ": " + actual + " instead of " + expected);

        private void Scatter(int body, bool still)
        {
            ref NetPose pose = ref _poses[body];
            double apart = _share == 0 && body > Count ? 10 : 0;
            pose.X = 1000 + apart + (2 * _random.NextDouble());
            pose.Y = -1000 + apart + (2 * _random.NextDouble());
            pose.Angle = apart + (6 * _random.NextDouble());
            pose.Cos = Math.Cos(pose.Angle);
            pose.Sin = Math.Sin(pose.Angle);
            pose.InverseMass = still ? 0 : (float)((0.1 + _random.NextDouble()) / _unit);
            pose.InverseInertia = still || _random.Next(4) == 0 ? 0 : (float)((0.1 + (20 * _random.NextDouble())) / _unit);
            ref BodyState state = ref _bodies.State[body];
            state.DeltaCos = 1;
            for (int k = 0; k < 3; k++)
            {
                _velocity[body, k] = (float)((4 * _random.NextDouble()) - 2);
            }

            state.LinearVelocity.X = (float)_velocity[body, 0];
            state.LinearVelocity.Y = (float)_velocity[body, 1];
            state.AngularVelocity = (float)_velocity[body, 2];
            if (!still)
            {
                Displace(body);
            }
        }

        private void Displace(int body)
        {
            ref BodyState state = ref _bodies.State[body];
            state.DeltaPosition.X = (float)(0.04 * (_random.NextDouble() - 0.5));
            state.DeltaPosition.Y = (float)(0.04 * (_random.NextDouble() - 0.5));
            float turned = (float)(_random.NextDouble() - 0.5);
            _bodies.Motion[body].Turned = turned;
            state.DeltaSin = (float)Math.Sin(turned);
            state.DeltaCos = (float)Math.Cos(turned);
        }

        private void Tie(int i)
        {
            _settings[i] = new JointSettings
            {
                AnchorAX = _random.NextDouble() - 0.5,
                AnchorAY = _random.NextDouble() - 0.5,
                AnchorBX = _random.NextDouble() - 0.5,
                AnchorBY = _random.NextDouble() - 0.5,
                Target = _random.NextDouble(),
                MaxImpulse = double.PositiveInfinity,
            };
            int row = Rows.AddRow();
            NetEnds* ends = Rows.EndsOf(row);
            ends->BodyA[Rows.LaneOf(row)] = 1 + i;
            ends->BodyB[Rows.LaneOf(row)] = 1 + Count + i;
            ends->Joint[Rows.LaneOf(row)] = i;
            ends->Response[Rows.LaneOf(row)] = 1;
            Rows.AnchorsOf(row) = new NetAnchors
            {
                AX = _settings[i].AnchorAX,
                AY = _settings[i].AnchorAY,
                BX = _settings[i].AnchorBX,
                BY = _settings[i].AnchorBY,
                Target = _settings[i].Target,
            };
            _fastest[i] = 10;
            _largest[i] = _unit;
            JointState state = default;
            for (int k = 0; k < At(i).Hard; k++)
            {
                _impulse[i, k] = (float)(_unit * (_random.NextDouble() - 0.5));
                state.Impulse[k] = _impulse[i, k];
            }

            Rows.Take(row, state);
        }

        /// <summary>The rows of a joint where its bodies are now.</summary>
        private JointRows At(int i)
        {
            JointFrame frame = default;
            frame.PullTime = 5 * H;
            frame.H = H;
            Read(1 + i, out frame.AX, out frame.AY, out frame.AAngle, out frame.ACos, out frame.ASin);
            Read(1 + Count + i, out frame.BX, out frame.BY, out frame.BAngle, out frame.BCos, out frame.BSin);
            frame.SetAnchors(_settings[i]);
            JointRows rows = default;
            _form.Write(frame, _settings[i], JointFlags.None, ref rows);
            return rows;
        }

        private void Read(int body, out double x, out double y, out double angle, out double cos, out double sin)
        {
            x = _poses[body].X + _bodies.State[body].DeltaPosition.X;
            y = _poses[body].Y + _bodies.State[body].DeltaPosition.Y;
            angle = _poses[body].Angle + _bodies.Motion[body].Turned;
            cos = Math.Cos(angle);
            sin = Math.Sin(angle);
        }

        private double Inverse(int body, int k) => k < 2 ? _poses[body].InverseMass : _poses[body].InverseInertia;

        private void Push(int i, JointRows rows, int row, double impulse)
        {
            for (int k = 0; k < 3; k++)
            {
                _velocity[1 + i, k] += Inverse(1 + i, k) * rows.A[(row * 3) + k] * impulse;
                _velocity[1 + Count + i, k] += Inverse(1 + Count + i, k) * rows.B[(row * 3) + k] * impulse;
                _fastest[i] = Math.Max(_fastest[i], Math.Abs(_velocity[1 + i, k]));
                _fastest[i] = Math.Max(_fastest[i], Math.Abs(_velocity[1 + Count + i, k]));
            }

            _largest[i] = Math.Max(_largest[i], Math.Abs(_impulse[i, row]));
        }

        /// <summary>The impulses that bring the block to its targets at once, by elimination. A row without a response gets none.</summary>
        private double[] Inverse(int i, JointRows rows, bool biased)
        {
            int n = rows.Hard;
            double[,] m = new double[n, n + 1];
            for (int p = 0; p < n; p++)
            {
                double speed = 0;
                for (int k = 0; k < 3; k++)
                {
                    speed += (rows.A[(p * 3) + k] * _velocity[1 + i, k]) + (rows.B[(p * 3) + k] * _velocity[1 + Count + i, k]);
                    for (int q = 0; q < n; q++)
                    {
                        m[p, q] += (rows.A[(p * 3) + k] * rows.A[(q * 3) + k] * Inverse(1 + i, k))
                            + (rows.B[(p * 3) + k] * rows.B[(q * 3) + k] * Inverse(1 + Count + i, k));
                    }
                }

                m[p, n] = -speed - (biased ? _share * rows.Error[p] * Math.PI / 2 / (4 + (Math.PI / 2)) / H : 0);
            }

            for (int p = 0; p < n; p++)
            {
                for (int q = 0; q < n && m[p, p] > 0; q++)
                {
                    double share = m[q, p] / m[p, p];
                    for (int k = 0; q != p && k <= n; k++)
                    {
                        m[q, k] -= share * m[p, k];
                    }
                }
            }

            double[] impulse = new double[n];
            for (int p = 0; p < n; p++)
            {
                impulse[p] = m[p, p] > 0 ? m[p, n] / m[p, p] : 0;
            }

            return impulse;
        }
    }
}
