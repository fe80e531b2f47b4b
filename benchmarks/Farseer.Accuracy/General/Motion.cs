using System;

namespace Farseer.Accuracy.General;

/// <summary>
/// A motion that follows its equation: by the method of Runge and Kutta of fourth order, in steps so small that they do not matter.
/// </summary>
internal sealed class Motion
{
    /// <summary>What the method leaves of a second is less than 1e-11 of it.</summary>
    private const double LongestStep = 5e-4;

    private readonly Action<double[], double[]> _rates;
    private readonly double[] _probe;
    private readonly double[][] _k;

    /// <param name="state">Places, then speeds.</param>
    /// <param name="rates">Writes the rates of a state.</param>
    public Motion(double[] state, Action<double[], double[]> rates)
    {
        State = state;
        _rates = rates;
        _probe = new double[state.Length];
        _k = [new double[state.Length], new double[state.Length], new double[state.Length], new double[state.Length]];
    }

    public double[] State { get; }

    /// <summary>Goes on for some time.</summary>
    /// <param name="time">Seconds.</param>
    public void Go(double time)
    {
        int steps = (int)Math.Ceiling(time / LongestStep);
        double h = time / steps;
        for (int step = 0; step < steps; step++)
        {
            _rates(State, _k[0]);
            Probe(_k[0], 0.5 * h);
            _rates(_probe, _k[1]);
            Probe(_k[1], 0.5 * h);
            _rates(_probe, _k[2]);
            Probe(_k[2], h);
            _rates(_probe, _k[3]);
            for (int i = 0; i < State.Length; i++)
            {
                State[i] += h / 6 * (_k[0][i] + (2 * _k[1][i]) + (2 * _k[2][i]) + _k[3][i]);
            }
        }
    }

    private void Probe(double[] rate, double by)
    {
        for (int i = 0; i < State.Length; i++)
        {
            _probe[i] = State[i] + (by * rate[i]);
        }
    }
}
