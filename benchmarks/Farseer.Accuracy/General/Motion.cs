using System;

namespace Farseer.Accuracy.General;

/// <summary>Solves an equation of motion by the method of Runge and Kutta of fourth order.</summary>
internal static class Motion
{
    /// <summary>So many that what the method leaves of a second is less than 1e-11 of it.</summary>
    private const int StepsASecond = 2000;

    /// <summary>The state after some time.</summary>
    /// <param name="state">Places, then speeds.</param>
    /// <param name="time">Seconds.</param>
    /// <param name="rates">Writes the rates of a state.</param>
    public static double[] Solve(double[] state, double time, Action<double[], double[]> rates)
    {
        int steps = (int)Math.Ceiling(time * StepsASecond);
        double h = time / steps;
        int n = state.Length;
        var now = (double[])state.Clone();
        var probe = new double[n];
        double[][] k = [new double[n], new double[n], new double[n], new double[n]];
        for (int step = 0; step < steps; step++)
        {
            rates(now, k[0]);
            Probe(k[0], 0.5 * h);
            rates(probe, k[1]);
            Probe(k[1], 0.5 * h);
            rates(probe, k[2]);
            Probe(k[2], h);
            rates(probe, k[3]);
            for (int i = 0; i < n; i++)
            {
                now[i] += h / 6 * (k[0][i] + (2 * k[1][i]) + (2 * k[2][i]) + k[3][i]);
            }
        }

        return now;

        void Probe(double[] rate, double by)
        {
            for (int i = 0; i < n; i++)
            {
                probe[i] = now[i] + (by * rate[i]);
            }
        }
    }
}
